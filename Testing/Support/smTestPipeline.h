/**
 * @file smTestPipeline.h
 * @brief Reader and mass filter as most tests use them, and access to the filter's field data
 */
#ifndef smTestPipeline_h
#define smTestPipeline_h

#include "smMassPropertyNames.h"
#include "smMessageTrap.h"
#include "smTesting.h"

#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTEPReader.h>
#include <vtkStringArray.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace smtest
{
/// The display mesh, which no integral depends on, takes most of the time of reading a small file.
inline void UseCoarseMesh(vtkSTEPReader* reader)
{
  reader->SetLinearDeflection(0.1);
  reader->SetAngularDeflection(1.0);
}

enum class DisplayMesh
{
  Coarse,
  Fine
};

struct Pipeline
{
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<vtkMassPropertiesGPU> Mass;

  explicit Pipeline(const std::string& path, DisplayMesh mesh = DisplayMesh::Coarse)
  {
    this->Reader->SetFileName(path.c_str());
    if (mesh == DisplayMesh::Coarse)
    {
      UseCoarseMesh(this->Reader);
    }
    // The shaders are tested; TestMassPropertiesBackends holds the CPU against them.
    this->Mass->SetBackend(vtkMassPropertiesGPU::OPENGL);
    this->Mass->SetInputConnection(this->Reader->GetOutputPort());
  }
};

/// A component of a field data array; NaN when the array or the component is missing.
inline double GetField(vtkFieldData* fields, const std::string& name, int component = 0)
{
  vtkDataArray* array = fields ? fields->GetArray(name.c_str()) : nullptr;
  return array && array->GetNumberOfTuples() > 0 && component < array->GetNumberOfComponents()
    ? array->GetComponent(0, component)
    : std::numeric_limits<double>::quiet_NaN();
}

inline std::string GetFieldText(vtkFieldData* fields, const std::string& name)
{
  auto* array = fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray(name.c_str())) : nullptr;
  return array && array->GetNumberOfValues() > 0 ? std::string(array->GetValue(0)) : "(missing)";
}

inline double GetFieldBound(vtkFieldData* fields, const std::string& name)
{
  return GetField(fields, name + sm::names::BoundSuffix);
}

/// All components of a field data array of the output; empty when it is missing.
inline std::vector<double> GetArray(vtkSurfaceIntegralBase* filter, const std::string& name)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray(name.c_str());
  std::vector<double> values;
  for (int i = 0; array && i < array->GetNumberOfComponents(); ++i)
  {
    values.push_back(array->GetComponent(0, i));
  }
  return values;
}

/// Messages of the last run, a line each.
inline std::string GetMessages(vtkSurfaceIntegralBase* filter)
{
  std::string all;
  for (int i = 0; i < filter->GetNumberOfMessages(); ++i)
  {
    all += filter->GetMessage(i) + "\n";
  }
  return all;
}

inline bool Says(vtkSurfaceIntegralBase* filter, const std::string& text)
{
  return GetMessages(filter).find(text) != std::string::npos;
}

/// All numbers of a filter's field data, without evaluations and dispatches.
inline std::vector<double> GetFieldNumbers(vtkFieldData* fields)
{
  std::vector<double> numbers;
  for (int i = 0; i < fields->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = fields->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    for (vtkIdType k = 0; array && name != sm::names::Evaluations && name != sm::names::Dispatches &&
         k < array->GetNumberOfValues();
         ++k)
    {
      numbers.push_back(array->GetVariantValue(k).ToDouble());
    }
  }
  return numbers;
}

inline std::vector<double> GetFieldNumbers(vtkSurfaceIntegralBase* filter)
{
  return GetFieldNumbers(filter->GetOutput()->GetFieldData());
}

/// False also for fewer than 31 numbers, which would prove little.
inline bool HaveSameBits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() > 30 && a.size() == b.size() &&
    std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}
}

#endif

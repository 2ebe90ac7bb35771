// Arrays of numbers for models that tests build by hand.
#ifndef smTestArrays_h
#define smTestArrays_h

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>

#include <initializer_list>

namespace smtest
{
inline vtkSmartPointer<vtkDoubleArray> MakeArray(int components, std::initializer_list<double> values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}
}

#endif

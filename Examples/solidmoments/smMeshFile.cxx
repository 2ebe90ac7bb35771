#include "smMeshFile.h"

#include "smGLBFile.h"
#include "smSafeFile.h"
#include "smText.h"

#include "vtkAppendPolyData.h"
#include "vtkCleanPolyData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkOBJWriter.h"
#include "vtkPLYWriter.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkSTLWriter.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace sm
{
namespace
{
namespace fs = std::filesystem;

std::string GetExtension(const std::string& fileName)
{
  return LowerCase(fs::path(fileName).extension().string());
}

vtkSmartPointer<vtkPolyData> Join(vtkPartitionedDataSetCollection* bodies, const std::string& unit)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (unsigned int i = 0; i < bodies->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int k = 0; k < bodies->GetNumberOfPartitions(i); ++k)
    {
      if (auto* body = vtkPolyData::SafeDownCast(bodies->GetPartitionAsDataObject(i, k)))
      {
        // A plain copy without the exact model and without normals: points at edges have one for each face,
        // and are merged.
        vtkNew<vtkPolyData> triangles;
        triangles->SetPoints(body->GetPoints());
        triangles->SetPolys(body->GetPolys());
        append->AddInputData(triangles);
      }
    }
  }
  vtkNew<vtkCleanPolyData> merge;
  merge->SetInputConnection(append->GetOutputPort());
  merge->SetTolerance(0.0);
  merge->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  merge->Update();
  // vtkCleanPolyData turns a triangle with two equal corners into a line.
  merge->GetOutput()->SetLines(nullptr);
  merge->GetOutput()->SetVerts(nullptr);
  vtkNew<vtkStringArray> name;
  name->SetName("LengthUnit");
  name->InsertNextValue(unit);
  merge->GetOutput()->GetFieldData()->AddArray(name);
  return merge->GetOutput();
}

template <class Writer>
bool WriteWith(Writer* writer, vtkPolyData* mesh, const std::string& fileName)
{
  writer->SetInputData(mesh);
  writer->SetFileName(fileName.c_str());
  return writer->Write() == 1 && writer->GetErrorCode() == vtkErrorCode::NoError;
}

bool WriteAs(
  const std::string& extension, vtkPolyData* mesh, const std::string& unit, const std::string& fileName)
{
  if (extension == ".stl")
  {
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileTypeToBinary();
    // The header must not begin with "solid", which readers take for the text format.
    writer->SetHeader(("Triangles by SolidMoments, lengths in " + unit).c_str());
    return WriteWith(writer.Get(), mesh, fileName);
  }
  if (extension == ".obj")
  {
    return WriteWith(vtkNew<vtkOBJWriter>().Get(), mesh, fileName);
  }
  if (extension == ".ply")
  {
    return WriteWith(vtkNew<vtkPLYWriter>().Get(), mesh, fileName);
  }
  return WriteWith(vtkNew<vtkXMLPolyDataWriter>().Get(), mesh, fileName);
}

/// Returns an error message, also for no bytes at all.
std::string Save(const std::string& fileName, const std::string& bytes)
{
  if (bytes.empty())
  {
    return "no solid has triangles";
  }
  if (GetExtension(fileName) == ".glb" && bytes.size() > UINT32_MAX)
  {
    return "a glb file has at most 4 GB, and this one would have more";
  }
  const std::string problem = SaveFile(fileName, bytes);
  return problem.empty() ? problem : fileName + " cannot be written: " + problem;
}
}

bool IsMeshName(const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
  return extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".vtp" ||
    extension == ".glb";
}

std::string WriteMesh(
  vtkPartitionedDataSetCollection* bodies, const std::string& unit, const std::string& fileName)
{
  if (GetExtension(fileName) == ".glb")
  {
    return Save(fileName, MakeGLB(bodies, unit));
  }
  const vtkSmartPointer<vtkPolyData> mesh = Join(bodies, unit);
  if (mesh->GetNumberOfPolys() == 0)
  {
    return Save(fileName, {});
  }
  // VTK's writers write to a temporary file; SaveFile() then replaces the user's file when all bytes are
  // there.
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "solidmoments-XXXXXX").string();
  if (error || !mkdtemp(folder.data()))
  {
    return "there is no folder for temporary files that can be written";
  }
  const fs::path temporary = fs::path(folder) / ("mesh" + GetExtension(fileName));
  bool isWritten = WriteAs(GetExtension(fileName), mesh, unit, temporary.string());
  std::string bytes;
  if (isWritten)
  {
    std::ifstream file(temporary, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    isWritten = !file.bad() && bytes.size() == fs::file_size(temporary, error);
  }
  fs::remove_all(folder, error);
  if (!isWritten)
  {
    return "there is no room for it in the folder for temporary files";
  }
  return Save(fileName, bytes);
}
}

#include "smMeshFile.h"

#include "smGLBFile.h"
#include "smMeshOrigin.h"
#include "smSafeFile.h"

#include "vtkAppendPolyData.h"
#include "vtkCleanPolyData.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkDelaunay3D.h"
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
#include <vector>

namespace sm
{
namespace
{
namespace fs = std::filesystem;

vtkSmartPointer<vtkPolyData> Join(
  const std::vector<vtkPolyData*>& bodies, const std::string& unit, const std::array<double, 3>& origin)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (vtkPolyData* body : bodies)
  {
    // A plain copy without the exact model and without normals: points at edges have one for each face,
    // and are merged.
    vtkNew<vtkPolyData> triangles;
    triangles->SetPoints(body->GetPoints());
    triangles->SetPolys(body->GetPolys());
    append->AddInputData(triangles);
  }
  vtkNew<vtkCleanPolyData> merge;
  merge->SetInputConnection(append->GetOutputPort());
  merge->SetTolerance(0.0);
  merge->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  merge->Update();
  // vtkCleanPolyData turns a triangle with two equal corners into a line.
  merge->GetOutput()->SetLines(nullptr);
  merge->GetOutput()->SetVerts(nullptr);
  vtkPoints* points = merge->GetOutput()->GetPoints();
  for (vtkIdType i = 0; points && origin != std::array<double, 3>{} && i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    points->SetPoint(i, x[0] - origin[0], x[1] - origin[1], x[2] - origin[2]);
  }
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

bool WriteAs(const std::string& extension, vtkPolyData* mesh, const std::string& unit,
  const std::array<double, 3>& origin, const std::string& fileName)
{
  const bool isMoved = origin != std::array<double, 3>{};
  if (extension == ".stl")
  {
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileTypeToBinary();
    // The header must not begin with "solid", which readers take for the text format.
    writer->SetHeader(((isMoved ? "SolidMoments, lengths in " : "Triangles by SolidMoments, lengths in ") +
      unit + (isMoved ? ", add " + FormatMeshOrigin(origin, " ") : ""))
                        .c_str());
    return WriteWith(writer.Get(), mesh, fileName);
  }
  if (extension == ".obj")
  {
    return WriteWith(vtkNew<vtkOBJWriter>().Get(), mesh, fileName);
  }
  if (extension == ".ply")
  {
    vtkNew<vtkPLYWriter> writer;
    writer->AddComment("lengths in " + unit);
    if (isMoved)
    {
      writer->AddComment("add to all points: " + FormatMeshOrigin(origin, " "));
    }
    return WriteWith(writer.Get(), mesh, fileName);
  }
  return WriteWith(vtkNew<vtkXMLPolyDataWriter>().Get(), mesh, fileName);
}

/// Returns true if a file has all triangles. VTK's writers of OBJ and PLY do not report a full disk.
bool IsWhole(const std::string& extension, const std::string& bytes, vtkPolyData* mesh)
{
  if (extension == ".ply")
  {
    const std::string end = "end_header\n";
    const std::size_t header = bytes.find(end);
    // Three coordinates in single precision a point; a byte and three numbers a triangle.
    return header != std::string::npos &&
      bytes.size() - header - end.size() >= 12 * static_cast<std::size_t>(mesh->GetNumberOfPoints()) +
        13 * static_cast<std::size_t>(mesh->GetNumberOfPolys());
  }
  if (extension == ".obj")
  {
    vtkIdType triangles = 0;
    for (std::size_t at = bytes.find("\nf "); at != std::string::npos; at = bytes.find("\nf ", at + 1))
    {
      ++triangles;
    }
    return triangles == mesh->GetNumberOfPolys() && bytes.back() == '\n';
  }
  return true;
}

/// Returns an error message, also for no bytes at all.
std::string Save(const std::string& fileName, const std::string& bytes)
{
  if (bytes.empty())
  {
    return "no solid has triangles";
  }
  if (GetMeshExtension(fileName) == ".glb" && bytes.size() > UINT32_MAX)
  {
    return "a glb file has at most 4 GB, and this one would have more";
  }
  const std::string problem = SaveFile(fileName, bytes);
  return problem.empty() ? problem : fileName + " cannot be written: " + problem;
}
/// Writes a mesh in the format of the file's name. Returns an error message; empty if it was written.
std::string SaveAs(vtkPolyData* mesh, const std::string& unit, const std::array<double, 3>& origin,
  const std::string& fileName)
{
  // VTK's writers write to a temporary file; SaveFile() then replaces the user's file when all bytes are
  // there.
  std::error_code error;
  std::string folder = (fs::temp_directory_path(error) / "solidmoments-XXXXXX").string();
  if (error || !mkdtemp(folder.data()))
  {
    return "there is no folder for temporary files that can be written";
  }
  const fs::path temporary = fs::path(folder) / ("mesh" + GetMeshExtension(fileName));
  bool isWritten = WriteAs(GetMeshExtension(fileName), mesh, unit, origin, temporary.string());
  std::string bytes;
  if (isWritten)
  {
    std::ifstream file(temporary, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    isWritten = !file.bad() && bytes.size() == fs::file_size(temporary, error) &&
      IsWhole(GetMeshExtension(fileName), bytes, mesh);
  }
  fs::remove_all(folder, error);
  if (!isWritten)
  {
    return "there is no room for it in the folder for temporary files";
  }
  return Save(fileName, bytes);
}
}

std::string WriteMesh(vtkPartitionedDataSetCollection* bodies, const std::string& unit,
  const std::array<double, 3>& origin, const std::string& fileName)
{
  if (GetMeshExtension(fileName) == ".glb")
  {
    return Save(fileName, MakeGLB(bodies, unit));
  }
  const vtkSmartPointer<vtkPolyData> mesh = Join(ListMeshes(bodies), unit, origin);
  if (mesh->GetNumberOfPolys() == 0)
  {
    return Save(fileName, {});
  }
  return SaveAs(mesh, unit, origin, fileName);
}

std::string WriteLinkMesh(const std::vector<vtkPolyData*>& bodies, double metres,
  const std::array<double, 12>& pose, bool isHull, const std::string& fileName)
{
  vtkSmartPointer<vtkPolyData> mesh = Join(bodies, "m", {});
  vtkPoints* points = mesh->GetPoints();
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3] = { 0.0, 0.0, 0.0 };
    points->GetPoint(i, p);
    for (int k = 0; k < 3; ++k)
    {
      for (int c = 0; c < 3; ++c)
      {
        q[c] += pose[4 * k + c] * (metres * p[k] - pose[4 * k + 3]);
      }
    }
    points->SetPoint(i, q);
  }
  if (mesh->GetNumberOfPolys() == 0)
  {
    return Save(fileName, {});
  }
  if (isHull)
  {
    // The surface of the tetrahedra between all points.
    vtkNew<vtkDelaunay3D> tetrahedra;
    tetrahedra->SetInputData(mesh);
    tetrahedra->SetTolerance(1e-9);
    vtkNew<vtkDataSetSurfaceFilter> surface;
    surface->SetInputConnection(tetrahedra->GetOutputPort());
    surface->Update();
    mesh = surface->GetOutput();
    if (mesh->GetNumberOfPolys() < 4)
    {
      return "no convex hull of " + fileName + " can be made";
    }
  }
  return SaveAs(mesh, "m", {}, fileName);
}
}

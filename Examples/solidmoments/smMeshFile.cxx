#include "smMeshFile.h"

#include "smFormat.h"
#include "smGLBFile.h"
#include "smSafeFile.h"
#include "smText.h"

#include "vtkAppendPolyData.h"
#include "vtkBoundingBox.h"
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

#include <algorithm>
#include <cmath>
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

std::string GetExtension(const std::string& fileName)
{
  return LowerCase(fs::path(fileName).extension().string());
}

/// Returns the bodies with triangles.
std::vector<vtkPolyData*> ListBodies(vtkPartitionedDataSetCollection* collection)
{
  std::vector<vtkPolyData*> bodies;
  for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
  {
    for (unsigned int k = 0; k < collection->GetNumberOfPartitions(i); ++k)
    {
      auto* body = vtkPolyData::SafeDownCast(collection->GetPartitionAsDataObject(i, k));
      if (body && body->GetNumberOfPolys() > 0)
      {
        bodies.push_back(body);
      }
    }
  }
  return bodies;
}

/// Returns "100000 0 -5", which reads back to the same doubles.
std::string FormatOrigin(const std::array<double, 3>& origin, const char* separator)
{
  return FormatExact(origin[0]) + separator + FormatExact(origin[1]) + separator + FormatExact(origin[2]);
}

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
      unit + (isMoved ? ", add " + FormatOrigin(origin, " ") : ""))
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
      writer->AddComment("add to all points: " + FormatOrigin(origin, " "));
    }
    return WriteWith(writer.Get(), mesh, fileName);
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
  const fs::path temporary = fs::path(folder) / ("mesh" + GetExtension(fileName));
  bool isWritten = WriteAs(GetExtension(fileName), mesh, unit, origin, temporary.string());
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

bool IsMeshName(const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
  return extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".vtp" ||
    extension == ".glb";
}

bool HasSinglePoints(const std::string& fileName)
{
  const std::string extension = GetExtension(fileName);
  return extension == ".stl" || extension == ".ply";
}

MeshOrigin FindMeshOrigin(vtkPartitionedDataSetCollection* bodies, const std::string& unit, double deflection,
  const std::string& fileName)
{
  MeshOrigin result;
  if (!HasSinglePoints(fileName))
  {
    return result;
  }
  vtkBoundingBox box;
  double smallest = HUGE_VAL;
  for (vtkPolyData* body : ListBodies(bodies))
  {
    box.AddBounds(body->GetBounds());
    smallest = std::min(smallest, body->GetLength());
  }
  if (!box.IsValid())
  {
    return result;
  }
  const double allowed = SinglePrecisionShare * (deflection > 0.0 ? deflection : 1e-3 * smallest);
  // Rounding moves each coordinate by at most 2^-24 of it.
  const auto getRounding = [&box](const std::array<double, 3>& origin)
  {
    double square = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double largest =
        std::max(std::abs(box.GetBound(2 * c) - origin[c]), std::abs(box.GetBound(2 * c + 1) - origin[c]));
      square += largest * largest;
    }
    return std::sqrt(square) * 0x1p-24;
  };
  const double rounding = getRounding({});
  if (rounding <= allowed)
  {
    return result;
  }
  std::array<double, 3> center;
  box.GetCenter(center.data());
  // Short decimals, which headers of files have room for and people can type.
  const double digits = std::floor(std::log10(std::max(0.5 * box.GetMaxLength(), 1e-300)));
  const double step = std::pow(10.0, std::abs(digits));
  for (double& x : center)
  {
    x = digits < 0.0 ? std::round(x * step) / step : std::round(x / step) * step;
  }
  const double moved = getRounding(center);
  const std::string name = fs::path(fileName).filename().string();
  if (moved <= 0.5 * rounding)
  {
    result.Origin = center;
    result.Message = name + ": its points are relative to (" + FormatOrigin(center, ", ") + ") " + unit +
      ", because single precision would move them by up to " + FormatDistance(rounding) + " " + unit +
      " where they are; add this point, which the file states, too, or write .obj, .vtp or .glb";
  }
  const double left = std::min(moved, rounding);
  if (left > allowed)
  {
    result.Message += (result.Message.empty() ? name + ": single" : "; single") +
      std::string(" precision moves its points by up to ") + FormatDistance(left) + " " + unit +
      (result.Origin == std::array<double, 3>{} ? "; write .obj or .vtp, which have doubles" : "");
  }
  return result;
}

std::string WriteMesh(vtkPartitionedDataSetCollection* bodies, const std::string& unit,
  const std::array<double, 3>& origin, const std::string& fileName)
{
  if (GetExtension(fileName) == ".glb")
  {
    return Save(fileName, MakeGLB(bodies, unit));
  }
  const vtkSmartPointer<vtkPolyData> mesh = Join(ListBodies(bodies), unit, origin);
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

#include "smMeshOrigin.h"

#include "smFormat.h"
#include "smText.h"

#include "vtkBoundingBox.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace sm
{
namespace
{
namespace fs = std::filesystem;
}

std::string GetMeshExtension(const std::string& fileName)
{
  return LowerCase(fs::path(fileName).extension().string());
}

std::vector<vtkPolyData*> ListMeshes(vtkPartitionedDataSetCollection* collection)
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

std::string FormatMeshOrigin(const std::array<double, 3>& origin, const char* separator)
{
  return FormatExact(origin[0]) + separator + FormatExact(origin[1]) + separator + FormatExact(origin[2]);
}

bool IsMeshName(const std::string& fileName)
{
  const std::string extension = GetMeshExtension(fileName);
  return extension == ".stl" || extension == ".obj" || extension == ".ply" || extension == ".vtp" ||
    extension == ".glb";
}

bool HasSinglePoints(const std::string& fileName)
{
  const std::string extension = GetMeshExtension(fileName);
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
  for (vtkPolyData* body : ListMeshes(bodies))
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
    result.Message = name + ": its points are relative to (" + FormatMeshOrigin(center, ", ") + ") " + unit +
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
}

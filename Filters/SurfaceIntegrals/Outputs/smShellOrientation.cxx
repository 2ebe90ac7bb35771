#include "smShellOrientation.h"

#include "smMeshTriangles.h"
#include "smShellNesting.h"
#include "smWholeSphere.h"

#include "vtkNURBSDataSet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

namespace sm
{
namespace
{
/// Disjoint sets of faces (union-find).
class Partition
{
public:
  explicit Partition(std::size_t size)
    : Parent(size)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }
  int Find(int i)
  {
    while (this->Parent[i] != i)
    {
      this->Parent[i] = this->Parent[this->Parent[i]];
      i = this->Parent[i];
    }
    return i;
  }
  void Join(int i, int j)
  {
    this->Parent[std::max(this->Find(i), this->Find(j))] = std::min(this->Find(i), this->Find(j));
  }

private:
  std::vector<int> Parent;
};

/// Sets the shell of every face, numbered from 0 in the order of their first faces. Returns the number of
/// shells.
int FindShells(vtkTrimmedNURBSModel& model, std::vector<int>& shellOfFace)
{
  const std::vector<FacePointer>& faces = model.GetFaces();
  std::vector<int> fileShell(faces.size(), -1);
  const std::vector<std::vector<int>>& shells = model.GetShells();
  for (std::size_t s = 0; s < shells.size(); ++s)
  {
    for (const int face : shells[s])
    {
      if (face >= 0 && face < static_cast<int>(faces.size()))
      {
        fileShell[face] = static_cast<int>(s);
      }
    }
  }
  // Join faces that share an edge within one of the file's shells, and sum the signed uses of each edge
  // within the shell.
  Partition parts(faces.size());
  struct Uses
  {
    int Face;
    int Sum = 0;
  };
  std::unordered_map<const Edge*, std::map<int, Uses>> uses;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (const Loop& loop : faces[f]->Loops)
    {
      for (const Coedge& coedge : loop.Coedges)
      {
        if (coedge.Use->Degenerate)
        {
          continue;
        }
        const auto face = static_cast<int>(f);
        const auto found = uses[coedge.Use.get()].emplace(fileShell[f], Uses{ face });
        Uses& use = found.first->second;
        parts.Join(use.Face, face);
        use.Sum += faces[f]->Reversed == coedge.Reversed ? 1 : -1;
      }
    }
  }
  // A face without loops has no known neighbours: all faces of its shell are joined.
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (std::size_t other = 0; faces[f]->Loops.empty() && other < faces.size(); ++other)
    {
      if (fileShell[other] == fileShell[f])
      {
        parts.Join(static_cast<int>(f), static_cast<int>(other));
      }
    }
  }
  // Join shells that are closed only together.
  for (const auto& [edge, inShells] : uses)
  {
    int open = -1;
    for (const auto& [shell, use] : inShells)
    {
      if (use.Sum != 0)
      {
        parts.Join(open < 0 ? use.Face : open, use.Face);
        open = use.Face;
      }
    }
  }
  int count = 0;
  shellOfFace.assign(faces.size(), -1);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    int& first = shellOfFace[parts.Find(static_cast<int>(f))];
    first = first < 0 ? count++ : first;
    shellOfFace[f] = first;
  }
  return count;
}

/// Makes the shells that are one whole sphere each spheres, and says of which faces. `volume` is that of each
/// face.
std::vector<bool> SetSpheres(vtkTrimmedNURBSModel& model, vtkPolyData* mesh,
  const std::vector<int>& shellOfFace, const std::vector<double>& volume, std::vector<ShellMesh>& meshes)
{
  std::vector<bool> isSphere(shellOfFace.size());
  const auto* const leaf = vtkNURBSDataSet::SafeDownCast(mesh);
  const std::vector<WholeSphere> spheres =
    leaf ? FindWholeSpheres(model.GetFaces()) : std::vector<WholeSphere>();
  for (std::size_t f = 0; f < spheres.size(); ++f)
  {
    const auto faces = std::count(shellOfFace.begin(), shellOfFace.end(), shellOfFace[f]);
    if (spheres[f] && faces == 1 && Covers(spheres[f], spheres[f].GetArea(), 0.0, volume[f]))
    {
      const double* const m = leaf->GetPlacementData();
      const double* const origin = model.GetOrigin();
      Point3 center;
      for (int r = 0; r < 3; ++r)
      {
        center[r] = m[4 * r + 3];
        for (int c = 0; c < 3; ++c)
        {
          center[r] += m[4 * r + c] * (origin[c] + spheres[f].Center[c]);
        }
      }
      meshes[shellOfFace[f]].SetSphere(center, spheres[f].Radius);
      isSphere[f] = true;
    }
  }
  return isSphere;
}

std::vector<ShellMesh> MakeMeshes(vtkTrimmedNURBSModel& model, vtkPolyData* mesh,
  const std::vector<int>& shellOfFace, const std::vector<double>& volume, int count)
{
  std::vector<ShellMesh> meshes(count);
  const std::vector<bool> isSphere = SetSpheres(model, mesh, shellOfFace, volume, meshes);
  VisitTriangles(mesh, shellOfFace.size(),
    [&](std::size_t face, const auto& corners, const auto& normals)
    {
      if (!isSphere[face])
      {
        meshes[shellOfFace[face]].AddTriangle(corners, normals);
      }
    });
  return meshes;
}

/// Computes the number of shells around each shell. Returns a sentence with the reason if it cannot be
/// determined, else an empty string. `uncertain` receives the shells that the reason is about.
std::string FindDepths(const std::vector<ShellMesh>& meshes, const std::vector<double>& volumes,
  std::vector<int>& depths, std::set<std::size_t>& uncertain)
{
  depths.assign(meshes.size(), 0);
  if (std::any_of(meshes.begin(), meshes.end(), [](const ShellMesh& m) { return m.IsEmpty(); }))
  {
    return "a shell has no display mesh, so that it cannot be determined whether it is a void";
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    for (std::size_t j = i + 1; j < meshes.size(); ++j)
    {
      const ShellMesh::Place ij = meshes[i].Find(meshes[j]);
      const ShellMesh::Place ji = meshes[j].Find(meshes[i]);
      using Place = ShellMesh::Place;
      uncertain = { i, j };
      if (ij == Place::Crossing || ji == Place::Crossing || (ij == Place::Inside && ji == Place::Inside))
      {
        return "two of its shells cross";
      }
      if (ij == Place::Unknown || ji == Place::Unknown)
      {
        return "two of its shells are so near each other that it cannot be determined whether one is a void "
               "in the other";
      }
      // A shell inside another one must enclose less volume.
      if ((ij == Place::Inside && !(std::abs(volumes[i]) < std::abs(volumes[j]))) ||
        (ji == Place::Inside && !(std::abs(volumes[j]) < std::abs(volumes[i]))))
      {
        return "a shell inside another one encloses more than it";
      }
      depths[i] += ij == Place::Inside ? 1 : 0;
      depths[j] += ji == Place::Inside ? 1 : 0;
    }
  }
  uncertain.clear();
  return {};
}
}

ShellOrientation OrientShells(vtkTrimmedNURBSModel& model, vtkPolyData* mesh,
  const std::vector<double>& volume, const std::vector<double>& bound)
{
  ShellOrientation result;
  std::vector<int> shellOfFace;
  result.Shells = FindShells(model, shellOfFace);
  if (result.Shells < 2)
  {
    return result;
  }
  std::vector<double> volumes(result.Shells, 0.0);
  std::vector<double> bounds(result.Shells, 0.0);
  for (std::size_t f = 0; f < shellOfFace.size(); ++f)
  {
    volumes[shellOfFace[f]] += volume[f];
    bounds[shellOfFace[f]] += bound[f];
  }
  const auto setUncertain = [&](const std::string& reason, const std::set<std::size_t>& shells)
  {
    result.Uncertainty = reason;
    for (std::size_t f = 0; f < shellOfFace.size(); ++f)
    {
      if (shells.count(static_cast<std::size_t>(shellOfFace[f])) > 0)
      {
        result.Uncertain.push_back(f);
      }
    }
  };
  for (int i = 0; i < result.Shells; ++i)
  {
    if (!(std::abs(volumes[i]) > bounds[i]))
    {
      setUncertain("the volume of a shell is zero within its bound, so that its orientation is unknown",
        { static_cast<std::size_t>(i) });
      return result;
    }
  }
  std::vector<int> depths;
  std::set<std::size_t> uncertain;
  const std::string reason =
    FindDepths(MakeMeshes(model, mesh, shellOfFace, volume, result.Shells), volumes, depths, uncertain);
  if (!reason.empty())
  {
    setUncertain(reason, uncertain);
    return result;
  }
  const auto outer = std::count_if(depths.begin(), depths.end(), [](int depth) { return depth % 2 == 0; });
  if (model.GetNumberOfOuterShells() > 0 && outer != model.GetNumberOfOuterShells())
  {
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      if ((volumes[i] > 0.0) != (depths[i] % 2 == 0))
      {
        uncertain.insert(i);
      }
    }
    setUncertain("a void lies outside the outer shell, or inside another void", uncertain);
    return result;
  }
  std::vector<bool> wrong(result.Shells);
  for (int i = 0; i < result.Shells; ++i)
  {
    wrong[i] = (volumes[i] > 0.0) != (depths[i] % 2 == 0);
    result.Flipped += wrong[i] ? 1 : 0;
  }
  // A STEP file names the outer shell first. In a BREP file it may be any, and then the shells are oriented
  // rightly; so it may in a solid that is inside out as a whole.
  if (result.Flipped > 0 && result.Flipped < result.Shells && model.GetNumberOfOuterShells() == 1 &&
    depths[0] % 2 != 0)
  {
    result.Flipped = 0;
    setUncertain("the file's outer shell lies inside a void of it", { 0 });
    return result;
  }
  if (result.Flipped == result.Shells)
  {
    result.InsideOut = true;
  }
  else if (result.Flipped > 0)
  {
    for (const int shell : shellOfFace)
    {
      result.Sides.push_back(wrong[shell] ? -1 : 1);
    }
  }
  return result;
}
}

#include "smDisplayMesh.h"

#include <algorithm>
#include <map>

namespace sm
{
namespace
{
/// "2 faces, the first of them #17"
std::string CountFaces(const std::vector<const Face*>& faces)
{
  const std::string id =
    faces.front()->FileId > 0 ? " #" + std::to_string(faces.front()->FileId) : std::string();
  return faces.size() == 1
    ? "face" + id
    : std::to_string(faces.size()) + " faces" + (id.empty() ? "" : ", the first of them" + id);
}
}

double LimitDeflection(double deflection, double diagonal)
{
  const double wanted = deflection > 0.0 ? deflection : 1e-3 * diagonal;
  return std::max(wanted, 1e-5 * diagonal);
}

DisplayMesh JoinMeshes(const std::vector<FacePointer>& faces, std::vector<FaceMesh> meshes,
  const double origin[3], std::vector<std::string>& messages)
{
  DisplayMesh result;
  std::vector<const Face*> missing;
  std::vector<const Face*> crossing;
  std::map<std::string, std::vector<const Face*>> turned;
  for (std::size_t f = 0; f < meshes.size(); ++f)
  {
    const FaceMesh& mesh = meshes[f];
    const int first = static_cast<int>(result.Points.size());
    const int index = static_cast<int>(f);
    for (const Vector3& p : mesh.Points)
    {
      result.Points.push_back({ p[0] + origin[0], p[1] + origin[1], p[2] + origin[2] });
    }
    result.Normals.insert(result.Normals.end(), mesh.Normals.begin(), mesh.Normals.end());
    result.Parameters.insert(result.Parameters.end(), mesh.Parameters.begin(), mesh.Parameters.end());
    result.PointFace.insert(result.PointFace.end(), mesh.Points.size(), index);
    for (const std::array<int, 3>& t : mesh.Triangles)
    {
      result.Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    }
    result.TriangleFace.insert(result.TriangleFace.end(), mesh.Triangles.size(), index);
    result.Deviations.push_back(mesh.Deviation);
    if (mesh.Triangles.empty())
    {
      missing.push_back(faces[f].get());
    }
    else if (mesh.TurnedOver > 0)
    {
      turned[mesh.Reason].push_back(faces[f].get());
    }
    else if (!mesh.Reason.empty())
    {
      crossing.push_back(faces[f].get());
    }
    // The memory of a large face is not needed twice.
    meshes[f] = FaceMesh();
  }
  if (!missing.empty())
  {
    messages.push_back("The display mesh lacks " + CountFaces(missing) + "; the exact geometry is there.");
  }
  for (const auto& [reason, of] : turned)
  {
    messages.push_back("Display mesh of " + CountFaces(of) + ": " + reason);
  }
  if (!crossing.empty())
  {
    messages.push_back("Loops cross on " + CountFaces(crossing) + "; the display mesh may be open there.");
  }
  return result;
}
}

#include "smFoldedFaces.h"

#include "Trims/smFootPoint.h"
#include "smCatchFailure.h"
#include "smNaturalBoundary.h"

#include <unordered_map>

namespace sm
{
namespace
{
/// Cosine of the angle between normals that are opposite: within 0.8 degrees. Smooth edges of real files
/// deviate by less.
constexpr double Opposite = -0.9999;
/// The same between planes and surfaces of the second order, and tori, whose edges are smooth to the digits
/// of their radii and places: within 0.1 degrees. A cap that is flatter than 1e-6 of its radius, and a ball
/// on a plate with a rim narrower than 1e-3 of its radius, have such edges.
constexpr double OppositeOfElementary = -0.999999;

/// Returns true if the direction of its loops has decided on which part of a closed surface the face is.
bool IsDecidedByLoops(const DraftFace& face)
{
  return face.IsOutside() || (face.AddedEdges > 0 && IsOnClosedSurface(face));
}

bool IsElementary(const FaceShape& face)
{
  return face.Surface && face.Surface->GetIf<ElementarySurface>();
}

/// Returns the surface of a face. A surface of revolution may have its points twice, with opposite normals:
/// the surface is the part that was inspected, if the face was.
SurfacePointer FindSurface(const FaceShape& face, const SoundFaceTable& faces)
{
  const auto found = faces.find(&face);
  return found != faces.end() && found->second->IsPart ? found->second->Surface : face.Surface;
}

/// The surfaces of faces, to find points on them; null for planes and where points cannot be found.
using Finders = std::unordered_map<const FaceShape*, std::shared_ptr<const FootPointFinder>>;

/// Returns the outer unit normal of a face at the foot of a point; zero if it is not found.
Vector3 GetNormal(const FaceUse& use, const SoundFaceTable& faces, Finders& finders, const Vector3& point)
{
  const SurfacePointer surface = FindSurface(*use.Face, faces);
  const Placement& location = use.Face->Location;
  double uv[2] = { 0.0, 0.0 };
  if (!FindElementary(*surface, ElementarySurface::Type::Plane))
  {
    const auto [finder, isNew] = finders.try_emplace(use.Face.get());
    if (isNew)
    {
      finder->second = FootPointFinder::Make(surface, true);
    }
    if (!finder->second || !finder->second->Find(Invert(location).MapPoint(point), nullptr, uv))
    {
      return {};
    }
  }
  GeometricSurface::Derivatives at;
  surface->Evaluate(uv[0], uv[1], 1, at);
  const Vector3 normal = Cross(location.MapVector(at[1][0]), location.MapVector(at[0][1]));
  const double length = Norm(normal);
  return length > 0.0 ? Multiply((use.Reversed ? -1.0 : 1.0) / length, normal) : Vector3{};
}

/// The faces at each edge.
using Neighbours = std::unordered_map<const EdgeShape*, std::vector<FaceUse>>;

bool FoldsBack(
  const FaceUse& face, const SoundFaceTable& faces, const Neighbours& neighbours, Finders& finders)
{
  for (const WireShape& wire : face.Face->Wires)
  {
    for (const CoedgeShape& coedge : wire.Coedges)
    {
      const auto others = neighbours.find(coedge.Edge.get());
      if (!coedge.Edge->HasCurve() || others == neighbours.end())
      {
        continue;
      }
      const Vector3 middle = coedge.Edge->EvaluateAt(0.5);
      for (const FaceUse& other : others->second)
      {
        const double limit =
          IsElementary(*face.Face) && IsElementary(*other.Face) ? OppositeOfElementary : Opposite;
        if (other.Face != face.Face &&
          Dot(GetNormal(face, faces, finders, middle), GetNormal(other, faces, finders, middle)) < limit)
        {
          return true;
        }
      }
    }
  }
  return false;
}
}

std::vector<const FaceShape*> FindFoldedFaces(const BodyShape& body, const SoundFaceTable& faces)
{
  std::vector<const FaceShape*> folded;
  Neighbours neighbours;
  Finders finders;
  body.VisitFaces(
    [&](const FaceUse& use)
    {
      const auto found = faces.find(use.Face.get());
      if (found == faces.end() || !IsDecidedByLoops(*found->second))
      {
        return;
      }
      if (neighbours.empty())
      {
        body.VisitFaces(
          [&neighbours](const FaceUse& other)
          {
            for (const WireShape& wire : other.Face->Wires)
            {
              for (const CoedgeShape& coedge : wire.Coedges)
              {
                neighbours[coedge.Edge.get()].push_back(other);
              }
            }
          });
      }
      bool isFolded = false;
      CatchFailure([&] { isFolded = FoldsBack(use, faces, neighbours, finders); });
      if (isFolded)
      {
        folded.push_back(use.Face.get());
      }
    });
  return folded;
}
}

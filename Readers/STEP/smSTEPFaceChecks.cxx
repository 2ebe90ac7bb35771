#include "smSTEPFaceChecks.h"

#include "Loops/smNaturalBoundary.h"
#include "smCatchFailure.h"
#include "smFacePieces.h"
#include "smFormat.h"
#include "smParallelFor.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
namespace
{
/// Largest number of faces, and of edges of a face, that messages name.
constexpr std::size_t MaxNamedFaces = 10;
constexpr std::size_t MaxNamedEdges = 4;

/// Digits of the numbers in messages.
constexpr int MessageDigits = 6;

/// A face of the file, and the faces of the body that came of it.
struct StatedFace
{
  const FaceStatement* Statement;
  std::vector<std::size_t> Indices;
  std::vector<const Face*> Parts;
  FaceFinding Finding;
};

std::string NameEdges(const FaceStatement& statement)
{
  std::vector<std::uint64_t> edges;
  for (const EdgeUseStatement& use : statement.Uses)
  {
    if (std::find(edges.begin(), edges.end(), use.Edge) == edges.end())
    {
      edges.push_back(use.Edge);
    }
  }
  std::string text = edges.size() == 1 ? "edge" : "edges";
  for (std::size_t i = 0; i < std::min(edges.size(), MaxNamedEdges); ++i)
  {
    text += (i == 0 ? " #" : ", #") + std::to_string(edges[i]);
  }
  return edges.empty() ? "no edges" : text + (edges.size() > MaxNamedEdges ? ", .." : "");
}

std::string FormatVector(const Vector3& v)
{
  return "(" + FormatDigits(v[0], MessageDigits) + ", " + FormatDigits(v[1], MessageDigits) + ", " +
    FormatDigits(v[2], MessageDigits) + ")";
}

std::string DescribeDifference(const StatedFace& face)
{
  return "Face #" + std::to_string(face.Statement->Id) +
    " of the file was not read as its edges bound it in space (" + NameEdges(*face.Statement) +
    "): its vector area is " + FormatVector(face.Finding.Stated) + " mm^2 by its edges and " +
    FormatVector(face.Finding.Read) + " mm^2 as read, and its moments differ by " +
    FormatDigits(face.Finding.MomentDifference, 3) +
    " mm^3. Area and volume are in doubt; export the file again, or correct the face.";
}

std::string DescribeOverlap(const FaceStatement& statement)
{
  return "Face #" + std::to_string(statement.Id) + " of the file: edges #" +
    std::to_string(statement.Overlap[0]) + " and #" + std::to_string(statement.Overlap[1]) +
    " follow each other and cover the same part of one curve, which the boundary of a face does not: the "
    "rest of the curve may be meant. Correct the senses of the edges, or export the file again.";
}

std::vector<StatedFace> CollectStatedFaces(const FaceStatements& statements, const ConvertedBody& body)
{
  std::vector<StatedFace> faces;
  std::unordered_map<std::int64_t, std::size_t> places;
  for (std::size_t i = 0; i < body.Faces.size(); ++i)
  {
    const ConvertedFace& face = body.Faces[i];
    const auto found = statements.find(static_cast<std::uint64_t>(face.Result->FileId));
    if (face.Result->FileId <= 0 || found == statements.end() || !found->second.IsKnown)
    {
      continue;
    }
    const auto place = places.emplace(face.Result->FileId, faces.size());
    if (place.second)
    {
      faces.push_back({ &found->second, {}, {}, FaceFinding() });
    }
    faces[place.first->second].Indices.push_back(i);
    faces[place.first->second].Parts.push_back(face.Result.get());
  }
  return faces;
}

/// Returns true if the surface of a face is closed.
bool IsClosedSurface(const StatedFace& face, const ConvertedBody& body)
{
  bool isClosed = false;
  CatchFailure(
    [&]
    {
      EdgeIndex edges;
      isClosed =
        IsOnClosedSurface(CollectFace(*body.Faces[face.Indices[0]].Source, false, edges, MissingTrim::Feet));
    });
  return isClosed;
}

bool IsMirror(const StatementPlace& place)
{
  return Dot(place.Linear[0], Cross(place.Linear[1], place.Linear[2])) < 0.0;
}

/// Returns 1 if the body's normal on a face is that which the file states, -1 if it is the opposite one.
int GetSide(const StatedFace& face, const StatementPlace& place)
{
  const bool isForward = face.Parts[0]->Reversed == IsMirror(place);
  return isForward == (face.Statement->IsForward == face.Statement->IsShellForward) ? 1 : -1;
}

/// Returns true if the outer shell of a solid is inside out in the file: it was reversed, or will be because
/// of its volume.
bool IsInsideOut(const std::vector<StatedFace>& faces, const CheckedBody& checked, const ConvertedBody& body)
{
  if (!checked.IsSolid || body.Shells.empty())
  {
    return false;
  }
  std::vector<bool> isOuter(body.Faces.size(), false);
  for (const int index : body.Shells[0])
  {
    isOuter[index] = true;
  }
  std::size_t kept = 0;
  std::size_t reversed = 0;
  for (const StatedFace& face : faces)
  {
    if (isOuter[face.Indices[0]] && face.Finding.Verdict == FaceVerdict::Agrees)
    {
      ++(GetSide(face, checked.Place) > 0 ? kept : reversed);
    }
  }
  const bool isReversed = reversed > 0 && kept == 0;
  return isReversed != (kept > 0 && reversed == 0 && checked.Volume < 0.0);
}

/// Describes what two parts of a closed surface make of the volume, in mm^3; empty if it is not known.
std::string DescribeVolumes(const StatedFace& face, const CheckedBody& checked)
{
  const double cube =
    std::abs(Dot(checked.Place.Linear[0], Cross(checked.Place.Linear[1], checked.Place.Linear[2])));
  const double volume = std::abs(checked.Volume) / cube;
  const bool isOutwards = face.Parts[0]->Reversed == IsMirror(checked.Place);
  const double other = std::abs(volume - (isOutwards ? 1.0 : -1.0) * face.Statement->WholeVolume);
  return std::isfinite(other) && checked.IsSolid
    ? " The volume of the solid is about " + FormatDigits(volume, 3) + " mm^3 as read, and about " +
      FormatDigits(other, 3) + " mm^3 with the other part."
    : std::string();
}

/// Fills in what the faces of the body show: pieces, crossings and areas.
void MeasureExtent(const StatedFace& face, const CheckedBody& checked, CheckedFace& result)
{
  const double scale = std::cbrt(
    std::abs(Dot(checked.Place.Linear[0], Cross(checked.Place.Linear[1], checked.Place.Linear[2]))));
  double area = 0.0;
  for (std::size_t i = 0; i < face.Parts.size(); ++i)
  {
    const Face& part = *face.Parts[i];
    result.Pieces = std::max(result.Pieces, part.Loops.size() > 1 ? CountOuterLoops(part) : 1);
    result.IsOnBothParts = result.IsOnBothParts ||
      (face.Statement->Spindle.Minor > 0.0 && IsOnBothParts(part, face.Statement->Spindle, checked.Place));
    area += checked.Areas.empty() ? 0.0 : checked.Areas[face.Indices[i]];
  }
  result.Area = checked.Areas.empty() ? result.Area : area / (scale * scale);
}

std::string DescribeContradiction(const BodyContradiction& found, double area,
  const std::vector<StatedFace>& faces, const CheckedBody& checked)
{
  const StatedFace& face = faces[found.Face];
  const std::string name = "Face #" + std::to_string(face.Statement->Id) + " of the file";
  const std::string edge = "edge #" + std::to_string(found.Edge);
  switch (found.Kind)
  {
    case BodyContradiction::Type::Reversed:
      return name + " is a part of a closed surface, and was read on the other side of its bounds (" +
        NameEdges(*face.Statement) + ") than their directions state." + DescribeVolumes(face, checked) +
        " Correct the senses of the face, its bounds and edges, or export the file again.";
    case BodyContradiction::Type::SameDirection:
      return name + " is a part of a closed surface, and uses " + edge + " in the same direction as face #" +
        std::to_string(faces[found.Other].Statement->Id) + ": the other part may be meant." +
        DescribeVolumes(face, checked) + " Correct the senses of these faces, or export the file again.";
    case BodyContradiction::Type::InsideOut:
      return name +
        " is a part of a closed surface, and its solid is inside out in the file: the other part may be "
        "meant (" +
        NameEdges(*face.Statement) + ")." + DescribeVolumes(face, checked) +
        " Correct the sense of the face, or export the file again.";
    case BodyContradiction::Type::InPieces:
      return name + " is in several pieces of a closed surface within its bounds (" +
        NameEdges(*face.Statement) +
        "), which no face is: the rest of the surface may be meant. Correct the senses of the face and its "
        "bounds, or export the file again.";
    case BodyContradiction::Type::CrossesItself:
      return name + " crosses itself: it has the outer and the inner part of a torus whose minor radius, " +
        FormatDigits(face.Statement->Spindle.Minor, MessageDigits) + " mm, exceeds the major one (" +
        NameEdges(*face.Statement) +
        "). The other part of the torus may be meant. Correct the sense of the face, or export the file "
        "again.";
    case BodyContradiction::Type::TooLarge:
      return name + " has an area of about " + FormatDigits(area, 3) + " mm^2, and its whole surface has " +
        FormatDigits(face.Statement->WholeArea, MessageDigits) + " mm^2 (" + NameEdges(*face.Statement) +
        "). Area and volume are in doubt; export the file again.";
    case BodyContradiction::Type::NotInMesh:
      return name + " has no triangles, but its edges bound an area (" + NameEdges(*face.Statement) +
        "). Area and volume are in doubt; export the file again, or correct the face.";
    default:
      return name + " and all others at " + edge +
        " lie on the other side of their bounds than the file states: the rest of the edge's curve may be "
        "meant. Correct the sense of the edge, or export the file again.";
  }
}
}

void CheckFaces(const FaceStatements& statements, const CheckedBody& checked, ConvertedBody& body)
{
  std::vector<StatedFace> faces = CollectStatedFaces(statements, body);
  ParallelFor(faces.size(), 16,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        faces[i].Finding = CheckFace(faces[i].Parts, *faces[i].Statement, checked.Place);
      }
    });
  const bool isInsideOut = IsInsideOut(faces, checked, body);
  std::vector<CheckedFace> results;
  std::vector<std::string> messages;
  for (const StatedFace& face : faces)
  {
    CheckedFace result;
    result.Statement = face.Statement;
    result.Finding = face.Finding;
    MeasureExtent(face, checked, result);
    result.IsClosed = face.Statement->Extent == SurfaceExtent::Closed;
    results.push_back(result);
    if (face.Finding.Verdict == FaceVerdict::Differs)
    {
      messages.push_back(DescribeDifference(face));
    }
    if (face.Statement->Overlap[0] != 0)
    {
      messages.push_back(DescribeOverlap(*face.Statement));
    }
  }
  // For other surfaces than spheres and tori this takes time.
  const auto isClosed = [&](std::size_t i) { return IsClosedSurface(faces[i], body); };
  for (const BodyContradiction& found : FindContradictions(results, isInsideOut, isClosed))
  {
    messages.push_back(DescribeContradiction(found, results[found.Face].Area, faces, checked));
  }
  body.Defects += static_cast<int>(messages.size());
  for (std::size_t i = 0; i < std::min(messages.size(), MaxNamedFaces); ++i)
  {
    body.Messages.push_back(messages[i]);
  }
  if (messages.size() > MaxNamedFaces)
  {
    body.Messages.push_back(
      std::to_string(messages.size() - MaxNamedFaces) + " more faces contradict their edges, or others.");
  }
}
}

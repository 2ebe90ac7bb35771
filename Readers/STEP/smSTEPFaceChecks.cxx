#include "smSTEPFaceChecks.h"

#include "smFormat.h"
#include "smParallelFor.h"

#include <algorithm>
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

std::vector<StatedFace> CollectStatedFaces(const FaceStatements& statements, const ConvertedBody& body)
{
  std::vector<StatedFace> faces;
  std::unordered_map<int, std::size_t> places;
  for (const ConvertedFace& face : body.Faces)
  {
    const auto found = statements.find(static_cast<std::uint64_t>(face.Result->FileId));
    if (face.Result->FileId <= 0 || found == statements.end() || !found->second.IsKnown)
    {
      continue;
    }
    const auto place = places.emplace(face.Result->FileId, faces.size());
    if (place.second)
    {
      faces.push_back({ &found->second, {}, FaceFinding() });
    }
    faces[place.first->second].Parts.push_back(face.Result.get());
  }
  return faces;
}
}

void CheckFaces(const FaceStatements& statements, const StatementPlace& place, ConvertedBody& body)
{
  std::vector<StatedFace> faces = CollectStatedFaces(statements, body);
  ParallelFor(faces.size(), 16,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t i = begin; i < end; ++i)
      {
        faces[i].Finding = CheckFace(faces[i].Parts, *faces[i].Statement, place);
      }
    });
  std::size_t different = 0;
  for (const StatedFace& face : faces)
  {
    if (face.Finding.Verdict == FaceVerdict::Differs)
    {
      ++body.Defects;
      if (++different <= MaxNamedFaces)
      {
        body.Messages.push_back(DescribeDifference(face));
      }
    }
  }
  if (different > MaxNamedFaces)
  {
    body.Messages.push_back(
      std::to_string(different - MaxNamedFaces) + " more faces were not read as their edges bound them.");
  }
}
}

#include "Detail/smSelfCrossing.h"

#include "smFormat.h"

#include "vtkMatrix4x4.h"
#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace sm
{
namespace
{
/// Adds the result of a body to its messages and its status.
void Report(const SelfCrossing& result, BodyIntegrals& body)
{
  if (result.Winding != 0)
  {
    const double point[4] = { result.Point[0], result.Point[1], result.Point[2], 1.0 };
    double p[4];
    vtkMatrix4x4::MultiplyPoint(body.Placement.data(), point, p);
    const std::string times = std::to_string(std::abs(result.Winding)) + " times";
    body.Flag(Status::Suspect,
      "its boundary crosses itself: near face #" + std::to_string(result.Face) + ", about the point (" +
        FormatDigits(p[0], 6) + ", " + FormatDigits(p[1], 6) + ", " + FormatDigits(p[2], 6) +
        "), its winding number is " + std::to_string(result.Winding) + ": the volume there " +
        (result.Winding > 0        ? "counts " + times
            : result.Winding == -1 ? "is subtracted"
                                   : "is subtracted " + times));
    // One of the parts that are checked together has the face.
    const std::vector<FacePointer>& faces = body.Model->GetFaces();
    const auto found = std::find_if(
      faces.begin(), faces.end(), [&result](const FacePointer& face) { return face->FileId == result.Face; });
    if (result.Face > 0 && found != faces.end())
    {
      body.FaceDefects.push_back(
        { { static_cast<std::size_t>(found - faces.begin()) }, "the boundary crosses itself near it" });
    }
  }
  else if (!result.Unchecked.empty())
  {
    body.Messages.push_back("whether its boundary crosses itself was not checked: " + result.Unchecked);
  }
}

bool IsCheckable(const BodyIntegrals& body)
{
  return body.Faces && body.HasVolume() && body.OpenEdges == 0 && body.SkippedFaces == 0 &&
    body.Status < Status::Suspect && !body.Faces->empty();
}

/// Returns true if a body is a part of the same solid of a file as the one before it, because OpenCASCADE
/// makes a solid of each connected part of a shell. Solids of two files may have the same entity number; the
/// numbers of their faces distinguish them.
bool IsSameSolid(const BodyIntegrals& first, const BodyIntegrals& body, const std::set<std::int64_t>& faceIds)
{
  const std::vector<FacePointer>& faces = body.Model->GetFaces();
  return IsCheckable(body) && body.Model->GetFileId() > 0 &&
    body.Model->GetFileId() == first.Model->GetFileId() && body.Placement == first.Placement &&
    std::none_of(faces.begin(), faces.end(),
      [&faceIds](const FacePointer& face) { return faceIds.count(face->FileId) > 0; });
}
}

SelfCrossingCheck::EntryPointer SelfCrossingCheck::Find(const std::vector<std::uint64_t>& faces,
  bool checkEdits, const std::unordered_map<std::uint64_t, EntryPointer>& current) const
{
  const auto instance = current.find(faces.front());
  if (instance != current.end() && instance->second->Faces == faces)
  {
    return instance->second;
  }
  EntryPointer original;
  for (const std::uint64_t face : faces)
  {
    const auto known = this->Known.find(face);
    if (known != this->Known.end() && known->second->Faces == faces)
    {
      return known->second;
    }
    original = original || known == this->Known.end() ? original : known->second;
  }
  // An edit may have removed a crossing that was found, so only a sound original decides.
  return !checkEdits && original && original->Result.Winding == 0 ? original : nullptr;
}

void SelfCrossingCheck::Run(
  std::vector<BodyIntegrals>& bodies, bool checkEdits, const std::function<bool()>& shouldContinue)
{
  bool isStopped = false;
  std::unordered_map<std::uint64_t, EntryPointer> current;
  for (std::size_t b = 0; b < bodies.size();)
  {
    if (!IsCheckable(bodies[b]))
    {
      ++b;
      continue;
    }
    std::vector<const BodyIntegrals*> parts;
    std::vector<std::uint64_t> faces;
    std::set<std::int64_t> ids;
    std::size_t end = b;
    for (; end < bodies.size() && (end == b || IsSameSolid(bodies[b], bodies[end], ids)); ++end)
    {
      parts.push_back(&bodies[end]);
      for (const FacePointer& face : bodies[end].Model->GetFaces())
      {
        faces.push_back(face->Id);
        ids.insert(face->FileId);
      }
    }
    EntryPointer entry = this->Find(faces, checkEdits, current);
    if (!entry)
    {
      isStopped = isStopped || (b > 0 && shouldContinue && !shouldContinue());
      SelfCrossing result;
      result.Unchecked = SelfCrossing::Stopped;
      result = isStopped ? result : FindSelfCrossing(parts, shouldContinue);
      isStopped = isStopped || result.Unchecked == SelfCrossing::Stopped;
      entry = std::make_shared<const Entry>(Entry{ std::move(faces), result });
    }
    // A body that could not be checked may have a mesh in the next run.
    for (const std::uint64_t face : entry->Faces)
    {
      if (entry->Result.Unchecked.empty())
      {
        current.emplace(face, entry);
      }
    }
    for (; b < end; ++b)
    {
      Report(entry->Result, bodies[b]);
    }
  }
  this->Known = std::move(current);
}
}

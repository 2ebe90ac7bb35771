#include "smBodyIntegrals.h"
#include "smUnitRoundoff.h"

#include "Outputs/smOpenEdges.h"
#include "Outputs/smShellOrientation.h"
#include "smBodyScales.h"
#include "smCompensatedSum.h"
#include "smCountedTexts.h"
#include "smFormat.h"
#include "smInstanceNames.h"
#include "smMeshTriangles.h"
#include "smVector.h"
#include "smWholeSphere.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNURBSDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace sm
{
namespace
{
// Distance of a trim curve from its surface, relative to the body, above which it is not attributed to
// rounding.
constexpr double LargeOverhang = 1e-5;
// Half the diagonal of a body, below and above which products of lengths, of which second moments have five,
// may leave the range of doubles: they become 0 without an error that a bound counts.
constexpr double MinSize = 1e-40;
constexpr double MaxSize = 1e40;

std::string NameOf(vtkInformation* info, const std::string& otherwise)
{
  const char* name = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name && *name ? name : otherwise;
}

void Reject(vtkDataObject* data, const std::string& name, int& count, RejectedInput& rejected)
{
  ++count;
  auto* mesh = vtkDataSet::SafeDownCast(data);
  if (!mesh || mesh->GetNumberOfPoints() > 0)
  {
    rejected.Meshes.emplace_back(data, name);
  }
}

void Collect(
  vtkDataObject* data, const std::string& name, std::vector<BodyIntegrals>& bodies, RejectedInput& rejected)
{
  if (auto leaf = vtkNURBSDataSet::SafeDownCast(data))
  {
    if (vtkTrimmedNURBSModel* model = leaf->GetModel())
    {
      BodyIntegrals body;
      body.Model = model;
      body.Mesh = leaf;
      std::copy_n(leaf->GetPlacementData(), 16, body.Placement.begin());
      body.Name = GetPartName(*leaf, name);
      body.Block = name.empty() ? body.Name : name;
      body.Path = leaf->GetPartPath().empty() ? body.Name : leaf->GetPartPath();
      body.Id = std::to_string(bodies.size() + 1);
      bodies.push_back(std::move(body));
      return;
    }
    Reject(data, name, leaf->IsModelWithheld() ? rejected.Withheld : rejected.Plain, rejected);
  }
  else if (auto collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < collection->GetNumberOfPartitionedDataSets(); ++i)
    {
      vtkInformation* info = collection->HasMetaData(i) ? collection->GetMetaData(i) : nullptr;
      Collect(collection->GetPartitionedDataSet(i), NameOf(info, name), bodies, rejected);
    }
  }
  else if (auto partitions = vtkPartitionedDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < partitions->GetNumberOfPartitions(); ++i)
    {
      Collect(partitions->GetPartitionAsDataObject(i), name, bodies, rejected);
    }
  }
  else if (auto blocks = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    for (unsigned int i = 0; i < blocks->GetNumberOfBlocks(); ++i)
    {
      vtkInformation* info = blocks->HasMetaData(i) ? blocks->GetMetaData(i) : nullptr;
      Collect(blocks->GetBlock(i), NameOf(info, name), bodies, rejected);
    }
  }
  else if (data)
  {
    Reject(data, name, rejected.Plain, rejected);
  }
}

bool IsRigid(const std::array<double, 16>& m)
{
  bool rigid = m[12] == 0.0 && m[13] == 0.0 && m[14] == 0.0 && m[15] == 1.0 && std::isfinite(m[3]) &&
    std::isfinite(m[7]) && std::isfinite(m[11]);
  for (int i = 0; i < 3; ++i)
  {
    for (int j = i; j < 3; ++j)
    {
      const double product = m[i] * m[j] + m[4 + i] * m[4 + j] + m[8 + i] * m[8 + j];
      rigid = rigid && std::abs(product - (i == j ? 1.0 : 0.0)) <= 1e-12;
    }
  }
  return rigid;
}
}

void BodyIntegrals::Degrade(sm::Status status)
{
  this->Status = std::max(this->Status, status);
}

void BodyIntegrals::Flag(sm::Status status, const std::string& message)
{
  if (status > this->Status)
  {
    this->Reason = message;
  }
  this->Degrade(status);
  this->Messages.push_back(message);
}

std::vector<BodyIntegrals> CollectBodies(vtkDataObject* input, RejectedInput& rejected)
{
  std::vector<BodyIntegrals> bodies;
  Collect(input, "", bodies, rejected);
  return bodies;
}

std::string LeaveOut(
  const std::function<bool(const std::string& name)>& leavesOut, std::vector<BodyIntegrals>& bodies)
{
  CountedTexts names;
  const auto end = std::remove_if(bodies.begin(), bodies.end(),
    [&](const BodyIntegrals& body)
    {
      if (!leavesOut(body.Name))
      {
        return false;
      }
      names.Add(body.GetLabel());
      return true;
    });
  bodies.erase(end, bodies.end());
  return names.GetTotal() == 0
    ? std::string()
    : "the materials leave out " + FormatCount(names.GetTotal(), "body", "bodies") + ": " + names.List();
}

void CheckTopology(BodyIntegrals& body)
{
  body.Status = Status::Ok;
  const std::vector<std::string>& said = body.Model->GetMessages();
  body.Messages.insert(body.Messages.end(), said.begin(), said.end());
  if (body.Model->GetNumberOfMissingFaces() > 0)
  {
    body.Flag(Status::Suspect,
      FormatCount(body.Model->GetNumberOfMissingFaces(), "face", "faces") +
        " of the file could not be carried over");
  }
  if (body.Model->GetNumberOfDefects() > 0)
  {
    body.Flag(Status::Suspect,
      FormatCount(body.Model->GetNumberOfDefects(), "defect", "defects") +
        " in the file's loops, edges or instances");
  }
  if (!IsRigid(body.Placement))
  {
    body.Flag(Status::Suspect,
      "its placement scales, shears or projects it, or is not finite; only rotations, mirrors and "
      "translations are supported");
  }
  const double size = GetRadius(*body.Model);
  if (size > 0.0 && !(size >= MinSize && size <= MaxSize))
  {
    body.Flag(Status::Suspect,
      "its size, " + FormatBound(size) +
        ", is beyond 1e-40 to 1e40: products of lengths leave the range of doubles");
  }
  CountOpenEdges(body);
}

double SumClosing(const std::vector<BodyIntegrals>& bodies, std::size_t integrand)
{
  double sum = 0.0;
  for (const BodyIntegrals& body : bodies)
  {
    const bool isKnown = integrand < body.Value.size() && integrand < body.FaceValue.size();
    sum += isKnown ? std::abs(body.Value[integrand] - body.FaceValue[integrand])
                   : std::numeric_limits<double>::quiet_NaN();
  }
  return sum;
}

void SetUnknown(BodyIntegrals& body, std::size_t integrands)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  body.Value.assign(integrands, nan);
  body.FaceValue.assign(integrands, nan);
  body.Bound.assign(integrands, nan);
  body.MeasuredBound.assign(integrands, nan);
  body.GapSquared = body.GapArea = body.MaxGap = nan;
  CheckTopology(body);
  body.Flag(Status::NotComputed, "nothing was computed");
}

namespace
{
/// The distances of trim curve and edge add along the edge; the square of the face's own gap has been
/// counted.
double GetOverhangSquared(const FaceIntegrals& face)
{
  return face.Outside.Squared + 2.0 * std::sqrt(face.Outside.Squared * face.GapSquared);
}

/// The strip between the border of a surface and the trim curves beyond it is a gap of the model, next to
/// that between the trim curves and the edges.
void AddOverhang(BodyIntegrals& body, std::size_t index, const std::string& label)
{
  const FaceIntegrals& face = (*body.Faces)[index];
  const Overhang& outside = face.Outside;
  const std::string message = label + ": a trim curve leaves the surface" +
    (std::isfinite(outside.Distance)
        ? (face.IsContinued ? " by at most " : " by about ") + FormatBound(outside.Distance)
        : std::string(", by how much is not known"));
  if (!face.IsContinued)
  {
    body.Flag(Status::Suspect, message);
    body.FaceDefects.push_back({ { index }, "a trim curve leaves the surface", false, outside.Area });
    return;
  }
  body.Messages.push_back(message + ", to which the surface is continued");
  body.MaxOverhang = GetLargerGap(body.MaxOverhang, outside.Distance + face.MaxGap);
  body.MaxGap = GetLargerGap(body.MaxGap, outside.Distance + face.MaxGap);
  body.GapArea += outside.Area;
  body.GapSquared += GetOverhangSquared(face);
}
}

void SumFaces(BodyIntegrals& body, const std::vector<Integrand>& integrands)
{
  CheckTopology(body);
  const double size = GetRadius(*body.Model);
  for (std::size_t i = 0; i < body.Faces->size(); ++i)
  {
    const FaceIntegrals& result = (*body.Faces)[i];
    const Face& source = *body.Model->GetFaces()[i];
    const std::string label = "face #" + std::to_string(source.FileId);
    if (!result.Error.empty())
    {
      body.Flag(Status::Suspect, result.Error + "; it is left out");
      body.FaceDefects.push_back({ { i }, "left out", true });
      continue;
    }
    for (const std::string& message : source.Messages)
    {
      body.Messages.push_back(label + ": " + message);
    }
    body.GapSquared += result.GapSquared;
    body.GapArea += result.GapArea;
    body.MaxGap = GetLargerGap(body.MaxGap, result.MaxGap);
    if (result.Estimated)
    {
      body.EstimatedFaces.push_back(source.FileId);
    }
    body.SkippedFaces += result.Skipped ? 1 : 0;
    if (result.LeftOut)
    {
      body.LeftOutFaces.push_back(source.FileId);
    }
    if (result.CoverageDefects > 0)
    {
      body.Flag(
        Status::Suspect, label + ": a loop covers part of the surface more than once or from outside");
      body.FaceDefects.push_back({ { i }, "a loop covers part of it more than once or from outside", true });
    }
    if (result.Overlap != 0.0 && !(result.Overlap <= LargeOverhang * size))
    {
      body.Messages.push_back(label + ": its loops overlap by at most " + FormatBound(result.Overlap) +
        ", next to gaps at their corners");
    }
    body.MaxOverlap = GetLargerGap(body.MaxOverlap, result.Overlap);
    body.MaxGap = GetLargerGap(body.MaxGap, result.Overlap);
    if (result.Outside.Distance > LargeOverhang * size)
    {
      AddOverhang(body, i, label);
    }
  }
  SumValues(body, integrands);
  if (body.SkippedFaces > 0)
  {
    body.Flag(Status::ToleranceNotMet,
      "the run was stopped: " + std::to_string(body.SkippedFaces) +
        " faces were not integrated; they count as 0, and the bounds include their largest possible "
        "magnitude");
  }
  if (!body.LeftOutFaces.empty())
  {
    body.Flag(Status::ToleranceNotMet,
      FormatCount(body.LeftOutFaces.size(), "face", "faces") + " (" + ListIds(body.LeftOutFaces) +
        ") could not be integrated with a bound, because weights of the surface differ too much; integrals "
        "there count "
        "as 0, and the bounds include their largest possible magnitude");
  }
  const bool everything = std::any_of(
    integrands.begin(), integrands.end(), [](const Integrand& integrand) { return integrand.Degree < 0; });
  if (everything && body.IsEstimated())
  {
    body.Messages.push_back("the bounds are estimated from the differences of two orders");
  }
  else if (body.IsEstimated())
  {
    body.Messages.push_back("the bound of the area is estimated on " +
      FormatCount(body.EstimatedFaces.size(), "face", "faces") + " (" + ListIds(body.EstimatedFaces) +
      "), whose normals nearly vanish somewhere or are those of a fitted surface");
  }
}

void SumValues(BodyIntegrals& body, const std::vector<Integrand>& integrands)
{
  const std::size_t count = integrands.size();
  std::vector<CompensatedSum> face(count);
  std::vector<CompensatedSum> all(count);
  body.Bound.assign(count, 0.0);
  body.MeasuredBound.assign(count, 0.0);
  body.Value.assign(count, 0.0);
  body.FaceValue.assign(count, 0.0);
  bool complete = body.Model->GetNumberOfMissingFaces() == 0 && !body.Faces->empty();
  for (std::size_t i = 0; i < body.Faces->size(); ++i)
  {
    const FaceIntegrals& result = (*body.Faces)[i];
    if (!result.Error.empty())
    {
      complete = false;
      continue;
    }
    for (std::size_t k = 0; k < count; ++k)
    {
      const double side = integrands[k].ClosedChain ? body.GetSide(i) : 1.0;
      face[k].Add(side * result.Face[k]);
      all[k].Add(side * result.Face[k]);
      all[k].Add(side * result.Closing[k]);
      body.Bound[k] += result.GetBound(k);
      body.MeasuredBound[k] += result.Rounding[k] + result.Residual[k];
    }
  }
  for (std::size_t k = 0; k < count; ++k)
  {
    body.Value[k] = all[k].Get();
    body.FaceValue[k] = face[k].Get();
    body.Bound[k] +=
      complete ? 4.0 * UnitRoundoff * std::abs(body.Value[k]) : std::numeric_limits<double>::infinity();
  }
}

double GetExcused(double limit, double size, double excuse)
{
  return limit >= 1.0 ? std::numeric_limits<double>::infinity()
                      : std::max(limit * size, std::min(excuse, 10.0 * limit * size));
}

namespace
{
void FlagOverhangs(BodyIntegrals& body, double excused)
{
  for (std::size_t i = 0; i < body.Faces->size(); ++i)
  {
    const FaceIntegrals& face = (*body.Faces)[i];
    if (face.IsContinued && !(face.Outside.Distance + face.MaxGap <= excused))
    {
      body.FaceDefects.push_back({ { i }, "trim curves and edges lie beyond its surface", false,
        face.Outside.Area, GetOverhangSquared(face) });
    }
  }
}

void FlagOverlaps(BodyIntegrals& body, double excused)
{
  for (std::size_t i = 0; i < body.Faces->size(); ++i)
  {
    if (!((*body.Faces)[i].Overlap <= excused))
    {
      body.FaceDefects.push_back({ { i }, "loops of it overlap", true });
    }
  }
}

void FlagUncertainty(const ShellOrientation& found, BodyIntegrals& body)
{
  if (!found.Uncertainty.empty())
  {
    body.Flag(Status::Suspect, found.Uncertainty + "; its shells are taken as the file orients them");
    body.FaceDefects.push_back({ found.Uncertain, found.Uncertainty, true });
  }
}
}

void MeasureEdges(std::vector<BodyIntegrals>& bodies, double limit, bool reportSmall)
{
  using Key = std::pair<vtkTrimmedNURBSModel*, const std::vector<FaceIntegrals>*>;
  std::map<Key, std::shared_ptr<const std::vector<EdgeGap>>> known;
  for (BodyIntegrals& body : bodies)
  {
    auto& edges = known[{ body.Model, body.Faces.get() }];
    if (!edges)
    {
      edges = std::make_shared<const std::vector<EdgeGap>>(CollectEdgeGaps(*body.Model, body.Faces.get()));
    }
    body.Edges = edges;
    const double diagonal = 2.0 * GetRadius(*body.Model);
    const std::string message = DescribeWorstEdge(*edges, diagonal, body.Model->GetLengthUnit());
    const double widest = edges->empty() ? 0.0 : edges->front().MaxGap;
    const double excused = GetExcused(limit, diagonal, 2.0 * body.Model->GetFileUncertainty());
    body.ExcusedGap = excused;
    if (!(body.MaxOverhang <= excused))
    {
      FlagOverhangs(body, excused);
      body.Flag(Status::Suspect,
        "trim curves and edges lie beyond the surface of their face" +
          (std::isfinite(body.MaxOverhang / diagonal)
              ? ", by up to " + FormatDigits(100.0 * body.MaxOverhang / diagonal, 2) + " % of the body's size"
              : std::string()));
    }
    if (body.MaxOverlap != 0.0 && !(body.MaxOverlap <= excused))
    {
      FlagOverlaps(body, excused);
      body.Flag(Status::Suspect,
        "loops of a face overlap by " + FormatDigits(100.0 * body.MaxOverlap / diagonal, 2) +
          " % of the body's size");
    }
    if (widest > excused)
    {
      body.Flag(Status::Suspect,
        (message.empty() ? "the widest gap between a face and its edge" : message) + ": " +
          FormatDigits(100.0 * widest / diagonal, 2) + " % of its size");
    }
    else if (!message.empty() && reportSmall)
    {
      body.Messages.push_back(message);
    }
  }
}

void MeasureSpreads(ClosingSpreads& spreads, std::vector<BodyIntegrals>& bodies)
{
  std::map<vtkTrimmedNURBSModel*, std::shared_ptr<const ClosingSpread>> known;
  std::map<const std::vector<EdgeGap>*, std::shared_ptr<const std::vector<EdgeGap>>> measured;
  for (BodyIntegrals& body : bodies)
  {
    auto& spread = known[body.Model];
    spread = spread ? spread : spreads.Measure(*body.Model);
    body.Spread = spread;
    auto& edges = measured[body.Edges.get()];
    if (!edges && body.Edges)
    {
      std::unordered_map<const Edge*, double> volumes;
      for (const ClosingSpreadEntry& entry : *spread)
      {
        volumes[entry.Source] = entry.Spread->GetVolume();
      }
      auto copy = std::make_shared<std::vector<EdgeGap>>(*body.Edges);
      for (EdgeGap& edge : *copy)
      {
        const auto found = volumes.find(edge.Source);
        edge.Spread = found != volumes.end() ? found->second : edge.Spread;
      }
      edges = copy;
    }
    body.Edges = edges;
  }
  spreads.EndRun();
}

void CheckShells(BodyIntegrals& body)
{
  const std::size_t faces = body.Model->GetFaces().size();
  if (body.OpenEdges > 0 || body.Model->GetShells().size() < 2)
  {
    return;
  }
  std::vector<double> volumes(faces, 0.0);
  const double* const origin = body.Model->GetOrigin();
  const std::array<double, 16>& m = body.Placement;
  Vector3 center;
  for (int d = 0; d < 3; ++d)
  {
    center[d] = m[4 * d] * origin[0] + m[4 * d + 1] * origin[1] + m[4 * d + 2] * origin[2] + m[4 * d + 3];
  }
  const double side = vtkMatrix4x4::Determinant(m.data()) < 0.0 ? -1.0 : 1.0;
  const std::vector<WholeSphere> spheres = FindWholeSpheres(body.Model->GetFaces());
  const auto isSphere = [&spheres](std::size_t face) { return !spheres.empty() && spheres[face]; };
  VisitTriangles(body.Mesh, faces,
    [&](std::size_t face, const std::array<Vector3, 3>& corners, const std::array<Vector3, 3>&)
    {
      const Vector3 twice = Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]));
      volumes[face] += isSphere(face) ? 0.0 : side * Dot(Subtract(corners[0], center), twice) / 6.0;
    });
  for (std::size_t face = 0; face < faces; ++face)
  {
    volumes[face] = isSphere(face) ? spheres[face].GetSignedVolume() : volumes[face];
  }
  const ShellOrientation found =
    OrientShells(*body.Model, body.Mesh, volumes, std::vector<double>(faces, 0.0));
  FlagUncertainty(found, body);
  if (!found.Sides.empty())
  {
    body.Flag(Status::Suspect,
      std::to_string(found.Flipped) + " of " + std::to_string(found.Shells) +
        " shells are inside out in the file, and are taken so: correct the file");
  }
}

void ReverseShells(BodyIntegrals& body, const std::vector<Integrand>& integrands, int volume)
{
  std::vector<double> volumes;
  std::vector<double> bounds;
  for (const FaceIntegrals& face : *body.Faces)
  {
    // A face that could not be integrated leaves its shell open; the body already is suspect.
    if (face.Error.empty() && body.OpenEdges == 0)
    {
      volumes.push_back(face.Face[volume] + face.Closing[volume]);
      // The paper's schemes have no bound: their values are used as exact ones.
      const double bound = face.GetBound(volume);
      bounds.push_back(std::isnan(bound) ? 0.0 : bound);
    }
  }
  ShellOrientation found;
  found.Shells = std::max(1, static_cast<int>(body.Model->GetShells().size()));
  if (volumes.size() == body.Faces->size())
  {
    found = OrientShells(*body.Model, body.Mesh, volumes, bounds);
  }
  FlagUncertainty(found, body);
  if (!found.Sides.empty())
  {
    body.Sides = found.Sides;
    body.FlippedShells = found.Flipped;
    body.Messages.push_back(std::to_string(found.Flipped) + " of " + std::to_string(found.Shells) +
      (found.Flipped == 1 ? " shells was inside out and was reversed"
                          : " shells were inside out and were reversed"));
    SumValues(body, integrands);
  }
  // A sum without some faces may be negative although the solid is not inside out.
  const bool isSignKnown = (body.SkippedFaces == 0 && body.LeftOutFaces.empty()) ||
    std::abs(body.Value[volume]) > body.Bound[volume];
  if (body.Value[volume] < 0.0 && isSignKnown)
  {
    body.InsideOut = true;
    body.FlippedShells = found.Shells;
    body.Messages.push_back("the solid is inside out in the file; it was reversed");
  }
}
}

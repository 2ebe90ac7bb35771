#include "Detail/smFaceTolerances.h"

#include "Detail/smMassSensitivity.h"
#include "Detail/smMassSpread.h"
#include "Detail/smOffsetGeometry.h"
#include "smBodyIntegrals.h"
#include "smEdgeLines.h"
#include "smFormat.h"
#include "smMassIntegrands.h"
#include "smMaterials.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

namespace sm
{
namespace
{
/// Largest number of faces that a message lists.
constexpr std::size_t NamedFaces = 5;
/// Relative excess of sums of bounds over their rounding.
constexpr double SumExcess = 1.0 + 1e-12;

std::string FormatColor(const std::array<double, 3>& color)
{
  char text[8];
  const auto get = [&color](int i) { return static_cast<unsigned>(std::lround(255.0 * color[i])) & 255u; };
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", get(0), get(1), get(2));
  return text;
}

bool Fits(const FaceToleranceRule& rule, const BodyIntegrals& body, const Face& face)
{
  switch (rule.By)
  {
    case FaceToleranceRule::Kind::Face:
      return rule.Pattern == "#" + std::to_string(face.FileId) ||
        (!face.Name.empty() && MatchesPattern(rule.Pattern, face.Name));
    case FaceToleranceRule::Kind::Part:
      return MatchesPattern(rule.Pattern, body.Name);
    case FaceToleranceRule::Kind::Color:
      return face.Color[0] >= 0.0 && MatchesPattern(rule.Pattern, FormatColor(face.Color));
  }
  return false;
}

/// Sums over the faces of some bodies about a common centre.
class ToleranceSums
{
public:
  ToleranceSums(const MassProperties& properties, const FaceToleranceOptions& options)
    : Properties(properties)
    , ByNormal(options.IsNormal)
  {
    this->Bounds.Reference = properties.Center;
    this->Change[0] = this->Change[1] = 0.0;
  }

  /// `density` is what a volume that is added weighs, in mass per volume in model units; NaN without one.
  void Add(const BodyIntegrals& body, const MassRow& row, const OffsetGeometry& geometry,
    const std::vector<OffsetRange>& ranges, const OffsetChange& lower, const OffsetChange& upper,
    double density)
  {
    Vector3 way;
    for (int d = 0; d < 3; ++d)
    {
      way[d] = this->Properties.Center[d] - row.Properties.Center[d];
    }
    double areaError = 0.0;
    double thickness = 0.0;
    Vector3 reach{};
    // A solid of the set may grow at one place and shrink at another.
    const double movable = lower.Second + upper.Second;
    const double step = std::max(lower.Reach, upper.Reach);
    for (std::size_t f = 0; f < ranges.size(); ++f)
    {
      AreaMoments moments = GetAreaMoments(body, row, f);
      moments.Move(way);
      const double largest = ranges[f].GetLargest();
      const Box box = this->GetBox(body, geometry.Faces[f]);
      for (int d = 0; d < 3; ++d)
      {
        reach[d] = std::max({ reach[d], std::abs(box.Low[d]), std::abs(box.High[d]) });
      }
      this->AddFirstOrder(moments, box, largest);
      this->AddDeviation(moments, ranges[f], density);
      areaError += largest * moments.AreaBound;
      thickness += 0.5 * (ranges[f].Lower * ranges[f].Lower + ranges[f].Upper * ranges[f].Upper) *
        (moments.Area + moments.AreaBound);
    }
    const double changes[2] = { lower.Volume - lower.Remainder - areaError,
      upper.Volume + upper.Remainder + areaError };
    for (int i = 0; i < 2; ++i)
    {
      this->Change[i] += changes[i];
      this->MassChange[i] += density * changes[i];
    }
    for (int d = 0; d < 3; ++d)
    {
      reach[d] += step;
      this->Bounds.FirstBound[d] += movable * reach[d] + thickness;
    }
    constexpr int pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
    for (int k = 0; k < 6; ++k)
    {
      const double a = reach[pairs[k][0]];
      const double b = reach[pairs[k][1]];
      this->Bounds.SecondBound[k] += movable * a * b + thickness * (a + b + step);
    }
  }

  ToleranceRow Finish(const MassRow& row)
  {
    ToleranceRow result;
    const double v = row.Properties.Volume;
    const double bound = row.Properties.VolumeBound;
    result.VolumeLower = std::max(v - bound + SumExcess * this->Change[0], 0.0);
    result.VolumeUpper = v + bound + SumExcess * this->Change[1];
    result.VolumeDeviation = std::sqrt(this->Variance);
    result.MassLower = std::max(row.Mass - row.MassBound + SumExcess * this->MassChange[0], 0.0);
    result.MassUpper = row.Mass + row.MassBound + SumExcess * this->MassChange[1];
    result.MassDeviation = std::sqrt(this->MassVariance);
    this->Bounds.VolumeBound = SumExcess * std::max(std::abs(this->Change[0]), std::abs(this->Change[1]));
    const MassSpread spread = ComputeSpread({ this->Bounds }, v - bound, this->Properties.Center);
    result.CenterReach = SumExcess * spread.Center;
    result.InertiaReach = SumExcess * spread.Inertia;
    result.PrincipalReach = SumExcess * spread.Principal;
    for (int d = 0; d < 3; ++d)
    {
      result.CenterDeviation[d] = std::sqrt(this->CenterVariance[d]) / v;
      result.PrincipalDeviation[d] = std::sqrt(this->PrincipalVariance[d]);
    }
    for (int k = 0; k < 9; ++k)
    {
      result.InertiaDeviation[k] = std::sqrt(this->InertiaVariance[k]);
    }
    return result;
  }

private:
  struct Box
  {
    Vector3 Low, High;
  };

  /// Returns a box of the face relative to the centre, in axes of the world.
  Box GetBox(const BodyIntegrals& body, const OffsetFace& face) const
  {
    Box box;
    box.Low.fill(std::numeric_limits<double>::infinity());
    box.High.fill(-box.Low[0]);
    for (int corner = 0; corner < 8; ++corner)
    {
      Vector3 stored;
      for (int d = 0; d < 3; ++d)
      {
        stored[d] = (corner >> d & 1) != 0 ? face.High[d] : face.Low[d];
      }
      const Vector3 point = PlacePoint(*body.Model, body.Placement.data(), stored);
      for (int d = 0; d < 3; ++d)
      {
        box.Low[d] = std::min(box.Low[d], point[d] - this->Properties.Center[d]);
        box.High[d] = std::max(box.High[d], point[d] - this->Properties.Center[d]);
      }
    }
    return box;
  }

  /// Adds no less than the integrals of |x_j| and |x_j x_k| over the face: those of x_j and x_j x_k where the
  /// sign does not change, else by the inequality of Cauchy and Schwarz.
  void AddFirstOrder(const AreaMoments& moments, const Box& box, double offset)
  {
    const double error = this->Properties.CenterBound;
    bool isOneSided[3];
    double squares[3];
    for (int d = 0; d < 3; ++d)
    {
      isOneSided[d] = box.Low[d] >= 0.0 || box.High[d] <= 0.0;
      squares[d] = std::max(moments.Second[d][d], 0.0) + moments.SecondBound;
      const double first = isOneSided[d] ? std::abs(moments.First[d]) + moments.FirstBound
                                         : std::sqrt((moments.Area + moments.AreaBound) * squares[d]);
      this->Bounds.FirstBound[d] += offset * (first + error * moments.Area);
    }
    constexpr int pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
    for (int k = 0; k < 6; ++k)
    {
      const int i = pairs[k][0];
      const int j = pairs[k][1];
      this->Bounds.SecondBound[k] += offset *
        (isOneSided[i] && isOneSided[j] ? std::abs(moments.Second[i][j]) + moments.SecondBound
                                        : std::sqrt(squares[i] * squares[j]));
    }
  }

  void AddDeviation(const AreaMoments& moments, const OffsetRange& range, double density)
  {
    const double sigma = 0.5 * (range.Upper - range.Lower) / (this->ByNormal ? 3.0 : std::sqrt(3.0));
    const auto square = [sigma](double slope) { return sigma * sigma * slope * slope; };
    this->Variance += square(moments.Area);
    this->MassVariance += square(density * moments.Area);
    double bound;
    const std::array<double, 3> principal = GetPrincipalSlopes(this->Properties, moments, bound);
    const double trace = moments.Second[0][0] + moments.Second[1][1] + moments.Second[2][2];
    for (int i = 0; i < 3; ++i)
    {
      this->CenterVariance[i] += square(moments.First[i]);
      this->PrincipalVariance[i] += square(principal[i]);
      for (int j = 0; j < 3; ++j)
      {
        this->InertiaVariance[3 * i + j] += square((i == j ? trace : 0.0) - moments.Second[i][j]);
      }
    }
  }

  const MassProperties& Properties;
  bool ByNormal;
  /// Changes of the moments about the centre, without signs.
  Moments Bounds;
  double Change[2];
  double MassChange[2] = { 0.0, 0.0 };
  double Variance = 0.0;
  double MassVariance = 0.0;
  double CenterVariance[3] = { 0.0, 0.0, 0.0 };
  double PrincipalVariance[3] = { 0.0, 0.0, 0.0 };
  double InertiaVariance[9] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
};

std::string NameFaces(const BodyIntegrals& body, const std::vector<std::size_t>& faces)
{
  std::string text;
  for (std::size_t i = 0; i < std::min(faces.size(), NamedFaces); ++i)
  {
    text += (i > 0 ? ", #" : " #") + std::to_string(body.Model->GetFaces()[faces[i]]->FileId);
  }
  return text + (faces.size() > NamedFaces ? ", ..." : "");
}

/// Reports faces at which the worst case is not of third order, once for each model.
void ReportFaces(const BodyIntegrals& body, const OffsetChange& lower, const OffsetChange& upper,
  std::vector<std::string>& messages)
{
  const std::string name = body.Name.empty() ? "" : body.Name + ": ";
  const auto report = [&](std::vector<std::size_t> faces, const std::vector<std::size_t>& more,
                        const char* one, const char* many)
  {
    faces.insert(faces.end(), more.begin(), more.end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    if (!faces.empty())
    {
      const std::string text = name + FormatCount(faces.size(), one, many) +
        ", so that the worst case is wide there:" + NameFaces(body, faces);
      if (std::find(messages.begin(), messages.end(), text) == messages.end())
      {
        messages.push_back(text);
      }
    }
  };
  report(lower.TightFaces, upper.TightFaces,
    "face has a curvature radius that is not well above its tolerance",
    "faces have curvature radii that are not well above their tolerances");
  report(lower.NarrowFaces, upper.NarrowFaces, "face is about as narrow as the tolerances",
    "faces are about as narrow as the tolerances");
}

/// Returns why the worst case of a solid is not known, with its consequence and remedy.
std::string ExplainUnknown(
  const BodyIntegrals& body, const OffsetGeometry& geometry, const std::vector<std::size_t>& unmet)
{
  const std::string name = body.GetLabel();
  if (!unmet.empty())
  {
    return name +
      ": what tolerances leave open is not known, since faces with different tolerances meet at less than 6 "
      "degrees, which does not say where they meet when they are moved; give them one tolerance:" +
      NameFaces(body, unmet);
  }
  std::vector<std::size_t> creased;
  for (std::size_t f = 0; f < geometry.Faces.size(); ++f)
  {
    if (geometry.Faces[f].IsCreased)
    {
      creased.push_back(f);
    }
  }
  if (!creased.empty())
  {
    return name +
      ": what tolerances leave open is not known, since there are creases, corners or borders of faces that "
      "are not edges of the model; split the faces there, with edges that both sides share:" +
      NameFaces(body, creased);
  }
  return name +
    ": what tolerances leave open is not known, since an edge is not shared by two faces, a face was not "
    "integrated, or the run was stopped; sew the faces, see the other messages";
}

const char* GetKindName(FaceToleranceRule::Kind kind)
{
  using Kind = FaceToleranceRule::Kind;
  return kind == Kind::Face ? "face" : kind == Kind::Part ? "part" : "colour";
}
}

bool FindToleranceKind(const std::string& name, FaceToleranceRule::Kind& kind)
{
  using Kind = FaceToleranceRule::Kind;
  const bool isColor = name == "colour" || name == "color";
  kind = name == "face" ? Kind::Face : isColor ? Kind::Color : Kind::Part;
  return name == "face" || name == "part" || isColor;
}

double OffsetRange::GetLargest() const
{
  return std::max(std::abs(this->Lower), std::abs(this->Upper));
}

ToleranceRow::ToleranceRow()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->VolumeLower = this->VolumeUpper = this->VolumeDeviation = this->MassLower = this->MassUpper =
    this->MassDeviation = this->CenterReach = this->InertiaReach = this->PrincipalReach = nan;
  this->CenterDeviation.fill(nan);
  this->InertiaDeviation.fill(nan);
  this->PrincipalDeviation.fill(nan);
}

std::vector<FaceToleranceRule> MakeDrawingRules(const std::vector<DrawingTolerance>& tolerances)
{
  std::map<std::int64_t, FaceToleranceRule> ofFaces;
  std::vector<FaceToleranceRule> ofAll;
  const auto narrow = [](const DrawingTolerance& by, FaceToleranceRule& rule)
  {
    if (std::max(-by.Lower, by.Upper) < std::max(-rule.Lower, rule.Upper))
    {
      rule.Lower = by.Lower;
      rule.Upper = by.Upper;
    }
  };
  for (const DrawingTolerance& tolerance : tolerances)
  {
    if (!tolerance.Problem.empty())
    {
      continue;
    }
    for (const std::int64_t face : tolerance.Faces)
    {
      narrow(tolerance,
        ofFaces
          .try_emplace(face,
            FaceToleranceRule{
              FaceToleranceRule::Kind::Face, "#" + std::to_string(face), tolerance.Lower, tolerance.Upper })
          .first->second);
    }
    if (tolerance.IsForAll && ofAll.empty())
    {
      ofAll.push_back({ FaceToleranceRule::Kind::Part, "*", tolerance.Lower, tolerance.Upper });
    }
    else if (tolerance.IsForAll)
    {
      narrow(tolerance, ofAll.front());
    }
  }
  std::vector<FaceToleranceRule> rules;
  for (const auto& [face, rule] : ofFaces)
  {
    rules.push_back(rule);
  }
  rules.insert(rules.end(), ofAll.begin(), ofAll.end());
  return rules;
}

FaceToleranceResults ComputeFaceTolerances(const std::vector<BodyIntegrals>& bodies,
  const std::vector<MassRow>& rows, const MassRow& total, const BodyOffsets& offsets,
  const FaceToleranceOptions& options)
{
  FaceToleranceResults results;
  results.Rows.resize(bodies.size());
  results.Ranges.resize(bodies.size());
  std::vector<char> isUsed(options.Rules.size(), 0);
  ToleranceSums all(total.Properties, options);
  bool isWhole = std::isfinite(total.Properties.Volume);
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    const BodyIntegrals& body = bodies[b];
    const std::vector<FacePointer>& faces = body.Model->GetFaces();
    bool isKnown = offsets.Get(b).IsKnown;
    std::vector<double> areas(faces.size());
    std::vector<double> ends[2];
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      const auto rule = std::find_if(options.Rules.begin(), options.Rules.end(),
        [&](const FaceToleranceRule& candidate) { return Fits(candidate, body, *faces[f]); });
      const bool isFound = rule != options.Rules.end();
      if (isFound && body.IsSolid())
      {
        isUsed[static_cast<std::size_t>(rule - options.Rules.begin())] = 1;
      }
      results.Ranges[b].push_back(
        isFound ? OffsetRange{ rule->Lower, rule->Upper } : OffsetRange{ options.Lower, options.Upper });
      ends[0].push_back(results.Ranges[b].back().Lower);
      ends[1].push_back(results.Ranges[b].back().Upper);
      isKnown = isKnown && HasAreaMoments(body, rows[b], f);
      areas[f] = isKnown ? (*body.Faces)[f].Face[MassArea] : 0.0;
    }
    OffsetChange lower;
    OffsetChange upper;
    if (isKnown)
    {
      lower = EvaluateOffsets(offsets.Get(b), areas, ends[0]);
      upper = EvaluateOffsets(offsets.Get(b), areas, ends[1]);
      isKnown = lower.IsKnown() && upper.IsKnown();
    }
    if (!isKnown)
    {
      if (body.IsSolid())
      {
        std::vector<std::size_t> unmet = lower.UnmetFaces;
        unmet.insert(unmet.end(), upper.UnmetFaces.begin(), upper.UnmetFaces.end());
        std::sort(unmet.begin(), unmet.end());
        unmet.erase(std::unique(unmet.begin(), unmet.end()), unmet.end());
        const std::string text = ExplainUnknown(body, offsets.Get(b), unmet);
        if (std::find(results.Messages.begin(), results.Messages.end(), text) == results.Messages.end())
        {
          results.Messages.push_back(text);
        }
        isWhole = false;
      }
      continue;
    }
    ReportFaces(body, lower, upper, results.Messages);
    ToleranceSums own(rows[b].Properties, options);
    // A stated mass does not change with the volume. What solids have of that of a product changes with the
    // volumes of the others, too, and the sum does not.
    const bool isStated = rows[b].OverriddenMass > 0.0;
    const bool isShared = rows[b].ShareOfProduct > 0.0;
    own.Add(body, rows[b], offsets.Get(b), results.Ranges[b], lower, upper,
      isShared ? vtkMath::Nan() : rows[b].GetAddedDensity());
    results.Rows[b] = own.Finish(rows[b]);
    if (isWhole)
    {
      all.Add(body, rows[b], offsets.Get(b), results.Ranges[b], lower, upper,
        isStated ? 0.0 : rows[b].GetAddedDensity());
    }
  }
  if (isWhole)
  {
    results.Total = all.Finish(total);
  }
  for (std::size_t i = 0; i < isUsed.size(); ++i)
  {
    if (!isUsed[i])
    {
      const FaceToleranceRule& rule = options.Rules[i];
      results.Messages.push_back(std::string("the tolerance for ") + GetKindName(rule.By) + " \"" +
        rule.Pattern + "\" fits no face of a solid and has no effect: check the name; * and ? are wildcards");
    }
  }
  return results;
}
}

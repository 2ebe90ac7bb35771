// TestMomentGradientIdentities [opengl] [entries] FILE.step...: identities that gradients satisfy on any
// closed solid, each within the sum of the bounds:
//
//     sum dV/dP = 0,   sum dM_x/dP = V e_x,   sum P x dV/dP = 0,   sum P . dM_g/dP = (3 + degree of g) M_g,
//     and for each face: sum w dM_g/dw = 0, sum dA/dP = 0, sum P . dA/dP = 2 A, sum w dA/dw = 0.
// With `entries`, each entry at a loose tolerance is compared with that at a tight one, too; with `opengl`
// the gradients are computed by compute shaders.
#include "smComputeMassProperties.h"
#include "smGradientSums.h"
#include "smMomentGradient.h"
#include "smSubnormals.h"
#include "smTestPipeline.h"

#include <cstdlib>

namespace
{
using namespace smtest;

int numberOfSolids = 0;
std::size_t numberOfUnknownAreas = 0;
/// Faces whose bounds of the area's derivatives by points exceed these derivatives, and solids with a sum of
/// bounds above the area.
std::size_t numberOfLargeBounds = 0;
int numberOfLargeSums = 0;
std::size_t numberOfFaces = 0;
double worstRatio = 0.0;
double momentSeconds = 0.0;
double gradientSeconds = 0.0;
double integralSeconds = 0.0;
long long evaluations = 0;

/// The largest deviation of an identity relative to its bound.
struct Worst
{
  double Ratio = 0.0;
  double Deviation = 0.0;
  double Bound = 0.0;
  bool IsNumber = true;
  std::string What;

  void Add(const std::string& what, long double deviation, double bound)
  {
    const double size = std::abs(static_cast<double>(deviation));
    this->IsNumber = this->IsNumber && std::isfinite(size) && std::isfinite(bound);
    const double ratio = size == 0.0 ? 0.0 : size / bound;
    if (ratio > this->Ratio || this->What.empty())
    {
      this->Ratio = ratio;
      this->Deviation = size;
      this->Bound = bound;
      this->What = what;
    }
  }
};

std::string Axis(int c)
{
  return std::string(1, "XYZ"[c]);
}

void CheckSolid(vtkDataObject* model, int solid, const sm::BodyMassProperties& body)
{
  sm::MomentGradientOptions options;
  options.Solids = { solid };
  options.Tied = false;
  const sm::MomentGradientResult result = ComputeGradient(model, options);
  if (!(body.Volume.Bound < std::abs(body.Volume.Value)) || body.OpenEdges > 0 || result.Faces.empty())
  {
    std::printf("     solid %d: %s, left out: %s\n", solid, body.Status.c_str(), result.Reason.c_str());
    return;
  }
  // Moments about the origin, from volume, centre and inertia about the origin.
  const double volume = body.Volume.Value;
  double first[3];
  double firstBound[3];
  for (int c = 0; c < 3; ++c)
  {
    first[c] = volume * body.Center.Value[c];
    firstBound[c] = std::abs(volume) * body.Center.Bound +
      std::abs(body.Center.Value[c]) * body.Volume.Bound + body.Center.Bound * body.Volume.Bound;
  }
  const std::array<double, 9>& i = body.InertiaAtOrigin.Value;
  const double second[6] = { 0.5 * (i[4] + i[8] - i[0]), 0.5 * (i[0] + i[8] - i[4]),
    0.5 * (i[0] + i[4] - i[8]), -i[1], -i[5], -i[2] };
  const double inertiaBound = 1.5 * body.InertiaAtOrigin.Bound + 1e-15 * (i[0] + i[4] + i[8]);

  Worst worst;
  const auto along = [](int c)
  {
    return [c](const auto&, const auto&)
    {
      std::array<double, 3> step{};
      step[c] = 1.0;
      return step;
    };
  };
  const auto grow = [](const auto&, const std::array<double, 4>& p) {
    return std::array<double, 3>{ p[0], p[1], p[2] };
  };
  for (int c = 0; c < 3; ++c)
  {
    const GradientSum sum = SumOverPoints(result, 0, along(c));
    worst.Add("sum of dV/dP", sum.Value, sum.Bound);
    for (int d = 0; d < 3; ++d)
    {
      const GradientSum moment = SumOverPoints(result, 1 + d, along(c));
      worst.Add("sum of dM_" + Axis(d) + "/dP", moment.Value - (c == d ? volume : 0.0),
        moment.Bound + body.Volume.Bound);
    }
    const GradientSum turn = SumOverPoints(result, 0,
      [c](const auto&, const std::array<double, 4>& p)
      {
        std::array<double, 3> step{};
        step[(c + 1) % 3] = -p[(c + 2) % 3];
        step[(c + 2) % 3] = p[(c + 1) % 3];
        return step;
      });
    worst.Add("sum of P x dV/dP", turn.Value, turn.Bound);
  }
  for (int g = 0; g < 10; ++g)
  {
    const GradientSum sum = SumOverPoints(result, g, grow);
    const double degree = g == 0 ? 3.0 : g < 4 ? 4.0 : 5.0;
    const double value = g == 0 ? volume : g < 4 ? first[g - 1] : second[g - 4];
    const double bound = g == 0 ? body.Volume.Bound : g < 4 ? firstBound[g - 1] : inertiaBound;
    worst.Add(std::string("Euler ") + sm::GetGradientQuantities()[g].Name, sum.Value - degree * value,
      sum.Bound + degree * (bound + 1e-15 * std::abs(value)));
  }
  // The area: face by face, where its bounds are known.
  const int q = sm::NumberOfGradientQuantities - 1;
  GradientSum area;
  std::size_t unknownAreas = 0;
  std::size_t large = 0;
  for (const sm::FaceMomentGradient& face : result.Faces)
  {
    for (int g = 0; g < 10; ++g)
    {
      const GradientSum sum = SumOverWeights(face, g);
      worst.Add("sum of w dM/dw", sum.Value, sum.Bound);
    }
    sm::MomentGradientResult alone;
    alone.Faces = { face };
    const GradientSum grown = SumOverPoints(alone, q, grow);
    area.Value += grown.Value;
    area.Bound += grown.Bound;
    double value = 0.0;
    double bound = 0.0;
    for (std::size_t at = q; at < face.Bounds.size(); at += sm::NumberOfGradientQuantities)
    {
      const bool isPoint = at / sm::NumberOfGradientQuantities % 4 < 3;
      value = std::max(value, isPoint ? std::abs(face.Values[at]) : 0.0);
      bound = std::max(bound, isPoint ? face.Bounds[at] : 0.0);
    }
    large += bound > value ? 1 : 0;
    bool isKnown = true;
    for (std::size_t at = q; at < face.Bounds.size(); at += sm::NumberOfGradientQuantities)
    {
      isKnown = isKnown && std::isfinite(face.Bounds[at]);
    }
    if (!isKnown)
    {
      ++unknownAreas;
      continue;
    }
    for (int c = 0; c < 3; ++c)
    {
      const GradientSum sum = SumOverPoints(alone, q, along(c));
      worst.Add("sum of dA/dP", sum.Value, sum.Bound);
    }
    const GradientSum weights = SumOverWeights(face, q);
    worst.Add("sum of w dA/dw", weights.Value, weights.Bound);
  }
  const double areaDeviation = std::abs(static_cast<double>(area.Value) - 2.0 * body.Area.Value);
  if (unknownAreas == 0 && std::isfinite(body.Area.Bound))
  {
    worst.Add("Euler SurfaceArea", static_cast<double>(area.Value) - 2.0 * body.Area.Value,
      area.Bound + 2.0 * body.Area.Bound);
  }
  numberOfUnknownAreas += unknownAreas;
  numberOfLargeBounds += large;
  numberOfLargeSums += area.Bound > body.Area.Value ? 1 : 0;
  numberOfFaces += result.Faces.size();
  worstRatio = std::max(worstRatio, worst.Ratio);
  momentSeconds += result.MomentSeconds;
  gradientSeconds += result.GradientSeconds;
  integralSeconds += result.IntegralSeconds;
  evaluations += result.Evaluations;
  const GradientSum translation = SumOverPoints(result, 0, along(0));
  std::printf(
    "     %-28s %5zu faces, worst %s: %.1e of bound %.1e; bound of sum dV/dP_x %.1e of the area; area "
    "%.1e of %.1e, unknown %zu, large %zu; %.3f s, %.3f s\n",
    body.Name.c_str(), result.Faces.size(), worst.What.c_str(), worst.Ratio, worst.Bound,
    translation.Bound / body.Area.Value, areaDeviation / body.Area.Value, area.Bound / body.Area.Value,
    unknownAreas, large, result.MomentSeconds, result.GradientSeconds);
  // The bound of a sum is that of all control points, several times that of the surface where gaps count.
  CheckTrue("identities within their bounds", worst.IsNumber && worst.Ratio <= 1.0, worst.What);
  ++numberOfSolids;
}

/// Compares each entry at a loose tolerance, where the error of the quadrature is most of it, with that at a
/// tight one: they differ by no more than both bounds.
void CheckEntries(vtkDataObject* model)
{
  sm::MomentGradientOptions options;
  options.RelativeTolerance = 1e-13;
  const sm::MomentGradientResult tight = ComputeGradient(model, options);
  for (const double tolerance : { 1e-1, 1e-4 })
  {
    options.RelativeTolerance = tolerance;
    const sm::MomentGradientResult loose = ComputeGradient(model, options);
    double worst = 0.0;
    double size = 0.0;
    long long entries = 0;
    for (std::size_t f = 0; f < loose.Faces.size(); ++f)
    {
      const sm::FaceMomentGradient& a = loose.Faces[f];
      const sm::FaceMomentGradient& b = tight.Faces[f];
      for (std::size_t k = 0; k < a.Values.size(); ++k)
      {
        const double bound = a.Bounds[k] + b.Bounds[k];
        const double difference = std::abs(a.Values[k] - b.Values[k]);
        if (std::isfinite(bound) && difference > 0.0)
        {
          ++entries;
          worst = std::max(worst, difference / bound);
          size = std::max(size, difference / (std::abs(b.Values[k]) + bound));
        }
      }
    }
    std::printf(
      "     tolerance %.0e: %lld entries differ, by up to %.1e of themselves and %.1e of the bounds\n",
      tolerance, entries, size, worst);
    CheckTrue("entries within their bounds", worst <= 1.0 && tight.Faces.size() == loose.Faces.size());
  }
}

void CheckFile(const std::string& path, bool withEntries)
{
  std::printf("--- %s\n", path.c_str());
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  UseCoarseMesh(reader);
  reader->Update();
  vtkDataObject* model = reader->GetOutputDataObject(0);
  const sm::MassPropertiesResult mass = sm::ComputeMassProperties(model);
  for (std::size_t k = 0; k < mass.Solids.size(); ++k)
  {
    CheckSolid(model, static_cast<int>(k), mass.Solids[k]);
  }
  if (withEntries)
  {
    CheckEntries(model);
  }
}
}

int TestMomentGradientIdentities(int argc, char* argv[])
{
  RequireUsage(argc > 1, "TestMomentGradientIdentities [opengl] [entries] FILE.step...");
  const bool onDevice = std::string(argv[1]) == "opengl";
  GradientTestBackend = onDevice ? sm::BackendChoice::OpenGL : sm::BackendChoice::CPU;
  if (onDevice && FlushesSubnormals())
  {
    return Skipped;
  }
  const int first = onDevice ? 2 : 1;
  const bool withEntries = argc > first && std::string(argv[first]) == "entries";
  for (int k = withEntries ? first + 1 : first; k < argc; ++k)
  {
    CheckFile(argv[k], withEntries);
  }
  std::printf(
    "     %zu faces, %zu of them without a bound of the area's derivatives, %zu with bounds above the "
    "derivatives; %d solids, %d with a sum of bounds above the area; largest deviation %.2f of its bound; "
    "mass properties %.2f s, gradients %.2f s, of these %.2f s for integrals with %lld evaluations\n",
    numberOfFaces, numberOfUnknownAreas, numberOfLargeBounds, numberOfSolids, numberOfLargeSums, worstRatio,
    momentSeconds, gradientSeconds, integralSeconds, evaluations);
  CheckEqual(
    "faces without a bound of the area's derivatives", 0, static_cast<long long>(numberOfUnknownAreas));
  if (!withEntries)
  {
    // Of the real files two long trimmed faces of occt_linkrods. Some of the small solids have weights of 1
    // and 1000.
    CheckRange("faces with bounds above the derivatives", 0, static_cast<double>(numberOfLargeBounds), 2);
    CheckRange("solids with a sum of bounds above the area", 0, numberOfLargeSums, 1);
  }
  CheckRange("closed solids", 1, numberOfSolids, 1e9);
  return Finish();
}

// TestMomentGradientIdentities FILE.step...: identities that gradients satisfy on any closed solid, each
// within the sum of the bounds:
//
//     sum dV/dP = 0,   sum dM_x/dP = V e_x,   sum P x dV/dP = 0,   sum P . dM_g/dP = (3 + degree of g) M_g,
//     and for each face: sum w dM_g/dw = 0, sum dA/dP = 0, sum P . dA/dP = 2 A, sum w dA/dw = 0.
#include "smComputeMassProperties.h"
#include "smGradientSums.h"
#include "smMomentGradient.h"
#include "smTestPipeline.h"

#include <cstdlib>

namespace
{
using namespace smtest;

int numberOfSolids = 0;
std::size_t numberOfUnknownAreas = 0;

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
  const sm::MomentGradientResult result = sm::ComputeMomentGradient(model, options);
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
  const GradientSum translation = SumOverPoints(result, 0, along(0));
  std::printf(
    "     %-28s %5zu faces, worst %s: %.1e of bound %.1e; bound of sum dV/dP_x %.1e of the area; area "
    "%.1e of %.1e, unknown %zu; %.3f s, %.3f s\n",
    body.Name.c_str(), result.Faces.size(), worst.What.c_str(), worst.Ratio, worst.Bound,
    translation.Bound / body.Area.Value, areaDeviation / body.Area.Value, area.Bound / body.Area.Value,
    unknownAreas, result.MomentSeconds, result.GradientSeconds);
  // The bound of a sum is that of all control points, several times that of the surface where gaps count.
  CheckTrue("identities within their bounds", worst.IsNumber && worst.Ratio <= 1.0, worst.What);
  ++numberOfSolids;
}

void CheckFile(const std::string& path)
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
}
}

int TestMomentGradientIdentities(int argc, char* argv[])
{
  RequireUsage(argc > 1, "TestMomentGradientIdentities FILE.step...");
  for (int k = 1; k < argc; ++k)
  {
    CheckFile(argv[k]);
  }
  std::printf("     %zu faces without a bound of the area's derivatives\n", numberOfUnknownAreas);
  CheckRange("closed solids", 1, numberOfSolids, 1e9);
  return Finish();
}

// TestMassTolerances: what tolerances of faces leave open, against closed forms of box, wedge, cylinder,
// bracket, ball and torus whose faces are moved, and 100,000 random offsets.
#include "smBoxBodies.h"
#include "smMessageTrap.h"
#include "smPrismBody.h"
#include "smTestPipeline.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkMassTolerances.h>
#include <vtkMatrix4x4.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <functional>
#include <random>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// Offsets of the faces of a solid, and its volume with these.
using ExactVolume = std::function<double(const std::vector<double>&)>;

double GetTotal(vtkMassTolerances* filter, const char* name, int component = 0)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, component) : vtkMath::Nan();
}

vtkSmartPointer<vtkMassTolerances> RunTolerances(vtkNURBSDataSet* leaf, double lower, double upper)
{
  auto filter = vtkSmartPointer<vtkMassTolerances>::New();
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetDensity(7850.0);
  filter->SetInputDataObject(leaf);
  filter->SetFaceTolerance(lower, upper);
  filter->Update();
  return filter;
}

/// Area of a polygon whose sides are moved outwards.
double GetPolygonArea(const std::vector<sm::Point2>& corners, const std::vector<double>& offsets)
{
  const std::size_t n = corners.size();
  std::vector<sm::Point2> moved;
  const auto getSide = [&](std::size_t i)
  {
    const sm::Point2& a = corners[i % n];
    const sm::Point2& b = corners[(i + 1) % n];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const sm::Point2 normal{ (b[1] - a[1]) / length, (a[0] - b[0]) / length };
    return std::array<double, 3>{ normal[0], normal[1],
      normal[0] * a[0] + normal[1] * a[1] + offsets[i % n] };
  };
  for (std::size_t i = 0; i < n; ++i)
  {
    const auto p = getSide(i);
    const auto q = getSide(i + 1);
    const double det = p[0] * q[1] - p[1] * q[0];
    moved.push_back({ (p[2] * q[1] - p[1] * q[2]) / det, (p[0] * q[2] - p[2] * q[0]) / det });
  }
  double area = 0.0;
  for (std::size_t i = 0; i < n; ++i)
  {
    const sm::Point2& a = moved[i];
    const sm::Point2& b = moved[(i + 1) % n];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return area;
}

struct ToleranceCase
{
  std::string Name;
  vtkSmartPointer<vtkNURBSDataSet> Leaf;
  std::size_t Faces;
  /// Faces from the first to this one have one offset, since they are tangent.
  std::size_t Together;
  ExactVolume Volume;
  double Tolerance;
  /// Largest distance of the interval's ends from the closed form, relative to the third power of the
  /// tolerance; 0: it is exact.
  double Slack;
};

ToleranceCase MakePolygonCase(
  const std::string& name, const std::vector<sm::Point2>& corners, double height, double t)
{
  std::vector<ProfilePiece> profile;
  for (const sm::Point2& corner : corners)
  {
    profile.push_back({ corner });
  }
  const std::size_t n = corners.size();
  return { name, PrismBody(profile, height).Make(), n + 2, 1,
    [=](const std::vector<double>& offsets)
    { return GetPolygonArea(corners, offsets) * (height + offsets[n] + offsets[n + 1]); },
    t, 0.0 };
}

std::vector<ToleranceCase> MakeToleranceCases()
{
  std::vector<ToleranceCase> cases;
  cases.push_back(MakePolygonCase("box", { { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 } }, 10.0, 0.1));
  cases.push_back(MakePolygonCase("wedge", { { 1, 2 }, { 21, 2 }, { 6, 12 } }, 7.0, 0.05));
  cases.push_back(
    MakePolygonCase("angle", { { 0, 0 }, { 30, 0 }, { 30, 5 }, { 5, 8 }, { 4, 40 }, { 0, 40 } }, 12.0, 0.2));
  const double r = 5.0;
  cases.push_back({ "cylinder",
    PrismBody({ { { r, 0 }, true, { 0, 0 } }, { { 0, r }, true, { 0, 0 } }, { { -r, 0 }, true, { 0, 0 } },
                { { 0, -r }, true, { 0, 0 } } },
      8.0)
      .Make(),
    6, 4,
    [r](const std::vector<double>& t)
    { return vtkMath::Pi() * (r + t[0]) * (r + t[0]) * (8.0 + t[4] + t[5]); },
    0.1, 60.0 });
  // Six straight sides of an angle, a fillet of radius 3 inside, and one of radius 8 outside.
  const std::vector<ProfilePiece> bracket = { { { 8, 0 } }, { { 60, 0 } }, { { 60, 5 } },
    { { 8, 5 }, true, { 8, 8 } }, { { 5, 8 } }, { { 5, 40 } }, { { 0, 40 } }, { { 0, 8 }, true, { 8, 8 } } };
  // Area of both legs, with what the fillets fill and cut off; and with one offset of all sides.
  const double area =
    60.0 * 5.0 + 35.0 * 5.0 + (9.0 - 9.0 * vtkMath::Pi() / 4.0) - (64.0 - 16.0 * vtkMath::Pi());
  const double length = 52.0 + 5.0 + 52.0 + 1.5 * vtkMath::Pi() + 32.0 + 5.0 + 32.0 + 4.0 * vtkMath::Pi();
  cases.push_back({ "bracket", PrismBody(bracket, 20.0).Make(), 10, 8,
    [=](const std::vector<double>& t)
    {
      // Four right angles of corners, a quarter turn to the left and one to the right.
      const double section = area + length * t[0] + 4.0 * t[0] * t[0];
      return section * (20.0 + t[8] + t[9]);
    },
    0.1, 300.0 });
  cases.push_back({ "ball", MakeRoundBody({ MakeBall({ 1, 2, 3 }, 4.0) }), 1, 1,
    [](const std::vector<double>& t) { return 4.0 / 3.0 * vtkMath::Pi() * std::pow(4.0 + t[0], 3); }, 0.2,
    0.0 });
  cases.push_back({ "torus", MakeRoundBody({ MakeTorus({ 1, 2, 3 }, 5.0, 2.0) }), 1, 1,
    [](const std::vector<double>& t)
    { return 2.0 * vtkMath::Pi() * vtkMath::Pi() * 5.0 * (2.0 + t[0]) * (2.0 + t[0]); },
    0.2, 0.0 });
  return cases;
}

void CheckToleranceVolume(const ToleranceCase& test)
{
  const double t = test.Tolerance;
  std::printf("--- %s, +- %g\n", test.Name.c_str(), t);
  const auto filter = RunTolerances(test.Leaf, -t, t);
  CheckEqual("status", names::StatusOk, filter->GetStatus());
  const double nominal = test.Volume(std::vector<double>(test.Faces, 0.0));
  // Cubics stand for the arcs on planes.
  Check("nominal volume", nominal, filter->GetVolume(), 1e-8 * nominal, "cubics for arcs");
  const double low = GetTotal(filter, names::VolumeLower);
  const double high = GetTotal(filter, names::VolumeUpper);
  const double rest = test.Slack * t * t * t + 1e-8 * nominal;
  CheckRange("lower end", -1e-8 * nominal, test.Volume(std::vector<double>(test.Faces, -t)) - low, rest);
  CheckRange("upper end", -1e-8 * nominal, high - test.Volume(std::vector<double>(test.Faces, t)), rest);
  const double density = 7850e-9;
  Check("mass", density * high, GetTotal(filter, names::MassUpper), 1e-9 * density * high);
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-t, t);
  int outside = 0;
  double widest = 0.0;
  for (int i = 0; i < 100000; ++i)
  {
    std::vector<double> offsets(test.Faces);
    for (std::size_t f = 0; f < test.Faces; ++f)
    {
      offsets[f] = f > 0 && f < test.Together ? offsets[0] : uniform(random);
    }
    const double volume = test.Volume(offsets);
    outside += volume < low - 1e-8 * nominal || volume > high + 1e-8 * nominal ? 1 : 0;
    widest = std::max(widest, std::abs(volume - nominal));
  }
  CheckEqual("random offsets outside of the interval", 0, outside);
  CheckTrue("which are not all near the middle", widest > 0.4 * (high - nominal));
}

double GetPrismVolume(const std::vector<sm::Point2>& corners, std::vector<double> offsets, double height)
{
  return GetPolygonArea(corners, offsets) * height;
}

/// Neighbours with different tolerances that meet at a few degrees.
void CheckNearlyTangent()
{
  std::printf("--- a roof of 1.5 degrees, one side of which may shrink\n");
  const double rise = 10.0 * std::tan(vtkMath::RadiansFromDegrees(1.5));
  const std::vector<sm::Point2> roof = { { -10, 0 }, { 10, 0 }, { 10, 5 }, { 0, 5 + rise }, { -10, 5 } };
  std::vector<ProfilePiece> profile;
  for (const sm::Point2& corner : roof)
  {
    profile.push_back({ corner });
  }
  vtkNew<vtkMassTolerances> filter;
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputDataObject(PrismBody(profile, 20.0).Make());
  filter->AddTolerance("face", "#102", -0.1, 0.0);
  filter->Update();
  const double nominal = GetPrismVolume(roof, { 0, 0, 0, 0, 0 }, 20.0);
  const double change = GetPrismVolume(roof, { 0, 0, -0.1, 0, 0 }, 20.0) - nominal;
  Check("the closed form", -21.918, change, 5e-4, "rounded");
  Check("lower end", nominal + change, GetTotal(filter, names::VolumeLower), 1e-9);
  Check("upper end", nominal, GetTotal(filter, names::VolumeUpper), 1e-9);
  filter->ClearTolerances();
  filter->AddTolerance("face", "#102", 0.0, 0.1);
  filter->Update();
  CheckRange("upper end of one that may grow", GetPrismVolume(roof, { 0, 0, 0.1, 0, 0 }, 20.0) - 1e-9,
    GetTotal(filter, names::VolumeUpper), nominal + 21.0);

  std::printf("--- a flat on a shaft\n");
  const double r = 10.0;
  const double half = std::sqrt(2.0 * r * 0.0123 - 0.0123 * 0.0123);
  const double depth = r - 0.0123;
  const std::vector<ProfilePiece> shaft = { { { half, depth }, false }, { { -half, depth }, true, { 0, 0 } },
    { { -r, 0 }, true, { 0, 0 } }, { { 0, -r }, true, { 0, 0 } }, { { r, 0 }, true, { 0, 0 } } };
  vtkNew<vtkMassTolerances> flat;
  MessageTrap trap(flat);
  flat->SetBackend(vtkMassPropertiesGPU::CPU);
  flat->SetInputDataObject(PrismBody(shaft, 20.0).Make());
  flat->AddTolerance("face", "#100", -0.05, 0.0);
  flat->Update();
  CheckTrue("has no interval", std::isnan(GetTotal(flat, names::VolumeLower)));
  CheckTrue(
    "both faces are named", Says(flat, "less than 6 degrees") && Says(flat, "#100, #101"), GetMessages(flat));
}

/// Edges that the model does not have.
void CheckHiddenEdges()
{
  std::printf("--- a box of six faces without loops\n");
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { 10, 10, 10 } });
  const auto leaf = body.Make();
  std::vector<sm::FacePointer> faces;
  for (const sm::FacePointer& face : leaf->GetModel()->GetFaces())
  {
    auto plain = std::make_shared<sm::Face>(*face);
    plain->Id = sm::NewId();
    plain->Loops.clear();
    faces.push_back(plain);
  }
  leaf->GetModel()->SetFaces(faces);
  vtkNew<vtkMassTolerances> filter;
  MessageTrap trap(filter);
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputDataObject(leaf);
  filter->SetFaceTolerance(0.1);
  filter->Update(3);
  Check("volume", 1000.0, filter->GetVolume(), 1e-9);
  CheckTrue("has no interval",
    std::isnan(GetTotal(filter, names::VolumeLower)) && std::isnan(GetTotal(filter, names::VolumeUpper)));
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  CheckTrue("nor a change of the area",
    std::isnan(table->GetRowData()->GetArray(names::SurfaceAreaPerOffset)->GetTuple1(0)));
  CheckTrue("the faces are named", Says(filter, "not edges of the model") && Says(filter, "#100"),
    GetMessages(filter));

  std::printf("--- a prism with a crease in a side\n");
  const auto base = PrismBody({ { { 0, 0 } }, { { 10, 0 } }, { { 10, 10 } }, { { 0, 10 } } }, 10.0).Make();
  faces = base->GetModel()->GetFaces();
  auto creased = std::make_shared<sm::Face>(*faces[0]);
  sm::NURBSSurface& surface = creased->Surface;
  // The middle of the side sinks by 1: a crease at u = 0.5, which is not an edge.
  surface.Knots[0] = { 0.0, 0.0, 0.5, 1.0, 1.0 };
  surface.NumberOfControlPoints[0] = 3;
  surface.ControlPoints = { { 0, 0, 0, 1 }, { 5, 1, 0, 1 }, { 10, 0, 0, 1 }, { 0, 0, 10, 1 }, { 5, 1, 10, 1 },
    { 10, 0, 10, 1 } };
  faces[0] = creased;
  base->GetModel()->SetFaces(faces);
  vtkNew<vtkMassTolerances> folded;
  MessageTrap foldedTrap(folded);
  folded->SetBackend(vtkMassPropertiesGPU::CPU);
  folded->SetInputDataObject(base);
  folded->SetFaceTolerance(0.1);
  folded->Update();
  CheckTrue("has no interval", std::isnan(GetTotal(folded, names::VolumeUpper)));
  CheckTrue("the face is named", Says(folded, "creases") && Says(folded, "#100"), GetMessages(folded));
}

/// Prisms over regular polygons whose inner radius is the height, 10; all faces may be off by 0.1.
void CheckManySides(int sides)
{
  std::printf("--- a prism of %d sides\n", sides);
  std::vector<ProfilePiece> profile;
  const double step = 2.0 * vtkMath::Pi() / sides;
  for (int i = 0; i < sides; ++i)
  {
    const double r = 10.0 / std::cos(0.5 * step);
    profile.push_back({ { r * std::cos(i * step), r * std::sin(i * step) } });
  }
  const auto filter = RunTolerances(PrismBody(profile, 10.0).Make(), -0.1, 0.1);
  const double factor = sides * std::tan(0.5 * step);
  const double upper = factor * 10.1 * 10.1 * 10.2;
  const double lower = factor * 9.9 * 9.9 * 9.8;
  const bool isExact = 2.0 * std::tan(0.5 * step) > 1e-3;
  const double slack = isExact ? 1e-8 : 1.0;
  CheckRange("upper end", upper - 1e-8, GetTotal(filter, names::VolumeUpper), upper + slack);
  CheckRange("lower end", lower - slack, GetTotal(filter, names::VolumeLower), lower + 1e-8);
}

/// A chamfer that vanishes where the faces shrink: its edges turn around.
void CheckInvertedEdges()
{
  std::printf("--- a chamfer narrower than the tolerance\n");
  vtkNew<vtkMassTolerances> filter;
  MessageTrap trap(filter);
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputDataObject(
    PrismBody({ { { 0, 0 } }, { { 10, 0 } }, { { 10, 9.95 } }, { { 9.95, 10 } }, { { 0, 10 } } }, 10.0)
      .Make());
  filter->SetFaceTolerance(0.1);
  filter->Update();
  // The chamfer's plane is nearer to the corner of the shrunk sides than its own offset: 0.05 / sqrt(2).
  const double cut = std::max(0.05 + std::sqrt(2.0) * 0.1 - 0.2, 0.0);
  const double side = 9.8;
  CheckRange(
    "lower end", 0.0, GetTotal(filter, names::VolumeLower), (side * side - 0.5 * cut * cut) * side + 1e-9);
  CheckTrue("the faces are named", Says(filter, "narrow") && Says(filter, "#102"), GetMessages(filter));
}

/// A bar with a small lump beyond one end, which may grow, and a void near the other one, which may grow,
/// too: both move the centre the same way.
void CheckGrowingAndShrinking()
{
  std::printf("--- one place grows, another shrinks\n");
  BoxBody body;
  body.Add({ { -12, -1, -1 }, { 12, 1, 1 } });
  body.Add({ { 12.5, -0.5, -0.5 }, { 13.5, 0.5, 0.5 } });
  body.Add({ { -11.5, -0.5, -0.5 }, { -10.5, 0.5, 0.5 }, false });
  vtkNew<vtkMassTolerances> filter;
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputDataObject(body.Make());
  for (int f = 0; f < 6; ++f)
  {
    filter->AddTolerance("face", ("#" + std::to_string(106 + f)).c_str(), 0.0, 0.05);
    filter->AddTolerance("face", ("#" + std::to_string(112 + f)).c_str(), -0.05, 0.0);
  }
  filter->Update();
  const auto getCenter = [](double lump, double hole)
  {
    return (13.0 * lump * lump * lump + 11.0 * hole * hole * hole) /
      (96.0 + lump * lump * lump - hole * hole * hole);
  };
  double center[3];
  filter->GetCenterOfMass(center);
  Check("centre", getCenter(1.0, 1.0), center[0], 1e-9);
  const double shift = getCenter(1.1, 1.1) - getCenter(1.0, 1.0);
  CheckRange("reach", shift, GetTotal(filter, names::CenterOfMassReach), 1.1 * shift);
}

/// A box whose faces are moved, with its moments in closed form.
void CheckBoxMoments()
{
  std::printf("--- centre and inertia of a box\n");
  const double size[3] = { 3.0, 4.0, 6.0 };
  const double t = 0.05;
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { size[0], size[1], size[2] } });
  const auto leaf = body.Make();
  const auto filter = RunTolerances(leaf, -t, t);
  const double areas[3] = { size[1] * size[2], size[0] * size[2], size[0] * size[1] };
  const double sigma = t / std::sqrt(3.0);
  const double v = size[0] * size[1] * size[2];
  double variance = 0.0;
  for (const double area : areas)
  {
    variance += 2.0 * area * area * sigma * sigma;
  }
  Check("deviation of the volume", std::sqrt(variance), GetTotal(filter, names::VolumeDeviation), 1e-12);
  Check(
    "deviation of the mass", 7850e-9 * std::sqrt(variance), GetTotal(filter, names::MassDeviation), 1e-15);
  for (int d = 0; d < 3; ++d)
  {
    // Both faces of a direction move the centre, by half of their offset; opposite ones cancel elsewhere.
    Check("deviation of the centre", std::sqrt(0.5) * sigma,
      GetTotal(filter, names::CenterOfMassDeviation, d), 1e-12);
  }
  const auto getMoment = [](const double* s, int a)
  { return s[0] * s[1] * s[2] * (s[(a + 1) % 3] * s[(a + 1) % 3] + s[(a + 2) % 3] * s[(a + 2) % 3]) / 12.0; };
  for (int a = 0; a < 3; ++a)
  {
    double sum = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      double ends[2];
      for (int i = 0; i < 2; ++i)
      {
        double moved[3] = { size[0], size[1], size[2] };
        moved[d] += i == 0 ? -1e-4 : 1e-4;
        ends[i] = getMoment(moved, a);
      }
      const double slope = (ends[1] - ends[0]) / 2e-4;
      sum += 2.0 * slope * slope * sigma * sigma;
    }
    Check("deviation of the inertia", std::sqrt(sum), GetTotal(filter, names::VolumeInertiaDeviation, 4 * a),
      1e-5);
  }
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-t, t);
  std::bernoulli_distribution isExtreme(0.5);
  double farthest[2] = { 0.0, 0.0 };
  for (int i = 0; i < 100000; ++i)
  {
    double moved[3];
    for (int d = 0; d < 3; ++d)
    {
      const double low = isExtreme(random) ? t : uniform(random);
      const double high = isExtreme(random) ? -t : uniform(random);
      moved[d] = size[d] + low + high;
      farthest[0] = std::max(farthest[0], 0.5 * std::abs(high - low));
    }
    for (int a = 0; a < 3; ++a)
    {
      farthest[1] = std::max(farthest[1], std::abs(getMoment(moved, a) - getMoment(size, a)));
    }
  }
  CheckRange("centre", farthest[0], GetTotal(filter, names::CenterOfMassReach), 5.0 * farthest[0],
    "of all solids in the zone, which may be thick on one half of every face");
  CheckRange("inertia", farthest[1], GetTotal(filter, names::VolumeInertiaReach), 3.0 * farthest[1]);
  CheckRange(
    "principal moments", farthest[1], GetTotal(filter, names::PrincipalMomentsReach), 5.0 * farthest[1]);

  // The worst case of the centre to first order: thick where x > c, thin where x < c, on all six faces.
  double worst = 0.0;
  for (int d = 0; d < 3; ++d)
  {
    const double sides = 2.0 * (v / size[d] * 0.5 * size[d]);
    const double others = 2.0 * (areas[(d + 1) % 3] + areas[(d + 2) % 3]) * 0.25 * size[d];
    worst = std::max(worst, t * (sides + others) / v);
  }
  CheckRange("reach of the centre over its first order", worst, GetTotal(filter, names::CenterOfMassReach),
    1.35 * worst, "2/sqrt(3) by the inequality of Cauchy and Schwarz, and second order at both ends");
}

void CheckPlacedBox()
{
  std::printf("--- far away and rotated\n");
  vtkNew<vtkMatrix4x4> placement;
  const double rows[16] = { 0.6, -0.8, 0, 100, 0.8, 0.6, 0, -20, 0, 0, 1, 30, 0, 0, 0, 1 };
  placement->DeepCopy(rows);
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { 3, 4, 6 } });
  const auto plain = RunTolerances(body.Make(), -0.05, 0.05);
  const auto leaf = body.Make();
  leaf->SetPlacement(placement);
  const auto moved = RunTolerances(leaf, -0.05, 0.05);
  for (const char* name : { names::VolumeLower, names::VolumeUpper, names::VolumeDeviation })
  {
    Check(name, GetTotal(plain, name), GetTotal(moved, name), 1e-9);
  }
}

void CheckToleranceRules()
{
  std::printf("--- tolerances by face, part and colour\n");
  const auto base =
    PrismBody({ { { 0, 0 } }, { { 10, 0 } }, { { 10, 10 } }, { { 0, 10 } } }, 10.0).Make("bolt 3");
  std::vector<sm::FacePointer> faces = base->GetModel()->GetFaces();
  auto red = std::make_shared<sm::Face>(*faces[0]);
  red->Color = { 1.0, 0.0, 0.0 };
  faces[0] = red;
  base->GetModel()->SetFaces(faces);
  vtkNew<vtkMassTolerances> filter;
  MessageTrap trap(filter);
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputDataObject(base);
  filter->SetFaceTolerance(0.01);
  filter->AddTolerance("colour", "#ff0000", 0.0, 0.5);
  filter->AddTolerance("face", "#101", "-0.2", "0.1");
  filter->AddTolerance("part", "nut*", -9.0, 9.0);
  filter->Update(5);
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  const auto get = [table](const char* name, vtkIdType row)
  { return table->GetRowData()->GetArray(name)->GetTuple1(row); };
  const double expected[6][2] = { { 0.0, 0.5 }, { -0.2, 0.1 }, { -0.01, 0.01 }, { -0.01, 0.01 },
    { -0.01, 0.01 }, { -0.01, 0.01 } };
  for (vtkIdType row = 0; row < 6; ++row)
  {
    Check("lower limit", expected[row][0], get(names::ToleranceLower, row), 0.0);
    Check("upper limit", expected[row][1], get(names::ToleranceUpper, row), 0.0);
    Check("volume", 100.0 * std::max(-expected[row][0], expected[row][1]), get(names::VolumeByTolerance, row),
      1e-10);
  }
  Check("upper volume", 10.11 * 10.51 * 10.02, GetTotal(filter, names::VolumeUpper), 1e-9);
  Check("lower volume", 9.79 * 9.99 * 9.98, GetTotal(filter, names::VolumeLower), 1e-9);
  CheckTrue("the rule without a face is named",
    Says(filter,
      "the tolerance for part \"nut*\" fits no face of a solid and has no effect: check the name; * and ? "
      "are "
      "wildcards"),
    GetMessages(filter));
  auto* meshes = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(5));
  CheckTrue("there are meshes", meshes != nullptr);

  filter->AddTolerance("part", "*", "-0,1", "0.1");
  filter->AddTolerance("edge", "#1", 0.0, 1.0);
  filter->AddTolerance("face", "#1", 1.0, 0.0);
  filter->SetFaceTolerance(0.0, HUGE_VAL);
  filter->AddTolerance("face", "#1", 0.1, 0.2);
  filter->SetFaceTolerance(-0.2, -0.1);
  CheckEqual("wrong tolerances are refused", 3, filter->GetNumberOfTolerances());
  Check("and change nothing", 0.01, filter->GetFaceTolerance()[1], 0.0);
  filter->SetDistribution(vtkMassTolerances::NORMAL);
  filter->ClearTolerances();
  filter->Update();
  Check("normal distribution", std::sqrt(6.0) * 100.0 * 0.01 / 3.0, GetTotal(filter, names::VolumeDeviation),
    1e-10);
}

void CheckTight()
{
  std::printf("--- tolerances as large as the curvature radius\n");
  vtkNew<vtkMassTolerances> filter;
  MessageTrap trap(filter);
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  const auto ball = MakeRoundBody({ MakeBall({ 0, 0, 0 }, 1.0) });
  filter->SetInputDataObject(ball);
  filter->SetFaceTolerance(1.2);
  filter->Update();
  CheckRange("nothing may be left", 0.0, GetTotal(filter, names::VolumeLower), 0.0);
  const double upper = 4.0 / 3.0 * vtkMath::Pi() * 2.2 * 2.2 * 2.2;
  CheckRange("upper end", upper * (1.0 - 1e-9), GetTotal(filter, names::VolumeUpper), upper * (1.0 + 1e-6),
    "outwards nothing folds");
  CheckTrue("the face is named", Says(filter, "curvature radius"), GetMessages(filter));
}

void CheckShell()
{
  std::printf("--- a shell\n");
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { 1, 2, 3 }, true, 5 });
  vtkNew<vtkMassTolerances> filter;
  MessageTrap trap(filter);
  filter->SetBackend(vtkMassPropertiesGPU::CPU);
  filter->SetInputDataObject(body.Make(false));
  filter->SetFaceTolerance(0.1);
  filter->AddTolerance("part", "boxes", -0.1, 0.1);
  filter->Update();
  CheckTrue("a rule of it has no effect", Says(filter, "fits no face of a solid"), GetMessages(filter));
  CheckTrue("has no interval",
    std::isnan(GetTotal(filter, names::VolumeLower)) && std::isnan(GetTotal(filter, names::VolumeUpper)));
}
}

int TestMassTolerances(int, char*[])
{
  for (const ToleranceCase& test : MakeToleranceCases())
  {
    CheckToleranceVolume(test);
  }
  CheckBoxMoments();
  CheckPlacedBox();
  CheckToleranceRules();
  CheckNearlyTangent();
  CheckHiddenEdges();
  CheckManySides(400);
  CheckManySides(7000);
  CheckInvertedEdges();
  CheckGrowingAndShrinking();
  CheckTight();
  CheckShell();
  return Finish();
}

// Masses, centres and inertia of boxes of several materials, one of them mirrored and rotated, against sums
// of formulas in extended precision; the order of rules, density and file; a frame of reference; and what
// cannot be set.
#include "smBoxBodies.h"
#include "smMaterials.h"
#include "smTestPipeline.h"

#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkMatrix4x4.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkTable.h>

#include <cmath>
#include <cstdio>
#include <limits>

namespace
{
using namespace smtest;
namespace names = sm::names;

using Vector = std::array<long double, 3>;
using Matrix = std::array<Vector, 3>;

struct Box
{
  std::string Name;
  std::array<double, 3> Low;
  std::array<double, 3> High;
  /// Rows of R and t of the placement.
  std::array<std::array<double, 4>, 3> Placement{ { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } } };
  /// kg/m^3; 0: none.
  double Density = 0.0;
};

// Mirrored at x = 0 and rotated by the angle with cosine 0.6.
const std::array<std::array<double, 4>, 3> Mirrored = { { { -0.6, -0.8, 0, 100 }, { -0.8, 0.6, 0, -20 },
  { 0, 0, 1, 5 } } };

/// The file of the light box states a density of 500 and the material foam.
std::vector<Box> MakeBoxes()
{
  return { { "steel box", { 0, 0, 0 }, { 10, 20, 30 } }, { "light box", { 5, 6, 7 }, { 45, 9, 8 }, Mirrored },
    { "other", { -30, 0, 0 }, { -20, 1, 2 } } };
}

vtkSmartPointer<vtkPartitionedDataSetCollection> MakeInput(const std::vector<Box>& boxes, const char* unit)
{
  auto input = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  for (unsigned int i = 0; i < boxes.size(); ++i)
  {
    BoxBody body;
    body.Add({ boxes[i].Low, boxes[i].High });
    const auto leaf = body.Make();
    leaf->GetModel()->SetLengthUnit(unit);
    if (boxes[i].Name == "light box")
    {
      leaf->GetModel()->SetDensity(500.0);
      leaf->GetModel()->SetMaterial("foam");
    }
    vtkNew<vtkMatrix4x4> placement;
    for (int r = 0; r < 3; ++r)
    {
      for (int c = 0; c < 4; ++c)
      {
        placement->SetElement(r, c, boxes[i].Placement[r][c]);
      }
    }
    leaf->SetPlacement(placement);
    input->SetPartition(i, 0, leaf);
    input->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), boxes[i].Name.c_str());
  }
  return input;
}

struct Sum
{
  long double Mass = 0.0L;
  Vector First{};
  Matrix Second{}; ///< about the origin
};

/// Masses of cubic metres for lengths in `metres`; the moments stay in the unit.
Sum Add(const std::vector<Box>& boxes, long double metres)
{
  Sum sum;
  for (const Box& box : boxes)
  {
    Vector size;
    Vector middle;
    long double mass = box.Density * metres * metres * metres;
    for (int i = 0; i < 3; ++i)
    {
      size[i] = static_cast<long double>(box.High[i]) - box.Low[i];
      mass *= size[i];
      middle[i] = 0.5L * (static_cast<long double>(box.High[i]) + box.Low[i]);
    }
    Vector center{};
    for (int i = 0; i < 3; ++i)
    {
      center[i] = box.Placement[i][3];
      for (int j = 0; j < 3; ++j)
      {
        center[i] += box.Placement[i][j] * middle[j];
      }
    }
    sum.Mass += mass;
    for (int i = 0; i < 3; ++i)
    {
      sum.First[i] += mass * center[i];
      for (int j = 0; j < 3; ++j)
      {
        sum.Second[i][j] += mass * center[i] * center[j];
        for (int k = 0; k < 3; ++k)
        {
          sum.Second[i][j] += static_cast<long double>(box.Placement[i][k]) * box.Placement[j][k] * mass *
            size[k] * size[k] / 12.0L;
        }
      }
    }
  }
  return sum;
}

/// Inertia about a point.
Matrix GetInertia(const Sum& sum, const Vector& about)
{
  Matrix inertia;
  long double trace = 0.0L;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      inertia[i][j] = -(sum.Second[i][j] - sum.First[i] * about[j] - about[i] * sum.First[j] +
        sum.Mass * about[i] * about[j]);
    }
    trace -= inertia[i][i];
  }
  for (int i = 0; i < 3; ++i)
  {
    inertia[i][i] += trace;
  }
  return inertia;
}

void CheckArray(vtkFieldData* fields, const std::string& name, const std::vector<long double>& expected)
{
  const double bound = GetFieldBound(fields, name.c_str());
  long double largest = 0.0L;
  for (const long double x : expected)
  {
    largest = std::max(largest, std::abs(x));
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const auto value = static_cast<double>(expected[i]);
    Check(name + " " + std::to_string(i), value, GetField(fields, name.c_str(), static_cast<int>(i)),
      bound + 2e-16 * std::abs(value), "its bound, and the rounding of the expected number");
  }
  CheckRange(name + ": bound", 0.0, bound, 1e-8 * static_cast<double>(largest) + 1e-12, "not vacuous");
}

std::vector<long double> Flatten(const Matrix& m)
{
  return { m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2] };
}

void CheckMass(vtkMassPropertiesGPU* mass, const std::vector<Box>& boxes, long double metres)
{
  mass->Update();
  CheckEqual("status", names::StatusOk, mass->GetStatus());
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  const Sum sum = Add(boxes, metres);
  const Vector center = { sum.First[0] / sum.Mass, sum.First[1] / sum.Mass, sum.First[2] / sum.Mass };
  CheckArray(fields, names::Mass, { sum.Mass });
  CheckArray(fields, names::MassCenter, { center[0], center[1], center[2] });
  CheckArray(fields, names::MassInertia, Flatten(GetInertia(sum, center)));
  Check("GetMassBound()", GetFieldBound(fields, names::Mass), mass->GetMassBound(), 0.0);
}

void CheckMaterials(const char* unit, long double metres)
{
  std::printf("--- materials, %s\n", unit);
  std::vector<Box> boxes = MakeBoxes();
  const auto input = MakeInput(boxes, unit);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(input);
  mass->Update();
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  CheckTrue("two solids without a density: no mass", std::isnan(mass->GetMass()));
  CheckEqual("solids with a mass", 1, static_cast<long long>(GetField(fields, names::SolidsWithMass)));
  CheckEqual("of", 3, static_cast<long long>(GetField(fields, names::SolidsWithVolume)));
  boxes[1].Density = 500.0;
  const auto known = static_cast<double>(Add(boxes, metres).Mass);
  Check("the mass that is known", known, GetField(fields, names::KnownMass),
    GetFieldBound(fields, names::KnownMass) + 2e-16 * known, "its bound");
  CheckTrue(
    "it names the two", Says(mass, "no density for 2 of 3 solids: steel box, other"), GetMessages(mass));

  mass->AddMaterial("*STEEL*", "steel", 7850.0);
  mass->AddMaterial("s*", "never", 1.0);
  mass->AddMaterial("oth?r", "Brass", "");
  CheckEqual("materials", 3, mass->GetNumberOfMaterials());
  boxes[0].Density = 7850.0;
  boxes[2].Density = sm::FindCommonMaterial("brass")->Density;
  CheckMass(mass, boxes, metres);
  CheckTrue("a rule that is never used", Says(mass, "the pattern s*"), GetMessages(mass));
  auto* table = vtkTable::SafeDownCast(mass->GetOutputDataObject(1));
  const std::string materials[] = { "steel", "foam", "Brass" };
  for (int i = 0; i < 3; ++i)
  {
    CheckEqual("material", materials[i], table->GetValueByName(i, names::Material).ToString());
    Check("density", boxes[i].Density, table->GetValueByName(i, names::Density).ToDouble(), 0.0);
  }

  // The uncertainty: the boxes have no gaps, the rules with a tolerance of their own keep it.
  mass->SetDensityTolerance(0.02);
  mass->ClearMaterials();
  mass->AddMaterial("*STEEL*", "steel", 7850.0, 0.1);
  mass->AddMaterial("oth?r", "Brass", "");
  mass->Update();
  fields = mass->GetOutput()->GetFieldData();
  const std::vector<Box> other(boxes.begin() + 1, boxes.end());
  const auto inDoubt =
    static_cast<double>(0.1L * Add({ boxes[0] }, metres).Mass + 0.02L * Add(other, metres).Mass);
  const auto share = [&fields](int c)
  { return fields->GetArray(names::MassUncertainty)->GetComponent(0, c); };
  Check("in doubt by the densities", inDoubt, share(1), 1e-14 * inDoubt);
  CheckEqual("by gaps", 0.0, share(2));
  CheckRange("by the bound", GetFieldBound(fields, names::Mass), share(3),
    1.1 * GetFieldBound(fields, names::Mass), "with the largest tolerance");
  Check("in all", share(1) + share(3), share(0), 2e-6 * share(0), "rounding of the sum");
  mass->SetDensityTolerance(0.0);

  // The density of the filter comes behind the rules and before that of the file.
  mass->SetDensity(3.0);
  boxes[1].Density = 3.0;
  CheckMass(mass, boxes, metres);
  mass->ClearMaterials();
  boxes[0].Density = boxes[2].Density = 3.0;
  CheckMass(mass, boxes, metres);

  // About a point, with axes that are rotated by the angle with cosine 0.6 and exchanged.
  const double origin[3] = { 7.0, -8.0, 90.0 };
  const double z[3] = { 6.0, 8.0, 0.0 };
  const double x[3] = { 1.0, 1.0, 5.0 };
  mass->SetReferenceFrame(origin, z, x);
  mass->Update();
  // The part of x across z: (1,1,5) - 1.4 (0.6,0.8,0) = (0.16,-0.12,5).
  Matrix axes = { { { 0.16L, -0.12L, 5.0L }, {}, { 0.6L, 0.8L, 0.0L } } };
  const long double length = std::sqrt(0.16L * 0.16L + 0.12L * 0.12L + 25.0L);
  for (long double& value : axes[0])
  {
    value /= length;
  }
  for (int i = 0; i < 3; ++i)
  {
    axes[1][i] = axes[2][(i + 1) % 3] * axes[0][(i + 2) % 3] - axes[2][(i + 2) % 3] * axes[0][(i + 1) % 3];
  }
  const Sum sum = Add(boxes, metres);
  const Matrix about = GetInertia(sum, { 7.0L, -8.0L, 90.0L });
  Matrix rotated{};
  Vector center{};
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      center[i] += axes[i][k] * (sum.First[k] / sum.Mass - origin[k]);
      for (int j = 0; j < 3; ++j)
      {
        for (int l = 0; l < 3; ++l)
        {
          rotated[i][j] += axes[i][k] * about[k][l] * axes[j][l];
        }
      }
    }
  }
  fields = mass->GetOutput()->GetFieldData();
  CheckArray(fields, names::MassInertiaInFrame, Flatten(rotated));
  CheckArray(fields, names::MassCenterInFrame, { center[0], center[1], center[2] });
  mass->ClearReferenceFrame();
  mass->Update();
  CheckTrue("no frame, no columns", !mass->GetOutput()->GetFieldData()->HasArray(names::MassInertiaInFrame));
}

void CheckErrors()
{
  std::printf("--- errors\n");
  vtkNew<vtkMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  mass->AddMaterial("*", "steel", -1.0);
  mass->AddMaterial("*", "steel", std::numeric_limits<double>::quiet_NaN());
  mass->AddMaterial("*", "unobtainium", "");
  mass->AddMaterial("*", "steel", "7,85");
  mass->AddMaterial("*", "steel", 7850.0, 1.5);
  mass->SetDensityTolerance(-0.1);
  mass->SetDensityTolerance(5.0);
  mass->SetDensityTolerance(std::numeric_limits<double>::quiet_NaN());
  CheckEqual("density tolerance", 0.0, mass->GetDensityTolerance());
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double z[3] = { 0.0, 0.0, 2.0 };
  const double parallel[3] = { 0.0, 0.0, -5.0 };
  mass->SetReferenceFrame(origin, z, parallel);
  mass->SetReferenceFrame(origin, origin, z);
  CheckEqual("errors", 10, trap.NumberOfErrors);
  CheckEqual("no material", 0, mass->GetNumberOfMaterials());
  CheckTrue("no frame", !mass->HasReferenceFrame());
}

void CheckRules()
{
  const std::vector<sm::MaterialRule> rules = { { "M8*20", {} }, { "b*", {} }, { "Bolt", {} },
    { "bolt", {} } };
  const std::pair<const char*, const char*> found[] = { { "bolt", "bolt" }, { "Bolt", "Bolt" },
    { "BOLT", "b*" }, { "M8*20", "M8*20" }, { "M8*120", "M8*20" }, { "nut", "" } };
  for (const auto& [name, pattern] : found)
  {
    const sm::MaterialRule* rule = sm::FindRule(rules, name);
    CheckEqual(std::string("the rule of ") + name, pattern, rule ? rule->Pattern : "");
  }
}

void CheckPatterns()
{
  std::printf("--- patterns\n");
  const std::pair<const char*, const char*> fits[] = { { "", "" }, { "*", "" }, { "*", "a" }, { "a*", "A" },
    { "*b*c", "abcbc" }, { "?", "x" }, { "**a", "a" }, { "M3x?", "m3X8" }, { "*aab", "aaab" } };
  const std::pair<const char*, const char*> misses[] = { { "", "a" }, { "a", "" }, { "a", "ab" }, { "?", "" },
    { "a?c", "ac" }, { "*b", "abc" }, { "[ab]", "a" } };
  for (const auto& [pattern, name] : fits)
  {
    CheckTrue(std::string(pattern) + " fits " + name, sm::MatchesPattern(pattern, name));
  }
  for (const auto& [pattern, name] : misses)
  {
    CheckTrue(std::string(pattern) + " does not fit " + name, !sm::MatchesPattern(pattern, name));
  }
}
}

int TestMassPropertiesMaterials(int, char*[])
{
  CheckMaterials("mm", 0.001L);
  CheckMaterials("inch", 0.0254L);
  CheckErrors();
  CheckRules();
  CheckPatterns();
  return Finish();
}

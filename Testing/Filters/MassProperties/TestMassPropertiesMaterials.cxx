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
  /// kg, in place of a density; 0: none.
  double Stated = 0.0;
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
    mass = box.Stated > 0.0 ? static_cast<long double>(box.Stated) : mass;
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
  Check("in all", share(1) + share(3), share(0), 1e-14 * share(0), "rounding of the sum");
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

/// A mass that materials state: boxes with the inertia of their volume, scaled to it; and a row that leaves a
/// box out.
void CheckStatedMasses(const char* unit, long double metres)
{
  std::printf("--- stated masses, %s\n", unit);
  std::vector<Box> boxes = MakeBoxes();
  const auto input = MakeInput(boxes, unit);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(input);
  mass->SetDensity(1200.0);
  mass->SetDensityTolerance(0.02);
  mass->AddMass("light*", "", 12.3, 0.05);
  mass->AddMass("other", "pump", 4.0);
  boxes[0].Density = 1200.0;
  boxes[1].Stated = 12.3;
  boxes[2].Stated = 4.0;
  CheckMass(mass, boxes, metres);
  vtkFieldData* fields = mass->GetOutput()->GetFieldData();
  Check("overridden", 16.3, GetField(fields, names::OverriddenMass), 1e-14);
  const auto inDoubt = [&fields](int c)
  { return fields->GetArray(names::MassUncertainty)->GetComponent(0, c); };
  const auto density = static_cast<double>(0.02L * Add({ boxes[0] }, metres).Mass);
  Check("in doubt by the density of the first alone", density, inDoubt(1), 1e-14 * density);
  Check("by the stated masses, of which one has a tolerance", 0.05 * 12.3, inDoubt(4), 1e-15);
  CheckEqual("by gaps", 0.0, inDoubt(2));
  Check("in all", inDoubt(1) + inDoubt(3) + inDoubt(4), inDoubt(0), 1e-14 * inDoubt(0));
  CheckTrue("it names them", Says(mass, "override the mass of 2 solids: light box 12.3 kg, other 4 kg"),
    GetMessages(mass));
  auto* table = vtkTable::SafeDownCast(mass->GetOutputDataObject(1));
  const auto volume = static_cast<double>(40.0L * 3.0L * 1.0L * metres * metres * metres);
  Check("mean density", 12.3 / volume, table->GetValueByName(1, names::Density).ToDouble(),
    1e-14 * 12.3 / volume);
  CheckEqual("material", "pump", table->GetValueByName(2, names::Material).ToString());
  CheckEqual("overridden of the first", 0.0, table->GetValueByName(0, names::OverriddenMass).ToDouble());
  Check("overridden of the last", 4.0, table->GetValueByName(2, names::OverriddenMass).ToDouble(), 0.0);
  const double frame[9] = { 7.0, -8.0, 90.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0 };
  mass->SetReferenceFrame(frame, frame + 3, frame + 6);
  mass->Update();
  const Sum sum = Add(boxes, metres);
  CheckArray(mass->GetOutput()->GetFieldData(), names::MassInertiaInFrame,
    Flatten(GetInertia(sum, { 7.0L, -8.0L, 90.0L })));
  mass->ClearReferenceFrame();

  // The order of the rows counts; a text with a unit is a mass, "left out" leaves out.
  mass->ClearMaterials();
  mass->AddMaterial("oth*", "", "250 g");
  mass->AddLeftOut("o*");
  mass->AddMaterial("steel*", "Left Out", "");
  boxes[1].Density = 1200.0;
  boxes[1].Stated = 0.0;
  boxes[2].Stated = 0.25;
  CheckMass(mass, { boxes[1], boxes[2] }, metres);
  CheckEqual("rows", 2,
    static_cast<long long>(vtkTable::SafeDownCast(mass->GetOutputDataObject(1))->GetNumberOfRows()));
  CheckTrue("it names the one left out", Says(mass, "leave out 1 body: steel box"), GetMessages(mass));
  CheckTrue(
    "a row that leaves nothing out", Says(mass, "no solid is left out by the pattern o*"), GetMessages(mass));
  mass->ClearMaterials();
  boxes[0].Density = boxes[2].Density = 1200.0;
  boxes[2].Stated = 0.0;
  CheckMass(mass, boxes, metres);
  CheckEqual(
    "nothing is overridden", 0.0, GetField(mass->GetOutput()->GetFieldData(), names::OverriddenMass));
}

/// Boxes whose mirror images have a material, and one that is its own mirror image.
void CheckTwins()
{
  std::printf("--- mirrored twins\n");
  const auto makeLeaf = [](double sign, double last)
  {
    BoxBody body;
    const auto add = [&](double x0, double x1, double y0, double y1, double z1) {
      body.Add({ { std::min(sign * x0, sign * x1), y0, 0.0 }, { std::max(sign * x0, sign * x1), y1, z1 } });
    };
    add(0, 4, 0, 3, 5);
    add(6, 7, 0, 2, 1);
    add(0, 1, 5, 8, last);
    return body.Make();
  };
  const struct
  {
    const char* Name;
    double Sign, Last;
  } solids[] = { { "left", 1.0, 2.0 }, { "right", -1.0, 2.0 }, { "same", 1.0, 2.0 },
    { "longer", -1.0, 2.5 } };
  vtkNew<vtkPartitionedDataSetCollection> input;
  for (unsigned int i = 0; i < std::size(solids); ++i)
  {
    input->SetPartition(i, 0, makeLeaf(solids[i].Sign, solids[i].Last));
    input->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), solids[i].Name);
  }
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(input);
  mass->AddMaterial("left", "steel", 7850.0);
  mass->Update();
  const auto getDensity = [&mass](int row)
  {
    return vtkTable::SafeDownCast(mass->GetOutputDataObject(1))
      ->GetValueByName(row, names::Density)
      .ToDouble();
  };
  Check("the mirror image", 7850.0, getDensity(1), 0.0);
  CheckTrue("the same shape has no material of its own, and gets none", std::isnan(getDensity(2)));
  CheckTrue("another shape gets none", std::isnan(getDensity(3)));
  CheckTrue("it says so",
    Says(mass, "right has no line of its own in the materials and gets that of its mirror image left"),
    GetMessages(mass));
  mass->AddMaterial("same", "brass", 8500.0);
  mass->Update();
  CheckTrue("two twins of different materials: none", std::isnan(getDensity(1)));
  CheckTrue("it says so, too", Says(mass, "whose materials differ: it gets none"), GetMessages(mass));
  mass->AddMaterial("right", "wood", 700.0);
  mass->Update();
  Check("a line of its own", 700.0, getDensity(1), 0.0);
  CheckTrue("no twin", !Says(mass, "mirror image"), GetMessages(mass));
  // More places of the mirror image are found with it.
  for (unsigned int i = 4; i < 6; ++i)
  {
    auto* leaf = vtkNURBSDataSet::SafeDownCast(input->GetPartition(1, 0));
    vtkNew<vtkNURBSDataSet> placed;
    placed->ShallowCopy(leaf);
    vtkNew<vtkMatrix4x4> placement;
    placement->SetElement(0, 3, 20.0 * i);
    placed->SetPlacement(placement);
    input->SetPartition(i, 0, placed);
    input->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), "more");
  }
  input->Modified();
  mass->ClearMaterials();
  mass->AddMaterial("left", "steel", 7850.0);
  mass->Update();
  Check("another place of the mirror image", 7850.0, getDensity(5), 0.0);
  CheckTrue("all in one message",
    Says(mass, "right and 2 more solids of its shape have no line of their own in the materials"),
    GetMessages(mass));
  mass->ClearMaterials();
  mass->AddMass("left", "", 3.0);
  mass->Update();
  Check("a stated mass goes to the twin, too", 3.0,
    vtkTable::SafeDownCast(mass->GetOutputDataObject(1))->GetValueByName(1, names::Mass).ToDouble(), 0.0);
}

void CheckTexts()
{
  std::printf("--- texts of rules\n");
  const std::pair<const char*, double> masses[] = { { "2.5", 2.5 }, { "2.5 kg", 2.5 }, { "250 g", 0.25 },
    { "250g", 0.25 }, { "3 mg", 3e-6 }, { "3 KG", 3.0 }, { "2 LB", 0.90718474 }, { "1.5 t", 1500.0 },
    { "2 lb", 0.90718474 }, { "1 oz", 0.028349523125 }, { "1e-3 kg", 1e-3 } };
  for (const auto& [text, mass] : masses)
  {
    Check(std::string("the mass ") + text, mass, sm::ParseMass(text, false), 1e-15 * mass);
  }
  CheckTrue("a unit is needed", std::isnan(sm::ParseMass("2.5", true)));
  for (const char* text : { "", "kg", "2,5 kg", "-1 kg", "0", "nan", "inf kg", "1 stone", "1 kg kg", "1e400",
         "250 Mg", "3 MG", "1 G", "1 T", "1 kG" })
  {
    CheckTrue(std::string("no mass: ") + text, std::isnan(sm::ParseMass(text, false)));
  }
  const struct
  {
    sm::MaterialTexts Texts;
    const char* Said;
  } wrong[] = { { { "a", "steel", "7850", "", "2" }, "contradict each other" },
    { { "a", "", "", "", "-2" }, "-2 is not a mass" },
    { { "a", "", "", "", "2 stone" }, "2 stone is not a mass" },
    { { "a", "", "", "3 g", "2 g" }, "3 g is not a relative tolerance" },
    { { "a", "", "7850", "3 g", "" }, "3 g is not a relative tolerance" },
    { { "a", "left out", "7850", "", "" }, "neither density nor mass" },
    { { "a", "", "250 Mg", "", "" }, "the case of the unit Mg counts" },
    { { "a", "", "", "", "250 Mg" }, "the case of the unit Mg counts" },
    { { "a", "", "", "5 Mg", "2 t" }, "the case of the unit Mg counts" },
    { { "a", "", "2 stone", "", "" }, "2 stone is not a density" },
    { { "a", "", "1e250", "", "" }, "1e250 is not a density; give kg/m^3 from 1e-200 to 1e200" },
    { { "a", "", "", "", "1e250" }, "1e250 is not a mass; give a number from 1e-200 to 1e200 in kg" },
    { { "", "steel", "", "", "" }, "name is empty" } };
  for (const auto& entry : wrong)
  {
    sm::MaterialRule rule{ "as it was", {} };
    const std::string said = sm::MakeRule(entry.Texts, rule);
    CheckTrue(std::string("refused: ") + entry.Said, said.find(entry.Said) != std::string::npos, said);
    CheckEqual("  no rule", "as it was", rule.Pattern);
  }
  for (const bool isMass : { false, true })
  {
    const std::string problem =
      sm::FindRuleProblem({ "a", { "dust", isMass ? 0.0 : 1e250, -1.0, isMass ? 1e250 : 0.0 } });
    CheckTrue("a rule out of range",
      problem.find("1e+250 is not a ") == 0 && problem.find("from 1e-200 to 1e200") != std::string::npos,
      problem);
  }
  sm::MaterialRule rule;
  CheckEqual("a mass with a tolerance", "", sm::MakeRule({ "a", "pump", "", "5 g", "2 kg" }, rule));
  Check("  relative", 0.0025, rule.Material.Tolerance, 1e-18);
  Check("  mass", 2.0, rule.Material.Mass, 0.0);
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
  mass->AddMass("*", "", 0.0);
  mass->AddMass("*", "", -1.0);
  mass->AddMass("*", "", std::numeric_limits<double>::infinity());
  mass->AddMass("*", "", 1.0, 1.5);
  mass->AddMaterial("*", "left out", 7850.0);
  mass->AddMass("*", "Left Out", 2.0);
  mass->SetDensity(1e250);
  CheckTrue("range of densities",
    trap.Errors.find("give kg/m^3 from 1e-200 to 1e200, for example 7850") != std::string::npos, trap.Errors);
  mass->SetDensityTolerance(-0.1);
  mass->SetDensityTolerance(5.0);
  mass->SetDensityTolerance(std::numeric_limits<double>::quiet_NaN());
  CheckEqual("density tolerance", 0.0, mass->GetDensityTolerance());
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double z[3] = { 0.0, 0.0, 2.0 };
  const double parallel[3] = { 0.0, 0.0, -5.0 };
  mass->SetReferenceFrame(origin, z, parallel);
  mass->SetReferenceFrame(origin, origin, z);
  CheckEqual("errors", 17, trap.NumberOfErrors);
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
  CheckStatedMasses("mm", 0.001L);
  CheckStatedMasses("inch", 0.0254L);
  CheckTwins();
  CheckTexts();
  CheckErrors();
  CheckRules();
  CheckPatterns();
  return Finish();
}

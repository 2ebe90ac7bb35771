// TestMassPropertiesValues FOLDER SOLID: every variant of an exact solid, from its STEP file through reader and filter,
// against the closed form.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkTable.h>

#include <algorithm>
#include <cstdio>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// Two conditions: the tolerance that is promised, and the bound that is stated. `doubt` is what the model itself leaves
/// open (gaps between trim and edge), which is no part of the bound.
void CheckQuantity(const std::string& what, double expected, double actual, double tolerance, double bound,
  double accuracy, double doubt)
{
  Check(what, expected, actual, tolerance, "(promised)");
  Check(what + " within its bound", expected, actual, bound + accuracy + doubt,
    "(bound + digits of the file + gaps)");
}

void CheckValues(const Expected& expected, vtkFieldData* fields)
{
  const double volume = GetField(fields, names::Volume);
  const double volumeBound = GetFieldBound(fields, names::Volume);
  const double gapSquared = GetField(fields, names::GapSquared);
  const double gapArea = GetField(fields, names::GapArea);
  const double size = expected.Size;
  // Other ways to close a gap differ by the integral of its square; gaps move the faces' own area to first order.
  CheckQuantity("volume", expected.Volume, volume, 1e-9 * expected.Volume, volumeBound,
    expected.VolumeAccuracy, gapSquared);
  CheckRange("volume bound", 0.0, volumeBound, 1e-9 * expected.Volume, "(the filter's tolerance)");
  CheckTrue("volume bound is not zero", volumeBound > 0.0);
  if (!std::isnan(expected.Area))
  {
    const double projected = expected.HasPcurves ? 0.0 : gapArea;
    CheckQuantity("area", expected.Area, GetField(fields, names::SurfaceArea),
      1e-8 * expected.Area + projected, GetFieldBound(fields, names::SurfaceArea), expected.AreaAccuracy,
      gapArea);
    CheckRange("area of the gaps", 0.0, gapArea, 1e-5 * expected.Area, "(OCCT projects trims to 1e-4 mm)");
  }
  const double areaBound = GetFieldBound(fields, names::SurfaceArea);
  CheckTrue("area bound is not zero", areaBound > 0.0);
  CheckRange(
    "area bound", 0.0, areaBound, 1e-9 * GetField(fields, names::SurfaceArea), "(the filter's tolerance)");

  const double centerBound = GetFieldBound(fields, names::CenterOfMass);
  for (int i = 0; i < 3; ++i)
  {
    CheckQuantity("centre " + std::to_string(i), expected.Center[i], GetField(fields, names::CenterOfMass, i),
      1e-9 * size, centerBound, expected.CenterAccuracy, gapSquared * size / expected.Volume);
  }
  CheckTrue("centre bound is not zero", centerBound > 0.0);
  // First moments carry the tolerance times cbrt(V), the centre inherits it over V: a few times 1e-9 of the size.
  CheckRange("centre bound", 0.0, centerBound, 1e-8 * size);

  const double trace = expected.GetInertiaTrace();
  const double inertiaBound = GetFieldBound(fields, names::VolumeInertia);
  for (int i = 0; i < 9; ++i)
  {
    CheckQuantity("inertia " + std::to_string(i), expected.Inertia[i],
      GetField(fields, names::VolumeInertia, i), 1e-8 * trace, inertiaBound, expected.InertiaAccuracy,
      gapSquared * size * size);
  }
  CheckTrue("inertia bound is not zero", inertiaBound > 0.0);
  CheckRange("inertia bound", 0.0, inertiaBound, 1e-8 * trace);
}

/// What follows from volume, centre and inertia by arithmetic, to its rounding.
void CheckDerived(const Expected& expected, vtkFieldData* fields)
{
  const double v = GetField(fields, names::Volume);
  double c[3];
  double inertia[9];
  for (int i = 0; i < 3; ++i)
  {
    c[i] = GetField(fields, names::CenterOfMass, i);
  }
  for (int i = 0; i < 9; ++i)
  {
    inertia[i] = GetField(fields, names::VolumeInertia, i);
  }
  const double square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  const double length = expected.Size + std::sqrt(square);
  // 64 roundings of the largest term.
  const double epsilon = 64 * std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 3; ++i)
  {
    Check("first moment " + std::to_string(i), v * c[i], GetField(fields, names::FirstMoments, i),
      epsilon * v * length);
    for (int j = 0; j < 3; ++j)
    {
      const double steiner = v * ((i == j ? square : 0.0) - c[i] * c[j]);
      Check("inertia at origin " + std::to_string(3 * i + j), inertia[3 * i + j] + steiner,
        GetField(fields, names::VolumeInertiaAtOrigin, 3 * i + j), epsilon * v * length * length);
    }
  }
  const double trace = inertia[0] + inertia[4] + inertia[8];
  const int order[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
  for (int k = 0; k < 6; ++k)
  {
    const int i = order[k][0];
    const int j = order[k][1];
    Check("second moment " + std::to_string(k), (i == j ? trace / 2 : 0.0) - inertia[3 * i + j],
      GetField(fields, names::SecondMoments, k), epsilon * trace);
  }
  double moments[3];
  for (int k = 0; k < 3; ++k)
  {
    moments[k] = GetField(fields, names::PrincipalMoments, k);
    Check("radius of gyration " + std::to_string(k), std::sqrt(moments[k] / v),
      GetField(fields, names::RadiiOfGyration, k), epsilon * expected.Size);
  }
  CheckTrue("principal moments ascend", moments[0] <= moments[1] && moments[1] <= moments[2]);
  // Rows of the axes rebuild the tensor: I = sum of lambda a a^T.
  double axes[9];
  for (int i = 0; i < 9; ++i)
  {
    axes[i] = GetField(fields, names::PrincipalAxes, i);
  }
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        sum += moments[k] * axes[3 * k + i] * axes[3 * k + j];
      }
      Check("axes rebuild " + std::to_string(3 * i + j), inertia[3 * i + j], sum, 1e-13 * trace,
        "(Jacobi's iteration)");
    }
  }
}

void CheckRun(const Pipeline& pipeline, vtkFieldData* fields)
{
  CheckEqual("status", names::StatusOk, GetFieldText(fields, names::Status));
  CheckEqual("backend", "opengl", GetFieldText(fields, names::Backend));
  CheckEqual("length unit", "mm", GetFieldText(fields, names::LengthUnit));
  CheckTrue("renderer is named", GetFieldText(fields, names::Renderer).size() > 3);
  CheckTrue("evaluations were counted", GetField(fields, names::Evaluations) > 0);
  CheckTrue("dispatches were counted", GetField(fields, names::Dispatches) > 0);
  CheckEqual("open edges", 0, static_cast<long long>(GetField(fields, names::OpenEdges)));
  Check("leak", 0.0, GetField(fields, names::Leak), 1e-9, "(a closed chain)");
  auto* table = vtkTable::SafeDownCast(pipeline.Mass->GetOutputDataObject(1));
  CheckEqual("rows of solids", 1, table->GetNumberOfRows());
  Check("volume in the table", pipeline.Mass->GetVolume(), table->GetValueByName(0, names::Volume).ToDouble(),
    0.0, "(the same number)");
  Check("volume of the getter", GetField(fields, names::Volume), pipeline.Mass->GetVolume(), 0.0,
    "(the same number)");
}
}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::fprintf(stderr, "usage: TestMassPropertiesValues FOLDER SOLID\n");
    return 1;
  }
  const Manifest manifest(argv[1]);
  for (const Expected& expected : manifest.GetSolid(argv[2]))
  {
    std::printf("--- %s %s\n", expected.Solid.c_str(), expected.Variant.c_str());
    Pipeline pipeline(expected.Path);
    MessageTrap readerMessages(pipeline.Reader);
    MessageTrap filterMessages(pipeline.Mass);
    pipeline.Mass->Update();
    vtkFieldData* fields = pipeline.Mass->GetOutput()->GetFieldData();
    CheckRun(pipeline, fields);
    CheckValues(expected, fields);
    CheckDerived(expected, fields);
    CheckEqual("errors and warnings", "",
      readerMessages.Errors + readerMessages.Warnings + filterMessages.Errors + filterMessages.Warnings);
  }
  return Finish();
}

// smMakeSolids OUTDIR: writes every exact solid in every variant to OUTDIR/<solid>-<variant>.step, files for
// the error tests next to them, comparison.txt with what OCCT's quadrature says, and OUTDIR/manifest.json
// with the expected values.

#include "smExactBlocks.h"
#include "smExactSolids.h"
#include "smFileAccuracy.h"
#include "smJson.h"
#include "smSpecialFiles.h"
#include "smStepFile.h"

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace
{
using nlohmann::json;
using namespace smtest;

json ToJson(Real x)
{
  return std::isnan(x) ? json() : json(static_cast<double>(x));
}

json ToJson(const Vector& v)
{
  return { static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2]) };
}

json Describe(const ExactMoments& moments, double size, double displacement)
{
  json entry;
  entry["volume"] = ToJson(moments.Volume);
  entry["area"] = ToJson(moments.Area);
  entry["center_of_mass"] = ToJson(moments.Center);
  const Matrix inertia = moments.GetInertia();
  entry["inertia"] = { ToJson(inertia[0]), ToJson(inertia[1]), ToJson(inertia[2]) };
  entry["size"] = size;
  const FileAccuracy accuracy = GetFileAccuracy(moments, size, displacement);
  entry["file_accuracy"] = { { "volume", accuracy.Volume }, { "area", accuracy.Area },
    { "center_of_mass", accuracy.Center }, { "inertia", accuracy.Inertia } };
  return entry;
}

/// Largest relative difference of volume, centre and inertia, and of the area, from OCCT's quadrature.
std::array<double, 2> GetDifference(
  const TopoDS_Shape& shape, const ExactMoments& exact, double size, bool adaptive)
{
  GProp_GProps properties;
  GProp_GProps surface;
  if (adaptive)
  {
    BRepGProp::VolumeProperties(shape, properties, 1e-9);
    BRepGProp::SurfaceProperties(shape, surface, 1e-9);
  }
  else
  {
    BRepGProp::VolumeProperties(shape, properties);
    BRepGProp::SurfaceProperties(shape, surface);
  }
  const gp_Pnt center = properties.CentreOfMass();
  const gp_Mat occt = properties.MatrixOfInertia();
  const double volume = static_cast<double>(exact.Volume);
  double error = std::fabs(properties.Mass() - volume) / volume;
  const Matrix inertia = exact.GetInertia();
  const double trace = static_cast<double>(inertia[0][0] + inertia[1][1] + inertia[2][2]);
  for (int i = 0; i < 3; ++i)
  {
    error = std::max(error, std::fabs(center.Coord(i + 1) - static_cast<double>(exact.Center[i])) / size);
    for (int j = 0; j < 3; ++j)
    {
      error =
        std::max(error, std::fabs(occt.Value(i + 1, j + 1) - static_cast<double>(inertia[i][j])) / trace);
    }
  }
  const double area = static_cast<double>(exact.Area);
  return { error, std::isnan(exact.Area) ? 0.0 : std::fabs(surface.Mass() / area - 1) };
}

/// The closed form and OCCT's own quadrature of the shape are independent: a slip in either stops the build.
void Compare(const std::string& name, const TopoDS_Shape& shape, const ExactMoments& exact, double size,
  bool volumes, std::ostream& log)
{
  const std::array<double, 2> plain = GetDifference(shape, exact, size, false);
  const std::array<double, 2> adaptive = GetDifference(shape, exact, size, true);
  log << name << ": OCCT differs by " << plain[0] << " or " << adaptive[0] << ", in area by " << plain[1]
      << " or " << adaptive[1] << "\n";
  // Each of OCCT's two rules misses some of these by percents; 1e-3 separates the better one from a wrong
  // formula.
  if (!((!volumes || std::min(plain[0], adaptive[0]) < 1e-3) && std::min(plain[1], adaptive[1]) < 1e-3))
  {
    throw std::runtime_error(name + ": the closed form and OCCT's quadrature disagree");
  }
}

void WriteSolid(const NamedSolid& named, const std::string& folder, json& entries, std::ostream& log)
{
  const ExactSolid solid = named.Make();
  if (solid.Shape.IsNull())
  {
    throw std::runtime_error(named.Name + ": OCCT made no solid");
  }
  for (const Variant& variant : GetVariants(solid))
  {
    const std::string file = named.Name + "-" + variant.Name + ".step";
    TopoDS_Shape shape = MovedShape(solid.Shape, variant.Move);
    const double size = solid.Size * static_cast<double>(variant.Move.Scale);
    const ExactMoments moments = Moved(solid.Moments, variant.Move);
    const double displacement = GetDisplacement(solid.Shape, shape, variant.Move, moments, size);
    if (variant.AsNurbs)
    {
      shape = BRepBuilderAPI_NurbsConvert(shape, true).Shape();
    }
    if (variant.Reversed)
    {
      shape.Reverse();
    }
    WriteStep(shape, folder + "/" + file, { variant.WithPcurves, variant.AllDigits, variant.Unit });
    if (solid.Comparable && !variant.Reversed && variant.Name != "far" && variant.Name != "distant")
    {
      // OCCT integrates about the world origin, which costs it all digits of a far part's inertia.
      Compare(named.Name + "-" + variant.Name, shape, moments, size, solid.VolumeComparable, log);
    }
    json entry =
      Describe(moments, size, variant.AllDigits ? displacement : GetShortFormatDisplacement(moments, size));
    entry["file"] = file;
    entry["solid"] = named.Name;
    entry["variant"] = variant.Name;
    entry["unit"] = variant.Unit;
    entry["pcurves"] = variant.WithPcurves;
    entries.push_back(entry);
  }
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::fprintf(stderr, "usage: smMakeSolids OUTDIR\n");
    return 1;
  }
  const std::string folder = argv[1];
  try
  {
    QuietOcct();
    std::ofstream log(folder + "/comparison.txt");
    json manifest;
    manifest["solids"] = json::array();
    for (const std::vector<NamedSolid>* solids : { &GetExactSolids(), &GetExactBlocks() })
    {
      for (const NamedSolid& solid : *solids)
      {
        WriteSolid(solid, folder, manifest["solids"], log);
      }
    }
    for (const SpecialFile& special : WriteSpecialFiles(folder))
    {
      json entry = special.Solids > 0
        ? Describe(special.Total, special.Size, GetShortFormatDisplacement(special.Total, special.Size))
        : json::object();
      entry["file"] = special.File;
      entry["solids"] = special.Solids;
      manifest["special"][special.Name] = entry;
    }
    std::ofstream(folder + "/manifest.json") << manifest.dump(1) << "\n";
  }
  catch (const Standard_Failure& failure)
  {
    std::fprintf(stderr, "smMakeSolids: OCCT: %s\n", failure.GetMessageString());
    return 1;
  }
  catch (const std::exception& failure)
  {
    std::fprintf(stderr, "smMakeSolids: %s\n", failure.what());
    return 1;
  }
  return 0;
}

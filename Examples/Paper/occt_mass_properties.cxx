// Computes the mass properties of the solids in a STEP file by OpenCASCADE's BRepGProp, for comparison.
#include "smJson.h"
#include "smOptions.h"

#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>

#include <chrono>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{
using sm::Json;

const char* const Footer =
  R"(Without --eps VolumeProperties works without an error estimate; with it, it is adaptive and "claimed" is its
estimate of the relative error. "seconds" is the time of VolumeProperties alone, "read_seconds" that of the reader.

Exit status: 0; 1 wrong usage; 2 the file cannot be read or has no solid, or OpenCASCADE failed.)";

class Stopwatch
{
public:
  double GetSeconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/// Returns a compound of every placement of every solid, without faces outside of solids, which belong to no
/// body.
TopoDS_Compound ReadSolids(const std::string& path, int& count)
{
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.TransferRoots() == 0)
  {
    throw std::runtime_error("OpenCASCADE cannot read the file");
  }
  BRep_Builder builder;
  TopoDS_Compound solids;
  builder.MakeCompound(solids);
  count = 0;
  for (TopExp_Explorer solid(reader.OneShape(), TopAbs_SOLID); solid.More(); solid.Next())
  {
    builder.Add(solids, solid.Current());
    ++count;
  }
  return solids;
}

Json Measure(const std::string& path, double eps)
{
  const Stopwatch reading;
  int count = 0;
  const TopoDS_Compound solids = ReadSolids(path, count);
  const double readSeconds = reading.GetSeconds();
  if (count == 0)
  {
    throw std::runtime_error("the file has no solid");
  }
  GProp_GProps volume;
  const Stopwatch integrating;
  const double claimed = eps > 0.0 ? BRepGProp::VolumeProperties(solids, volume, eps) : 0.0;
  if (!(eps > 0.0))
  {
    BRepGProp::VolumeProperties(solids, volume);
  }
  const double seconds = integrating.GetSeconds();
  GProp_GProps area;
  BRepGProp::SurfaceProperties(solids, area);
  const gp_Pnt center = volume.CentreOfMass();
  Json inertia = Json::array();
  for (int row = 1; row <= 3; ++row)
  {
    const gp_XYZ entries = volume.MatrixOfInertia().Row(row); // about the centre of mass
    inertia.push_back({ entries.X(), entries.Y(), entries.Z() });
  }
  Json result = { { "file", path }, { "solids", count }, { "eps", nullptr }, { "volume", volume.Mass() },
    { "claimed", nullptr }, { "area", area.Mass() },
    { "center_of_mass", { center.X(), center.Y(), center.Z() } }, { "inertia", inertia },
    { "seconds", seconds }, { "read_seconds", readSeconds } };
  if (eps > 0.0)
  {
    result["eps"] = eps;
    result["claimed"] = claimed;
  }
  return result;
}

std::string CheckEps(const std::string& text)
{
  const double eps = sm::ParseNumber(text);
  return eps > 0.0 && eps < 1.0 ? "" : "the relative error must be a number between 0 and 1";
}
}

int main(int argc, char** argv)
{
  std::string path;
  double eps = 0.0;
  CLI::App app(
    "Volume, area, centre of mass and inertia (about it, density 1) of all solids in a STEP file by\n"
    "OpenCASCADE's BRepGProp, as JSON on the standard output; lengths in mm.",
    "occt_mass_properties");
  app.footer(Footer);
  app.add_option("FILE", path, "STEP file")->required()->type_name("");
  sm::AddNumberOption(app, "--eps", eps, "Relative error to ask VolumeProperties for")->check(CheckEps);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 1;
  }
  Message::DefaultMessenger()->ChangePrinters().Clear();
  try
  {
    std::cout << sm::Dump(Measure(path, eps), 1) << "\n";
  }
  catch (const Standard_Failure& failure)
  {
    std::cerr << "occt_mass_properties: OpenCASCADE: " << failure.DynamicType()->Name() << " "
              << failure.GetMessageString() << "\n";
    return 2;
  }
  catch (const std::exception& failure)
  {
    std::cerr << "occt_mass_properties: " << failure.what() << "\n";
    return 2;
  }
  return 0;
}

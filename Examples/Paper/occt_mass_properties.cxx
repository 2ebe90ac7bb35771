// What OpenCASCADE's own BRepGProp says of the solids in a STEP file, as JSON on stdout; lengths in mm.
//   occt_mass_properties [--eps E] FILE.step
// Without --eps VolumeProperties in its default way, which states no error; with it the adaptive way, whose
// claimed relative error is "claimed". "seconds" is the time of VolumeProperties alone, "read_seconds" that of the
// reader. Exit status 0; 1 wrong usage; 2 nothing to read, or OpenCASCADE failed, and a sentence on stderr.
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <string>

namespace
{
using Json = nlohmann::ordered_json;

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

/// Every placement of every solid; faces beside the solids are no part of a body.
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
  Json result = { { "file", path }, { "solids", count }, { "eps", nullptr }, { "volume", volume.Mass() },
    { "claimed", nullptr }, { "area", area.Mass() },
    { "center_of_mass", { center.X(), center.Y(), center.Z() } }, { "seconds", seconds },
    { "read_seconds", readSeconds } };
  if (eps > 0.0)
  {
    result["eps"] = eps;
    result["claimed"] = claimed;
  }
  return result;
}

bool ParseArguments(int argc, char** argv, std::string& path, double& eps)
{
  eps = 0.0;
  if (argc == 4 && std::string(argv[1]) == "--eps")
  {
    eps = std::strtod(argv[2], nullptr);
    path = argv[3];
    return eps > 0.0 && eps < 1.0;
  }
  path = argc == 2 ? argv[1] : "";
  return argc == 2 && path[0] != '-';
}
}

int main(int argc, char** argv)
{
  std::string path;
  double eps = 0.0;
  if (!ParseArguments(argc, argv, path, eps))
  {
    std::cerr << "usage: occt_mass_properties [--eps E] FILE.step, 0 < E < 1\n";
    return 1;
  }
  Message::DefaultMessenger()->ChangePrinters().Clear();
  try
  {
    std::cout << Measure(path, eps).dump(1) << "\n";
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

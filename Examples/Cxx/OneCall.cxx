// The mass properties of a STEP file by one call: prints its volume, the bound of its error and the status.
#include <smComputeMassProperties.h>
#include <vtkNew.h>
#include <vtkSTEPReader.h>

#include <iomanip>
#include <iostream>

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: OneCall FILE.step\n";
    return 1;
  }
  // [one call]
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  sm::MassPropertiesOptions options;
  options.RelativeTolerance = 1e-10;
  const sm::MassPropertiesResult result = sm::ComputeMassProperties(reader->GetOutputDataObject(0), options);
  const sm::BodyMassProperties& total = result.Total; // result.Solids has each solid
  std::cout << std::setprecision(17) << "volume " << total.Volume.Value << " +/- " << total.Volume.Bound
            << " " << total.Status << "\n";
  // [one call]
  return total.Status == "ok" ? 0 : 3;
}

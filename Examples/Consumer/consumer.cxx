// A program outside SolidMoments' tree, built against its install: prints the volume of a STEP file.
#include <vtkMassPropertiesGPU.h>
#include <vtkNew.h>
#include <vtkSTEPReader.h>

#include <iomanip>
#include <iostream>

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: consumer FILE.step\n";
    return 1;
  }
  // [ten lines]
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  mass->Update();
  std::cout << std::setprecision(17) << mass->GetVolume() << "\n";
  // [ten lines]
  return mass->GetStatus() == "ok" ? 0 : 2;
}

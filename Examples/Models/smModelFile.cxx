#include "smModelFile.h"

#include <APIHeaderSection_MakeHeader.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <iomanip>
#include <iostream>

namespace smmodel
{
namespace
{
bool WriteStep(const TopoDS_Shape& shape, const ModelFile& file, const char* fileName)
{
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.product.name", file.Name.c_str());
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone)
  {
    return false;
  }
  const auto text = [](const std::string& string) { return new TCollection_HAsciiString(string.c_str()); };
  APIHeaderSection_MakeHeader header(writer.Model());
  header.SetName(text(file.Name + ".step"));
  header.SetTimeStamp(text("2025-01-01T00:00:00"));
  header.SetAuthorValue(1, text("SolidMoments"));
  header.SetOrganizationValue(1, text("SolidMoments"));
  header.SetOriginatingSystem(text(file.Program));
  header.SetDescriptionValue(1, text(file.Description));
  return writer.Write(fileName) == IFSelect_RetDone;
}
}

int Run(int argc, char** argv, const ModelFile& file, const std::function<TopoDS_Shape()>& make)
{
  if (argc != 2)
  {
    std::cerr << "usage: " << file.Program << " FILE.step\n";
    return 1;
  }
  try
  {
    const TopoDS_Shape shape = make();
    TopTools_IndexedMapOfShape solids;
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_SOLID, solids);
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties, 1e-6, true);
    const bool valid = solids.Extent() == 1 && BRepCheck_Analyzer(shape).IsValid();
    std::cout << solids.Extent() << " solid, " << faces.Extent() << " faces, "
              << (valid ? "valid" : "INVALID") << ", volume " << std::setprecision(9) << properties.Mass()
              << " mm^3\n";
    if (!valid || !WriteStep(solids(1), file, argv[1]))
    {
      std::cerr << file.Program << ": the part is not valid or " << argv[1] << " cannot be written\n";
      return 1;
    }
  }
  catch (const Standard_Failure& failure)
  {
    std::cerr << file.Program << ": OpenCASCADE: " << failure.GetMessageString() << "\n";
    return 1;
  }
  return 0;
}
}

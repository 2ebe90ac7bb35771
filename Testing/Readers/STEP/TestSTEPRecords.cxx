// TestSTEPRecords FILE.step...: the model that OpenCASCADE loads of our records is the one it loads of its
// own parser's, entity by entity, with the same complaints; texts that it may read in another way are left to
// it.
#include "smMemoryBuffer.h"
#include "smOCCTFile.h"
#include "smOCCTRecords.h"
#include "smReaderTesting.h"

#include <Interface_Check.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_WorkSession.hxx>

#include <istream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

std::string Wrap(const std::string& data)
{
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n/* (;' */\n"
         "FILE_NAME('a','2020',('b','c'),(''),'','','');\nFILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 "
         "}'));\nENDSEC;\nDATA;\n" +
    data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

bool MakeRecords(const std::string& text, sm::KernelRecords& records)
{
  sm::Part21File file;
  file.Parse(text);
  return records.Make(file, std::vector<bool>(file.GetTypeNames().size()));
}

/// The model as text, and how often OpenCASCADE complains about each of its entities.
std::string Load(const std::string& text, const sm::KernelRecords* records)
{
  const sm::KernelSession kernel;
  STEPControl_Reader reader;
  if (records)
  {
    reader.WS()->SetLibrary(sm::MakeRecordLibrary(*records));
  }
  sm::MemoryBuffer buffer(records ? std::string_view() : std::string_view(text));
  std::istream stream(&buffer);
  if (reader.ReadStream("", stream) != IFSelect_RetDone)
  {
    return "not read";
  }
  const Handle(StepData_StepModel) model = Handle(StepData_StepModel)::DownCast(reader.WS()->Model());
  StepData_StepWriter writer(model);
  writer.SendModel(Handle(StepData_Protocol)::DownCast(reader.WS()->Protocol()));
  std::ostringstream result;
  writer.Print(result);
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const Handle(Interface_Check) check = model->Check(i, true);
    for (int k = 1; k <= check->NbFails(); ++k)
    {
      result << "#" << model->IdentLabel(model->Value(i)) << ": " << check->CFail(k) << "\n";
    }
    result << check->NbWarnings();
  }
  return result.str();
}

void CheckSame(const std::string& name, const std::string& text)
{
  sm::KernelRecords records;
  CheckTrue(name + ": records", MakeRecords(text, records));
  const std::string expected = Load(text, nullptr);
  CheckTrue(name + ": read", expected.size() > 100);
  CheckTrue(name + ": the same model", Load(text, &records) == expected);
}

/// Every kind of token, known entities and others, references in both directions and to nothing.
void CheckTokens()
{
  CheckSame("tokens",
    Wrap("#7=CARTESIAN_POINT('it''s (;',(1.,-2.5E-3,+.5));#3 = DIRECTION ( 'a\n b' ,\t( 0. , 0. , 1. ) ) ;\n"
         "#11=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n"
         "#0012=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-05),#11,'','');\n"
         "#20=X_THING(1,12,-3,+4,1.,12E5,.T.,$,*,\"0FF\",#7,(),((1,2),(#3,'x')),Y(1),Y((2,Z(3))));\n"
         "#21=AXIS2_PLACEMENT_3D('',#7,#3,$);#22=VERTEX_POINT('',#7);#23=VECTOR('',#3,2);\n"
         "#24=(B_SPLINE_CURVE(1,(#7,#7),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((2,2),(0.,1.),."
         "UNSPECIFIED.)\n"
         "BOUNDED_CURVE()CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,2.))"
         "REPRESENTATION_ITEM(''));\n"
         "#25=LINE('',#7,#99);#26=CIRCLE('',#21,'x');#27=CIRCLE('',#21);/* #28=A(); */#29=x_small(1);\n"));
}

/// A comma behind two apostrophes in a string ends it for OpenCASCADE's lexer.
void CheckStrings()
{
  sm::KernelRecords records;
  CheckTrue(
    "apostrophe and comma", MakeRecords(Wrap("#1=CARTESIAN_POINT('5'',6''(7'')',(1.,2.,3.));\n"), records));
  const sm::KernelSession kernel;
  STEPControl_Reader reader;
  reader.WS()->SetLibrary(sm::MakeRecordLibrary(records));
  std::istringstream stream;
  CheckTrue("  read", reader.ReadStream("", stream) == IFSelect_RetDone);
  const auto point = Handle(StepGeom_CartesianPoint)::DownCast(reader.WS()->Model()->Value(1));
  CheckEqual("  name", "5',6'(7')", std::string(point->Name()->ToCString()));
}

void CheckEmptied()
{
  sm::Part21File file;
  file.Parse(Wrap("#1=X_LIST('a)',2,((0.,1.),(3.,4.)));\n#2=Y(#1);\n#3=(X_LIST(1)Z());\n"));
  sm::KernelRecords records;
  CheckTrue("emptied: records", records.Make(file, { true, false, false }));
  CheckTrue("  the same model",
    Load("", &records) == Load(Wrap("#1=X_LIST();\n#2=Y(#1);\n#3=(X_LIST(1)Z());\n"), nullptr));
}

/// Texts that OpenCASCADE's parser may read in another way, or not at all, are left to it.
void CheckLeft()
{
  for (const char* data : { "#1=A(1e5);", "#1=A(1E5);", "#1=A(.true.);", "#1=A(\"0ff\");", "#0=A();",
         "#1=A(#0);", "#2147483648=A();", "#1=A(#2147483648);", "#1=A();#1=B();", "#1=A(1,);",
         "#1=A(1;#2=B();", "text #1=A();", "#1=A();text;", "#1=A();ENDSEC;DATA;#2=B();", "#1=A(<x>);",
         "#1=A(\x01);", "&SCOPE #1=A(); ENDSCOPE", "" })
  {
    sm::KernelRecords records;
    CheckTrue(
      std::string("left to the parser: ") + data, !MakeRecords(Wrap(std::string(data) + "\n"), records));
  }
  const std::string text = Wrap("#1=A();\n");
  for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
         { "DATA;", "DATA('a',('b'));" }, { "HEADER;", "" }, { "FILE_NAME(", "FILE_NAME((" },
         { "'2;1')", "'2;1',)" }, { "END-ISO-10303-21;", "" }, { "ENDSEC;\nEND", "END" } })
  {
    sm::KernelRecords records;
    std::string changed = text;
    changed.replace(changed.find(from), from.size(), to);
    CheckTrue("left to the parser: " + to + " for " + from, !MakeRecords(changed, records));
  }
}
}

int TestSTEPRecords(int argc, char* argv[])
{
  CheckTokens();
  CheckStrings();
  CheckEmptied();
  CheckLeft();
  for (int i = 1; i < argc; ++i)
  {
    CheckSame(argv[i], ReadAll(argv[i]));
  }
  return Finish();
}

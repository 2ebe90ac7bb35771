// TestSTEPCrashes FOLDER: files that OpenCASCADE crashes on, in this very process: each is read without the damage, or refused with its
// entity. FOLDER takes the files.
#include "smCensusSamples.h"
#include "smFileState.h"
#include "smReaderTesting.h"

#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"

#include <cstdio>
#include <cstdlib>
#include <regex>
#include <string>

namespace
{
using namespace smtest;

/// What the reader says of a ball in a box.
struct Reading
{
  std::string Status;
  std::string Said;
  int Bodies = 0;
};

Reading ReadText(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  ErrorLog log;
  log.Watch(reader);
  ErrorLog executive;
  executive.Watch(reader->GetExecutive());
  reader->SetFileName(Make("reader_crashes.step", MakeStepText(text)).c_str());
  reader->Update();
  Reading reading{ reader->GetStatusAsString(), log.Text, reader->GetNumberOfBodies() };
  for (int i = 0; i < reader->GetNumberOfMessages(); ++i)
  {
    reading.Said += std::string("\n") + reader->GetMessage(i);
  }
  for (const std::string& defect : sm::GetFileState(reader->GetOutput()).Defects)
  {
    reading.Said += "\n" + defect;
  }
  return reading;
}

void CheckRefused(const std::string& name, const std::string& text, const std::string& said)
{
  const Reading reading = ReadText(text);
  CheckEqual(name, "unreadable", reading.Status);
  CheckTrue("  said", reading.Said.find(said) != std::string::npos, reading.Said);
}

/// An entity that nothing depends on.
void CheckUnused(const std::string& entity, const std::string& said = "")
{
  const Reading reading = ReadText(GetBallText() + GetAssemblyText() + entity + "\n");
  CheckEqual("beside the ball: " + entity, "ok", reading.Status);
  CheckEqual("  bodies", 1, reading.Bodies);
  CheckTrue("  said", said.empty() ? reading.Said.empty() : reading.Said.find(said) != std::string::npos,
    reading.Said);
}

void CheckEmptyLists()
{
  for (const char* entity :
    { "#90=DIRECTION('',());", "#90=DIRECTION('',( /* none */ ));",
      "#90=TRIMMED_CURVE('',#23,(),(),.T.,.PARAMETER.);", "#90=CURVE_BOUNDED_SURFACE('',#24,(),.T.);",
      "#90=B_SPLINE_CURVE_WITH_KNOTS('',1,(#20,#26),.UNSPECIFIED.,.F.,.F.,(),(),.UNSPECIFIED.);",
      "#90=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#20,#26),(#20,#26)),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(),(),(0."
      ",1.),"
      ".UNSPECIFIED.);",
      "#90=SURFACE_CURVE('',#23,(),.CURVE_3D.);", "#90=DERIVED_UNIT(());", "#90=INVISIBILITY(());",
      "#90=CC_DESIGN_APPROVAL(#1,());", "#90=APPLIED_APPROVAL_ASSIGNMENT(#1,());",
      "#90=PRESENTATION_STYLE_BY_CONTEXT((()),#1);", "#90=PARALLELISM_TOLERANCE('','',$,#1,());" })
  {
    CheckUnused(entity);
  }
  CheckUnused("#90=EDGE_LOOP('',());", "Entity #90 of the file: used by nothing");
  CheckUnused("#90=DIRECTION('not () empty',(1.,0.,0.));");
  const std::string ball = GetBallText() + GetAssemblyText();
  CheckEqual(
    "strings are no lists", "ok", ReadText(Replace(ball, "DIRECTION('',(0.", "DIRECTION('()',(0.")).Status);
  CheckRefused(
    "the ball's direction", Replace(ball, "DIRECTION('',(0.,0.,1.))", "DIRECTION('',())"), "first #23");
}

void CheckNestedLists()
{
  constexpr std::size_t deep = 300000;
  const std::string lists = std::string(deep, '(') + std::string(deep, ')');
  CheckUnused("#90=X(" + lists + ");");
  CheckUnused("#90=DIRECTION(''," + lists + ");");
  CheckUnused("#90=DIRECTION('" + lists + "',(1.,0.,0.));");
  const std::string ball = GetBallText() + GetAssemblyText();
  const Reading named =
    ReadText(Replace(ball, "DIRECTION('',(0.", "DIRECTION('" + lists.substr(0, deep) + "',(0."));
  CheckEqual("brackets in a string are no lists", "ok", named.Status);
  CheckEqual("  said", "", named.Said);
}

void CheckLongNumbers()
{
  const std::string ball = GetBallText() + GetAssemblyText();
  for (const char* id : { "#2147483648", "#4294967322", "#9223372036854775808" })
  {
    CheckRefused(id, Replace(Replace(ball, "#26=", std::string(id) + "="), "#26)", std::string(id) + ")"),
      "the number of its entity " + std::string(id) + " exceeds 2147483647");
    CheckUnused(std::string(id) + "=CARTESIAN_POINT('',(0.,0.,9.));");
  }
  CheckEqual("the longest number", "ok",
    ReadText(Replace(Replace(ball, "#26=", "#2147483647="), "#26)", "#0002147483647)")).Status);
}

/// The shape that the box places belongs to the box.
void CheckCycles()
{
  const std::string ball = GetBallText() + GetAssemblyText();
  const std::string cycle = "#64 (assembly contains itself, the placed product contains this one)";
  CheckRefused("the ball's shape is the box's", Replace(ball, "'','',#44)", "'','',#52)"), cycle);
  CheckRefused("the box placed in itself", Replace(ball, "'','',#32,#54)", "'','',#54,#54)"), cycle);
  CheckRefused("a mapped item of its own shape",
    Replace(ball, "(#23,#31)", "(#23,#31,#70)") +
      "#70=MAPPED_ITEM('',#71,#23);\n#71=REPRESENTATION_MAP(#23,#32);\n",
    "#70 (assembly contains itself, contains itself)");
  CheckRefused("mapped items of each other's shapes",
    Replace(ball, "(#23,#31)", "(#23,#31,#70)") +
      "#70=MAPPED_ITEM('',#71,#23);\n#71=REPRESENTATION_MAP(#23,#72);\n#72=SHAPE_REPRESENTATION('',(#23,#73),"
      "#6);\n"
      "#73=MAPPED_ITEM('',#74,#23);\n#74=REPRESENTATION_MAP(#23,#32);\n",
    "(assembly contains itself, contains itself)");
  const Reading unused = ReadText(ball +
    "#70=MAPPED_ITEM('',#71,#23);\n#71=REPRESENTATION_MAP(#23,#72);\n#72=SHAPE_REPRESENTATION('',(#23,#70),#"
    "6);\n");
  CheckEqual("one that no product has", "ok", unused.Status);
  CheckRefused("the first owner counts",
    Replace(ball, "#46=", "#39=SHAPE_DEFINITION_REPRESENTATION(#53,#32);\n#46="), cycle);
  CheckEqual("the second owner does not", "ok",
    ReadText(ball + "#65=SHAPE_DEFINITION_REPRESENTATION(#53,#32);\n").Status);
}

/// A plane face with two edges, in the place of the ball's face. Point #94, the vertex of #87, is left to be added.
std::string MakeDisc()
{
  return Replace(GetBallText() + GetAssemblyText(), "#29=ADVANCED_FACE('',(#28),#24,.T.);\n",
    "#29=ADVANCED_FACE('',(#80),#81,.T.);\n#80=FACE_BOUND('',#82,.T.);\n#81=PLANE('',#23);\n"
    "#82=EDGE_LOOP('',(#83,#84));\n#83=ORIENTED_EDGE('',*,*,#85,.T.);\n#84=ORIENTED_EDGE('',*,*,#86,.T.);\n"
    "#85=EDGE_CURVE('',#87,#88,#89,.T.);\n#86=EDGE_CURVE('',#88,#87,#90,.T.);\n#89=CIRCLE('',#23,5.);\n"
    "#90=LINE('',#91,#93);\n#91=CARTESIAN_POINT('',(-5.,0.,0.));\n#93=VECTOR('',#22,1.);\n"
    "#88=VERTEX_POINT('',#91);\n#87=VERTEX_POINT('',#94);\n");
}

/// OpenCASCADE took an undefined number for a record's position: at that of the oriented edge itself it recursed without end.
void CheckUndefinedNumbers()
{
  // Its numbers begin with 900, so that none of them is a record's position.
  const std::string disc =
    std::regex_replace(Replace(MakeDisc() + "#94=CARTESIAN_POINT('',(5.,0.,0.));\n", "*,*,#85", "*,*,?"),
      std::regex("#"), "#900");
  // Our records, and those of OpenCASCADE's parser, which small letters of exponents are left to.
  for (const std::string& text : { disc, disc + "#90095=CARTESIAN_POINT('',(1e1,0.,0.));\n" })
  {
    for (int number = 1; number < 150; ++number)
    {
      const std::string id = "#" + std::to_string(number);
      CheckRefused("undefined " + id, Replace(text, "?", id), "first #90083 (undefined reference)");
    }
  }
}

void CheckOthers()
{
  const std::string ball = GetBallText() + GetAssemblyText();
  CheckRefused("a location in the plane",
    Replace(ball, "(#62)", "(#70)") +
      "#70=ITEM_DEFINED_TRANSFORMATION('','',#23,#71);\n#71=AXIS2_PLACEMENT_3D('',#72,#21,#22);\n"
      "#72=CARTESIAN_POINT('',(0.,0.));\n",
    "#71 (value out of range, location without three coordinates)");
  const std::string disc = MakeDisc();
  CheckTrue("a half disc", ReadText(disc + "#94=CARTESIAN_POINT('',(5.,0.,0.));\n").Bodies > 0);
  CheckRefused("a point on a curve", disc + "#94=POINT_ON_CURVE('',#89,0.);\n",
    "#87 (wrong type, a point that is not read)");
  // The shape of an aspect that has a validation property, with an item that is not there.
  const std::string aspect =
    "#70=SHAPE_ASPECT('','',#45,.T.);\n#71=PROPERTY_DEFINITION('','Shape for Validation Properties',#70);\n"
    "#72=SHAPE_DEFINITION_REPRESENTATION(#71,#73);\n#73=SHAPE_REPRESENTATION('',(#31),#6);\n"
    "#74=MEASURE_REPRESENTATION_ITEM('volume measure',VOLUME_MEASURE(523.6),#75);\n"
    "#75=DERIVED_UNIT((#76));\n#76=DERIVED_UNIT_ELEMENT(#2,3.);\n#77=REPRESENTATION('volume',(#74),#6);\n"
    "#78=PROPERTY_DEFINITION('geometric validation property','',#70);\n"
    "#79=PROPERTY_DEFINITION_REPRESENTATION(#78,#77);\n";
  CheckEqual("an aspect", "ok", ReadText(ball + aspect).Status);
  CheckEqual("an aspect without its item", "ok", ReadText(ball + Replace(aspect, "(#31)", "(#99)")).Status);
}
}

int TestSTEPCrashes(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return EXIT_FAILURE;
  }
  Folder = argv[1];
  CheckEmptyLists();
  CheckNestedLists();
  CheckLongNumbers();
  CheckCycles();
  CheckUndefinedNumbers();
  CheckOthers();
  return Finish();
}

// TestSTEPGuards FOLDER: what stands between a damaged file and OpenCASCADE, which follows null references
// and cycles without end. Each file is read without the damage, or refused with its entity. Every input here
// was seen to be harmless: OpenCASCADE alone reads or refuses it. FOLDER takes the files.
#include "smCensusSamples.h"
#include "smFileState.h"
#include "smReaderTesting.h"

#include "vtkExecutive.h"
#include "vtkNURBSDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTrimmedNURBSModel.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

/// What the reader says of a ball in a box.
struct Reading
{
  std::string Status;
  std::string Said;
  int Bodies = 0;
  /// Entity number of the first face.
  long long FirstFace = 0;
  /// Half the width of each body.
  std::vector<double> Radii;
};

Reading ReadText(const std::string& text)
{
  vtkNew<vtkSTEPReader> reader;
  ErrorLog log;
  log.Watch(reader);
  ErrorLog executive;
  executive.Watch(reader->GetExecutive());
  reader->SetFileName(Make("reader_guards.step", MakeStepText(text)).c_str());
  reader->Update();
  Reading reading{ reader->GetStatusAsString(), log.Text, reader->GetNumberOfBodies(), 0, {} };
  for (int i = 0; i < reading.Bodies; ++i)
  {
    auto* const body = vtkNURBSDataSet::SafeDownCast(
      reader->GetOutput()->GetPartitionAsDataObject(static_cast<unsigned int>(i), 0));
    reading.FirstFace = i > 0 ? reading.FirstFace : body->GetModel()->GetFaces()[0]->FileId;
    reading.Radii.push_back(
      0.5 * (body->GetModel()->GetLocalBounds()[1] - body->GetModel()->GetLocalBounds()[0]));
  }
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
  CheckEqual("next to the ball: " + entity, "ok", reading.Status);
  CheckEqual("  bodies", 1, reading.Bodies);
  CheckTrue("  said", said.empty() ? reading.Said.empty() : reading.Said.find(said) != std::string::npos,
    reading.Said);
}

void CheckLists()
{
  for (const char* entity :
    { "#90=TRIMMED_CURVE('',#23,(),(),.T.,.PARAMETER.);", "#90=SURFACE_CURVE('',#23,(),.CURVE_3D.);",
      "#90=CC_DESIGN_APPROVAL(#1,());", "#90=APPLIED_APPROVAL_ASSIGNMENT(#1,());",
      "#90=PARALLELISM_TOLERANCE('','',$,#1,());", "#90=DIRECTION('not () empty',(1.,0.,0.));" })
  {
    CheckUnused(entity);
  }
  const std::string ball = GetBallText() + GetAssemblyText();
  CheckEqual(
    "strings are not lists", "ok", ReadText(Replace(ball, "DIRECTION('',(0.", "DIRECTION('()',(0.")).Status);
  const Reading brief = ReadText(Replace(ball, "DIRECTION('',(0.,0.,1.))", "DIRECTION('',(1.))"));
  CheckTrue("a direction with one number",
    brief.Said.find("#21 of the file: value out of range (number of coordinates)") != std::string::npos,
    brief.Said);
  const std::string brackets(1000, '(');
  CheckUnused("#90=DIRECTION('" + brackets + "',(1.,0.,0.));");
  const Reading named = ReadText(Replace(ball, "DIRECTION('',(0.", "DIRECTION('" + brackets + "',(0."));
  CheckEqual("brackets in a string are not lists", "ok", named.Status);
  CheckEqual("  said", "", named.Said);
}

void CheckLongNumbers()
{
  const std::string ball = GetBallText() + GetAssemblyText();
  const auto renumber = [&ball](const std::string& from, const std::string& to)
  { return Replace(Replace(ball, from + "=", to + "="), from + ")", to + ")"); };
  const char* const tooLong = "#9223372036854775808";
  CheckRefused(tooLong, renumber("#26", tooLong),
    "the number of its entity " + std::string(tooLong) + " exceeds 9223372036854775807");
  for (const char* id : { "#2147483648", "#4294967322", tooLong })
  {
    CheckUnused(std::string(id) + "=CARTESIAN_POINT('',(0.,0.,9.));");
  }
  CheckEqual("the longest number", "ok", ReadText(renumber("#26", "#9223372036854775807")).Status);
  // More digits than a double or an int has: every one of them is kept.
  const Reading face = ReadText(renumber("#29", "#9007199254740993"));
  CheckEqual("a long number of a face", "ok", face.Status);
  CheckEqual("  kept", 9007199254740993ll, face.FirstFace);
  // Numbers that agree in their last 32 bits (findings/occt_entity_numbers_are_modulo_2_32.sh).
  std::string second;
  const std::string other = Replace(GetBallText(), "5.);\n#26", "7.);\n#26");
  for (std::size_t at = 0; at < other.size(); ++at)
  {
    const std::size_t end = other[at] == '#' ? other.find_first_not_of("0123456789", at + 1) : at + 1;
    second += end > at + 1 ? "#" + std::to_string(std::stoll(other.substr(at + 1)) + (1ll << 32))
                           : std::string(1, other[at]);
    at = end - 1;
  }
  const Reading two = ReadText(GetBallText() + second);
  CheckEqual("the same numbers modulo 2^32", 2, two.Bodies);
  CheckTrue("  are different balls",
    two.Radii.size() == 2 && std::abs(two.Radii[0] - 5.0) < 1e-6 && std::abs(two.Radii[1] - 7.0) < 1e-6);
}

/// What a file hides counts, and is reported: a body by its style, by its layer and with its representation,
/// an occurrence by the context of its style.
void CheckHidden()
{
  const std::string ball = GetBallText() + GetAssemblyText();
  const std::string style = "#90=PRESENTATION_STYLE_ASSIGNMENT((NULL_STYLE(.NULL.)));\n";
  const std::string said = "1 body or occurrence is hidden in the file (INVISIBILITY), first #";
  const struct
  {
    const char* Name;
    std::string Text;
    std::string First;
  } cases[] = {
    { "hidden by its style", style + "#91=STYLED_ITEM('',(#90),#31);\n#92=INVISIBILITY((#91));\n", "31" },
    { "hidden by a layer", "#91=PRESENTATION_LAYER_ASSIGNMENT('a','',(#31));\n#92=INVISIBILITY((#91));\n",
      "31" },
    { "hidden with its representation", "#92=INVISIBILITY((#32));\n", "31" },
    { "a hidden occurrence",
      "#93=PRESENTATION_STYLE_BY_CONTEXT((NULL_STYLE(.NULL.)),#95);\n#94=SHAPE_DEFINITION_REPRESENTATION(#61,"
      "#95);\n"
      "#95=SHAPE_REPRESENTATION('',(#23),#6);\n#91=STYLED_ITEM('',(#93),#31);\n#92=INVISIBILITY((#91));\n",
      "60" },
  };
  for (const auto& hidden : cases)
  {
    const Reading reading = ReadText(ball + hidden.Text);
    CheckEqual(hidden.Name, "ok", reading.Status);
    CheckTrue("  said", reading.Said.find(said + hidden.First + ":") != std::string::npos, reading.Said);
  }
  CheckEqual("hidden, and nothing there", "", ReadText(ball + "#92=INVISIBILITY((#99));\n").Said);
}

/// Shapes that refer to each other, but belong to no product, and a shape with two owners.
void CheckOwners()
{
  const std::string ball = GetBallText() + GetAssemblyText();
  const Reading unused = ReadText(ball +
    "#70=MAPPED_ITEM('',#71,#23);\n#71=REPRESENTATION_MAP(#23,#72);\n#72=SHAPE_REPRESENTATION('',(#23,#70),#"
    "6);\n");
  CheckEqual("a shape that no product has", "ok", unused.Status);
  CheckEqual("the second owner does not count", "ok",
    ReadText(ball + "#65=SHAPE_DEFINITION_REPRESENTATION(#53,#32);\n").Status);
}

/// A plane face with two edges, in the place of the ball's face. Point #94, the vertex of #87, is left to be
/// added.
std::string MakeDisc()
{
  return Replace(GetBallText() + GetAssemblyText(), "#29=ADVANCED_FACE('',(#28),#24,.T.);\n",
    "#29=ADVANCED_FACE('',(#80),#81,.T.);\n#80=FACE_BOUND('',#82,.T.);\n#81=PLANE('',#23);\n"
    "#82=EDGE_LOOP('',(#83,#84));\n#83=ORIENTED_EDGE('',*,*,#85,.T.);\n#84=ORIENTED_EDGE('',*,*,#86,.T.);\n"
    "#85=EDGE_CURVE('',#87,#88,#89,.T.);\n#86=EDGE_CURVE('',#88,#87,#90,.T.);\n#89=CIRCLE('',#23,5.);\n"
    "#90=LINE('',#91,#93);\n#91=CARTESIAN_POINT('',(-5.,0.,0.));\n#93=VECTOR('',#22,1.);\n"
    "#88=VERTEX_POINT('',#91);\n#87=VERTEX_POINT('',#94);\n");
}

/// An oriented edge of an entity that is not there. OpenCASCADE takes a number for a record's position.
void CheckUndefinedNumbers()
{
  // Its numbers begin with 900, so that none of them is a record's position.
  const std::string disc =
    std::regex_replace(Replace(MakeDisc() + "#94=CARTESIAN_POINT('',(5.,0.,0.));\n", "*,*,#85", "*,*,?"),
      std::regex("#"), "#900");
  // Our records, and those of OpenCASCADE's parser, which small letters of exponents are left to.
  for (const std::string& text : { disc, disc + "#90095=CARTESIAN_POINT('',(1e1,0.,0.));\n" })
  {
    for (const char* id : { "#6", "#46", "#126" })
    {
      CheckRefused(std::string("undefined ") + id, Replace(text, "?", id),
        "entity #90083 (ORIENTED_EDGE) is not read, undefined reference");
    }
  }
}

void CheckOthers()
{
  const std::string ball = GetBallText() + GetAssemblyText();
  const std::string disc = MakeDisc();
  CheckTrue("a half disc", ReadText(disc + "#94=CARTESIAN_POINT('',(5.,0.,0.));\n").Bodies > 0);
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

int TestSTEPGuards(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return EXIT_FAILURE;
  }
  Folder = argv[1];
  CheckLists();
  CheckLongNumbers();
  CheckHidden();
  CheckOwners();
  CheckUndefinedNumbers();
  CheckOthers();
  return Finish();
}

// TestSTEPMeanings FOLDER: what the standard says by rules that OpenCASCADE does not follow: chains of units,
// placements of instances, omitted directions, and solids of several products. A box of 1 x 2 x 3 has exact
// values in all of them.
#include "smReaderTesting.h"
#include "smStepText.h"
#include "smTestPipeline.h"

#include <StepData_StepModel.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using namespace smtest;
namespace names = sm::names;

using Vector = std::array<double, 3>;
const Vector BoxCenter = { 0.5, 1.0, 1.5 };
const std::string Millimetre = "(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))";
const std::string Radian = "(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))";

/// A file that is changed as text.
class BoxText
{
public:
  BoxText()
  {
    const std::string path = Folder + "/meanings_box.step";
    StepPrism().Write(path, { { { { 0, 0, 0 }, { 1, 0, 1 }, { 1, 2, 2 }, { 0, 2, 3 } }, true } }, 3.0);
    this->Text = ReadAll(path);
  }

  /// Exchanges a text, of which there must be one.
  BoxText& Exchange(const std::string& from, const std::string& to)
  {
    const std::size_t at = this->Text.find(from);
    CheckTrue(
      "one " + from, at != std::string::npos && this->Text.find(from, at + from.size()) == std::string::npos);
    this->Text.replace(std::min(at, this->Text.size()), from.size(), to);
    return *this;
  }
  BoxText& Add(const std::string& entities)
  {
    this->Text.insert(this->Text.find("ENDSEC;\nEND-ISO"), entities);
    return *this;
  }
  /// The name "#n" of the entity of a type, of which there must be one.
  std::string Find(const std::string& type) const
  {
    const std::size_t end = this->Text.find("=" + type + "(");
    const std::size_t begin = end == std::string::npos ? end : this->Text.rfind('#', end);
    CheckTrue("an entity " + type, begin != std::string::npos);
    return begin == std::string::npos ? "#0" : this->Text.substr(begin, end - begin);
  }
  std::string FindContext() const
  {
    return this->Find("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT");
  }

  /// The box in a second product, which is #900 and has the representation `shape`.
  BoxText& AddProduct(const std::string& shape)
  {
    const std::string definition = this->Find("PRODUCT_DEFINITION");
    const std::size_t at = this->Text.find(definition + "=PRODUCT_DEFINITION(");
    const std::string parameters = this->Text.substr(at, this->Text.find(';', at) + 1 - at);
    return this->Add("#900" + parameters.substr(definition.size()) +
      "\n#901=PRODUCT_DEFINITION_SHAPE('','',#900);\n#902=SHAPE_DEFINITION_REPRESENTATION(#901," + shape +
      ");\n");
  }

  /// Places the box by a mapped item, with this target; the shape of the product is then #950.
  BoxText& Map(const std::string& origin, const std::string& target)
  {
    const std::string shape = this->Find("ADVANCED_BREP_SHAPE_REPRESENTATION");
    const std::string link = this->Find("SHAPE_DEFINITION_REPRESENTATION");
    return this->Exchange("," + shape + ");", ",#950);")
      .Add("#951=REPRESENTATION_MAP(" + origin + "," + shape + ");\n#952=MAPPED_ITEM('',#951," + target +
        ");\n#950=SHAPE_REPRESENTATION('',(#952)," + this->FindContext() + ");\n");
  }

  /// Places the box in an assembly; interchanged: the relationship names the assembly first.
  BoxText& Assemble(const std::string& origin, const std::string& target, bool isInterchanged)
  {
    const std::string shape = this->Find("ADVANCED_BREP_SHAPE_REPRESENTATION");
    const std::string part = this->Find("PRODUCT_DEFINITION");
    this->Exchange("'',(", "'',(" + origin + ",", shape + "=ADVANCED_BREP_SHAPE_REPRESENTATION(");
    this->Add("#950=SHAPE_REPRESENTATION('',(" + target + ")," + this->FindContext() +
      ");\n#953=NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','one','',#900," + part +
      ",$);\n#954=PRODUCT_DEFINITION_SHAPE('','',#953);\n#955=ITEM_DEFINED_TRANSFORMATION('',''," + origin +
      "," + target + ");\n#956=(REPRESENTATION_RELATIONSHIP(''," +
      (isInterchanged ? "'',#950," + shape : "''," + shape + ",#950") +
      ")REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#955)SHAPE_REPRESENTATION_RELATIONSHIP());\n"
      "#957=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#956,#954);\n");
    return this->AddProduct("#950");
  }

  /// Exchanges a text behind another one.
  BoxText& Exchange(const std::string& from, const std::string& to, const std::string& behind)
  {
    const std::size_t at = this->Text.find(from, this->Text.find(behind));
    CheckTrue("a text behind " + behind, at != std::string::npos);
    this->Text.replace(std::min(at, this->Text.size()), from.size(), to);
    return *this;
  }

  std::string Text;
};

void CheckBox(const std::string& name, const BoxText& box, double unit, const Vector& center,
  const std::string& said = "")
{
  std::printf("--- %s\n", name.c_str());
  Pipeline pipeline(Make("meanings_" + name + ".step", box.Text));
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
  MessageTrap reader(pipeline.Reader);
  MessageTrap filter(pipeline.Mass);
  pipeline.Mass->Update();
  CheckEqual(
    "status", said.empty() ? names::StatusOk : names::StatusSuspect, std::string(pipeline.Mass->GetStatus()));
  CheckTrue("messages", said.empty() ? pipeline.Mass->GetNumberOfMessages() == 0 : Says(pipeline.Mass, said),
    GetMessages(pipeline.Mass));
  Check("volume", 6.0 * unit * unit * unit, pipeline.Mass->GetVolume(), 1e-13 * 6.0 * unit * unit * unit,
    "planes: rounding");
  Vector read{};
  pipeline.Mass->GetCenterOfMass(read.data());
  for (std::size_t k = 0; said.empty() && k < 3; ++k)
  {
    Check("center", center[k], read[k], 1e-13 * (unit + std::fabs(center[k])), "planes: rounding");
  }
}

void CheckUnits()
{
  const auto scale = [](double unit) {
    return Vector{ unit * BoxCenter[0], unit * BoxCenter[1], unit * BoxCenter[2] };
  };
  const std::string foot =
    "(CONVERSION_BASED_UNIT('FOOT',#801)LENGTH_UNIT()NAMED_UNIT(#800));\n#800=DIMENSIONAL_EXPONENTS(1.,0.,0.,"
    "0.,0.,0.,0.);\n#801=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(12.),#802);\n#803=LENGTH_MEASURE_WITH_UNIT("
    "LENGTH_MEASURE(25.4),#804);\n#804=" +
    Millimetre + ";\n#802=";
  const std::string inch = "(CONVERSION_BASED_UNIT('INCH',#803)LENGTH_UNIT()NAMED_UNIT(#800))";
  CheckBox("foot_of_12_inches", BoxText().Exchange(Millimetre, foot + inch), 304.8, scale(304.8));
  const BoxText named = BoxText()
                          .Exchange(Millimetre, foot + inch)
                          .Exchange("'FOOT'", "'SMOOT'")
                          .Exchange("(12.)", "(10.)")
                          .Exchange("(25.4)", "(1.)");
  CheckBox("unknown_name", named, 10.0, scale(10.0));
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(Make("meanings_unknown_name.step", named.Text).c_str());
  reader->SetOutputUnit("file");
  reader->Update();
  CheckEqual("a unit with an unknown name is known by its size", "cm", reader->GetLengthUnit());
  CheckBox("foot_of_simple_inches",
    BoxText().Exchange(Millimetre, foot + "CONVERSION_BASED_UNIT(#800,'INCH',#803)"), 304.8, scale(304.8));
  CheckBox("simple_unit", BoxText().Exchange(Millimetre, "SI_UNIT(*,.CENTI.,.METRE.)"), 10.0, scale(10.0));
  CheckBox("simple_unit_of_angles", BoxText().Exchange(Radian, "SI_UNIT(*,$,.RADIAN.)"), 1.0, BoxCenter);
}

/// #810: at (5,0,0); #811: at (100,0,0), rotated by 90 degrees; #812: at the origin, the axis is x, the
/// reference direction omitted or x.
std::string AddFrames(const std::string& reference = "$")
{
  return "#813=CARTESIAN_POINT('',(5.,0.,0.));\n#814=CARTESIAN_POINT('',(100.,0.,0.));\n"
         "#815=CARTESIAN_POINT('',(0.,0.,0.));\n#816=DIRECTION('',(0.,0.,1.));\n#817=DIRECTION('',(1.,0.,0.))"
         ";\n"
         "#818=DIRECTION('',(0.,1.,0.));\n#819=DIRECTION('',(1.,1.,1.));\n"
         "#810=AXIS2_PLACEMENT_3D('',#813,#816,#817);\n#811=AXIS2_PLACEMENT_3D('',#814,#816,#818);\n"
         "#812=AXIS2_PLACEMENT_3D('',#815,#817," +
    reference + ");\n#820=AXIS2_PLACEMENT_3D('',#815,#819,$);\n#821=AXIS2_PLACEMENT_3D('',#815,#816,#817);\n";
}

void CheckPlacements()
{
  // (0.5, 1, 1.5) less (5, 0, 0), rotated, and (100, 0, 0).
  const Vector center = { 99.0, -4.5, 1.5 };
  CheckBox("mapped", BoxText().Add(AddFrames()).Map("#810", "#811"), 1.0, center);
  CheckBox("assembled", BoxText().Add(AddFrames()).Assemble("#810", "#811", false), 1.0, center);
  CheckBox("interchanged", BoxText().Add(AddFrames()).Assemble("#810", "#811", true), 1.0, center);
  CheckBox("shifted", BoxText().Add(AddFrames()).Map("#810", "#810"), 1.0, BoxCenter);
  // Millimetres in the part, inches in the assembly.
  BoxText inches = BoxText().Add(AddFrames()).Assemble("#810", "#811", false);
  const std::string context = inches.FindContext();
  const std::size_t at = inches.Text.find(context + "=(GEOMETRIC");
  const std::string copy = inches.Text.substr(at, inches.Text.find('\n', at) + 1 - at);
  const std::size_t unit = copy.find("UNIT_ASSIGNED_CONTEXT((") + 23;
  inches.Exchange("(#811)," + context, "(#811),#890")
    .Add("#890" + copy.substr(context.size(), unit - context.size()) + "#891" +
      copy.substr(copy.find(',', unit)) +
      "#891=(CONVERSION_BASED_UNIT('INCH',#892)LENGTH_UNIT()NAMED_UNIT(#894));\n"
      "#892=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#893);\n#893=" +
      Millimetre + ";\n#894=DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n");
  CheckBox("assembled_in_inches", inches, 1.0, { 2539.0, -4.5, 1.5 });
}

void CheckDirections()
{
  CheckBox("omitted_for_x", BoxText().Add(AddFrames()).Map("#821", "#812"), 1.0, { 1.5, 0.5, 1.0 });
  const double two = std::sqrt(2.0);
  const double three = std::sqrt(3.0);
  // x = (2, -1, -1), y = (0, 1, -1), z = (1, 1, 1), each divided by its length.
  CheckBox("omitted_for_a_diagonal", BoxText().Add(AddFrames()).Map("#821", "#820"), 1.0,
    { 1.0 / (two * three) + 1.5 / three, -0.5 / (two * three) + 1.0 / two + 1.5 / three,
      -0.5 / (two * three) - 1.0 / two + 1.5 / three });
  CheckBox("parallel", BoxText().Add(AddFrames("#817")).Map("#821", "#812"), 1.0, {},
    "its reference direction is parallel to its axis");

  const auto operate = [](const std::string& axes, const std::string& third)
  {
    return BoxText()
      .Add(AddFrames() + "#830=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',''," + axes + ",#814,1.," + third +
        ");\n#831=DIRECTION('',(0.,-1.,0.));\n")
      .Map("#821", "#830");
  };
  CheckBox("operator_beside_origin",
    BoxText()
      .Add(AddFrames() + "#830=CARTESIAN_TRANSFORMATION_OPERATOR_3D('','','',$,$,#814,1.,$);\n")
      .Map("#810", "#830"),
    1.0, {}, "whose origin is not that of its representation");
  CheckBox("operator_y", operate("$,#831", "$"), 1.0, { 100.5, -1.0, 1.5 });
  CheckBox("operator_z", operate("$,$", "#831"), 1.0, {}, "is parallel to another one");
  CheckBox("operator_none", operate("$,$", "$"), 1.0, { 100.5, 1.0, 1.5 });
  // The third axis is x, the first one y, and the second one, z, is given or left to the default, which is y:
  // it is undetermined.
  CheckBox("operator_of_three", operate("#818,#816", "#817"), 1.0, { 101.5, 0.5, 1.0 });
  CheckBox("operator_of_two", operate("#817,$", "#816"), 1.0, { 100.5, 1.0, 1.5 });
  CheckBox("operator_of_y_and_x", operate("#818,$", "#817"), 1.0, {}, "is parallel to another one");
}

void CheckProducts()
{
  BoxText box;
  const std::string shape = box.Find("ADVANCED_BREP_SHAPE_REPRESENTATION");
  const std::string solid = box.Find("MANIFOLD_SOLID_BREP");
  box.AddProduct("#960").Add(
    "#960=ADVANCED_BREP_SHAPE_REPRESENTATION('',(" + solid + ")," + box.FindContext() + ");\n");
  const auto check = [](const std::string& name, const BoxText& text, const std::string& said)
  {
    Pipeline pipeline(Make("meanings_" + name + ".step", text.Text));
    pipeline.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
    pipeline.Mass->Update();
    CheckEqual(name, names::StatusSuspect, std::string(pipeline.Mass->GetStatus()));
    CheckTrue("  said", Says(pipeline.Mass, said), GetMessages(pipeline.Mass));
  };
  check("two_products", box, "several definitions of one product, which are all counted");
  check("mapped_twice", BoxText().Add(AddFrames()).Map("#810", "#811").Exchange("(#952)", "(#952,#952)"),
    "item twice in a representation");
  BoxText two;
  const std::string property = two.Find("PRODUCT_DEFINITION_SHAPE");
  two.Add("#960=ADVANCED_BREP_SHAPE_REPRESENTATION('',(" + two.Find("MANIFOLD_SOLID_BREP") + ")," +
    two.FindContext() + ");\n#961=SHAPE_DEFINITION_REPRESENTATION(" + property + ",#960);\n");
  check("two_shapes", two, "item twice in a representation (two shapes of one product");
  // Two solids of one shell: OpenCASCADE numbers the faces of the second one only.
  BoxText shared;
  const std::string first = shared.Find("MANIFOLD_SOLID_BREP");
  shared.Exchange("," + first + ")", "," + first + ",#970)")
    .Add("#970=MANIFOLD_SOLID_BREP('second'," + shared.Find("CLOSED_SHELL") + ");\n");
  Pipeline pipeline(Make("meanings_shared_shell.step", shared.Text));
  pipeline.Mass->SetBackend(vtkMassPropertiesGPU::CPU);
  pipeline.Mass->Update();
  CheckEqual("two solids of one shell", names::StatusOk, std::string(pipeline.Mass->GetStatus()));
  Check("  volume", 12.0, pipeline.Mass->GetVolume(), 1e-12, "planes: rounding");
}
}

int TestSTEPMeanings(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::printf("Usage: TestSTEPMeanings FOLDER\n");
    return 1;
  }
  Folder = argv[1];
  CheckUnits();
  CheckPlacements();
  CheckDirections();
  CheckProducts();
  return Finish();
}

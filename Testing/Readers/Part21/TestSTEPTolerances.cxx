// TestSTEPTolerances: the tolerances of a drawing as ranges of offsets of faces, from entities written by
// hand.
#include "smSTEPTolerances.h"
#include "smTesting.h"

#include <cmath>

namespace
{
using namespace smtest;

/// Two planes that are opposite sides of a plate from z = 0 to 5, two of a slot, a shaft and a hole, in
/// inches where the unit is #2 and in mm where it is #1.
const char ToleranceText[] = R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF'));
ENDSEC;
DATA;
#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#3=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#1);
#2=(CONVERSION_BASED_UNIT('INCH',#3)LENGTH_UNIT()NAMED_UNIT(*));
#10=CARTESIAN_POINT('',(0.,0.,0.));
#11=CARTESIAN_POINT('',(1.,2.,5.));
#12=DIRECTION('',(0.,0.,1.));
#13=DIRECTION('',(0.,0.,-1.));
#14=DIRECTION('',(1.,0.,0.));
#15=AXIS2_PLACEMENT_3D('',#10,#12,#14);
#16=AXIS2_PLACEMENT_3D('',#11,#12,#14);
#17=AXIS2_PLACEMENT_3D('',#11,#13,#14);
#20=PLANE('',#15);
#21=PLANE('',#16);
#22=PLANE('',#17);
#23=CYLINDRICAL_SURFACE('',#15,4.);
#24=TOROIDAL_SURFACE('',#15,4.,1.);
#30=ADVANCED_FACE('bottom',(),#20,.F.);
#31=ADVANCED_FACE('top',(),#21,.T.);
#32=ADVANCED_FACE('slot below',(),#20,.T.);
#33=ADVANCED_FACE('slot above',(),#22,.T.);
#34=ADVANCED_FACE('shaft',(),#23,.T.);
#35=ADVANCED_FACE('hole',(),#23,.F.);
#36=ADVANCED_FACE('ring',(),#24,.T.);
#40=PRODUCT_DEFINITION_SHAPE('','',$);
#50=SHAPE_ASPECT('','',#40,.T.);
#51=SHAPE_ASPECT('','',#40,.T.);
#52=SHAPE_ASPECT('','',#40,.T.);
#53=SHAPE_ASPECT('','',#40,.T.);
#54=SHAPE_ASPECT('','',#40,.T.);
#55=SHAPE_ASPECT('','',#40,.T.);
#56=SHAPE_ASPECT('','',#40,.T.);
#57=COMPOSITE_SHAPE_ASPECT('','',#40,.F.);
#58=SHAPE_ASPECT_RELATIONSHIP('',$,#57,#54);
#59=SHAPE_ASPECT_RELATIONSHIP('',$,#57,#50);
#60=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#50,$,#30);
#61=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#51,$,#31);
#62=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#52,$,#32);
#63=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#53,$,#33);
#64=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#54,$,#34);
#65=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#55,$,SET_REPRESENTATION_ITEM((#35)));
#66=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#56,$,#36);
#70=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.2),#1);
#71=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.01),#2);
#72=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(-0.05),#1);
#73=(LENGTH_MEASURE_WITH_UNIT()MEASURE_REPRESENTATION_ITEM()MEASURE_WITH_UNIT(LENGTH_MEASURE(0.3),#1)REPRESENTATION_ITEM(''));
#80=(GEOMETRIC_TOLERANCE('','',#70,#50)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#99))SURFACE_PROFILE_TOLERANCE());
#81=(GEOMETRIC_TOLERANCE('','',#71,#57)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#99))SURFACE_PROFILE_TOLERANCE());
#82=SURFACE_PROFILE_TOLERANCE('','',#70,#51);
#83=(GEOMETRIC_TOLERANCE('','',#70,#51)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#99))SURFACE_PROFILE_TOLERANCE()UNEQUALLY_DISPOSED_GEOMETRIC_TOLERANCE(#73));
#84=(GEOMETRIC_TOLERANCE('','',#70,#55)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#99))POSITION_TOLERANCE());
#85=(GEOMETRIC_TOLERANCE('','',#70,#40)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#99))SURFACE_PROFILE_TOLERANCE());
#86=FLATNESS_TOLERANCE('','',#70,#51);
#90=TOLERANCE_VALUE(#72,#73);
#91=DIMENSIONAL_SIZE(#54,'diameter');
#92=PLUS_MINUS_TOLERANCE(#90,#91);
#93=DIMENSIONAL_SIZE(#55,'radius');
#94=PLUS_MINUS_TOLERANCE(#90,#93);
#95=DIMENSIONAL_LOCATION('linear distance',$,#50,#51);
#96=PLUS_MINUS_TOLERANCE(#90,#95);
#97=DIMENSIONAL_LOCATION('linear distance',$,#53,#52);
#98=PLUS_MINUS_TOLERANCE(#90,#97);
#99=DATUM('','',#40,.F.,'A');
#100=DIMENSIONAL_SIZE(#56,'diameter');
#101=PLUS_MINUS_TOLERANCE(#90,#100);
#102=DIMENSIONAL_LOCATION('linear distance',$,#51,#52);
#103=PLUS_MINUS_TOLERANCE(#90,#102);
#104=LIMITS_AND_FITS('G6','hole','','');
#105=PLUS_MINUS_TOLERANCE(#104,#93);
#106=TOLERANCE_VALUE(#73,#72);
#107=PLUS_MINUS_TOLERANCE(#106,#91);
#108=SHAPE_ASPECT('nothing','',#40,.T.);
#109=(GEOMETRIC_TOLERANCE('','',#70,#108)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#99))SURFACE_PROFILE_TOLERANCE());
#110=ANGULAR_LOCATION('',$,#50,#51,.SMALL.);
#111=PLUS_MINUS_TOLERANCE(#90,#110);
#112=(GEOMETRIC_TOLERANCE('','',#70,#50)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#99))SURFACE_PROFILE_TOLERANCE());
#113=GEOMETRIC_TOLERANCE_RELATIONSHIP('composite',$,#80,#112);
#114=SHAPE_ASPECT('a face and a point','',#40,.T.);
#115=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#114,$,SET_REPRESENTATION_ITEM((#35,#10)));
#116=(GEOMETRIC_TOLERANCE('','',#70,#114)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#99))SURFACE_PROFILE_TOLERANCE());
#120=PRODUCT('a','a','',());
ENDSEC;
END-ISO-10303-21;
)";

std::string ListFaces(const sm::STEPTolerance& tolerance)
{
  std::string text = tolerance.IsForAll ? "all" : "";
  for (const std::uint64_t face : tolerance.Faces)
  {
    text += (text.empty() ? "#" : " #") + std::to_string(face);
  }
  return text;
}
}

int TestSTEPTolerances(int, char*[])
{
  sm::Part21File file;
  CheckTrue("the text is read", file.Parse(ToleranceText));
  struct Expected
  {
    std::uint64_t Id;
    const char* Kind;
    const char* Faces;
    double Lower, Upper;
    /// A part of the reason; empty: it is understood.
    const char* Problem;
  };
  const Expected expected[] = { { 80, "surface profile", "#30", -0.1, 0.1, "" },
    { 81, "surface profile", "#30 #34", -0.127, 0.127, "" },
    { 82, "surface profile", "#31", -0.1, 0.1, "without a datum" },
    { 83, "surface profile", "#31", 0.1, 0.4, "leaves out the face" },
    { 84, "position", "#35", -0.1, 0.1, "along its normal" }, { 85, "surface profile", "all", -0.1, 0.1, "" },
    { 86, "flatness", "#31", -0.1, 0.1, "along its normal" }, { 92, "diameter", "#34", -0.025, 0.15, "" },
    { 94, "radius", "#35", -0.3, 0.05, "" }, { 96, "thickness", "#30 #31", -0.025, 0.15, "" },
    { 98, "thickness", "#33 #32", -0.15, 0.025, "" }, { 101, "diameter", "#36", 0.0, 0.0, "cylinders" },
    { 103, "thickness", "#31 #32", 0.0, 0.0, "opposite normals" },
    { 105, "plus minus", "", 0.0, 0.0, "those of a fit" }, { 107, "plus minus", "", 0.0, 0.0, "not lengths" },
    { 109, "surface profile", "", -0.1, 0.1, "no face" }, { 111, "plus minus", "", 0.0, 0.0, "angle" },
    { 112, "surface profile", "#30", -0.1, 0.1, "composite" },
    { 116, "surface profile", "#35", -0.1, 0.1, "other things than faces" } };
  const std::vector<sm::STEPTolerance> found = sm::ReadSTEPTolerances(file);
  CheckEqual("number", static_cast<long long>(std::size(expected)), static_cast<long long>(found.size()));
  for (std::size_t i = 0; i < std::min(found.size(), std::size(expected)); ++i)
  {
    const std::string what = "#" + std::to_string(expected[i].Id);
    CheckEqual(what, static_cast<long long>(expected[i].Id), static_cast<long long>(found[i].Id));
    CheckEqual(what + ": kind", expected[i].Kind, found[i].Kind);
    CheckEqual(what + ": faces", expected[i].Faces, ListFaces(found[i]));
    Check(what + ": lower", expected[i].Lower, found[i].Lower, 1e-15, "roundings of decimals");
    Check(what + ": upper", expected[i].Upper, found[i].Upper, 1e-15);
    const std::string problem = expected[i].Problem;
    CheckTrue(what + ": reason",
      problem.empty() ? found[i].Problem.empty()
                      : found[i].Problem.find(problem) != std::string::npos &&
          found[i].Problem.find("--face-tolerance") != std::string::npos,
      found[i].Problem);
  }
  // Of several products nothing says whose faces "all" are.
  std::string text = ToleranceText;
  text.insert(text.rfind("ENDSEC;"), "#121=PRODUCT('b','b','',());\n");
  sm::Part21File several;
  CheckTrue("the second text is read", several.Parse(text));
  for (const sm::STEPTolerance& tolerance : sm::ReadSTEPTolerances(several))
  {
    CheckTrue("#" + std::to_string(tolerance.Id) + " of two products",
      !tolerance.IsForAll || tolerance.Problem.find("the file has several") != std::string::npos,
      tolerance.Problem);
  }
  return Finish();
}

#include "smCensusSamples.h"

#include <stdexcept>

namespace smtest
{
namespace
{
const char Ball[] = R"(#1=APPLICATION_CONTEXT('');
#2=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#3=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#4=(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT());
#5=UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#2,'distance_accuracy_value','');
#6=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#5))GLOBAL_UNIT_ASSIGNED_CONTEXT((#2,#3,#4))REPRESENTATION_CONTEXT('',''));
#20=CARTESIAN_POINT('',(0.,0.,0.));
#21=DIRECTION('',(0.,0.,1.));
#22=DIRECTION('',(1.,0.,0.));
#23=AXIS2_PLACEMENT_3D('',#20,#21,#22);
#24=SPHERICAL_SURFACE('',#23,5.);
#26=CARTESIAN_POINT('',(0.,0.,5.));
#25=VERTEX_POINT('',#26);
#27=VERTEX_LOOP('',#25);
#28=FACE_BOUND('',#27,.T.);
#29=ADVANCED_FACE('',(#28),#24,.T.);
#30=CLOSED_SHELL('',(#29));
#31=MANIFOLD_SOLID_BREP('ball',#30);
#32=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#23,#31),#6);
#40=PRODUCT_CONTEXT('',#1,'mechanical');
#41=PRODUCT('ball','ball','',(#40));
#42=PRODUCT_DEFINITION_FORMATION('','',#41);
#43=PRODUCT_DEFINITION_CONTEXT('part definition',#1,'design');
#44=PRODUCT_DEFINITION('design','',#42,#43);
#45=PRODUCT_DEFINITION_SHAPE('','',#44);
#46=SHAPE_DEFINITION_REPRESENTATION(#45,#32);
)";

const char Assembly[] = R"(#50=PRODUCT('box','box','',(#40));
#51=PRODUCT_DEFINITION_FORMATION('','',#50);
#52=PRODUCT_DEFINITION('design','',#51,#43);
#53=PRODUCT_DEFINITION_SHAPE('','',#52);
#54=SHAPE_REPRESENTATION('',(#23),#6);
#55=SHAPE_DEFINITION_REPRESENTATION(#53,#54);
#60=NEXT_ASSEMBLY_USAGE_OCCURRENCE('1','first','',#52,#44,$);
#61=PRODUCT_DEFINITION_SHAPE('','',#60);
#62=ITEM_DEFINED_TRANSFORMATION('','',#23,#23);
#63=(REPRESENTATION_RELATIONSHIP('','',#32,#54)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#62)SHAPE_REPRESENTATION_RELATIONSHIP());
#64=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#63,#61);
)";
}

std::string GetBallText()
{
  return Ball;
}

std::string GetAssemblyText()
{
  return Assembly;
}

std::string MakeStepText(const std::string& data)
{
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
         "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
    data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

std::string Replace(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  if (at == std::string::npos)
  {
    throw std::logic_error("a test's text has no " + from);
  }
  return text.replace(at, from.size(), to);
}

std::string ChangeBall(const std::string& from, const std::string& to)
{
  return MakeStepText(Replace(GetBallText(), from, to));
}

std::string ExtendBall(const std::string& from, const std::string& to, const std::string& more)
{
  return MakeStepText(Replace(GetBallText(), from, to) + more);
}

std::string MakeLevels(int levels, int occurrences)
{
  std::string text = Ball;
  int product = 44;
  int shape = 32;
  for (int level = 0; level < levels; ++level)
  {
    const int base = 100 + (4 + 8 * occurrences) * level;
    const auto id = [base](int k) { return "#" + std::to_string(base + k); };
    const std::string below = "#" + std::to_string(product);
    const std::string shapeBelow = "#" + std::to_string(shape);
    text += id(0) + "=PRODUCT_DEFINITION('','',#42,#43);\n" + id(1) + "=PRODUCT_DEFINITION_SHAPE('',''," +
      id(0) + ");\n" + id(2) + "=SHAPE_REPRESENTATION('',(#23),#6);\n" + id(3) +
      "=SHAPE_DEFINITION_REPRESENTATION(" + id(1) + "," + id(2) + ");\n";
    for (int k = 4; k < 4 + 8 * occurrences; k += 8)
    {
      text += id(k) + "=NEXT_ASSEMBLY_USAGE_OCCURRENCE('','',''," + id(0) + "," + below + ",$);\n" +
        id(k + 1) + "=PRODUCT_DEFINITION_SHAPE('',''," + id(k) + ");\n" + id(k + 2) +
        "=ITEM_DEFINED_TRANSFORMATION('','',#23,#23);\n" + id(k + 3) +
        "=(REPRESENTATION_RELATIONSHIP('',''," + shapeBelow + "," + id(2) +
        ")REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(" + id(k + 2) +
        ")SHAPE_REPRESENTATION_RELATIONSHIP());\n" + id(k + 4) + "=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(" +
        id(k + 3) + "," + id(k + 1) + ");\n";
    }
    product = base;
    shape = base + 2;
  }
  return MakeStepText(text);
}
}

#include "smCensusCases.h"

#include "smCensusSamples.h"

namespace smtest
{
namespace
{
/// No bodies but solids.
std::string Count(int solids, int instances, int faces, int occurrences = 0, int mapped = 0)
{
  return "solids " + std::to_string(solids) + ", instances " + std::to_string(instances) + ", faces " +
    std::to_string(faces) + ", surface models 0 with faces 0, other solids 0, occurrences " +
    std::to_string(occurrences) + ", mapped " + std::to_string(mapped);
}

const std::string OneBall = Count(1, 1, 1);
const std::string OneInBox = Count(1, 1, 1, 1);
const std::string OneSurfaceModel =
  "solids 0, instances 0, faces 0, surface models 1 with faces 1, other solids 0, occurrences 0, mapped 0";

/// Oriented shells from #`first` on, each of the next one, the last one of the ball's face.
std::string MakeShellChain(int first, int count)
{
  std::string text;
  for (int id = first; id < first + count; ++id)
  {
    text += "#" + std::to_string(id) + "=ORIENTED_CLOSED_SHELL('',*,#" + std::to_string(id + 1) + ",.F.);\n";
  }
  return text + "#" + std::to_string(first + count) + "=CLOSED_SHELL('',(#29));\n";
}

std::string ChangeBox(const std::string& from, const std::string& to)
{
  return MakeStepText(GetBallText() + Replace(GetAssemblyText(), from, to));
}
}

std::vector<CensusCase> GetBodyCases()
{
  const std::string curve =
    "#70=B_SPLINE_CURVE_WITH_KNOTS('',2,(#20,#26,#20),.UNSPECIFIED.,.F.,.F.,(3,3),(0.,1.),.UNSPECIFIED.);\n"
    "#71=EDGE_CURVE('',#25,#25,#70,.T.);\n#72=ORIENTED_EDGE('',*,*,#71,.T.);\n#27=EDGE_LOOP('',(#72));\n";
  const std::string loop = "#27=VERTEX_LOOP('',#25);\n";
  const std::string rational =
    "#70=(BOUNDED_CURVE()B_SPLINE_CURVE(2,(#20,#26,#20),.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS((3,3)"
    ",(0.,1.),"
    ".UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE((1.,0.5,1.))REPRESENTATION_"
    "ITEM(''));\n"
    "#71=EDGE_CURVE('',#25,#25,#70,.T.);\n#72=ORIENTED_EDGE('',*,*,#71,.T.);\n#27=EDGE_LOOP('',(#72));\n";
  const std::string surface = "#24=B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#20,#26),(#20,#26)),.UNSPECIFIED.,.F."
                              ",.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),"
                              ".UNSPECIFIED.);\n";
  const std::string sphere = "#24=SPHERICAL_SURFACE('',#23,5.);\n";
  const std::string second =
    "#70=VERTEX_LOOP('',#25);\n#71=FACE_BOUND('',#70,.T.);\n#72=ADVANCED_FACE('',(#71),#24,.T.);\n"
    "#73=CLOSED_SHELL('',(#72));\n";
  const std::string solid = "#31=MANIFOLD_SOLID_BREP('ball',#30);";
  return {
    { "a ball", ChangeBall("ball", "ball"), OneBall, "" },
    { "the ball in two shapes of its product",
      ExtendBall("ball", "ball",
        "#70=SHAPE_REPRESENTATION('',(#31),#6);\n#71=SHAPE_DEFINITION_REPRESENTATION(#45,#70);\n"),
      OneBall, "item twice in a representation: 1 (#44 PRODUCT_DEFINITION two shapes of one product #31)" },
    { "the ball and facets of it",
      ExtendBall("ball", "ball",
        "#74=FACETED_BREP_SHAPE_REPRESENTATION('',(#75),#6);\n#76=SHAPE_DEFINITION_REPRESENTATION(#45,#74);\n"
        "#75=FACETED_BREP('',#73);\n" +
          second),
      Count(2, 2, 2),
      "exact and faceted shapes of one product, which are both counted: 1 (#44 PRODUCT_DEFINITION)" },
    { "a ball next to it",
      ExtendBall("ball", "ball",
        "#74=SHAPE_REPRESENTATION('',(#75),#6);\n#76=SHAPE_DEFINITION_REPRESENTATION(#45,#74);\n"
        "#75=MANIFOLD_SOLID_BREP('',#73);\n" +
          second),
      Count(2, 2, 2), "" },
    { "a product of a closed shell next to the ball",
      ExtendBall("ball", "ball",
        second +
          "#74=SHELL_BASED_SURFACE_MODEL('',(#73));\n#75=SHAPE_REPRESENTATION('',(#74),#6);\n"
          "#76=PRODUCT_DEFINITION('','',#42,#43);\n#77=PRODUCT_DEFINITION_SHAPE('','',#76);\n"
          "#78=SHAPE_DEFINITION_REPRESENTATION(#77,#75);\n"),
      "solids 1, instances 1, faces 1, surface models 1 with faces 1, other solids 0, occurrences 0, mapped "
      "0",
      "a product of closed surfaces without a solid, whose volume is not added to that of solids: 1 (#76 "
      "PRODUCT_DEFINITION closed shell #73)" },
    { "a product of an open shell next to the ball",
      ExtendBall("ball", "ball",
        Replace(second, "CLOSED_SHELL", "OPEN_SHELL") +
          "#74=SHELL_BASED_SURFACE_MODEL('',(#73));\n#75=SHAPE_REPRESENTATION('',(#74),#6);\n"
          "#76=PRODUCT_DEFINITION('','',#42,#43);\n#77=PRODUCT_DEFINITION_SHAPE('','',#76);\n"
          "#78=SHAPE_DEFINITION_REPRESENTATION(#77,#75);\n"),
      "solids 1, instances 1, faces 1, surface models 1 with faces 1, other solids 0, occurrences 0, mapped "
      "0",
      "" },
    { "a closed shell in the ball's product",
      ExtendBall("(#23,#31)", "(#23,#31,#74)", second + "#74=SHELL_BASED_SURFACE_MODEL('',(#73));\n"),
      "solids 1, instances 1, faces 1, surface models 1 with faces 1, other solids 0, occurrences 0, mapped "
      "0",
      "" },
    { "two versions of the ball",
      ExtendBall("ball", "ball",
        second +
          "#74=MANIFOLD_SOLID_BREP('',#73);\n#75=SHAPE_REPRESENTATION('',(#74),#6);\n"
          "#76=PRODUCT_DEFINITION('','',#79,#43);\n#77=PRODUCT_DEFINITION_SHAPE('','',#76);\n"
          "#78=SHAPE_DEFINITION_REPRESENTATION(#77,#75);\n#79=PRODUCT_DEFINITION_FORMATION('2','',#41);\n"),
      Count(2, 2, 2),
      "several definitions of one product, which are all counted: 1 (#76 PRODUCT_DEFINITION of one product "
      "#44)" },
    { "a solid of a complex instance",
      ChangeBall(solid,
        "#31=(BREP_WITH_VOIDS((#73))FACETED_BREP()GEOMETRIC_REPRESENTATION_ITEM()MANIFOLD_SOLID_BREP(#30)"
        "REPRESENTATION_ITEM('x')SOLID_MODEL());\n" +
          second),
      Count(1, 1, 2), "" },
    { "a void",
      ExtendBall(solid, "#31=BREP_WITH_VOIDS('ball',#30,(#80));",
        second + "#80=ORIENTED_CLOSED_SHELL('',*,#73,.F.);\n"),
      Count(1, 1, 2), "" },
    { "too long a chain of oriented shells",
      ExtendBall(solid, "#31=BREP_WITH_VOIDS('ball',#30,(#80));", MakeShellChain(80, 18)), OneBall,
      "cyclic reference: 2 (#80 ORIENTED_CLOSED_SHELL voids #96, #31 BREP_WITH_VOIDS voids #80)" },
    { "an oriented face", ExtendBall("(#29))", "(#80))", "#80=ORIENTED_FACE('',*,#29,.F.);\n"), OneBall, "" },
    { "a faceted solid", ExtendBall(loop, "#27=POLY_LOOP('',(#20,#26,#26));\n", ""), OneBall, "" },
    { "a surface model", ChangeBall(solid, "#31=SHELL_BASED_SURFACE_MODEL('',(#30));"), OneSurfaceModel, "" },
    { "a shell as an item", ChangeBall("(#23,#31)", "(#23,#30)"), OneSurfaceModel,
      "used by nothing: 1 (#31 MANIFOLD_SOLID_BREP)" },
    { "a face as an item", ChangeBall("(#23,#31)", "(#23,#29)"), OneSurfaceModel,
      "used by nothing: 1 (#31 MANIFOLD_SOLID_BREP)" },
    { "a set of curves",
      ExtendBall(
        "(#23,#31)", "(#23,#31,#80)", "#80=GEOMETRIC_CURVE_SET('',(#81));\n#81=CIRCLE('',#23,-1.);\n"),
      OneBall, "" },
    { "a solid without faces",
      ExtendBall("(#23,#31)", "(#23,#80)", "#80=CSG_SOLID('',#81);\n#81=BLOCK('',#23,1.,1.,1.);\n"),
      "solids 0, instances 0, faces 0, surface models 0 with faces 0, other solids 1, occurrences 0, mapped "
      "0",
      "used by nothing: 1 (#31 MANIFOLD_SOLID_BREP)" },
    { "triangles", ExtendBall("(#23,#31)", "(#23,#31,#80)", "#80=TESSELLATED_SOLID('',(#81),$);\n"), OneBall,
      "" },
    { "the solid twice", ChangeBall("(#23,#31)", "(#31,#23,#31)"), OneBall,
      "item twice in a representation: 1 (#32 ADVANCED_BREP_SHAPE_REPRESENTATION items #31)" },
    { "an undefined item", ChangeBall("(#23,#31)", "(#23,#31,#99)"), OneBall,
      "undefined reference: 1 (#32 ADVANCED_BREP_SHAPE_REPRESENTATION items #99)" },
    { "damaged text next to the solid",
      ExtendBall("(#23,#31)", "(#23,#31,#80)", "#80=TEXT_LITERAL('',#99,#81,3);\n#81=X(;\n"), OneBall, "" },
    { "no solid in the representation", ChangeBall("(#23,#31)", "(#23)"), Count(0, 0, 0),
      "used by nothing: 1 (#31 MANIFOLD_SOLID_BREP)" },
    // Entities that the census cannot know are left unused.
    { "a misspelled solid", ChangeBall("#31=MANIFOLD_SOLID_BREP", "#31=MANIFOLD_SOLID_BREQ"), Count(0, 0, 0),
      "used by nothing: 1 (#30 CLOSED_SHELL)" },
    { "a misspelled face", ChangeBall("ADVANCED_FACE", "ADVANCED_FICE"), Count(1, 1, 0),
      "wrong type: 1 (#30 CLOSED_SHELL #29); used by nothing: 1 (#28 FACE_BOUND); shell without faces: 1 "
      "(#30 CLOSED_SHELL faces)" },
    { "an undefined shell", ChangeBall("'ball',#30)", "'ball',#99)"), Count(1, 1, 0),
      "undefined reference: 1 (#31 MANIFOLD_SOLID_BREP); used by nothing: 1 (#30 CLOSED_SHELL)" },
    { "a shell that is a face", ChangeBall("'ball',#30)", "'ball',#29)"), Count(1, 1, 0),
      "wrong type: 1 (#31 MANIFOLD_SOLID_BREP #29); used by nothing: 1 (#30 CLOSED_SHELL)" },
    { "no shell", ChangeBall("'ball',#30)", "'ball',$)"), Count(1, 1, 0),
      "wrong parameter: 1 (#31 MANIFOLD_SOLID_BREP a reference is expected); used by nothing: 1 (#30 "
      "CLOSED_SHELL)" },
    { "a parameter too few", ChangeBall("'ball',#30)", "'ball')"), Count(1, 1, 0),
      "wrong parameter: 1 (#31 MANIFOLD_SOLID_BREP too few parameters); used by nothing: 1 (#30 "
      "CLOSED_SHELL)" },
    { "a parameter too many", ChangeBall("'ball',#30)", "'ball',#30,1)"), OneBall,
      "wrong parameter: 1 (#31 MANIFOLD_SOLID_BREP too many parameters)" },
    { "an undefined face", ChangeBall("(#29))", "(#29,#99))"), OneBall,
      "undefined reference: 1 (#30 CLOSED_SHELL)" },
    { "a face twice", ChangeBall("(#29))", "(#29,#29))"), OneBall,
      "face twice in a shell: 1 (#30 CLOSED_SHELL faces #29)" },
    { "an empty shell", ChangeBall("(#29))", "())"), Count(1, 1, 0),
      "wrong parameter: 1 (#30 CLOSED_SHELL a list with members is expected); used by nothing: 1 (#29 "
      "ADVANCED_FACE); shell without faces: 1 (#30 CLOSED_SHELL faces)" },
    { "a face in no shell", ExtendBall("ball", "ball", Replace(second, "#73=CLOSED_SHELL('',(#72));\n", "")),
      OneBall, "used by nothing: 1 (#72 ADVANCED_FACE)" },
    { "a bound of two faces",
      ExtendBall(
        "(#29))", "(#29,#72))", Replace(second.substr(0, second.find("#73")), "(#71),#24", "(#28),#24")),
      Count(1, 1, 2),
      "bound of two faces: 1 (#72 ADVANCED_FACE bounds #28); used by nothing: 1 (#71 FACE_BOUND)" },
    { "the number of a face twice", ExtendBall("ball", "ball", "#29=ADVANCED_FACE('',(#28),#24,.F.);\n"),
      OneBall, "damaged entity: 1 (#29 ADVANCED_FACE); used by nothing: 1 (#29 ADVANCED_FACE)" },
    { "a bound without a bracket", ChangeBall("('',#27,.T.);", "('',#27,.T.;"), OneBall,
      "damaged entity: 1 (#28 FACE_BOUND)" },
    { "a sense that is none", ChangeBall("('',#27,.T.)", "('',#27,.U.)"), OneBall,
      "wrong parameter: 1 (#28 FACE_BOUND .T. or .F. is expected)" },
    { "an undefined surface", ChangeBall("(#28),#24", "(#28),#99999999"), OneBall,
      "undefined reference: 1 (#29 ADVANCED_FACE)" },
    { "a surface that is a point", ChangeBall("(#28),#24", "(#28),#26"), OneBall,
      "wrong type: 1 (#29 ADVANCED_FACE #26)" },
    { "a negative radius", ChangeBall("#23,5.)", "#23,-5.)"), OneBall,
      "value out of range: 1 (#24 SPHERICAL_SURFACE not above 0)" },
    { "a radius of zero", ChangeBall("#23,5.)", "#23,0.)"), OneBall,
      "value out of range: 1 (#24 SPHERICAL_SURFACE not above 0)" },
    { "an endless radius", ChangeBall("#23,5.)", "#23,5.E999)"), OneBall,
      "value out of range: 1 (#24 SPHERICAL_SURFACE too large a number)" },
    { "a radius that is text", ChangeBall("#23,5.)", "#23,'5.')"), OneBall,
      "wrong parameter: 1 (#24 SPHERICAL_SURFACE a number is expected)" },
    { "a direction without length", ChangeBall("(1.,0.,0.)", "(0.,-0.,0.E5)"), OneBall,
      "value out of range: 1 (#22 DIRECTION a direction without length)" },
    { "a point of two coordinates", ChangeBall("(0.,0.,5.)", "(0.,5.)"), OneBall,
      "value out of range: 1 (#26 CARTESIAN_POINT number of coordinates)" },
    { "a coordinate that is a reference", ChangeBall("(0.,0.,5.)", "(0.,0.,#5)"), OneBall,
      "wrong parameter: 1 (#26 CARTESIAN_POINT a number is expected #5)" },
    { "a coordinate above all sizes", ChangeBall("(0.,0.,5.)", "(0.,0.,-5.E200)"), OneBall,
      "value out of range: 1 (#26 CARTESIAN_POINT too large a number)" },
    { "a coordinate that is too large", ChangeBall("(0.,0.,5.)", "(0.,0.,5.E400)"), OneBall,
      "value out of range: 1 (#26 CARTESIAN_POINT too large a number)" },
    { "an edge with an undefined vertex",
      ChangeBall(loop, Replace(curve, "EDGE_CURVE('',#25", "EDGE_CURVE('',#99")), OneBall,
      "undefined reference: 1 (#71 EDGE_CURVE)" },
    { "a spline", ChangeBall(loop, curve), OneBall, "" },
    { "a composite curve of itself",
      ChangeBall(loop,
        Replace(curve, "#70,.T.)", "#80,.T.)") +
          "#80=COMPOSITE_CURVE('',(#81),.F.);\n#81=COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,#80);\n"),
      OneBall, "cyclic reference: 1 (#81 COMPOSITE_CURVE_SEGMENT #80)" },
    { "a curve that is part of itself",
      ChangeBall(loop,
        Replace(curve, "#70,.T.)", "#80,.T.)") +
          "#80=CURVE_REPLICA('',#80,#82);\n#82=CARTESIAN_TRANSFORMATION_OPERATOR_3D('',$,$,#20,1.,$);\n"),
      OneBall, "cyclic reference: 1 (#80 CURVE_REPLICA #80)" },
    { "a surface without its radius", ChangeBall("#23,5.)", "#23)"), OneBall,
      "wrong parameter: 1 (#24 SPHERICAL_SURFACE too few parameters)" },
    { "a multiplicity too large", ChangeBall(loop, Replace(curve, "(3,3)", "(3,4)")), OneBall,
      "inconsistent spline: 1 (#70 B_SPLINE_CURVE_WITH_KNOTS multiplicities)" },
    { "a multiplicity too small", ChangeBall(loop, Replace(curve, "(3,3)", "(3,2)")), OneBall,
      "inconsistent spline: 1 (#70 B_SPLINE_CURVE_WITH_KNOTS multiplicities)" },
    { "a multiplicity too few", ChangeBall(loop, Replace(curve, "(3,3)", "(3)")), OneBall,
      "inconsistent spline: 1 (#70 B_SPLINE_CURVE_WITH_KNOTS knots)" },
    { "equal knots", ChangeBall(loop, Replace(curve, "(0.,1.)", "(1.,1.)")), OneBall,
      "inconsistent spline: 1 (#70 B_SPLINE_CURVE_WITH_KNOTS knots)" },
    { "another degree", ChangeBall(loop, Replace(curve, "',2,", "',1,")), OneBall,
      "inconsistent spline: 1 (#70 B_SPLINE_CURVE_WITH_KNOTS multiplicities)" },
    { "a pole too few", ChangeBall(loop, Replace(curve, "(#20,#26,#20)", "(#20,#26)")), OneBall,
      "inconsistent spline: 1 (#70 B_SPLINE_CURVE_WITH_KNOTS multiplicities)" },
    { "a rational spline", ChangeBall(loop, rational), OneBall, "" },
    { "a weight too few", ChangeBall(loop, Replace(rational, "(1.,0.5,1.)", "(1.,0.5)")), OneBall,
      "inconsistent spline: 1 (#70 BOUNDED_CURVE weights)" },
    { "a negative weight", ChangeBall(loop, Replace(rational, "(1.,0.5,1.)", "(1.,-0.5,1.)")), OneBall,
      "value out of range: 1 (#70 BOUNDED_CURVE not above 0)" },
    { "a spline surface", ChangeBall(sphere, surface), OneBall, "" },
    { "rows of different lengths",
      ChangeBall(sphere, Replace(surface, "((#20,#26),(#20,#26))", "((#20,#26),(#20,#26,#20))")), OneBall,
      "inconsistent spline: 1 (#24 B_SPLINE_SURFACE_WITH_KNOTS control points)" },
    { "knots of a surface", ChangeBall(sphere, Replace(surface, "(0.,1.),(0.,1.)", "(0.,1.),(1.,0.)")),
      OneBall, "inconsistent spline: 1 (#24 B_SPLINE_SURFACE_WITH_KNOTS knots)" },
  };
}

std::vector<CensusCase> GetAssemblyCases()
{
  return {
    { "an assembly", ChangeBox("box", "box"), OneInBox, "" },
    { "three occurrences",
      ChangeBox("#62=",
        "#70=NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','','',#52,#44,$);\n#71=PRODUCT_DEFINITION_SHAPE('','',#70);"
        "\n#72=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#63,#71);\n#73=NEXT_ASSEMBLY_USAGE_OCCURRENCE('3','',''"
        ",#52,#44,$);\n#74=PRODUCT_DEFINITION_SHAPE('','',#73);\n#75=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#"
        "63,#74);\n#62="),
      Count(1, 3, 1, 3), "" },
    { "an occurrence without a placement",
      ChangeBox("#64=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#63,#61);\n", ""), OneInBox,
      "missing placement: 1 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE no placement)" },
    { "a placement without a transformation",
      ChangeBox("#63=(REPRESENTATION_RELATIONSHIP('','',#32,#54)REPRESENTATION_RELATIONSHIP_WITH_"
                "TRANSFORMATION(#62)SHAPE_REPRESENTATION_RELATIONSHIP());",
        "#63=SHAPE_REPRESENTATION_RELATIONSHIP('','',#32,#54);"),
      OneInBox, "missing placement: 1 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE no transformation #64)" },
    { "representations the other way round", ChangeBox("#32,#54)R", "#54,#32)R"), OneInBox, "" },
    { "a placement of another product",
      MakeStepText(GetBallText() + Replace(GetAssemblyText(), "#32,#54)R", "#74,#54)R") +
        "#70=PRODUCT('x','x','',(#40));\n#71=PRODUCT_DEFINITION_FORMATION('','',#70);\n"
        "#72=PRODUCT_DEFINITION('','',#71,#43);\n#73=PRODUCT_DEFINITION_SHAPE('','',#72);\n"
        "#74=SHAPE_REPRESENTATION('',(#23),#6);\n#75=SHAPE_DEFINITION_REPRESENTATION(#73,#74);\n"),
      OneInBox,
      "placement of other products: 1 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE representations of other products "
      "#64)" },
    { "a placement by an axis",
      MakeStepText(GetBallText() +
        Replace(GetAssemblyText(), "'','',#23,#23)", "'','',#23,#70);\n#70=AXIS1_PLACEMENT('',#20,#21)")),
      OneInBox, "wrong type: 1 (#62 ITEM_DEFINED_TRANSFORMATION #70)" },
    { "a placed usage of another type",
      MakeStepText(GetBallText() + GetAssemblyText() +
        "#70=PROMISSORY_USAGE_OCCURRENCE('2','second','',#52,#44,$);\n#71=PRODUCT_DEFINITION_SHAPE('','',#70)"
        ";\n"
        "#72=CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#73,#71);\n"
        "#73=(REPRESENTATION_RELATIONSHIP('','',#32,#54)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#62)"
        "SHAPE_"
        "REPRESENTATION_RELATIONSHIP());\n"),
      OneInBox,
      "placement of other products: 1 (#70 PROMISSORY_USAGE_OCCURRENCE a usage of a type that is not read "
      "#72)" },
    { "an undefined parent", ChangeBox("#52,#44,$", "#99,#44,$"), OneInBox,
      "undefined reference: 1 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE relating product #99)" },
    { "a child that is a shape", ChangeBox("#52,#44,$", "#52,#32,$"), OneInBox,
      "wrong type: 1 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE related product #32)" },
    { "a product in itself", ChangeBox("#52,#44,$", "#52,#52,$"), OneInBox,
      "assembly contains itself: 1 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE contains itself #52); placement of "
      "other products: 1 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE representations of other products #64)" },
    { "two products in each other",
      ChangeBox("#62=", "#70=NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','','',#44,#52,$);\n#62="), Count(0, 0, 0, 2),
      "assembly contains itself: 2 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE contains itself #44, #70 "
      "NEXT_ASSEMBLY_USAGE_OCCURRENCE contains itself #52); missing placement: 1 (#70 "
      "NEXT_ASSEMBLY_USAGE_OCCURRENCE no placement); in no product: 1 (#31 MANIFOLD_SOLID_BREP)" },
    { "an undefined transformation", ChangeBox("TRANSFORMATION(#62)", "TRANSFORMATION(#98)"), OneInBox,
      "undefined reference: 1 (#63 REPRESENTATION_RELATIONSHIP transformation #98)" },
    { "a transformation by a point", ChangeBox("',#23,#23)", "',#23,#20)"), OneInBox,
      "wrong type: 1 (#62 ITEM_DEFINED_TRANSFORMATION #20)" },
    { "a shape definition of nothing", ChangeBall("(#45,#32)", "(#45,#99)"), OneBall,
      "undefined reference: 1 (#46 SHAPE_DEFINITION_REPRESENTATION representation #99)" },
    { "no shape definition", ChangeBall("#46=SHAPE_DEFINITION_REPRESENTATION(#45,#32);\n", ""), OneBall, "" },
    { "a solid in no product",
      ChangeBox("#54=",
        "#80=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#81),#6);\n#81=MANIFOLD_SOLID_BREP('',#30);\n#54="),
      OneInBox, "in no product: 1 (#81 MANIFOLD_SOLID_BREP)" },
    { "a solid of construction",
      ChangeBox("#54=",
        "#80=CONSTRUCTIVE_GEOMETRY_REPRESENTATION('',(#81),#6);\n#81=MANIFOLD_SOLID_BREP('',#30);\n#54="),
      OneInBox, "" },
    { "shapes that are one",
      ExtendBall("(#45,#32)", "(#45,#80)",
        "#80=SHAPE_REPRESENTATION('',(#23),#6);\n#81=SHAPE_REPRESENTATION_RELATIONSHIP('','',#80,#32);\n"),
      OneBall, "" },
    { "shapes that are one, both with the solid",
      ExtendBall("(#45,#32)", "(#45,#80)",
        "#80=SHAPE_REPRESENTATION('',(#23,#31),#6);\n#81=SHAPE_REPRESENTATION_RELATIONSHIP('','',#32,#80);"
        "\n"),
      OneBall, "" },
    { "a relationship to nothing",
      ExtendBall("(#45,#32)", "(#45,#80)",
        "#80=SHAPE_REPRESENTATION('',(#23),#6);\n#81=SHAPE_REPRESENTATION_RELATIONSHIP('','',#80,#99);\n"),
      Count(0, 0, 0),
      "undefined reference: 1 (#81 SHAPE_REPRESENTATION_RELATIONSHIP second representation #99); in no "
      "product: 1 (#31 MANIFOLD_SOLID_BREP)" },
    { "a shape placed in a shape",
      ExtendBall("(#45,#32)", "(#45,#80)",
        "#80=SHAPE_REPRESENTATION('',(#23),#6);\n#81=(REPRESENTATION_RELATIONSHIP('','',#32,#80)"
        "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#82)SHAPE_REPRESENTATION_RELATIONSHIP());\n#82=ITEM_"
        "DEFINED_TRANSFORMATION('','',#23,#23);\n"),
      OneBall, "" },
    { "two mapped items",
      ExtendBall("(#45,#32)", "(#45,#80)",
        "#80=SHAPE_REPRESENTATION('',(#23,#81,#82),#6);\n#81=MAPPED_ITEM('',#83,#23);\n#82=MAPPED_ITEM('',#"
        "83,#23);\n#83=REPRESENTATION_MAP(#23,#32);\n"),
      Count(1, 2, 1, 0, 2), "" },
    { "placed as an occurrence and by a mapped item",
      ChangeBox("#54=SHAPE_REPRESENTATION('',(#23),#6);",
        "#54=SHAPE_REPRESENTATION('',(#23,#81),#6);\n#81=MAPPED_ITEM('',#83,#23);\n#83=REPRESENTATION_MAP(#"
        "23,"
        "#32);"),
      Count(1, 2, 1, 1, 1),
      "placed as an occurrence and by a mapped item, which are both counted: 1 (#60 "
      "NEXT_ASSEMBLY_USAGE_OCCURRENCE mapped item #81)" },
    { "a mapped item of nothing",
      ExtendBall("(#45,#32)", "(#45,#80)",
        "#80=SHAPE_REPRESENTATION('',(#23,#81),#6);\n#81=MAPPED_ITEM('',#83,#23);\n#83=REPRESENTATION_MAP(#"
        "23,#99);\n"),
      Count(0, 0, 0),
      "undefined reference: 1 (#83 REPRESENTATION_MAP mapped representation #99); in no product: 1 (#31 "
      "MANIFOLD_SOLID_BREP)" },
    { "a misspelled occurrence", ChangeBox("NEXT_ASSEMBLY_USAGE_OCCURRENCE", "NEXT_ASSEMBLY_USAGE_OCCURENCE"),
      OneBall, "wrong type: 1 (#61 PRODUCT_DEFINITION_SHAPE definition #60)" },
    { "a mapped item at a point",
      ExtendBall("(#45,#32)", "(#45,#80)",
        "#80=SHAPE_REPRESENTATION('',(#23,#81),#6);\n#81=MAPPED_ITEM('',#83,#20);\n#83=REPRESENTATION_MAP(#"
        "23,#32);\n"),
      Count(1, 1, 1, 0, 1), "wrong type: 1 (#81 MAPPED_ITEM mapping target #20)" },
    { "no products", MakeStepText(GetBallText().substr(0, GetBallText().find("#40="))), OneBall, "" },
    { "no products, mapped",
      MakeStepText(GetBallText().substr(0, GetBallText().find("#40=")) +
        "#80=SHAPE_REPRESENTATION('',(#81,#82),#6);\n#81=MAPPED_ITEM('',#83,#23);\n#82=MAPPED_ITEM('',#83,#"
        "23);\n#83=REPRESENTATION_MAP(#23,#32);\n"),
      Count(1, 2, 1, 0, 2), "" },
    { "a damaged occurrence", ChangeBox("'first','',#52", "'first'?,'',#52"), OneInBox,
      "damaged entity: 1 (#60 NEXT_ASSEMBLY_USAGE_OCCURRENCE); wrong parameter: 2 (#60 "
      "NEXT_ASSEMBLY_USAGE_OCCURRENCE relating product, #60 NEXT_ASSEMBLY_USAGE_OCCURRENCE related "
      "product)" },
    { "the shape of a feature",
      ExtendBall("ball", "ball",
        "#80=SHAPE_ASPECT('','',#45,.T.);\n#81=PROPERTY_DEFINITION('','',#80);\n#82=SHAPE_DEFINITION_"
        "REPRESENTATION(#81,#83);\n#83=SHAPE_REPRESENTATION('',(#29),#6);\n"),
      OneBall, "" },
    { "10 levels of two", MakeLevels(10, 2), Count(1, 1024, 1, 20), "" },
    { "100 levels of one", MakeLevels(100, 1), Count(1, 1, 1, 100), "" },
  };
}
}

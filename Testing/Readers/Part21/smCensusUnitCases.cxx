// The cases of units of a census.
#include "smCensusCases.h"

#include "smCensusSamples.h"

namespace smtest
{
namespace
{
const std::string OneSolid = "solids 1, instances 1, faces 1, surface models 0 with faces 0, other solids 0, "
                             "occurrences 0, mapped 0";
}

std::vector<CensusCase> GetUnitCases()
{
  const std::string unit = "#2=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));";
  const auto inch = [&unit](const std::string& factor)
  {
    return ExtendBall(unit, "#2=(CONVERSION_BASED_UNIT('INCH',#70)LENGTH_UNIT()NAMED_UNIT(#72));",
      "#70=LENGTH_MEASURE_WITH_UNIT(" + factor +
        ",#71);\n#71=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n#72=DIMENSIONAL_EXPONENTS(1.,0.,"
        "0.,0.,0.,0.,0.);\n");
  };
  return {
    { "millimetres", ChangeBall("ball", "ball"), OneSolid, "" },
    { "inches", inch("LENGTH_MEASURE(25.4)"), OneSolid, "" },
    { "inches without a type", inch("25.4"), OneSolid, "" },
    { "negative inches", inch("LENGTH_MEASURE(-25.4)"), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "inches of zero", inch("LENGTH_MEASURE(0.)"), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "inches of 25.43", inch("LENGTH_MEASURE(25.43)"), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "inches without a number", inch("LENGTH_MEASURE('25.4')"), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "an inch of inches", Replace(inch("LENGTH_MEASURE(25.4)"), "#71);", "#2);"), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "inches of a damaged unit",
      ChangeBall("#2=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));",
        "#2=(CONVERSION_BASED_UNIT('INCH',#80)LENGTH_UNIT()NAMED_UNIT($));\n#80=LENGTH_MEASURE_WITH_UNIT("
        "LENGTH_MEASURE(25.4),#81);\n#81=(LENGTH_UNIT()PRODUCT(*)SI_UNIT(.MILLI.,.METRE.));"),
      OneSolid, "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "a unit with a digit before it", ChangeBall("#2=(LENGTH_UNIT", "#2=(8LENGTH_UNIT"), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "a solid for a unit", ChangeBall("((#2,#3,#4))", "((#31,#3,#4))"), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #31)" },
    { "an area unit in the place of the angle unit",
      ExtendBall(
        "((#2,#3,#4))", "((#2,#70,#4))", "#70=AREA_UNIT((#71));\n#71=DERIVED_UNIT_ELEMENT(#2,2.);\n"),
      OneSolid, "missing unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT angle unit)" },
    { "no length unit", ChangeBall("((#2,#3,#4))", "((#3,#4))"), OneSolid,
      "missing unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit)" },
    { "no angle unit", ChangeBall("((#2,#3,#4))", "((#2,#4))"), OneSolid,
      "missing unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT angle unit)" },
    { "no units", ChangeBall("GLOBAL_UNIT_ASSIGNED_CONTEXT((#2,#3,#4))", ""), OneSolid,
      "missing unit: 2 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit, #6 GEOMETRIC_REPRESENTATION_CONTEXT "
      "angle unit)" },
    { "no context", ChangeBall("(#23,#31),#6)", "(#23,#31),$)"), OneSolid,
      "missing unit: 1 (#31 MANIFOLD_SOLID_BREP context)" },
    { "a context with a record of another entity",
      ChangeBall("REPRESENTATION_CONTEXT('','')", "LENGTH_UNIT('','')"), OneSolid,
      "wrong unit: 2 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #6, #6 "
      "GEOMETRIC_REPRESENTATION_CONTEXT "
      "angle unit #6)" },
    { "a context with a parameter too many",
      ChangeBall("REPRESENTATION_CONTEXT('','')", "REPRESENTATION_CONTEXT('','','')"), OneSolid,
      "wrong unit: 2 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #6, #6 "
      "GEOMETRIC_REPRESENTATION_CONTEXT "
      "angle unit #6)" },
    { "an undefined unit", ChangeBall("((#2,#3,#4))", "((#99,#3,#4))"), OneSolid,
      "damaged entity: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT context); wrong unit: 1 (#6 "
      "GEOMETRIC_REPRESENTATION_CONTEXT length unit #6)" },
    { "a prefix that is none", ChangeBall(".MILLI.", ".MILLY."), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "petametres", ChangeBall(".MILLI.", ".PETA."), OneSolid,
      "absurd unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "grams", ChangeBall(".METRE.", ".GRAM."), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "a damaged unit", ChangeBall("(.MILLI.,.METRE.));", "(.MILLI.,.METRE.);"), OneSolid,
      "wrong unit: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT length unit #2)" },
    { "a damaged context", ChangeBall("GLOBAL_UNIT_ASSIGNED_CONTEXT((#2", "*) ((#2"), OneSolid,
      "damaged entity: 1 (#6 GEOMETRIC_REPRESENTATION_CONTEXT context); missing unit: 2 (#6 "
      "GEOMETRIC_REPRESENTATION_CONTEXT length unit, #6 GEOMETRIC_REPRESENTATION_CONTEXT angle unit)" },
  };
}
}

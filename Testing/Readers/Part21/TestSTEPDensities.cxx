/**
 * @file TestSTEPDensities.cxx
 * @brief Densities in the units that CAD systems state them in, of parts and of assemblies
 */
#include "smCensusCases.h"
#include "smCensusSamples.h"
#include "smSTEPCensus.h"
#include "smTesting.h"

#include <string>
#include <utility>

namespace
{
using smtest::Check;
using smtest::CheckEqual;
using smtest::CheckTrue;

/// Units of mass and length: #80 to #89.
const char DensityUnits[] = R"(#80=(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.GRAM.));
#81=(MASS_UNIT()NAMED_UNIT(*)SI_UNIT($,.GRAM.));
#82=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));
#83=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));
#84=DIMENSIONAL_EXPONENTS(0.,1.,0.,0.,0.,0.,0.);
#85=MASS_MEASURE_WITH_UNIT(MASS_MEASURE(0.45359237),#80);
#86=(CONVERSION_BASED_UNIT('POUND',#85)MASS_UNIT()NAMED_UNIT(#84));
#87=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),#2);
#88=(CONVERSION_BASED_UNIT('INCH',#87)LENGTH_UNIT()NAMED_UNIT(*));
#89=(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.MEGA.,.GRAM.));
)";

/// #104=#100 with the value in mass^a length^b, as a property of an entity.
std::string StateDensity(int first, const std::string& value, const std::string& mass,
  const std::string& length, const std::string& product,
  const std::string& property = "'material property','density'")
{
  const auto id = [first](int k) { return "#" + std::to_string(first + k); };
  return id(0) + "=DERIVED_UNIT_ELEMENT(" + mass + ");\n" + id(1) + "=DERIVED_UNIT_ELEMENT(" + length +
    ");\n" + id(2) + "=DERIVED_UNIT((" + id(0) + "," + id(1) + "));\n" + id(3) +
    "=MEASURE_REPRESENTATION_ITEM('measure',POSITIVE_RATIO_MEASURE(" + value + ")," + id(2) + ");\n" + id(4) +
    "=REPRESENTATION('',(" + id(3) + "),#6);\n" + id(5) + "=PROPERTY_DEFINITION(" + property + "," + product +
    ");\n" + id(6) + "=PROPERTY_DEFINITION_REPRESENTATION(" + id(5) + "," + id(4) + ");\n";
}

sm::STEPCensus TakeDensities(const std::string& text)
{
  sm::Part21File file;
  file.Parse(text);
  return sm::TakeSTEPCensus(file);
}

sm::STEPCensus TakeBall(const std::string& statements)
{
  return TakeDensities(smtest::MakeStepText(smtest::GetBallText() + DensityUnits + statements));
}

void CheckBall(const std::string& what, double density, const std::string& statements)
{
  const sm::STEPCensus census = TakeBall(statements);
  Check(what, density, census.Bodies.at(0).Density, 4e-16 * density, "rounding");
  CheckTrue(what + ": no contradiction", census.Problems.empty());
}

void CheckUnits()
{
  CheckBall("kg/m^3", 7850.0, StateDensity(100, "7850.", "#80,1.", "#82,-3.", "#44"));
  CheckBall("g/cm^3", 7850.0, StateDensity(100, "7.85", "#81,1.", "#83,-3.", "#44"));
  CheckBall("kg/mm^3", 7850.0, StateDensity(100, "7.85E-6", "#80,1.", "#2,-3.", "#44"));
  CheckBall("t/mm^3", 7850.0, StateDensity(100, "7.85E-09", "#89,1.", "#2,-3.", "#44"));
  CheckBall("lb/in^3", 0.2836 * 0.45359237 / (0.0254 * 0.0254 * 0.0254),
    StateDensity(100, "0.2836", "#86,1.", "#88,-3.", "#44"));
  CheckBall("without the minus", 7850.0, StateDensity(100, "7850.", "#80,1.", "#82,3.", "#44"));
  CheckBall("OpenCASCADE's g/cm^3", 7850.0, StateDensity(100, "7.85", "#81,3.", "#83,2.", "#44"));
}

void CheckProperties()
{
  const std::string kilograms = "#80,1.";
  const std::string metres = "#82,-3.";
  CheckBall(
    "a user's own", 1000.0, StateDensity(100, "1000.", kilograms, metres, "#44", "'PTC_MASS_DENSITY',''"));
  CheckBall("of the shape", 1000.0, StateDensity(100, "1000.", kilograms, metres, "#45", "'Density',$"));
  CheckBall("the recommended one goes first", 2700.0,
    StateDensity(100, "1000.", kilograms, metres, "#44", "'Density',''") +
      StateDensity(110, "2700.", kilograms, metres, "#44"));
  CheckBall("a material property that is not a density", 0.0,
    StateDensity(100, "7.", "#80,1.", "#82,-2.", "#44", "'material property','x'"));
  CheckBall("of another entity", 0.0, StateDensity(100, "7850.", kilograms, metres, "#31"));
  CheckBall("none", 0.0, "");
  CheckBall("also in a representation that no product uses", 1000.0,
    StateDensity(100, "1000.", kilograms, metres, "#44") +
      "#200=SHAPE_REPRESENTATION('',(#23),#6);\n#201=ITEM_DEFINED_TRANSFORMATION('','',#23,#23);\n"
      "#202=(REPRESENTATION_RELATIONSHIP('','',#32,#200)REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#201)"
      "SHAPE_REPRESENTATION_RELATIONSHIP());\n");
  CheckBall("also an item of a representation that no product uses", 1000.0,
    StateDensity(100, "1000.", kilograms, metres, "#44") + "#200=SHAPE_REPRESENTATION('',(#31),#6);\n");
  CheckBall("a zero for none", 0.0, StateDensity(100, "0.", kilograms, metres, "#44"));

  for (const auto& [value, unit] : { std::pair<std::string, std::string>{ "7850.", "#82,-2." },
         { "-7850.", metres }, { "1.E250", metres }, { "1.E-250", metres } })
  {
    const sm::STEPCensus census = TakeBall(StateDensity(100, value, kilograms, unit, "#44"));
    CheckEqual("not usable: statements", 1, static_cast<int>(census.Densities.size()));
    const sm::STEPDensity& density = census.Densities.at(0);
    CheckTrue("not usable: says why",
      density.Density == 0.0 && density.Product == 44 && density.Id == 103 && !density.Problem.empty(),
      density.Problem);
    CheckTrue("not usable: none", census.Bodies.at(0).Density == 0.0);
  }
}

void CheckSeveral()
{
  const std::string steel = StateDensity(100, "7850.", "#80,1.", "#82,-3.", "#44");
  const auto take = [](const std::string& statements)
  {
    const sm::STEPCensus census = TakeBall(statements);
    CheckEqual("several: statements", 1, static_cast<int>(census.Densities.size()));
    CheckEqual("several: the body has it", census.Densities.at(0).Density, census.Bodies.at(0).Density);
    return census.Densities.at(0);
  };
  const sm::STEPDensity same = take(steel + StateDensity(110, "7.85", "#81,1.", "#83,-3.", "#44"));
  CheckTrue("the same twice", same.Density == 7850.0 && same.Problem.empty() && same.Others.empty());
  for (const bool isFirst : { true, false })
  {
    const std::string other = StateDensity(isFirst ? 90 : 110, "2700.", "#80,1.", "#82,-3.", "#44");
    const sm::STEPDensity none = take(isFirst ? other + steel : steel + other);
    CheckTrue("of equal rank none counts", none.Density == 0.0 && none.Contradicted);
    CheckTrue("  and both are said",
      none.Problem.find("#103 states 7850 kg/m^3") != std::string::npos &&
        none.Problem.find("states 2700 kg/m^3") != std::string::npos,
      none.Problem);
  }
  const std::string own = StateDensity(110, "1000.", "#80,1.", "#82,-3.", "#44", "'Density',''");
  const sm::STEPDensity recommended = take(own + steel);
  CheckEqual("of lower rank is not used", 7850.0, recommended.Density);
  CheckEqual("  and said", " #113 states 1000 kg/m^3 and is not used.", recommended.Others);
  const sm::STEPDensity negative = take(steel + StateDensity(110, "-5.", "#80,1.", "#82,-3.", "#44"));
  CheckEqual("a negative one next to it", 7850.0, negative.Density);
  CheckEqual("  is said", " #113 is not used: it is not from 1e-200 to 1e200 kg/m^3.", negative.Others);
}

sm::CensusBody TakeBoxed(const std::string& statements)
{
  const std::string text = smtest::GetAssemblyCases().at(0).Text;
  return TakeDensities(smtest::Replace(text, "#60=NEXT", DensityUnits + statements + "#60=NEXT"))
    .Bodies.at(0);
}

void CheckAssemblies()
{
  const std::string whole = StateDensity(100, "2.7", "#81,1.", "#83,-3.", "#52");
  const std::string part = StateDensity(110, "7850.", "#80,1.", "#82,-3.", "#44");
  Check("of the assembly", 2700.0, TakeBoxed(whole).Density, 0.0);
  Check("its own goes first", 7850.0, TakeBoxed(whole + part).Density, 0.0);
  Check("none", 0.0, TakeBoxed("").Density, 0.0);
  // The ball in a second product, of another density, of none, and of the same.
  const std::string second = "#150=PRODUCT_DEFINITION('design','',#51,#43);\n"
                             "#151=NEXT_ASSEMBLY_USAGE_OCCURRENCE('2','second','',#150,#44,$);\n";
  for (const std::string& other : { StateDensity(160, "1.", "#81,1.", "#83,-3.", "#150"), std::string() })
  {
    const sm::CensusBody ball = TakeBoxed(whole + second + other);
    CheckTrue("in assemblies that differ", ball.Density == 0.0 && ball.DensitiesDiffer);
  }
  const sm::CensusBody ball =
    TakeBoxed(whole + second + StateDensity(160, "2700.", "#80,1.", "#82,-3.", "#150"));
  Check("its own contradict each other, so that of the assembly does not count", 0.0,
    TakeBoxed(whole + part + StateDensity(170, "1.", "#81,1.", "#83,-3.", "#44")).Density, 0.0);
  // The density of one instance.
  const auto take = [&](const std::string& statements)
  {
    const std::string text = smtest::GetAssemblyCases().at(0).Text;
    return TakeDensities(smtest::Replace(text, "#60=NEXT", DensityUnits + statements + "#60=NEXT"));
  };
  for (const char* described : { "#60", "#61" })
  {
    const std::string single = StateDensity(170, "5000.", "#80,1.", "#82,-3.", described);
    for (const bool isOwn : { false, true })
    {
      const sm::STEPCensus census = take(isOwn ? single + part : single);
      CheckEqual("of one occurrence: none", 0.0, census.Bodies.at(0).Density);
      const std::string& problem = census.Densities.at(0).Problem;
      CheckTrue("of one occurrence: said",
        problem.find("#173 states 5000 kg/m^3 for the occurrence #60 alone") != std::string::npos &&
          (problem.find("#113 states 7850 kg/m^3, and") != std::string::npos) == isOwn,
        problem);
    }
  }
  CheckEqual("of one occurrence, the same", 7850.0,
    take(part + StateDensity(170, "7.85", "#81,1.", "#83,-3.", "#60")).Bodies.at(0).Density);
  const sm::STEPCensus unusable = take(part + StateDensity(170, "-1.", "#80,1.", "#82,-3.", "#60"));
  CheckEqual("of one occurrence, not usable", 7850.0, unusable.Bodies.at(0).Density);
  CheckEqual("  and said",
    " #173 for the occurrence #60 alone is not used: it is not from 1e-200 to 1e200 kg/m^3.",
    unusable.Densities.at(0).Others);
  CheckTrue("in assemblies that agree", ball.Density == 2700.0 && !ball.DensitiesDiffer);
}
}

int TestSTEPDensities(int, char*[])
{
  CheckUnits();
  CheckProperties();
  CheckSeveral();
  CheckAssemblies();
  return smtest::Finish();
}

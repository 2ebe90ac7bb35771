/**
 * @file TestSTEPProducts.cxx
 * @brief Validation properties of products as systems state them, statements that contradict themselves, and
 * new ones in a file's text
 */
#include "smCensusSamples.h"
#include "smSTEPProducts.h"
#include "smTesting.h"

#include <cmath>
#include <string>

namespace
{
using smtest::Check;
using smtest::CheckEqual;
using smtest::CheckTrue;

/// A representation with the item #`first` as a property of an entity: #`first` + 1 to + 3.
std::string Describe(int first, const std::string& item, const std::string& described,
  const std::string& name = "geometric validation property")
{
  const auto id = [first](int k) { return "#" + std::to_string(first + k); };
  return id(0) + "=" + item + ";\n" + id(1) + "=REPRESENTATION('',(" + id(0) + "),#6);\n" + id(2) +
    "=PROPERTY_DEFINITION('" + name + "','any text'," + described + ");\n" + id(3) +
    "=PROPERTY_DEFINITION_REPRESENTATION(" + id(2) + "," + id(1) + ");\n";
}

/// #90: cubic centimetres; #91: square millimetres.
const char ProductUnits[] = R"(#80=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.CENTI.,.METRE.));
#81=DERIVED_UNIT_ELEMENT(#80,3.);
#82=DERIVED_UNIT_ELEMENT(#2,2.);
#90=DERIVED_UNIT((#81));
#91=DERIVED_UNIT((#82));
)";

std::string MakeText(const std::string& statements)
{
  return smtest::MakeStepText(smtest::GetBallText() + ProductUnits + statements);
}

sm::STEPProduct Read(const std::string& statements)
{
  sm::Part21File file;
  file.Parse(MakeText(statements));
  const std::vector<sm::STEPProduct> products = sm::ReadSTEPProducts(file);
  CheckEqual("products", 1, static_cast<long long>(products.size()));
  return products.at(0);
}

const std::string Volume = "MEASURE_REPRESENTATION_ITEM('volume measure',VOLUME_MEASURE(2.5),#90)";

void CheckStatements()
{
  sm::STEPProduct product = Read("");
  CheckEqual("name", "ball", product.Name);
  CheckEqual("definition", 44, static_cast<long long>(product.Definition));
  CheckEqual("shape", 45, static_cast<long long>(product.Shape));
  CheckEqual("context", 6, static_cast<long long>(product.Context));
  Check("its unit", 1.0, product.Millimetres, 0.0);
  CheckTrue("nothing is stated",
    std::isnan(product.Stated.Volume) && std::isnan(product.Stated.Area) && product.VolumeProblem.empty());

  product = Read(Describe(100, Volume, "#45") +
    Describe(110, "MEASURE_REPRESENTATION_ITEM('wetted area measure',AREA_MEASURE(7.),#91)", "#45") +
    Describe(120, "CARTESIAN_POINT('centre point',(1.,-2.E-1,3.))", "#45"));
  Check("volume in mm^3", 2500.0, product.Stated.Volume, 0.0);
  Check("area in mm^2", 7.0, product.Stated.Area, 0.0);
  Check("centroid", -0.2, product.Stated.Centroid[1], 0.0);
  CheckEqual("no problem", "", product.VolumeProblem + product.AreaProblem + product.CentroidProblem);

  CheckTrue("another property",
    std::isnan(Read(Describe(100, Volume, "#45", "pmi validation property")).Stated.Volume));
  CheckTrue("a property of something else", std::isnan(Read(Describe(100, Volume, "#31")).Stated.Volume));
  CheckTrue("another point",
    std::isnan(Read(Describe(100, "CARTESIAN_POINT('corner',(1.,2.,3.))", "#45")).Stated.Centroid[0]));
  CheckEqual(
    "twice the same", "", Read(Describe(100, Volume, "#45") + Describe(110, Volume, "#45")).VolumeProblem);
  const std::string other = smtest::Replace(Volume, "2.5", "2.6");
  CheckTrue("twice, with different values",
    !Read(Describe(100, Volume, "#45") + Describe(110, other, "#45")).VolumeProblem.empty());
  for (const char* unit : { "#91", "#2", "#45" })
  {
    product = Read(Describe(100, smtest::Replace(Volume, "#90", unit), "#45"));
    CheckTrue(std::string("a volume in the unit ") + unit,
      std::isnan(product.Stated.Volume) && product.VolumeProblem.find("#100") != std::string::npos,
      product.VolumeProblem);
  }
}

const std::string Area = "MEASURE_REPRESENTATION_ITEM('wetted area measure',AREA_MEASURE(7.),#91)";
const std::string Centroid = "CARTESIAN_POINT('centre point',(1.,-2.E-1,3.))";

/// One statement that cannot be used leaves the two others.
void CheckProblemsOfOne()
{
  const std::string noUnit = smtest::Replace(Volume, "#90", "#2");
  sm::STEPProduct product =
    Read(Describe(100, noUnit, "#45") + Describe(110, Area, "#45") + Describe(120, Centroid, "#45"));
  CheckTrue("a volume without a unit", !product.VolumeProblem.empty() && std::isnan(product.Stated.Volume));
  CheckEqual("  no problem of the others", "", product.AreaProblem + product.CentroidProblem);
  Check("  area", 7.0, product.Stated.Area, 0.0);
  Check("  centroid", 3.0, product.Stated.Centroid[2], 0.0);
  product = Read(Describe(100, Volume, "#45") + Describe(110, Area, "#45") +
    smtest::Replace(Describe(120, Centroid, "#45"), ",#6)", ",#2)"));
  CheckTrue("a centroid without a unit", !product.CentroidProblem.empty());
  CheckEqual("  no problem of the others", "", product.AreaProblem + product.VolumeProblem);
  Check("  volume", 2500.0, product.Stated.Volume, 0.0);
}

/// The unit of a point is that of its own context, also where no body has that context.
void CheckContextsOfPoints()
{
  const std::string metres = "#95=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n"
                             "#96=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#95))"
                             "REPRESENTATION_CONTEXT('',''));\n";
  const sm::STEPProduct product =
    Read(metres + smtest::Replace(Describe(120, Centroid, "#45"), ",#6)", ",#96)"));
  CheckEqual("a context that no body has: no problem", "", product.CentroidProblem);
  Check("  in metres", 3000.0, product.Stated.Centroid[2], 0.0);
}

/// Pro/ENGINEER states properties, with underscores in the name, of an aspect that is the whole shape.
void CheckAspects()
{
  const std::string name = "geometric_validation_property";
  const std::string aspects =
    "#97=SHAPE_ASPECT('','solid data',#45,.F.);\n#98=SHAPE_ASPECT('','another',#45,.F.);\n";
  sm::STEPProduct product = Read(aspects + Describe(100, Volume, "#97", name) +
    Describe(110, Area, "#97", name) + Describe(120, Centroid, "#97", name));
  Check("of the only aspect: volume", 2500.0, product.Stated.Volume, 0.0);
  Check("  area", 7.0, product.Stated.Area, 0.0);
  Check("  centroid", 1.0, product.Stated.Centroid[0], 0.0);
  product = Read(aspects + Describe(100, Volume, "#97", name) + Describe(110, Area, "#98", name));
  CheckTrue("of two aspects: which one is the whole is not known",
    std::isnan(product.Stated.Volume) && std::isnan(product.Stated.Area));
  const std::string other = smtest::Replace(Volume, "2.5", "2.6");
  product = Read(aspects + Describe(100, Volume, "#45") + Describe(110, other, "#97", name));
  Check("the product's own statement counts", 2500.0, product.Stated.Volume, 0.0);
  CheckEqual("  no problem", "", product.VolumeProblem);
}

void CheckAppending()
{
  for (const char* behind : { "", "/* ENDSEC; is not the end yet */\n" })
  {
    const std::string text = MakeText(behind);
    sm::Part21File file;
    file.Parse(text);
    sm::STEPStatement statement;
    statement.Product = sm::ReadSTEPProducts(file).at(0);
    statement.Values.Volume = 1.0 / 3.0;
    statement.Values.Centroid = { -1e-17, 2.0, 1e20 };
    statement.Density = 7850.0;
    statement.Material = "O'Neill\\steel";
    const std::string longer = sm::AppendSTEPValidation(file, { statement });
    const std::size_t end = text.rfind("ENDSEC;");
    CheckTrue("what was there is there",
      longer.compare(0, end, text, 0, end) == 0 &&
        longer.compare(
          longer.size() - (text.size() - end), std::string::npos, text, end, std::string::npos) == 0);
    sm::Part21File again;
    CheckTrue("it is a file", again.Parse(longer) && again.GetProblems().empty());
    const sm::STEPProduct product = sm::ReadSTEPProducts(again).at(0);
    Check("volume, to the bit", 1.0 / 3.0, product.Stated.Volume, 0.0);
    Check("centroid x", -1e-17, product.Stated.Centroid[0], 0.0);
    Check("centroid z", 1e20, product.Stated.Centroid[2], 0.0);
    CheckTrue("no area", std::isnan(product.Stated.Area));
    CheckTrue("a density", product.HasDensity && !statement.Product.HasDensity);
    CheckTrue("a material", product.HasMaterial && !statement.Product.HasMaterial);
    CheckTrue("quotes", longer.find("'O''Neill\\\\steel'") != std::string::npos);
  }
  sm::Part21File nothing;
  CheckEqual("no entities", "", sm::AppendSTEPValidation(nothing, {}));
}
}

int TestSTEPProducts(int, char*[])
{
  CheckStatements();
  CheckProblemsOfOne();
  CheckContextsOfPoints();
  CheckAspects();
  CheckAppending();
  return smtest::Finish();
}

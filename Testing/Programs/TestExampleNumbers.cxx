// TestExampleNumbers [commas]: the command line prints and reads numbers with a decimal point, in the locale
// "C" or, with `commas`, in de_DE.UTF-8 of LOCPATH.
#include "smArguments.h"
#include "smBuoyancyAnalysis.h"
#include "smOptionValues.h"
#include "smReport.h"
#include "smTesting.h"
#include "smText.h"

#include <clocale>
#include <cmath>
#include <cstring>
#include <locale>
#include <vector>

namespace
{
using namespace smtest;

void CheckReading()
{
  Check("number", -0.25, sm::ParseNumber("-0.25"), 0.0);
  Check("with a plus", 1500.0, sm::ParseNumber("+1.5e3"), 0.0);
  for (const char* wrong : { "", "+", "0,5", "1.5x", " 1", "+-1", "1.5 " })
  {
    CheckTrue(std::string("no number: '") + wrong + "'", std::isnan(sm::ParseNumber(wrong)));
  }
  std::string quantity;
  double relative = 0.0;
  double absolute = 0.0;
  CheckTrue("tolerance", sm::ParseQuantityTolerance("center=0.5,1.25e-3", quantity, relative, absolute));
  CheckEqual("its quantity", "center", quantity);
  Check("relative", 0.5, relative, 0.0);
  Check("absolute", 1.25e-3, absolute, 0.0);
  for (const char* wrong : { "center", "center=", "center=0.5,", "center=1,2,3", "mass=0.5", "volume=-1" })
  {
    CheckTrue(std::string("no tolerance: ") + wrong,
      !sm::ParseQuantityTolerance(wrong, quantity, relative, absolute));
  }
  std::array<double, 3> direction{};
  CheckTrue("direction", sm::ParseDirection("0.5,-1.25,2", direction));
  CheckTrue("its numbers", direction == std::array<double, 3>{ 0.5, -1.25, 2.0 });
  for (const char* wrong : { "0.5,1", "1,2,3,4", "1,,2", "1,2,", "0,0,0" })
  {
    CheckTrue(std::string("no direction: ") + wrong, !sm::ParseDirection(wrong, direction));
  }
}

void CheckArguments()
{
  std::vector<std::string> texts = { "solidmoments", "--tolerance", "0.25", "--density", "7850.5",
    "--max-seconds", "1.5", "--waterline", "-2.5", "--waterline", "0.125", "--up", "0,0.5,1", "part.step" };
  std::vector<char*> pointers;
  for (std::string& text : texts)
  {
    pointers.push_back(text.data());
  }
  sm::Arguments arguments;
  CheckTrue("arguments",
    !sm::ParseArguments(static_cast<int>(pointers.size()), pointers.data(), arguments).has_value());
  Check("tolerance", 0.25, arguments.Job.Tolerance, 0.0);
  Check("density", 7850.5, arguments.Job.Density, 0.0);
  Check("seconds", 1.5, arguments.Job.MaximumSeconds, 0.0);
  for (const std::shared_ptr<sm::Analysis>& analysis : arguments.Job.Analyses)
  {
    if (const auto* buoyancy = dynamic_cast<const sm::BuoyancyAnalysis*>(analysis.get()))
    {
      CheckTrue("heights", buoyancy->GetWaterlines() == std::vector<double>{ -2.5, 0.125 });
      Check("direction", 0.5, buoyancy->GetUp()[1], 0.0);
    }
  }
}

void CheckReport()
{
  CheckEqual("value", "1.2345679", sm::FormatValue(1.23456789, 1e-6));
  CheckEqual("vector", "0.5  -1.25  0", sm::FormatVector({ 0.5, -1.25, -1e-17 }, 1e-9));
  sm::JobOptions options;
  options.FileName = "part.step";
  sm::FileResult file = sm::UnreadableFile(options, "a note");
  file.Backend = "cpu";
  file.LengthUnit = "mm";
  file.Renderer = "CPU";
  file.Seconds.Start = 0.125;
  sm::TotalResult& total = file.Total;
  total.Volume.Value = { 1234.5 };
  total.Volume.Bound = 0.00123;
  total.Mass.Value = { 9.75 };
  total.Mass.Bound = 0.00025;
  total.Center.Value = { 0.5, 1.5, 2.5 };
  const std::string table = sm::FormatTable(file);
  for (const char* number :
    { "1234.5 mm^3", "+/- 0.0013", "9.75 kg", "+/- 0.00027", "0.5  1.5  2.5", "start 0.12" })
  {
    CheckTrue(std::string("table has ") + number, table.find(number) != std::string::npos, table);
  }
  const std::string csv = sm::FormatCsv({ file });
  CheckTrue("CSV", csv.find(",1234.5,0.00123,") != std::string::npos, csv);
  CheckTrue("CSV of the mass", csv.find(",9.75,0.00025,") != std::string::npos, csv);
}
}

int main(int argc, char* argv[])
{
  if (argc == 2 && std::strcmp(argv[1], "commas") == 0)
  {
    CheckTrue("locale", std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr);
    std::locale::global(std::locale("de_DE.UTF-8"));
    CheckEqual("it has commas", ",", std::localeconv()->decimal_point);
  }
  CheckReading();
  CheckArguments();
  CheckReport();
  return Finish();
}

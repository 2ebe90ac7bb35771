// TestTrimTextureOrder: what texels do to the volume of the paper's block with a slanted hole, whose only
// curved face is trimmed by two waves. Finer texels at the same sub-patches change it by less and less, at
// first order or better. What is left is that a trimmed sub-patch's integral is weighed as a whole, wherever
// in it the face is: that falls with the sub-patches alone, at second order.
#include "smPaperSolid.h"
#include "smTesting.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkSchemeMassPropertiesGPU.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace
{
constexpr int FinestTexels = 16;
constexpr int FirstFactor = 4;
constexpr int LastFactor = 12;
// At the finest texels, so that the error of the sub-patches is seen.
constexpr int FarFactor = 24;

/// Relative errors by sub-patch factor.
using Errors = std::map<int, double>;

Errors GetErrors(vtkSchemeMassPropertiesGPU* mass, double volume, int texels, int lastFactor = LastFactor)
{
  mass->SetTrimTextureFactor(texels);
  Errors errors;
  for (int k = FirstFactor; k <= lastFactor; ++k)
  {
    mass->SetSubPatchFactor(k);
    mass->Update();
    errors[k] = mass->GetVolume() / volume - 1.0;
  }
  return errors;
}

/// Root mean square of errors less `others` over the factors: one factor alone may be right by chance.
double GetMean(const Errors& errors, const Errors& others, int first, int last)
{
  double sum = 0.0;
  for (int k = first; k <= last; ++k)
  {
    const double difference = errors.at(k) - (others.empty() ? 0.0 : others.at(k));
    sum += difference * difference;
  }
  return std::sqrt(sum / (last - first + 1));
}

/// The slope of log(y) against log(x), by least squares.
double FitOrder(const std::vector<std::pair<double, double>>& points)
{
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [px, py] : points)
  {
    const double a = std::log(px);
    const double b = std::log(py);
    n += 1.0;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

void CheckScheme(vtkSchemeMassPropertiesGPU* mass, double volume, int scheme, const std::string& name)
{
  mass->SetScheme(scheme);
  const Errors finest = GetErrors(mass, volume, FinestTexels, FarFactor);
  std::vector<std::pair<double, double>> differences;
  double errorOfFour = 0.0;
  for (int texels = 1; texels < FinestTexels; texels *= 2)
  {
    const Errors errors = GetErrors(mass, volume, texels);
    errorOfFour = texels == 4 ? GetMean(errors, {}, FirstFactor, LastFactor) : errorOfFour;
    differences.push_back({ texels, GetMean(errors, finest, FirstFactor, LastFactor) });
    std::printf("%s, %2d texels: error %.2e, difference from %d texels %.2e\n", name.c_str(), texels,
      GetMean(errors, {}, FirstFactor, LastFactor), FinestTexels, differences.back().second);
  }
  // A texel on a curve errs by itself at most: order 1; by chance, along a curve: 3/2. Above 2 it would not
  // be the texels' error.
  smtest::CheckRange(name + ", order in the texels' width", -2.0, FitOrder(differences), -0.9);
  // With sub-patches of width h, each of h^2 on the curve is wrong by h of the integrand, and there are 1 / h
  // of them: order 2 to one side, 5/2 by chance.
  const double coarse = GetMean(finest, {}, FirstFactor, 8);
  const double fine = GetMean(finest, {}, 16, FarFactor);
  std::printf(
    "%s, %d texels: error %.2e near k = 6, %.2e near k = 20\n", name.c_str(), FinestTexels, coarse, fine);
  smtest::CheckRange(name + ", order of the rest in the sub-patches' width", -3.0,
    FitOrder({ { 6.0, coarse }, { 20.0, fine } }), -1.5);
  smtest::CheckRange(name + ", four times the texels do not help against it", 0.5 * errorOfFour,
    GetMean(finest, {}, FirstFactor, LastFactor), 1.5 * errorOfFour, "the rest is most of it");
}
}

int TestTrimTextureOrder(int, char*[])
{
  const smfigure::PaperSolid block = smfigure::MakeSlantedBlock();
  vtkNew<vtkSchemeMassPropertiesGPU> mass;
  mass->SetInputData(block.DataSet);
  // That the schemes have no bound is a warning of every run.
  vtkNew<vtkCallbackCommand> silence;
  mass->AddObserver(vtkCommand::WarningEvent, silence);
  // Planes as good as exact: the curved face makes the error.
  mass->SetChordTolerance(1e-10);
  CheckScheme(mass, block.Volume, vtkSchemeMassPropertiesGPU::GAUSS2, "GAUSS2");
  CheckScheme(mass, block.Volume, vtkSchemeMassPropertiesGPU::GAUSS3, "GAUSS3");
  return smtest::Finish();
}

#include "smIntegrationPrograms.h"

#include "smFacePanels.h"
#include "smResidentFaces.h"
#include "smShaderSource.h"

#include "smCapCS.h"
#include "smPanelCS.h"
#include "smRibbonCS.h"
#include "smWork.h"

#include <algorithm>
#include <cstdio>

namespace sm
{
namespace
{
// Leading columns of a row: largest gap, squared gap, gap area.
constexpr int GapColumns = 3;

std::string ListOfNumbers(const std::vector<int>& numbers)
{
  std::string text;
  for (const int number : numbers)
  {
    text += (text.empty() ? "" : ", ") + std::to_string(number);
  }
  return text;
}
}

IntegrationPrograms::IntegrationPrograms(vtkComputeContext* context)
  : Context(context)
{
}

void IntegrationPrograms::Configure(
  const std::vector<Integrand>& integrands, int stripPoints, bool usePlacements, double perturbation)
{
  this->Integrands = integrands;
  this->StripPoints = stripPoints;
  this->UsePlacements = usePlacements;
  this->Perturbation = perturbation;
  this->Magnitudes.clear();
  this->RoundingOf.clear();
  for (const Integrand& integrand : integrands)
  {
    auto found = std::find(this->Magnitudes.begin(), this->Magnitudes.end(), integrand.Magnitude);
    if (found == this->Magnitudes.end())
    {
      found = this->Magnitudes.insert(found, integrand.Magnitude);
    }
    this->RoundingOf.push_back(static_cast<int>(found - this->Magnitudes.begin()));
  }
  this->Programs.clear();
}

ProgramKey IntegrationPrograms::ChooseProgram(ItemKind kind, int degreeS, int degreeR)
{
  static const std::pair<int, int> common[] = { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 3, 3 } };
  if (kind == ItemKind::Panel &&
    std::find(std::begin(common), std::end(common), std::make_pair(degreeS, degreeR)) != std::end(common))
  {
    return { kind, degreeS, degreeR };
  }
  return { kind, 0, 0 };
}

int IntegrationPrograms::GetStride() const
{
  return GapColumns + 3 * static_cast<int>(this->Integrands.size()) + this->GetNumberOfRoundings();
}

std::string IntegrationPrograms::MakeAccumulation(bool chainOnly) const
{
  std::string text;
  for (std::size_t k = 0; k < this->Integrands.size(); ++k)
  {
    if (!chainOnly || this->Integrands[k].ClosedChain)
    {
      text += "values[" + std::to_string(k) + "] += weight * (" + this->Integrands[k].Expression + ");\n";
    }
  }
  return text;
}

ComputeProgram* IntegrationPrograms::Get(const ProgramKey& key)
{
  const auto found = this->Programs.find(key);
  if (found != this->Programs.end() && found->second.IsBuilt())
  {
    return &found->second;
  }
  const auto [kind, degreeS, degreeR] = key;
  const char* const texts[] = { smPanelCS, smRibbonCS, smCapCS };
  const char* const names[] = { "smPanelCS", "smRibbonCS", "smCapCS" };
  ShaderSource source(names[static_cast<int>(kind)], texts[static_cast<int>(kind)]);
  for (const char* chunk : { "smPortable", "smBernstein", "smPatch", "smResident" })
  {
    source.AddChunk(chunk, GetNURBSShaderChunk(chunk));
  }
  source.AddChunk("smWork", smWork);

  source.Define("SM_INTEGRANDS", static_cast<int>(this->Integrands.size()));
  source.Define("SM_ROUNDINGS", this->GetNumberOfRoundings());
  source.Define("SM_ROUNDING_OF", ListOfNumbers(this->RoundingOf));
  source.Define("SM_STRIP_POINTS", this->StripPoints);
  char literal[40];
  std::snprintf(literal, sizeof(literal), "%.17eLF", this->Perturbation);
  source.Define("SM_PERTURBATION", literal);
  if (this->UsePlacements)
  {
    source.Define("SM_PLACEMENT", 1);
  }
  source.Define("SM_DEGREE_S", degreeS > 0 ? std::to_string(degreeS) : "int(patchRecord.shape.y)");
  source.Define("SM_DEGREE_R", degreeR > 0 ? std::to_string(degreeR) : "int(patchRecord.shape.z)");
  source.Define("SM_ROW_SIZE", degreeS > 0 ? degreeS + 1 : MaximumDegree + 1);
  source.Define("SM_BASIS_SIZE", degreeR > 0 ? std::max(degreeS, degreeR) : MaximumDegree);

  std::string roundings;
  for (std::size_t k = 0; k < this->Magnitudes.size(); ++k)
  {
    roundings += "roundings[" + std::to_string(k) + "] += noise * (" + this->Magnitudes[k] + ");\n";
  }
  source.Replace(kind == ItemKind::Panel ? "//SM::AccumulateFaces" : "//SM::AccumulateChain",
    this->MakeAccumulation(kind != ItemKind::Panel));
  source.Replace("//SM::AccumulateRoundings", roundings);
  if (!source.Assemble())
  {
    this->Error = source.GetError();
    return nullptr;
  }
  ComputeProgram program;
  const std::string label = source.GetName() + " " + std::to_string(degreeS) + "x" + std::to_string(degreeR);
  if (!program.Build(this->Context, label, source.GetSource()))
  {
    this->Error = program.GetError();
    return nullptr;
  }
  ComputeProgram& stored = this->Programs[key];
  stored = std::move(program);
  return &stored;
}
}

#include "smIntegrationPrograms.h"

#include "smFacePanels.h"
#include "smResidentFaces.h"
#include "smShaderSource.h"

#include "smAccumulate.h"
#include "smCap.h"
#include "smCapCS.h"
#include "smPanel.h"
#include "smPanelCS.h"
#include "smRibbon.h"
#include "smRibbonCS.h"
#include "smWork.h"
#include "smWorkRecord.h"
#include "smWorkStorage.h"

#include <algorithm>
#include <cstdio>

namespace sm
{
namespace
{
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

void IntegrationPrograms::Configure(const ItemRunner::Setup& setup, const RowLayout& layout)
{
  this->Setup = setup;
  this->Layout = layout;
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

std::string IntegrationPrograms::MakeValues(bool chainOnly) const
{
  std::string text;
  for (std::size_t k = 0; k < this->Setup.Integrands.size(); ++k)
  {
    const Integrand& integrand = this->Setup.Integrands[k];
    if (!chainOnly || integrand.ClosedChain)
    {
      text += "smValues[" + std::to_string(k) + "] += weight * (" + integrand.Expression + ");\n";
    }
  }
  return text;
}

std::string IntegrationPrograms::MakeRoundings() const
{
  std::string text;
  for (int k = 0; k < this->Layout.GetNumberOfRoundings(); ++k)
  {
    const Integrand& integrand = this->Setup.Integrands[this->Layout.GetMagnitudes()[k]];
    text += "smRoundings[" + std::to_string(k) + "] += noise * (" + integrand.Magnitude + ");\n";
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
  for (const char* chunk : { "smPortable", "smBernstein", "smPatch", "smPatchRecord", "smResident" })
  {
    source.AddChunk(chunk, GetNURBSShaderChunk(chunk));
  }
  const std::pair<const char*, const char*> chunks[] = { { "smAccumulate", smAccumulate }, { "smCap", smCap },
    { "smPanel", smPanel }, { "smRibbon", smRibbon }, { "smWork", smWork }, { "smWorkRecord", smWorkRecord },
    { "smWorkStorage", smWorkStorage } };
  for (const auto& [name, text] : chunks)
  {
    source.AddChunk(name, text);
  }

  source.Define("SM_INTEGRANDS", this->Layout.GetNumberOfIntegrands());
  source.Define("SM_ROUNDINGS", this->Layout.GetNumberOfRoundings());
  source.Define("SM_ROUNDING_OF", ListOfNumbers(this->Layout.GetRoundingOf()));
  source.Define("SM_STRIP_POINTS", this->Setup.StripPoints);
  char literal[40];
  std::snprintf(literal, sizeof(literal), "%.17eLF", this->Setup.Perturbation);
  source.Define("SM_PERTURBATION", literal);
  source.Define("SM_PLACEMENT", this->Setup.UsePlacements ? "true" : "false");
  source.Define("SM_DEGREE_S", degreeS > 0 ? std::to_string(degreeS) : "int(patchRecord.shape.y)");
  source.Define("SM_DEGREE_R", degreeR > 0 ? std::to_string(degreeR) : "int(patchRecord.shape.z)");
  source.Define("SM_ROW_SIZE", degreeS > 0 ? degreeS + 1 : MaximumDegree + 1);
  source.Define("SM_BASIS_SIZE", degreeR > 0 ? std::max(degreeS, degreeR) : MaximumDegree);

  source.Replace("//SM::AccumulateFaces", this->MakeValues(false));
  source.Replace("//SM::AccumulateChain", this->MakeValues(true));
  source.Replace("//SM::AccumulateRoundings", this->MakeRoundings());
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

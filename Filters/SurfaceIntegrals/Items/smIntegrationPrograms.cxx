#include "smIntegrationPrograms.h"

#include "smFacePanels.h"
#include "smFormat.h"
#include "smResidentFaces.h"
#include "smShaderSource.h"
#include "smUnitRoundoff.h"

#include "smAccumulate.h"
#include "smBlockStorage.h"
#include "smCap.h"
#include "smCapCS.h"
#include "smElementary.h"
#include "smExpressionCS.h"
#include "smFaceSumCS.h"
#include "smFinish.h"
#include "smFinishCS.h"
#include "smLineStorage.h"
#include "smPanel.h"
#include "smPanelCS.h"
#include "smRibbon.h"
#include "smRibbonCS.h"
#include "smRowBlockCS.h"
#include "smRowStorage.h"
#include "smSample.h"
#include "smUserFunctions.h"
#include "smWork.h"
#include "smWorkRecord.h"
#include "smWorkStorage.h"

#include <algorithm>

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

ProgramKey IntegrationPrograms::ChooseProgram(ItemKind kind, int degreeS, int degreeR, bool isSoftware)
{
  static const std::pair<int, int> common[] = { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 3, 3 } };
  // With a constant degree in s the curve that a patch is along a line stays in registers. Ribbons of a plate
  // take a sixth of the time for it on an H200; llvmpipe, which takes longer to compile, gains nothing.
  constexpr int MaximumPanelDegree = 6;
  constexpr int MaximumRibbonDegree = 3;
  if (kind == ItemKind::Cap)
  {
    return { ProgramKind::Caps, 0, 0 };
  }
  if (kind == ItemKind::Ribbon)
  {
    return { ProgramKind::Ribbons, !isSoftware && degreeS <= MaximumRibbonDegree ? degreeS : 0, 0 };
  }
  const bool isCommon =
    std::find(std::begin(common), std::end(common), std::make_pair(degreeS, degreeR)) != std::end(common);
  return { ProgramKind::Panels, degreeS <= MaximumPanelDegree ? degreeS : 0, isCommon ? degreeR : 0 };
}

namespace
{
std::string GetFunctionName(std::size_t integrand)
{
  return "smUser" + std::to_string(integrand);
}

std::string CallFunction(std::size_t integrand)
{
  return GetFunctionName(integrand) + "(position, normal)";
}

void AddChunks(ShaderSource& source)
{
  for (const char* chunk : { "smBernstein", "smPatch", "smPatchRecord", "smPatchSecond", "smResident" })
  {
    source.AddChunk(chunk, GetNURBSShaderChunk(chunk));
  }
  const std::pair<const char*, const char*> chunks[] = { { "smAccumulate", smAccumulate },
    { "smBlockStorage", smBlockStorage }, { "smCap", smCap }, { "smElementary", smElementary },
    { "smFinish", smFinish }, { "smLineStorage", smLineStorage }, { "smPanel", smPanel },
    { "smRibbon", smRibbon }, { "smRowStorage", smRowStorage }, { "smSample", smSample },
    { "smUserFunctions", smUserFunctions }, { "smWork", smWork }, { "smWorkRecord", smWorkRecord },
    { "smWorkStorage", smWorkStorage } };
  for (const auto& [name, text] : chunks)
  {
    source.AddChunk(name, text);
  }
}
}

std::string IntegrationPrograms::FindError(const Integrand& integrand)
{
  if (integrand.Form != Integrand::Kind::User)
  {
    return "";
  }
  const UserExpression& expression = *integrand.Source;
  const std::string place = expression.GetError();
  if (!place.empty())
  {
    return place;
  }
  if (integrand.ClosedChain && expression.GetDetail() > UserExpression::PositionAndNormal)
  {
    return "parameters, derivatives and curvatures are those of faces; the strips that close the chain have "
           "none";
  }
  const std::string function = expression.MakeFunction(GetFunctionName(0), true);
  const auto [found, isNew] = this->Checked.emplace(function, "");
  if (!isNew)
  {
    return found->second;
  }
  ShaderSource source("smExpressionCS", smExpressionCS);
  AddChunks(source);
  source.Define("SM_SAMPLE_DETAIL", 0);
  source.Replace("//SM::UserFunctions", "//SM::Include smSample\n//SM::Include smUserFunctions\n" + function);
  ComputeProgram program;
  if (!source.Assemble())
  {
    found->second = source.GetError();
  }
  else if (!program.Build(this->Context, source.GetName(), source.GetSource()))
  {
    if (program.GetLog().empty())
    {
      // The failure is not caused by the expression.
      this->Checked.erase(found);
      return program.GetError();
    }
    found->second = expression.Explain(program.GetLog());
  }
  return found->second;
}

int IntegrationPrograms::GetDetail(bool isPanel) const
{
  int detail = UserExpression::PositionAndNormal;
  for (const Integrand& integrand : this->Setup.Integrands)
  {
    detail = isPanel && integrand.Source ? std::max(detail, integrand.Source->GetDetail()) : detail;
  }
  return detail;
}

std::string IntegrationPrograms::MakeFunctions(bool isPanel) const
{
  std::string text;
  for (std::size_t k = 0; k < this->Setup.Integrands.size(); ++k)
  {
    const Integrand& integrand = this->Setup.Integrands[k];
    if (integrand.Source && (isPanel || integrand.ClosedChain))
    {
      text += integrand.Source->MakeFunction(GetFunctionName(k), false);
    }
  }
  const int detail = this->GetDetail(isPanel);
  text = (text.empty() ? "" : "//SM::Include smUserFunctions\n") + text;
  text = (detail > 0 ? "//SM::Include smSample\n" : "") + text;
  return (detail >= UserExpression::SecondDerivatives ? "//SM::Include smPatchSecond\n" : "") + text;
}

std::string IntegrationPrograms::MakeForSums(const std::function<std::string(const std::string&)>& make) const
{
  std::string text;
  for (std::size_t k = 0; k < this->Setup.Integrands.size(); ++k)
  {
    text += make("smValue" + std::to_string(k)) + "\n";
  }
  for (int k = 0; k < this->Layout.GetNumberOfRoundings(); ++k)
  {
    text += make("smRounding" + std::to_string(k)) + "\n";
  }
  return text;
}

std::string IntegrationPrograms::MakeValues(bool chainOnly) const
{
  std::string text;
  for (std::size_t k = 0; k < this->Setup.Integrands.size(); ++k)
  {
    const Integrand& integrand = this->Setup.Integrands[k];
    if (!chainOnly || integrand.ClosedChain)
    {
      text += "smValue" + std::to_string(k) + " += weight * (" +
        (integrand.Source ? CallFunction(k) : integrand.Expression) + ");\n";
    }
  }
  return text;
}

std::string IntegrationPrograms::MakeRoundings(bool chainOnly) const
{
  std::string text;
  for (int k = 0; k < this->Layout.GetNumberOfRoundings(); ++k)
  {
    const int first = this->Layout.GetMagnitudes()[k];
    const Integrand& integrand = this->Setup.Integrands[first];
    if (integrand.Source && chainOnly && !integrand.ClosedChain)
    {
      continue;
    }
    text += "smRounding" + std::to_string(k) + " += noise * (" +
      (integrand.Source ? "abs(" + CallFunction(first) + ") / max(length(normal), 1e-300LF)"
                        : integrand.Magnitude) +
      ");\n";
  }
  return text;
}

bool IntegrationPrograms::IsBuilt(const ProgramKey& key) const
{
  const auto found = this->Programs.find(key);
  return found != this->Programs.end() && found->second.IsBuilt();
}

ShaderSource IntegrationPrograms::MakeSource(const ProgramKey& key) const
{
  const auto [kind, degreeS, degreeR] = key;
  const char* const texts[] = { smPanelCS, smRibbonCS, smCapCS, smFinishCS, smRowBlockCS, smFaceSumCS };
  const char* const names[] = { "smPanelCS", "smRibbonCS", "smCapCS", "smFinishCS", "smRowBlockCS",
    "smFaceSumCS" };
  ShaderSource source(names[static_cast<int>(kind)], texts[static_cast<int>(kind)]);
  AddChunks(source);
  const bool isPanel = kind == ProgramKind::Panels;
  source.Define("SM_SAMPLE_DETAIL", this->GetDetail(isPanel));
  source.Define("SM_INTEGRANDS", this->Layout.GetNumberOfIntegrands());
  source.Define("SM_ROUNDINGS", this->Layout.GetNumberOfRoundings());
  source.Define("SM_ROUNDING_OF", ListOfNumbers(this->Layout.GetRoundingOf()));
  source.Define("SM_STRIP_POINTS", this->Setup.StripPoints);
  source.Define("SM_PERTURBATION", MakeLiteral(this->Setup.Perturbation));
  const bool mayHaveKinks = std::any_of(this->Setup.Integrands.begin(), this->Setup.Integrands.end(),
    [](const Integrand& integrand) { return integrand.Source && integrand.Source->MayHaveKinks(); });
  source.Define("SM_MIN_ERROR_SHARE", mayHaveKinks ? "0.1LF" : "1e-3LF");
  source.Define("SM_UNIT_ROUNDOFF", MakeLiteral(UnitRoundoff));
  source.Define("SM_PLACEMENT", this->Setup.UsePlacements ? "true" : "false");
  source.Define("SM_DEGREE_S", degreeS > 0 ? std::to_string(degreeS) : "int(patchRecord.shape.y)");
  source.Define("SM_DEGREE_R", degreeR > 0 ? std::to_string(degreeR) : "int(patchRecord.shape.z)");
  source.Define("SM_ROW_SIZE", degreeS > 0 ? degreeS + 1 : MaximumDegree + 1);
  source.Define("SM_BASIS_SIZE", degreeR > 0 ? std::max(degreeS, degreeR) : MaximumDegree);

  if (isPanel || kind == ProgramKind::Ribbons || kind == ProgramKind::Caps)
  {
    source.Replace(
      "//SM::DeclareSums", this->MakeForSums([](const std::string& sum) { return "double " + sum + ";"; }));
    source.Replace(
      "//SM::ClearSums", this->MakeForSums([](const std::string& sum) { return sum + " = 0.0LF;"; }));
    source.Replace("//SM::StoreSums",
      this->MakeForSums(
        [](const std::string& sum) { return "smLineSums[at] = " + sum + "; at += smLineStride;"; }));
    source.Replace("//SM::UserFunctions", this->MakeFunctions(isPanel));
    // Ribbons and caps have no samples of faces.
    source.Replace("//SM::AccumulateFaces", this->MakeValues(!isPanel));
    source.Replace("//SM::AccumulateChain", this->MakeValues(true));
    source.Replace("//SM::AccumulateFaceRoundings", this->MakeRoundings(!isPanel));
    source.Replace("//SM::AccumulateChainRoundings", this->MakeRoundings(true));
  }
  return source;
}

bool IntegrationPrograms::Build(const std::vector<ProgramKey>& keys)
{
  std::vector<std::pair<ProgramKey, ComputeProgram>> begun;
  for (const ProgramKey& key : keys)
  {
    if (this->IsBuilt(key))
    {
      continue;
    }
    ShaderSource source = this->MakeSource(key);
    if (!source.Assemble())
    {
      this->Error = source.GetError();
      return false;
    }
    const auto [kind, degreeS, degreeR] = key;
    const std::string label =
      source.GetName() + " " + std::to_string(degreeS) + "x" + std::to_string(degreeR);
    ComputeProgram program;
    if (!program.BeginBuild(this->Context, label, source.GetSource()))
    {
      this->Error = program.GetError();
      return false;
    }
    begun.emplace_back(key, std::move(program));
  }
  for (auto& [key, program] : begun)
  {
    if (!program.FinishBuild())
    {
      this->Error = program.GetError();
      return false;
    }
    this->Programs[key] = std::move(program);
  }
  return true;
}

ComputeProgram* IntegrationPrograms::Get(const ProgramKey& key)
{
  return this->Build({ key }) ? &this->Programs[key] : nullptr;
}
}

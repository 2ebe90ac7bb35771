#include "vtkMassPropertiesBase.h"

#include "Detail/smMassGlyphs.h"
#include "Detail/smPartsListMaker.h"
#include "Detail/smReferenceFrame.h"
#include "Detail/smSelfCrossing.h"
#include "smBodyMeshes.h"
#include "smColumns.h"
#include "smCountedBodies.h"
#include "smFormat.h"
#include "smIntegralEngine.h"
#include "smMassAnalysis.h"
#include "smMassIntegrands.h"
#include "smMassPropertyNames.h"
#include "smMaterials.h"
#include "smProducts.h"

#include "vtkDataSetAttributes.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Columns of a row with masses and a reference frame.
constexpr int MaxColumns = 72;
}

vtkMassPropertiesBase::vtkMassPropertiesBase()
  : Analysis(new sm::MassAnalysis)
  , CrossingCheck(new sm::SelfCrossingCheck)
  , Glyphs(new sm::MassGlyphs)
  , Frame(new sm::ReferenceFrame)
{
  this->SetNumberOfOutputPorts(8);
}

vtkMassPropertiesBase::~vtkMassPropertiesBase() = default;

void vtkMassPropertiesBase::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Density: " << this->Density << "\n"
     << indent << "DensityTolerance: " << this->DensityTolerance << "\n"
     << indent << "Materials: " << this->Materials.size() << "\n"
     << indent << "HasReferenceFrame: " << this->Frame->IsGiven << "\n"
     << indent << "GlyphScale: " << this->GlyphScale << "\n"
     << indent << "ShowPrincipalAxes: " << this->ShowPrincipalAxes << "\n"
     << indent << "GlyphPerSolid: " << this->GlyphPerSolid << "\n"
     << indent << "CheckEditedSolids: " << this->CheckEditedSolids << "\n";
}

void vtkMassPropertiesBase::SetDensity(double density)
{
  this->ChangeDensity(this->Density, density);
}

void vtkMassPropertiesBase::SetDensityTolerance(double tolerance)
{
  this->ChangeSetting(this->DensityTolerance, tolerance, tolerance >= 0.0 && tolerance <= 1.0,
    "density tolerance", "0 to 1, for example 0.01 for one per cent");
}

void vtkMassPropertiesBase::AppendMaterial(const sm::MaterialRule& rule)
{
  const std::string problem = sm::FindRuleProblem(rule);
  if (!problem.empty())
  {
    vtkErrorMacro(
      "The solids " << rule.Pattern << ", material \"" << rule.Material.Name << "\": " << problem << ".");
    return;
  }
  this->Materials.push_back(rule);
  if (sm::LeavesOutBodies({ rule }))
  {
    this->SetLeftOut([this](vtkDataObject* input, std::vector<sm::BodyIntegrals>& bodies)
      { return sm::LeaveOutBodies(this->Materials, input, true, bodies); });
  }
  this->Modified();
}

void vtkMassPropertiesBase::AddMaterial(
  const char* pattern, const char* material, double density, double tolerance)
{
  this->AppendMaterial({ pattern ? pattern : "", { material ? material : "", density, tolerance } });
}

void vtkMassPropertiesBase::AddMass(const char* pattern, const char* material, double mass, double tolerance)
{
  this->AppendMaterial({ pattern ? pattern : "", { material ? material : "", 0.0, tolerance, mass } });
}

void vtkMassPropertiesBase::AddProductMass(
  const char* pattern, const char* material, double mass, double tolerance)
{
  this->AppendMaterial(
    { pattern ? pattern : "", { material ? material : "", 0.0, tolerance, mass }, false, true });
}

void vtkMassPropertiesBase::AddLeftOut(const char* pattern)
{
  this->AppendMaterial({ pattern ? pattern : "", { sm::LeftOutMaterial }, true });
}

void vtkMassPropertiesBase::AddCountedOnce(const char* pattern, bool inPlace)
{
  this->AppendMaterial(
    { pattern ? pattern : "", { inPlace ? sm::CountedInPlaceMaterial : sm::CountedOnceMaterial }, false,
      false, inPlace ? sm::Counting::OnceInPlace : sm::Counting::Once });
}

void vtkMassPropertiesBase::AddMaterial(const char* pattern, const char* material, const char* density)
{
  sm::MaterialRule rule;
  const std::string problem =
    sm::MakeRule({ pattern ? pattern : "", material ? material : "", density ? density : "", "", "" }, rule);
  if (!problem.empty())
  {
    vtkErrorMacro("The solids " << (pattern ? pattern : "") << ": " << problem << ".");
    return;
  }
  this->AppendMaterial(rule);
}

void vtkMassPropertiesBase::ClearMaterials()
{
  if (!this->Materials.empty())
  {
    this->Materials.clear();
    this->SetLeftOut(nullptr);
    this->Modified();
  }
}

int vtkMassPropertiesBase::GetNumberOfMaterials() const
{
  return static_cast<int>(this->Materials.size());
}

void vtkMassPropertiesBase::SetReferenceFrame(
  const double origin[3], const double zAxis[3], const double xAxis[3])
{
  sm::ReferenceFrame frame;
  frame.IsGiven = true;
  std::copy_n(origin, 3, frame.Origin.begin());
  std::copy_n(zAxis, 3, frame.ZAxis.begin());
  std::copy_n(xAxis, 3, frame.XAxis.begin());
  if (!frame.IsValid())
  {
    vtkErrorMacro("SetReferenceFrame: the z axis "
      << sm::FormatTriple(zAxis[0], zAxis[1], zAxis[2]) << " and the x axis "
      << sm::FormatTriple(xAxis[0], xAxis[1], xAxis[2])
      << " make no frame; give finite directions that are not parallel.");
    return;
  }
  *this->Frame = frame;
  this->Modified();
}

void vtkMassPropertiesBase::ClearReferenceFrame()
{
  if (this->Frame->IsGiven)
  {
    *this->Frame = sm::ReferenceFrame();
    this->Modified();
  }
}

bool vtkMassPropertiesBase::HasReferenceFrame() const
{
  return this->Frame->IsGiven;
}

double vtkMassPropertiesBase::GetVolume() const
{
  return this->Analysis->Total.Properties.Volume;
}

double vtkMassPropertiesBase::GetVolumeBound() const
{
  return this->Analysis->Total.Properties.VolumeBound;
}

double vtkMassPropertiesBase::GetSurfaceArea() const
{
  return this->Analysis->Total.Area;
}

double vtkMassPropertiesBase::GetSurfaceAreaBound() const
{
  return this->Analysis->Total.AreaBound;
}

void vtkMassPropertiesBase::GetCenterOfMass(double center[3]) const
{
  std::copy_n(this->Analysis->Total.Properties.Center.begin(), 3, center);
}

double vtkMassPropertiesBase::GetCenterOfMassBound() const
{
  return this->Analysis->Total.Properties.CenterBound;
}

void vtkMassPropertiesBase::GetVolumeInertia(double inertia[9]) const
{
  std::copy_n(this->Analysis->Total.Properties.Inertia.begin(), 9, inertia);
}

double vtkMassPropertiesBase::GetVolumeInertiaBound() const
{
  return this->Analysis->Total.Properties.InertiaBound;
}

void vtkMassPropertiesBase::GetPrincipalMoments(double moments[3]) const
{
  std::copy_n(this->Analysis->Total.Properties.Principal.begin(), 3, moments);
}

void vtkMassPropertiesBase::GetPrincipalAxes(double axes[9]) const
{
  std::copy_n(this->Analysis->Total.Properties.Axes.begin(), 9, axes);
}

double vtkMassPropertiesBase::GetMass() const
{
  return this->Analysis->Total.Mass;
}

double vtkMassPropertiesBase::GetMassBound() const
{
  return this->Analysis->Total.MassBound;
}

const std::vector<sm::PartsListEntry>& vtkMassPropertiesBase::GetPartsList() const
{
  return this->Analysis->Parts;
}

const sm::MassAnalysis& vtkMassPropertiesBase::GetAnalysis() const
{
  return *this->Analysis;
}

void vtkMassPropertiesBase::ResetResults()
{
  this->Superclass::ResetResults();
  *this->Analysis = sm::MassAnalysis();
}

void vtkMassPropertiesBase::ReleaseKept()
{
  this->CrossingCheck->Clear();
}

void vtkMassPropertiesBase::AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  sm::MassAnalysisOptions options = this->MakeAnalysisOptions();
  options.GapLimit = this->GapLimit;
  options.Density = this->Density;
  options.DensityTolerance = this->DensityTolerance;
  options.Materials = this->Materials;
  options.Frame = *this->Frame;
  options.TakeProducts(this->GetInputDataObject(0, 0));
  *this->Analysis = sm::AnalyzeRun(bodies, options, this->CheckEditedSolids, this->MakeLimits(),
    *this->CrossingCheck, this->GetEngine().GetReport());
  // Volumes in different units have no sum.
  if (this->Analysis->HasOneUnit)
  {
    this->Analysis->Parts =
      sm::MakePartsList(sm::MakeProductTree(this->GetInputDataObject(0, 0)), bodies, this->Analysis->Rows);
  }
}

void vtkMassPropertiesBase::WriteOutputs(
  const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const
{
  const sm::MassAnalysis& analysis = *this->Analysis;
  const bool hasMass = analysis.HasMass || this->Density > 0.0;
  sm::columns::Writer totals(outputs.Arrays, outputs.Totals->GetFieldData(), 1, MaxColumns);
  sm::WriteMassRows(&analysis.Total, 1, hasMass, this->Frame->IsGiven, totals);
  if (hasMass)
  {
    totals.SetDouble(sm::names::KnownMass, analysis.Total.KnownMass);
    totals.SetDouble(
      std::string(sm::names::KnownMass) + sm::names::BoundSuffix, analysis.Total.KnownMassBound);
    totals.SetInteger(sm::names::SolidsWithVolume, analysis.Weighable);
    totals.SetInteger(sm::names::SolidsWithMass, analysis.Weighed);
  }
  totals.SetString(sm::names::LengthUnit, analysis.Unit);
  totals.SetInteger(sm::names::OpenEdges, analysis.OpenEdges);
  totals.SetInteger(sm::names::FlippedShells, analysis.FlippedShells);
  const std::vector<sm::MassRow>& rows = analysis.Rows;
  sm::columns::Writer solids(outputs.Arrays, outputs.Solids->GetRowData(), rows.size(), MaxColumns);
  sm::WriteMassRows(rows.data(), rows.size(), hasMass, this->Frame->IsGiven, solids);
  const bool hasMaterial = hasMass ||
    std::any_of(rows.begin(), rows.end(), [](const sm::MassRow& row) { return !row.Material.empty(); });
  if (hasMaterial)
  {
    std::transform(rows.begin(), rows.end(), solids.AddStrings(sm::names::Material),
      [](const sm::MassRow& row) { return row.Material; });
  }
  sm::FillPartsTable(outputs.Arrays, analysis.Parts, analysis.Unit, hasMaterial, outputs.Parts);
  const sm::Status status = this->GetEngine().GetReport().Status;
  std::string summary = this->FormatStatus(bodies) +
    sm::FormatSummary(
      analysis.Total, analysis.Unit, static_cast<int>(bodies.size()), analysis.Weighed, analysis.Weighable);
  this->WriteMoreOutputs(bodies, outputs, summary);
  sm::columns::Writer(outputs.Arrays, outputs.Text->GetRowData()).SetString(sm::names::Text, summary);
  sm::columns::AddFaceRows(
    outputs.Arrays, bodies, sm::GetMassIntegrands(), outputs.Faces, { sm::MassVolume, sm::MassArea });
  this->Glyphs->Make(bodies, analysis, status,
    { this->GlyphScale, this->ShowPrincipalAxes, this->GlyphPerSolid }, outputs.Arrays, outputs.Totals);
}

void vtkMassPropertiesBase::WriteMoreOutputs(
  const std::vector<sm::BodyIntegrals>&, const Outputs&, std::string&) const
{
}

std::vector<sm::MeshArray> vtkMassPropertiesBase::GetMeshArrays(
  const std::vector<sm::BodyIntegrals>& bodies) const
{
  const std::vector<sm::MassRow>& rows = this->Analysis->Rows;
  const bool hasBounds = this->MakeAnalysisOptions().HasBounds;
  const auto getFace = [&bodies](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = bodies[body].Faces ? &(*bodies[body].Faces)[face] : nullptr;
    return result && result->Error.empty() ? result : nullptr;
  };
  const auto getShare = [&bodies, &rows, getFace](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = getFace(body, face);
    const double side = (bodies[body].InsideOut ? -1.0 : 1.0) * bodies[body].GetSide(face);
    return result
      ? side * (result->Face[sm::MassVolume] + result->Closing[sm::MassVolume]) / rows[body].Properties.Volume
      : vtkMath::Nan();
  };
  const auto getArea = [getFace](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = getFace(body, face);
    return result ? result->Face[sm::MassArea] + result->Closing[sm::MassArea] : vtkMath::Nan();
  };
  const auto getGap = [hasBounds, getFace](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = hasBounds ? getFace(body, face) : nullptr;
    return result ? result->MaxGap : vtkMath::Nan();
  };
  const auto getBound = [hasBounds, getFace](std::size_t body, std::size_t face)
  {
    const sm::FaceIntegrals* result = hasBounds ? getFace(body, face) : nullptr;
    return result ? result->GetBound(sm::MassVolume) : vtkMath::Nan();
  };
  return { { sm::names::VolumeOfWholeSolid,
             [&rows](std::size_t body, std::size_t) { return rows[body].Properties.Volume; } },
    { sm::names::MassOfWholeSolid, [&rows](std::size_t body, std::size_t) { return rows[body].Mass; } },
    { sm::names::FaceShare, getShare }, { sm::names::FaceArea, getArea }, { sm::names::FaceGap, getGap },
    { sm::names::FaceBound, getBound } };
}

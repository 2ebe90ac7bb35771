#include "vtkMassPropertiesGPU.h"
#include "smFormat.h"
#include "smUnitRoundoff.h"

#include "smMassPropertyNames.h"
#include "smMassTable.h"
#include "smMassTolerance.h"
#include "smPlausibility.h"
#include "vtkMassPropertiesGPUInternals.h"
#include "vtkSurfaceIntegralGPUInternals.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMassPropertiesGPU);

namespace
{

std::vector<sm::Integrand> MakeIntegrands()
{
  std::vector<sm::Integrand> integrands;
  integrands.push_back(sm::Integrand::VolumeMoment(sm::names::Volume, 0, 0, 0));
  const int powers[9][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 2, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 },
    { 1, 1, 0 }, { 0, 1, 1 }, { 1, 0, 1 } };
  const char* const names[9] = { "X", "Y", "Z", "XX", "YY", "ZZ", "XY", "YZ", "XZ" };
  for (int i = 0; i < 9; ++i)
  {
    integrands.push_back(sm::Integrand::VolumeMoment(names[i], powers[i][0], powers[i][1], powers[i][2]));
  }
  const char* const components[3] = { "NX", "NY", "NZ" };
  for (int i = 0; i < 3; ++i)
  {
    integrands.push_back(sm::Integrand::VectorArea(components[i], i));
  }
  integrands.push_back(sm::Integrand::AreaMoment(sm::names::SurfaceArea, 0, 0, 0));
  return integrands;
}

/// Moments of a body in the world, about its placed origin.
sm::Moments GetMoments(const sm::BodyIntegrals& body)
{
  sm::Moments moments;
  std::copy_n(body.Model->GetOrigin(), 3, moments.Reference.begin());
  moments.Volume = body.Value[sm::MassVolume];
  moments.VolumeBound = body.Bound[sm::MassVolume];
  std::copy_n(body.Value.begin() + sm::MassFirst, 3, moments.First.begin());
  std::copy_n(body.Bound.begin() + sm::MassFirst, 3, moments.FirstBound.begin());
  std::copy_n(body.Value.begin() + sm::MassSecond, 6, moments.Second.begin());
  std::copy_n(body.Bound.begin() + sm::MassSecond, 6, moments.SecondBound.begin());
  if (moments.Volume < 0.0)
  {
    moments.Negate();
  }
  moments.Place(body.Placement.data());
  return moments;
}

void SetMass(sm::MassRow& row, double density, const std::string& unit)
{
  const double metres = sm::GetMetres(unit);
  const double factor = density > 0.0 && metres > 0.0 ? density * metres * metres * metres : vtkMath::Nan();
  row.Mass = factor * row.Properties.Volume;
  row.MassBound = factor * row.Properties.VolumeBound + 4.0 * sm::UnitRoundoff * std::abs(row.Mass);
  for (int i = 0; i < 9; ++i)
  {
    row.MassInertia[i] = factor * row.Properties.Inertia[i];
  }
  row.MassInertiaBound = factor * row.Properties.InertiaBound;
}

/// Facts that hold for every body and not for this result make it suspect.
void CheckPlausibility(sm::BodyIntegrals& body, const sm::MassProperties& properties)
{
  std::array<double, 3> center;
  for (int i = 0; i < 3; ++i)
  {
    center[i] = body.Value[sm::MassFirst + i] / body.Value[sm::MassVolume];
  }
  // A trim that leaves its surface leads beyond the control points.
  double slack = 1e-12 * sm::GetRadius(*body.Model);
  for (const sm::FaceIntegrals& face : *body.Faces)
  {
    slack = std::max(slack, 2.0 * face.Outside);
  }
  for (const std::string& violation :
    sm::FindImplausibilities(properties, center, sm::GetHullBox(*body.Model), slack))
  {
    body.Flag(sm::names::StatusSuspect, violation);
  }
}
}

vtkMassPropertiesGPU::vtkMassPropertiesGPU()
  : Last(new Totals)
{
  this->Implementation->Integrands = MakeIntegrands();
  this->Implementation->LocalTolerances = [this](vtkTrimmedNURBSModel& model)
  { return sm::ShareTolerance(this->GetTolerance(), model); };
}

vtkMassPropertiesGPU::~vtkMassPropertiesGPU() = default;

void vtkMassPropertiesGPU::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&os, indent](const char* name, const double tolerance[2])
  { os << indent << name << ": " << tolerance[0] << " " << tolerance[1] << "\n"; };
  print("VolumeTolerance", this->VolumeTolerance);
  print("SurfaceAreaTolerance", this->SurfaceAreaTolerance);
  print("CenterOfMassTolerance", this->CenterOfMassTolerance);
  print("InertiaTolerance", this->InertiaTolerance);
  os << indent << "Density: " << this->Density << "\n"
     << indent << "GlyphScale: " << this->GlyphScale << "\n"
     << indent << "ShowPrincipalAxes: " << this->ShowPrincipalAxes << "\n"
     << indent << "GlyphPerSolid: " << this->GlyphPerSolid << "\n";
  this->PrintSchemeOptions(os, indent);
}

sm::MassTolerance vtkMassPropertiesGPU::GetTolerance() const
{
  const auto make = [this](const double asked[2]) {
    return sm::Tolerance{ asked[0] > 0.0 ? asked[0] : this->RelativeTolerance, asked[1] };
  };
  return { make(this->VolumeTolerance), make(this->SurfaceAreaTolerance), make(this->CenterOfMassTolerance),
    make(this->InertiaTolerance) };
}

void vtkMassPropertiesGPU::SetTolerance(
  const char* name, double (&tolerance)[2], double relative, double absolute)
{
  if (!(relative >= 0.0 && relative <= 1.0) || !(absolute >= 0.0) || !std::isfinite(absolute))
  {
    vtkErrorMacro(
      << name << "(" << relative << ", " << absolute
      << "): give a relative tolerance in [0, 1], 0 for RelativeTolerance, and an absolute one that is "
         "not negative, 0 for none.");
    return;
  }
  if (tolerance[0] != relative || tolerance[1] != absolute)
  {
    tolerance[0] = relative;
    tolerance[1] = absolute;
    this->Modified();
  }
}

void vtkMassPropertiesGPU::SetVolumeTolerance(double relative, double absolute)
{
  this->SetTolerance("SetVolumeTolerance", this->VolumeTolerance, relative, absolute);
}

void vtkMassPropertiesGPU::SetSurfaceAreaTolerance(double relative, double absolute)
{
  this->SetTolerance("SetSurfaceAreaTolerance", this->SurfaceAreaTolerance, relative, absolute);
}

void vtkMassPropertiesGPU::SetCenterOfMassTolerance(double relative, double absolute)
{
  this->SetTolerance("SetCenterOfMassTolerance", this->CenterOfMassTolerance, relative, absolute);
}

void vtkMassPropertiesGPU::SetInertiaTolerance(double relative, double absolute)
{
  this->SetTolerance("SetInertiaTolerance", this->InertiaTolerance, relative, absolute);
}

void vtkMassPropertiesGPU::SetDensity(double density)
{
  if (!std::isfinite(density) || density < 0.0)
  {
    vtkErrorMacro(
      "SetDensity: " << density << " is no density; give kg/m^3, for example 7850 for steel, or 0.");
    return;
  }
  if (this->Density != density)
  {
    this->Density = density;
    this->Modified();
  }
}

void vtkMassPropertiesGPU::RemoveAllIntegrands()
{
  vtkWarningMacro("The integrands of the mass properties are fixed; use vtkSurfaceIntegralGPU for others.");
}

void vtkMassPropertiesGPU::ForgetLastRun()
{
  this->Superclass::ForgetLastRun();
  this->Last->Row = sm::MassRow();
  this->Last->Volumes.clear();
  this->Last->Estimates = sm::SchemeTotals();
  this->Last->Run.Forget();
}

double vtkMassPropertiesGPU::GetVolume() const
{
  return this->Last->Row.Properties.Volume;
}

double vtkMassPropertiesGPU::GetVolumeBound() const
{
  return this->Last->Row.Properties.VolumeBound;
}

double vtkMassPropertiesGPU::GetSurfaceArea() const
{
  return this->Last->Row.Area;
}

double vtkMassPropertiesGPU::GetSurfaceAreaBound() const
{
  return this->Last->Row.AreaBound;
}

void vtkMassPropertiesGPU::GetCenterOfMass(double center[3]) const
{
  std::copy_n(this->Last->Row.Properties.Center.begin(), 3, center);
}

double vtkMassPropertiesGPU::GetCenterOfMassBound() const
{
  return this->Last->Row.Properties.CenterBound;
}

void vtkMassPropertiesGPU::GetVolumeInertia(double inertia[9]) const
{
  std::copy_n(this->Last->Row.Properties.Inertia.begin(), 9, inertia);
}

double vtkMassPropertiesGPU::GetVolumeInertiaBound() const
{
  return this->Last->Row.Properties.InertiaBound;
}

void vtkMassPropertiesGPU::GetPrincipalMoments(double moments[3]) const
{
  std::copy_n(this->Last->Row.Properties.Principal.begin(), 3, moments);
}

void vtkMassPropertiesGPU::GetPrincipalAxes(double axes[9]) const
{
  std::copy_n(this->Last->Row.Properties.Axes.begin(), 9, axes);
}

double vtkMassPropertiesGPU::GetMass() const
{
  return this->Last->Row.Mass;
}

sm::MassRow vtkMassPropertiesGPU::MakeRow(sm::BodyIntegrals& body, sm::Moments& moments)
{
  sm::MassRow row;
  row.Area = body.Value[sm::MassArea];
  row.AreaBound = body.Bound[sm::MassArea];
  row.GapSquared = body.GapSquared;
  row.MaxGap = body.MaxGap;
  row.GapArea = body.GapArea;
  row.ClosureCorrection = row.ClosureResidual = vtkMath::Nan();
  const bool computed = body.Faces != nullptr;
  if (computed && body.HasVolume())
  {
    sm::TurnShells(body, this->Implementation->Integrands, sm::MassVolume);
    moments = GetMoments(body);
    if (this->HasScheme())
    {
      sm::ZeroBounds(moments);
    }
    row.Properties = sm::ComputeMassProperties(moments);
    if (this->HasScheme())
    {
      sm::ForgetBounds(row);
    }
    else
    {
      row.ClosureCorrection = std::abs(body.Value[sm::MassVolume] - body.FaceValue[sm::MassVolume]);
    }
    const double perArea = std::cbrt(moments.Volume) / (3.0 * moments.Volume);
    row.ClosureResidual = perArea * vtkMath::Norm(body.Value.data() + sm::MassVectorArea);
    const double tight = this->GetLargestClosureResidual(body, perArea);
    if (!body.IsSolid() && body.SkippedFaces == 0 && !(row.ClosureResidual <= tight))
    {
      // A surface whose border is no edge: a patch without loops.
      body.Flag(sm::names::StatusOpen, "a surface, not a solid: it has an area and no volume");
      row.Properties = sm::MassProperties();
      row.ClosureCorrection = row.ClosureResidual = vtkMath::Nan();
      return row;
    }
    if (body.OpenEdges == 0 && body.SkippedFaces == 0 && !(row.ClosureResidual <= tight))
    {
      body.Flag(sm::names::StatusSuspect,
        "the faces do not close although every edge is shared: a loop is broken or a face is wrong" +
          (std::isfinite(row.ClosureResidual) ? ". The volume changes by " +
                sm::FormatBound(row.ClosureResidual) + " of itself when the origin moves by its cube root"
                                              : std::string()));
    }
    CheckPlausibility(body, row.Properties);
  }
  if (computed && body.HasVolume() && !std::isfinite(body.Value[sm::MassVolume]))
  {
    body.Flag(sm::names::StatusSuspect, "the volume is not a finite number");
  }
  if (computed && !std::isfinite(row.Area))
  {
    body.Flag(sm::names::StatusSuspect, "the area is not a finite number");
  }
  if (computed && this->HasScheme())
  {
    body.Degrade(sm::names::StatusToleranceNotMet);
    if (body.HasVolume())
    {
      // Once for all bodies.
      this->Implementation->Last.Note = this->GetSchemeMessage();
    }
    // It would be that of the texels.
    row.ClosureResidual = vtkMath::Nan();
    return row;
  }
  const std::string unmet = computed ? sm::FindUnmet(row, this->GetTolerance()) : std::string();
  if (!unmet.empty())
  {
    body.Flag(sm::names::StatusToleranceNotMet, "bounds above the tolerance, relative: " + unmet);
  }
  return row;
}

void vtkMassPropertiesGPU::ProduceOutputs(std::vector<sm::BodyIntegrals>& bodies, vtkPolyData* totals,
  vtkTable* solids, vtkTable* text, vtkTable* faces)
{
  // Instances are named in the length unit of the first; a reader gives all its bodies one unit.
  const std::string unit = bodies.empty() ? "mm" : bodies.front().Model->GetLengthUnit();
  sm::MassRow& total = this->Last->Row;
  if (!bodies.empty())
  {
    total.Area = total.AreaBound = total.ClosureCorrection = total.GapSquared = total.GapArea = total.MaxGap =
      0.0;
  }
  const bool oneUnit = std::all_of(bodies.begin(), bodies.end(),
    [&unit](const sm::BodyIntegrals& body) { return body.Model->GetLengthUnit() == unit; });
  if (!oneUnit)
  {
    // Cubic inches and cubic millimetres do not add up.
    total = sm::MassRow();
    this->Implementation->Last.Messages.push_back(
      "the parts have different length units: there is no total; read all files with one OutputUnit");
  }
  bool withMass = this->Density > 0.0;
  for (const sm::BodyIntegrals& body : bodies)
  {
    withMass = withMass || body.Model->GetDensity() > 0.0;
  }

  std::vector<sm::MassRow> rows;
  std::vector<sm::Moments> parts;
  double mass = 0.0;
  double massBound = 0.0;
  double vectorArea[3] = { 0.0, 0.0, 0.0 };
  for (sm::BodyIntegrals& body : bodies)
  {
    sm::Moments moments;
    sm::MassRow row = this->MakeRow(body, moments);
    const double density = this->Density > 0.0 ? this->Density : body.Model->GetDensity();
    SetMass(row, density, body.Model->GetLengthUnit());
    total.Area += row.Area;
    total.AreaBound += row.AreaBound + 2.0 * sm::UnitRoundoff * total.Area;
    total.GapSquared += row.GapSquared;
    total.GapArea += row.GapArea;
    // Not std::max, which loses a NaN.
    total.MaxGap = row.MaxGap > total.MaxGap || std::isnan(row.MaxGap) ? row.MaxGap : total.MaxGap;
    if (std::isfinite(row.Properties.Volume))
    {
      total.ClosureCorrection += row.ClosureCorrection;
      for (int i = 0; i < 3; ++i)
      {
        vectorArea[i] += std::abs(body.Value[sm::MassVectorArea + i]);
      }
      mass += row.Mass;
      massBound += row.MassBound;
      parts.push_back(moments);
    }
    rows.push_back(row);
  }
  if (!parts.empty() && oneUnit)
  {
    const sm::Moments sum = sm::Moments::Sum(parts);
    total.Properties = sm::ComputeMassProperties(sum);
    if (this->HasScheme())
    {
      sm::ForgetBounds(total);
    }
    total.ClosureResidual = this->HasScheme()
      ? vtkMath::Nan()
      : vtkMath::Norm(vectorArea) * std::cbrt(sum.Volume) / (3.0 * sum.Volume);
    if (this->Density > 0.0 || rows.size() == 1)
    {
      SetMass(total, this->Density > 0.0 ? this->Density : bodies.front().Model->GetDensity(), unit);
    }
    else
    {
      // Densities differ from part to part: the sum has a mass, but its inertia is not density times VolumeInertia.
      SetMass(total, 0.0, unit);
      total.Mass = mass;
      total.MassBound = massBound;
    }
  }
  else
  {
    total.ClosureCorrection = vtkMath::Nan();
  }
  this->Implementation->Last.Integrals = { { sm::names::Volume,
                                             { total.Properties.Volume, total.Properties.VolumeBound } },
    { sm::names::SurfaceArea, { total.Area, total.AreaBound } } };

  sm::MassColumns totalColumns(withMass);
  totalColumns.Append(total);
  totalColumns.AddTo(totals->GetFieldData());
  sm::columns::SetString(totals->GetFieldData(), sm::names::LengthUnit, unit);
  int openEdges = 0;
  int flippedShells = 0;
  std::string status = bodies.empty() ? sm::names::StatusEmpty : sm::names::StatusOk;
  sm::MassColumns columns(withMass);
  for (std::size_t i = 0; i < bodies.size(); ++i)
  {
    columns.Append(rows[i]);
    this->Last->Volumes.push_back(rows[i].Properties.Volume);
    openEdges += bodies[i].OpenEdges;
    flippedShells += bodies[i].FlippedShells;
    status = sm::IsWorse(bodies[i].Status, status) ? bodies[i].Status : status;
  }
  // Bounds add up, scales need not: parts on both sides of the origin.
  const std::string unmet = sm::FindUnmet(total, this->GetTolerance());
  if (status == sm::names::StatusOk && !unmet.empty())
  {
    status = this->Implementation->Last.Status = sm::names::StatusToleranceNotMet;
    this->Implementation->Last.Messages.push_back(
      "bounds of the total above the tolerance, relative: " + unmet);
  }
  sm::columns::SetInteger(totals->GetFieldData(), sm::names::OpenEdges, openEdges);
  sm::columns::SetInteger(totals->GetFieldData(), sm::names::FlippedShells, flippedShells);
  columns.AddTo(solids->GetRowData());
  std::string summary =
    sm::FormatSummary(total, status, this->FindReason(bodies, status), unit, static_cast<int>(bodies.size()));
  this->AddSchemeOutputs(bodies, oneUnit, totals, solids, summary);
  sm::columns::AddBodyColumns(bodies, solids);
  sm::columns::SetString(text->GetRowData(), sm::names::Text, summary);
  sm::columns::AddFaceRows(bodies, this->Implementation->Integrands, faces, { sm::MassVolume, sm::MassArea });
  sm::columns::SetString(text->GetFieldData(), sm::names::Status, status);
  this->MakeGlyphs(bodies, rows, status, totals);
}

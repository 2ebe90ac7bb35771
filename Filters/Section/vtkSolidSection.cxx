#include "vtkSolidSection.h"

#include "Detail/smSectionMesh.h"
#include "Detail/smSectionRow.h"
#include "smBodyMeshes.h"
#include "smBodyScales.h"
#include "smCoedgeGaps.h"
#include "smColumns.h"
#include "smFormat.h"
#include "smIntegralEngine.h"
#include "smLengthUnits.h"
#include "smMeshDemand.h"
#include "smSectionNames.h"
#include "smVector.h"

#include "vtkBoundingBox.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlane.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkSolidSection);

namespace
{
constexpr int MeshPort = 7;

/// Adds a column for every quantity and for its bound; none without rows.
void WriteRows(const sm::SectionRow* rows, std::size_t count, sm::columns::Writer writer)
{
  std::vector<double*> columns;
  for (std::size_t row = 0; row < count; ++row)
  {
    std::size_t next = 0;
    const auto append = [&](const std::string& name, const double* values, int components)
    {
      if (row == 0)
      {
        columns.push_back(writer.AddDoubles(name, components));
      }
      double*& column = columns[next++];
      column = std::copy_n(values, components, column);
    };
    rows[row].Visit(
      [&append](const std::string& name, const double* values, int components, const double* bound)
      {
        append(name, values, components);
        if (bound)
        {
          append(name + sm::names::BoundSuffix, bound, 1);
        }
      });
  }
}

/// Returns the density of a body in kg per cubic length unit; NaN without one.
double GetDensityPerVolume(const sm::BodyIntegrals& body, double density)
{
  const double own = density > 0.0 ? density : body.Model->GetDensity();
  const double metres = sm::GetMetres(body.Model->GetLengthUnit());
  return own > 0.0 && metres > 0.0 ? own * metres * metres * metres : vtkMath::Nan();
}

/// Adds to the findings about a face below the plane those about its part above; where it is cut, both have
/// its defects.
void AddFindings(const sm::FaceIntegrals& above, sm::FaceIntegrals& face)
{
  face.Skipped = face.Skipped || above.Skipped;
  face.LeftOut = face.LeftOut || above.LeftOut;
  face.Estimated = face.Estimated || above.Estimated;
  face.Error = face.Error.empty() ? above.Error : face.Error;
  face.CoverageDefects = std::max(face.CoverageDefects, above.CoverageDefects);
  face.Overlap = sm::GetLargerGap(face.Overlap, above.Overlap);
  face.Outside = face.Outside.Distance >= above.Outside.Distance ? face.Outside : above.Outside;
  face.IsContinued = face.IsContinued || above.IsContinued;
  sm::AddGaps(above, face);
}

/// Flags a body with a shell that does not have its material inside: the volumes on the two sides of the
/// plane then do not add up to the volume that the body encloses.
void CheckShells(
  const std::vector<sm::Integrand>& integrands, const sm::BodyBuoyancy& above, sm::BodyIntegrals& body)
{
  sm::BodyIntegrals whole = body;
  std::vector<sm::FaceIntegrals> faces = *body.Faces;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    faces[i].Face[0] += above.Faces[i].Face[0];
    faces[i].Closing[0] += above.Faces[i].Closing[0];
    faces[i].QuadratureError[0] += above.Faces[i].GetBound(0);
  }
  whole.Faces = std::make_shared<const std::vector<sm::FaceIntegrals>>(std::move(faces));
  sm::SumValues(whole, integrands);
  const std::size_t known = whole.FaceDefects.size();
  sm::ReverseShells(whole, integrands, 0);
  if (whole.FaceDefects.size() > known)
  {
    body.Flag(sm::Status::Suspect, whole.Messages.back());
    body.FaceDefects.push_back(whole.FaceDefects.back());
  }
  if (whole.FlippedShells > 0)
  {
    body.Flag(sm::Status::Suspect,
      "the normals of " + std::to_string(whole.FlippedShells) +
        " shells point inwards; section and volumes are those of the shells as the file orients them. "
        "Correct the file, or see "
        "Mass Properties for its volume");
  }
}

/// Returns the distance of a plane from the box of the bodies; 0 where they meet, or there is no body.
double GetDistance(
  const std::vector<sm::BodyIntegrals>& bodies, const double point[3], const sm::Vector3& normal)
{
  vtkBoundingBox box;
  for (const sm::BodyIntegrals& body : bodies)
  {
    sm::AddPlacedBox(body, box);
  }
  if (!box.IsValid())
  {
    return 0.0;
  }
  double nearest = HUGE_VAL;
  double farthest = -HUGE_VAL;
  for (int i = 0; i < 8; ++i)
  {
    double corner[3];
    box.GetCorner(i, corner);
    const double height =
      sm::Dot(sm::Vector3{ corner[0] - point[0], corner[1] - point[1], corner[2] - point[2] }, normal);
    nearest = std::min(nearest, height);
    farthest = std::max(farthest, height);
  }
  return std::max({ nearest, -farthest, 0.0 });
}

/// Flags a body with a bound above the tolerance, or with results that contradict each other.
void CheckResults(
  const sm::SectionRow& row, const std::string& contradiction, double tolerance, sm::BodyIntegrals& body)
{
  const double volumeScale = sm::GetVolumeScale(*body.Model);
  if (!(std::max(row.Below.VolumeBound, row.Above.VolumeBound) <= tolerance * volumeScale))
  {
    body.Flag(sm::Status::ToleranceNotMet, "the bound of the volume on one side is above the tolerance");
  }
  if (!(row.AreaBound <= tolerance * sm::GetAreaScale(*body.Model)))
  {
    body.Flag(sm::Status::ToleranceNotMet,
      "the bound of the section's area is above the tolerance: where the plane lies in a face, touches one, "
      "or "
      "runs along a gap, the area is not determined. Move the plane");
  }
  if (row.Below.Volume < -row.Below.VolumeBound || row.Above.Volume < -row.Above.VolumeBound)
  {
    body.Flag(sm::Status::Suspect, "the volume is negative: the solid is inside out in the file");
  }
  if (!contradiction.empty())
  {
    body.Flag(sm::Status::Suspect, contradiction);
  }
}
}

struct vtkSolidSection::Internals
{
  /// Results of the last run for each body, below and above the plane; empty if nothing was computed.
  std::vector<sm::BodyBuoyancy> Below;
  std::vector<sm::BodyBuoyancy> Above;
  std::vector<sm::SectionRow> Rows;
  sm::SectionRow Total;
  vtkNew<vtkPartitionedDataSetCollection> Meshes;
  /// Names of the bodies whose mesh could not be closed.
  std::string WithoutCap;
};

vtkSolidSection::vtkSolidSection()
  : vtkPlaneCutBase(true, sm::names::VolumeBelow)
  , Implementation(new Internals)
{
  this->SetNumberOfOutputPorts(MeshPort + 1);
}

vtkSolidSection::~vtkSolidSection() = default;

void vtkSolidSection::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Density: " << this->Density << "\n";
}

void vtkSolidSection::SetDensity(double density)
{
  this->ChangeDensity(this->Density, density);
}

int vtkSolidSection::FillOutputPortInformation(int port, vtkInformation* info)
{
  if (port == MeshPort)
  {
    info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPartitionedDataSetCollection");
    sm::DeclareMeshOutput(info);
    return 1;
  }
  return this->Superclass::FillOutputPortInformation(port, info);
}

int vtkSolidSection::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  vtkDataObject::GetData(outputVector, MeshPort)->ShallowCopy(this->Implementation->Meshes);
  this->Implementation->Meshes->Initialize();
  this->ShareBlocks(request, outputVector, MeshPort);
  return result;
}

double vtkSolidSection::GetSectionArea() const
{
  return this->Implementation->Total.Area;
}

double vtkSolidSection::GetSectionAreaBound() const
{
  return this->Implementation->Total.AreaBound;
}

void vtkSolidSection::GetSectionCentroid(double centroid[3]) const
{
  std::copy_n(this->Implementation->Total.Properties.Centroid.begin(), 3, centroid);
}

double vtkSolidSection::GetSectionCentroidBound() const
{
  return this->Implementation->Total.Properties.CentroidBound;
}

void vtkSolidSection::GetSectionSecondMoments(double moments[6]) const
{
  std::copy_n(this->Implementation->Total.Properties.Second.begin(), 6, moments);
}

double vtkSolidSection::GetSectionSecondMomentsBound() const
{
  return this->Implementation->Total.Properties.SecondBound;
}

void vtkSolidSection::GetSectionPrincipalMoments(double moments[2]) const
{
  std::copy_n(this->Implementation->Total.Properties.Principal.begin(), 2, moments);
}

double vtkSolidSection::GetSectionPrincipalMomentsBound() const
{
  return this->Implementation->Total.Properties.PrincipalBound;
}

double vtkSolidSection::GetVolumeBelow() const
{
  return this->Implementation->Total.Below.Volume;
}

double vtkSolidSection::GetVolumeBelowBound() const
{
  return this->Implementation->Total.Below.VolumeBound;
}

double vtkSolidSection::GetVolumeAbove() const
{
  return this->Implementation->Total.Above.Volume;
}

double vtkSolidSection::GetVolumeAboveBound() const
{
  return this->Implementation->Total.Above.VolumeBound;
}

void vtkSolidSection::ResetResults()
{
  this->Superclass::ResetResults();
  Internals& self = *this->Implementation;
  self.Below.clear();
  self.Above.clear();
  self.Rows.clear();
  self.Total = sm::SectionRow();
  self.Meshes->Initialize();
  self.WithoutCap.clear();
}

bool vtkSolidSection::IntegrateBodies(
  const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies)
{
  Internals& self = *this->Implementation;
  if (!this->IntegrateSide(request, bodies, false, 0.0, 0.5, self.Below) ||
    !this->IntegrateSide(request, bodies, true, 0.5, 1.0, self.Above))
  {
    self.Below.clear();
    self.Above.clear();
    return false;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    std::vector<sm::FaceIntegrals> faces = self.Below[b].Faces;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      AddFindings(self.Above[b].Faces[i], faces[i]);
    }
    bodies[b].Faces = std::make_shared<const std::vector<sm::FaceIntegrals>>(std::move(faces));
  }
  return true;
}

void vtkSolidSection::AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  Internals& self = *this->Implementation;
  const std::vector<sm::Integrand> integrands = this->MakeRequest().Integrands;
  const sm::Waterline plane{ { this->Point[0], this->Point[1], this->Point[2] },
    { this->Normal[0], this->Normal[1], this->Normal[2] } };
  sm::SectionMoments section;
  sm::SectionMoments fromAbove;
  sm::DisplacedMoments below;
  sm::DisplacedMoments above;
  sm::SectionRow masses;
  bool isFirst = true;
  bool hasTotal = sm::HaveOneUnit(bodies);
  if (!hasTotal)
  {
    this->GetEngine().GetReport().Messages.push_back(sm::MixedUnitsMessage);
  }
  self.Rows.assign(bodies.size(), {});
  for (std::size_t b = 0; b < bodies.size() && !self.Below.empty(); ++b)
  {
    sm::BodyIntegrals& body = bodies[b];
    if (!body.HasVolume() || !body.Faces)
    {
      continue;
    }
    if (body.Faces->empty())
    {
      hasTotal = false;
      body.Flag(
        sm::Status::Suspect, "it has no faces: it has no section and no volumes, nor are there totals");
      continue;
    }
    if (body.OpenEdges > 0)
    {
      hasTotal = false;
      body.Flag(sm::Status::Open,
        "the solid is not closed: its section and the volumes on either side are not defined, nor are the "
        "totals. Close it, or leave it out");
      continue;
    }
    sm::SectionRow& row = self.Rows[b];
    row = sm::SectionRow(self.Below[b].Section, self.Below[b].Total, self.Above[b].Total);
    row.SetMass(GetDensityPerVolume(body, this->Density));
    CheckShells(integrands, self.Above[b], body);
    CheckResults(row, sm::FindContradiction(self.Below[b].Section, self.Above[b].Section, plane),
      this->RelativeTolerance, body);
    if (isFirst)
    {
      section = self.Below[b].Section;
      fromAbove = self.Above[b].Section;
      below = self.Below[b].Total;
      above = self.Above[b].Total;
      masses = row;
      isFirst = false;
      continue;
    }
    section.Add(self.Below[b].Section);
    fromAbove.Add(self.Above[b].Section);
    below.Add(self.Below[b].Total);
    above.Add(self.Above[b].Total);
    masses.AddMass(row);
  }
  if (!isFirst && hasTotal)
  {
    self.Total = sm::SectionRow(section, below, above);
    const auto takeMass = [](const sm::SectionSide& from, sm::SectionSide& to)
    {
      to.Mass = from.Mass;
      to.MassBound = from.MassBound;
    };
    takeMass(masses.Below, self.Total.Below);
    takeMass(masses.Above, self.Total.Above);
    const std::string contradiction = sm::FindContradiction(section, fromAbove, plane);
    for (std::size_t b = 0; b < bodies.size() && !contradiction.empty(); ++b)
    {
      bodies[b].Flag(sm::Status::Suspect, "over all solids, " + contradiction);
    }
  }
}

void vtkSolidSection::DrawSection(const std::vector<sm::BodyIntegrals>& bodies) const
{
  Internals& self = *this->Implementation;
  vtkNew<vtkPlane> plane;
  // vtkMath::Normalize() overflows for large components.
  const sm::Vector3 normal = sm::Normalized(sm::Vector3{ this->Normal[0], this->Normal[1], this->Normal[2] });
  plane->SetOrigin(this->Point[0], this->Point[1], this->Point[2]);
  plane->SetNormal(normal[0], normal[1], normal[2]);
  const std::vector<std::string> blocks = sm::NameBlocks(bodies);
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    bool hasCap = true;
    const auto block = static_cast<unsigned int>(b);
    self.Meshes->SetPartition(
      block, 0, sm::MakeSectionMesh(bodies[b].Mesh, plane, static_cast<int>(b), hasCap));
    self.Meshes->GetMetaData(block)->Set(vtkCompositeDataSet::NAME(), blocks[b].c_str());
    if (!hasCap)
    {
      self.WithoutCap += (self.WithoutCap.empty() ? "" : ", ") + bodies[b].Name;
    }
  }
}

std::string vtkSolidSection::WriteSummary(const std::vector<sm::BodyIntegrals>& bodies) const
{
  const Internals& self = *this->Implementation;
  const sm::SectionRow& total = self.Total;
  const std::string unit = bodies.empty() ? "mm" : bodies.front().Model->GetLengthUnit();
  const double distance = GetDistance(
    bodies, this->Point, sm::Normalized(sm::Vector3{ this->Normal[0], this->Normal[1], this->Normal[2] }));
  const std::string away =
    distance > 0.0 ? ": their box is " + sm::FormatDistance(distance) + " " + unit + " away" : "";
  std::string text = this->FormatStatus(bodies) +
    (distance > 0.0 || (total.Area == 0.0 && total.AreaBound == 0.0)
        ? "The plane does not meet the solids" + away + ".\n"
        : "") +
    "Section area: " + sm::FormatWithBound(total.Area, total.AreaBound, unit + "^2") + "\n";
  const auto addPoint = [&text, &unit](const char* label, const std::array<double, 3>& point, double bound)
  {
    if (std::isfinite(bound))
    {
      text += label;
      for (std::size_t i = 0; i < point.size(); ++i)
      {
        text += (i == 0 ? "" : "  ") + sm::FormatNumber(point[i], bound);
      }
      text += " " + unit + sm::FormatBoundNote(bound) + "\n";
    }
  };
  const sm::SectionProperties& section = total.Properties;
  addPoint("Centroid: ", section.Centroid, section.CentroidBound);
  if (std::isfinite(section.PrincipalBound))
  {
    text += "Principal second moments: " + sm::FormatNumber(section.Principal[0], section.PrincipalBound) +
      "  " + sm::FormatNumber(section.Principal[1], section.PrincipalBound) + " " + unit + "^4" +
      sm::FormatBoundNote(section.PrincipalBound) + "\n";
  }
  const double gaps = sm::SumClosing(bodies, 0);
  const auto addSide = [&text, &unit, gaps](const std::string& label, const sm::SectionSide& side)
  {
    text +=
      "Volume " + label + ": " + sm::FormatWithBound(side.Volume, side.VolumeBound, unit + "^3", gaps) + "\n";
    if (std::isfinite(side.Mass))
    {
      text += "Mass " + label + ": " + sm::FormatWithBound(side.Mass, side.MassBound, "kg") + "\n";
    }
  };
  addSide("below", total.Below);
  addSide("above", total.Above);
  if (!self.WithoutCap.empty())
  {
    text += "The display mesh of " + self.WithoutCap + " is not closed: its section is not drawn.\n";
  }
  return text;
}

void vtkSolidSection::WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const
{
  const Internals& self = *this->Implementation;
  sm::columns::Writer totals(outputs.Arrays, outputs.Totals->GetFieldData());
  WriteRows(&self.Total, 1, totals);
  WriteRows(self.Rows.data(), self.Rows.size(),
    sm::columns::Writer(outputs.Arrays, outputs.Solids->GetRowData(), self.Rows.size()));
  this->DrawSection(bodies);
  const std::string unit = bodies.empty() ? "mm" : bodies.front().Model->GetLengthUnit();
  totals.SetString(sm::names::LengthUnit, unit);
  sm::columns::Writer(outputs.Arrays, outputs.Text->GetRowData())
    .SetString(sm::names::Text, this->WriteSummary(bodies));
  sm::columns::AddFaceRows(outputs.Arrays, bodies, this->MakeRequest().Integrands, outputs.Faces, { 0 });
}

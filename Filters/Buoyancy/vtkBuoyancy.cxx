#include "vtkBuoyancy.h"

#include "smBodyScales.h"
#include "smBuoyancy.h"
#include "smBuoyancyNames.h"
#include "smColumns.h"
#include "smFormat.h"
#include "smIntegralEngine.h"
#include "smUnitRoundoff.h"

#include "vtkBoundingBox.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkBuoyancy);

namespace
{
/// Volume, and first moments in x, y and z.
constexpr std::size_t NumberOfIntegrands = 4;

/// Values of one row of the outputs.
struct Row
{
  double Volume = vtkMath::Nan();
  double VolumeBound = vtkMath::Nan();
  std::array<double, 3> First = { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() };
  double FirstBound = vtkMath::Nan();
  std::array<double, 3> Center = { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() };
  double CenterBound = vtkMath::Nan();
};

/// Adds six columns: values and bounds.
void WriteRows(const Row* rows, std::size_t count, sm::columns::Writer writer)
{
  double* volume = writer.AddDoubles(sm::names::DisplacedVolume);
  double* volumeBound = writer.AddDoubles(std::string(sm::names::DisplacedVolume) + sm::names::BoundSuffix);
  double* first = writer.AddDoubles(sm::names::DisplacedFirstMoments, 3);
  double* firstBound =
    writer.AddDoubles(std::string(sm::names::DisplacedFirstMoments) + sm::names::BoundSuffix);
  double* center = writer.AddDoubles(sm::names::CenterOfBuoyancy, 3);
  double* centerBound = writer.AddDoubles(std::string(sm::names::CenterOfBuoyancy) + sm::names::BoundSuffix);
  for (const Row* row = rows; row != rows + count; ++row)
  {
    *volume++ = row->Volume;
    *volumeBound++ = row->VolumeBound;
    first = std::copy(row->First.begin(), row->First.end(), first);
    *firstBound++ = row->FirstBound;
    center = std::copy(row->Center.begin(), row->Center.end(), center);
    *centerBound++ = row->CenterBound;
  }
}

/// Returns the scale to which the tolerance of the volume (degree 0) or of the first moments (degree 1) is
/// relative.
double GetScale(const sm::BodyIntegrals& body, int degree)
{
  return std::pow(sm::GetReach(body), degree) * sm::GetVolumeScale(*body.Model);
}

/// Returns a line that states on which side of the plane all bodies lie; empty if their box, enlarged by a
/// hundredth of its diagonal, meets the plane.
std::string DescribeSide(
  const std::vector<sm::BodyIntegrals>& bodies, const double point[3], const double normal[3])
{
  vtkBoundingBox box;
  for (const sm::BodyIntegrals& body : bodies)
  {
    sm::AddPlacedBox(body, box);
  }
  if (!box.IsValid())
  {
    return "";
  }
  const double margin = 0.01 * box.GetDiagonalLength();
  double lowest = std::numeric_limits<double>::max();
  double highest = -lowest;
  for (int corner = 0; corner < 8; ++corner)
  {
    double p[3];
    box.GetCorner(corner, p);
    const double height =
      ((p[0] - point[0]) * normal[0] + (p[1] - point[1]) * normal[1] + (p[2] - point[2]) * normal[2]) /
      vtkMath::Norm(normal);
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
  }
  return highest < -margin ? "The solids lie wholly below the plane.\n"
    : lowest > margin      ? "The solids lie wholly above the plane.\n"
                           : "";
}

/// Makes a row of the sums over a body's faces and of the centre, which is computed about a point near the
/// body.
Row MakeRow(const sm::BodyIntegrals& body, const sm::DisplacedMoments* moments)
{
  Row row;
  row.Volume = body.Value[0];
  row.VolumeBound = body.Bound[0];
  std::copy_n(body.Value.begin() + 1, 3, row.First.begin());
  row.FirstBound = *std::max_element(body.Bound.begin() + 1, body.Bound.end());
  if (moments)
  {
    row.Center = moments->GetCenter(row.CenterBound);
  }
  return row;
}

}

struct vtkBuoyancy::Internals
{
  /// Results of the last run for each body; empty if nothing was computed.
  std::vector<sm::BodyBuoyancy> Results;
  std::vector<Row> Rows;
  Row Total;
};

vtkBuoyancy::vtkBuoyancy()
  : vtkPlaneCutBase(false, sm::names::DisplacedVolume)
  , Implementation(new Internals)
{
}

vtkBuoyancy::~vtkBuoyancy() = default;

void vtkBuoyancy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

double vtkBuoyancy::GetDisplacedVolume() const
{
  return this->Implementation->Total.Volume;
}

double vtkBuoyancy::GetDisplacedVolumeBound() const
{
  return this->Implementation->Total.VolumeBound;
}

void vtkBuoyancy::GetDisplacedFirstMoments(double moments[3]) const
{
  std::copy_n(this->Implementation->Total.First.begin(), 3, moments);
}

double vtkBuoyancy::GetDisplacedFirstMomentsBound() const
{
  return this->Implementation->Total.FirstBound;
}

void vtkBuoyancy::GetCenterOfBuoyancy(double center[3]) const
{
  std::copy_n(this->Implementation->Total.Center.begin(), 3, center);
}

double vtkBuoyancy::GetCenterOfBuoyancyBound() const
{
  return this->Implementation->Total.CenterBound;
}

void vtkBuoyancy::ResetResults()
{
  this->Superclass::ResetResults();
  this->Implementation->Results.clear();
  this->Implementation->Rows.clear();
  this->Implementation->Total = Row();
}

bool vtkBuoyancy::IntegrateBodies(const sm::IntegralRequest& request, std::vector<sm::BodyIntegrals>& bodies)
{
  Internals& self = *this->Implementation;
  if (!this->IntegrateSide(request, bodies, false, 0.0, 1.0, self.Results))
  {
    return false;
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    bodies[b].Faces = std::make_shared<const std::vector<sm::FaceIntegrals>>(self.Results[b].Faces);
  }
  return true;
}

void vtkBuoyancy::AnalyzeBodies(std::vector<sm::BodyIntegrals>& bodies)
{
  Internals& self = *this->Implementation;
  sm::DisplacedMoments moments;
  Row& total = self.Total;
  const bool hasTotal = sm::HaveOneUnit(bodies);
  if (!hasTotal)
  {
    this->GetEngine().GetReport().Messages.push_back(sm::MixedUnitsMessage);
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    sm::BodyIntegrals& body = bodies[b];
    for (std::size_t k = 0; k < NumberOfIntegrands && body.Faces; ++k)
    {
      const std::string quantity = k == 0 ? "displaced volume" : "first moments of the displaced volume";
      if (!std::isfinite(body.Value[k]))
      {
        body.Flag(sm::Status::Suspect, "the " + quantity + " is not a finite number somewhere on the faces");
      }
      else if (!(body.Bound[k] <= this->RelativeTolerance * GetScale(body, k == 0 ? 0 : 1)))
      {
        body.Flag(sm::Status::ToleranceNotMet, "the bound of the " + quantity + " is above the tolerance");
      }
    }
    if (body.Faces && body.OpenEdges == 0 && body.Value[0] < -body.Bound[0])
    {
      body.Flag(sm::Status::Suspect, "the displaced volume is negative: the solid is inside out in the file");
    }
    sm::CheckShells(body);
    const sm::DisplacedMoments* own = self.Results.empty() ? nullptr : &self.Results[b].Total;
    const Row row = MakeRow(body, own);
    self.Rows.push_back(row);
    if (!hasTotal)
    {
      continue;
    }
    if (b == 0)
    {
      total = row;
      moments = own ? *own : moments;
      continue;
    }
    total.Volume += row.Volume;
    total.VolumeBound += row.VolumeBound + 2.0 * sm::UnitRoundoff * std::abs(total.Volume);
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      total.First[c] += row.First[c];
      largest = std::max(largest, std::abs(total.First[c]));
    }
    total.FirstBound += row.FirstBound + 2.0 * sm::UnitRoundoff * largest;
    if (own)
    {
      moments.Add(*own);
      total.Center = moments.GetCenter(total.CenterBound);
    }
  }
}

void vtkBuoyancy::WriteOutputs(const std::vector<sm::BodyIntegrals>& bodies, const Outputs& outputs) const
{
  const Internals& self = *this->Implementation;
  sm::columns::Writer totals(outputs.Arrays, outputs.Totals->GetFieldData());
  WriteRows(&self.Total, 1, totals);
  WriteRows(self.Rows.data(), self.Rows.size(),
    sm::columns::Writer(outputs.Arrays, outputs.Solids->GetRowData(), self.Rows.size()));
  const std::string unit = bodies.empty() ? "mm" : bodies.front().Model->GetLengthUnit();
  std::string summary = this->FormatStatus(bodies) + DescribeSide(bodies, this->Point, this->Normal) +
    "Displaced volume: " +
    sm::FormatWithBound(self.Total.Volume, self.Total.VolumeBound, unit + "^3", sm::SumClosing(bodies, 0)) +
    "\n";
  if (std::isfinite(self.Total.CenterBound))
  {
    summary += "Centre of buoyancy:";
    for (std::size_t i = 0; i < 3; ++i)
    {
      summary += (i == 0 ? " " : "  ") + sm::FormatNumber(self.Total.Center[i], self.Total.CenterBound);
    }
    summary += " " + unit + sm::FormatBoundNote(self.Total.CenterBound) + "\n";
  }
  totals.SetString(sm::names::LengthUnit, unit);
  sm::columns::Writer(outputs.Arrays, outputs.Text->GetRowData()).SetString(sm::names::Text, summary);
  sm::columns::AddFaceRows(outputs.Arrays, bodies, this->MakeRequest().Integrands, outputs.Faces, { 0 });
}

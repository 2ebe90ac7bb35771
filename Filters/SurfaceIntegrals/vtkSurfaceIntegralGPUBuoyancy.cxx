// What vtkSurfaceIntegralGPU integrates below waterlines.
#include "vtkSurfaceIntegralGPU.h"

#include "smFormat.h"
#include "vtkSurfaceIntegralGPUInternals.h"

#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace
{
const char* const Quantities[] = { "", "MomentX", "MomentY", "MomentZ" };
}

void vtkSurfaceIntegralGPU::AddBuoyancy(
  const std::string& name, double x, double y, double z, double upX, double upY, double upZ)
{
  Internals& self = *this->Implementation;
  for (const double value : { x, y, z, upX, upY, upZ })
  {
    if (!std::isfinite(value))
    {
      vtkErrorMacro(
        "AddBuoyancy: '" << name << "': the point and the direction of a waterline must be finite.");
      return;
    }
  }
  if (upX == 0.0 && upY == 0.0 && upZ == 0.0)
  {
    vtkErrorMacro(
      "AddBuoyancy: '" << name << "' has no direction; give a vector out of the water that is not 0.");
    return;
  }
  for (const char* quantity : Quantities)
  {
    const std::string wanted = name + quantity;
    const bool exists = std::any_of(self.Integrands.begin(), self.Integrands.end(),
      [&wanted](const sm::Integrand& other) { return other.Name == wanted; });
    if (name.empty() || exists || self.LocalTolerances)
    {
      // Says why.
      self.Add(this, sm::Integrand::Displaced(name.empty() ? name : wanted, 0, 0));
      return;
    }
  }
  const int waterline = static_cast<int>(self.Waterlines.size());
  self.Waterlines.push_back({ { x, y, z }, { upX, upY, upZ } });
  self.WaterlineNames.push_back(name);
  for (int quantity = 0; quantity < 4; ++quantity)
  {
    self.Add(this, sm::Integrand::Displaced(name + Quantities[quantity], waterline, quantity));
  }
}

void vtkSurfaceIntegralGPU::GetCenterOfBuoyancy(const std::string& name, double center[3]) const
{
  const auto found = this->Implementation->Last.Centers.find(name);
  const bool known = found != this->Implementation->Last.Centers.end();
  for (int c = 0; c < 3; ++c)
  {
    center[c] = known ? found->second.first[c] : vtkMath::Nan();
  }
}

double vtkSurfaceIntegralGPU::GetCenterOfBuoyancyBound(const std::string& name) const
{
  const auto found = this->Implementation->Last.Centers.find(name);
  return found != this->Implementation->Last.Centers.end() ? found->second.second : vtkMath::Nan();
}

std::vector<sm::Integrand> vtkSurfaceIntegralGPU::Internals::GetPlainIntegrands() const
{
  std::vector<sm::Integrand> plain;
  std::copy_if(this->Integrands.begin(), this->Integrands.end(), std::back_inserter(plain),
    [](const sm::Integrand& integrand) { return integrand.Waterline < 0; });
  return plain;
}

std::string vtkSurfaceIntegralGPU::Internals::GetObstacle(std::size_t integrand) const
{
  if (this->Integrands[integrand].Waterline >= 0)
  {
    return "";
  }
  const auto end = this->Integrands.begin() + static_cast<std::ptrdiff_t>(integrand);
  return this->Integrator.GetObstacle(static_cast<std::size_t>(std::count_if(
    this->Integrands.begin(), end, [](const sm::Integrand& other) { return other.Waterline < 0; })));
}

bool vtkSurfaceIntegralGPU::Internals::IntegrateBuoyancy(
  vtkSurfaceIntegralGPU* self, std::vector<sm::BodyIntegrals>& bodies)
{
  Run& last = this->Last;
  sm::SurfaceIntegrator& integrator = this->Buoyancy.GetIntegrator();
  const vtkTypeUInt64 dispatches = this->Context->GetNumberOfDispatches();
  const bool done = this->Buoyancy.Integrate(
    bodies, this->Waterlines, self->RelativeTolerance,
    [this](const sm::Face& face) { return this->FaceIds.empty() || this->FaceIds.count(face.FileId) > 0; },
    [self](double fraction)
    {
      self->UpdateProgress(0.5 + 0.5 * fraction);
      return !self->GetAbortExecute();
    },
    this->Displaced);
  last.Evaluations += integrator.GetEvaluations();
  last.Dispatches += static_cast<vtkTypeInt64>(this->Context->GetNumberOfDispatches() - dispatches);
  last.StartSeconds += integrator.GetStartSeconds();
  last.PrepareSeconds += this->Buoyancy.GetCutSeconds() + integrator.GetPrepareSeconds();
  last.IntegrateSeconds += integrator.GetIntegrateSeconds();
  if (!done)
  {
    this->Displaced.clear();
    this->SetReason(
      integrator.WasAborted() ? "the run was aborted" : "nothing was computed: " + integrator.GetError());
    return false;
  }
  if (integrator.WasAborted())
  {
    this->SetReason("the run was stopped before all faces were integrated below the waterlines");
  }
  if (integrator.WasLoosened())
  {
    last.Messages.push_back("MaximumEvaluations are too few for the tolerance below the waterlines: it was "
                            "loosened, and the bounds say by how much");
  }
  for (std::size_t b = 0; b < bodies.size(); ++b)
  {
    auto faces = std::make_shared<std::vector<sm::FaceIntegrals>>(*bodies[b].Faces);
    for (std::size_t i = 0; i < faces->size(); ++i)
    {
      sm::FaceIntegrals& face = (*faces)[i];
      sm::FaceIntegrals all = face;
      for (std::vector<double>* values :
        { &all.Face, &all.Closing, &all.QuadratureError, &all.Rounding, &all.Conversion })
      {
        values->clear();
      }
      std::size_t next = 0;
      std::map<int, std::size_t> nextOf;
      for (const sm::Integrand& integrand : this->Integrands)
      {
        const bool isPlain = integrand.Waterline < 0;
        const sm::FaceIntegrals& from =
          isPlain ? face : this->Displaced[integrand.Waterline * bodies.size() + b].Faces[i];
        const std::size_t k = isPlain ? next++ : nextOf[integrand.Waterline]++;
        all.Face.push_back(from.Face[k]);
        all.Closing.push_back(from.Closing[k]);
        all.QuadratureError.push_back(from.QuadratureError[k]);
        all.Rounding.push_back(from.Rounding[k]);
        all.Conversion.push_back(from.Conversion[k]);
        all.Estimated = all.Estimated || from.Estimated;
        all.Skipped = all.Skipped || from.Skipped;
        all.Error = all.Error.empty() ? from.Error : all.Error;
        all.CoverageDefects = std::max(all.CoverageDefects, from.CoverageDefects);
        all.Outside = std::max(all.Outside, from.Outside);
      }
      face = std::move(all);
    }
    bodies[b].Faces = faces;
  }
  return true;
}

void vtkSurfaceIntegralGPU::Internals::AddCenters(
  const std::vector<sm::BodyIntegrals>& bodies, vtkPolyData* totals, vtkTable* solids, std::string& summary)
{
  for (std::size_t w = 0; w < this->Waterlines.size(); ++w)
  {
    const std::string name = this->WaterlineNames[w] + sm::names::CenterSuffix;
    sm::columns::Column centers(name, 3);
    sm::columns::Column bounds(name + sm::names::BoundSuffix, 1);
    std::array<double, 3> center = { vtkMath::Nan(), vtkMath::Nan(), vtkMath::Nan() };
    double bound = vtkMath::Nan();
    sm::DisplacedMoments total;
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
      center.fill(vtkMath::Nan());
      bound = vtkMath::Nan();
      if (!this->Displaced.empty())
      {
        const sm::DisplacedMoments& own = this->Displaced[w * bodies.size() + b].Total;
        center = own.GetCenter(bound);
        if (b == 0)
        {
          total = own;
        }
        else
        {
          total.Add(own);
        }
      }
      centers.Append(center.data());
      bounds.Append(&bound);
    }
    if (!this->Displaced.empty() && !bodies.empty())
    {
      center = total.GetCenter(bound);
    }
    centers.AddTo(solids->GetRowData());
    bounds.AddTo(solids->GetRowData());
    sm::columns::SetDoubles(totals->GetFieldData(), name, center.data(), 3);
    sm::columns::SetDoubles(totals->GetFieldData(), name + sm::names::BoundSuffix, &bound, 1);
    this->Last.Centers[this->WaterlineNames[w]] = { center, bound };
    if (std::isfinite(bound))
    {
      summary += name + " =";
      for (const double coordinate : center)
      {
        summary += " " + sm::FormatWithBound(coordinate, bound, "");
      }
      summary += "\n";
    }
  }
}

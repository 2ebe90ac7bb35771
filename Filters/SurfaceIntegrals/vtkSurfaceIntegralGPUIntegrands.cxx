// The integrands of vtkSurfaceIntegralGPU: the user's own and the ready ones; constants, and which faces they are integrated over.
#include "vtkSurfaceIntegralGPU.h"

#include "smFormat.h"
#include "smGaussLegendre.h"
#include "smUserExpression.h"
#include "vtkSurfaceIntegralGPUInternals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/// Beyond it, caps and straight panels would take Gauss rules that the table does not have (OrderLadder).
constexpr int LargestDegree = 60;
static_assert((LargestDegree + 4) / 2 <= sm::MaximumRuleSize, "the points of a cap");

bool AreValidPowers(int i, int j, int k)
{
  return std::min({ i, j, k }) >= 0 && std::max({ i, j, k }) <= LargestDegree && i + j + k <= LargestDegree;
}

/// dvec3 of a unit vector; empty when there is no direction.
std::string UnitVector(double x, double y, double z)
{
  const double length = std::hypot(x, y, z);
  if (!(length > 0.0) || !std::isfinite(length))
  {
    return {};
  }
  return "dvec3(" + sm::MakeLiteral(x / length) + ", " + sm::MakeLiteral(y / length) + ", " +
    sm::MakeLiteral(z / length) + ")";
}
}

void vtkSurfaceIntegralGPU::AddIntegrand(const std::string& name, const std::string& expression, int support)
{
  if (expression.empty())
  {
    vtkErrorMacro(
      "AddIntegrand: the expression of '" << name << "' is empty; give GLSL of position and normal.");
    return;
  }
  this->Implementation->Add(
    this, sm::Integrand::User(name, expression, support == CLOSED_CHAIN, this->Implementation->Constants));
}

void vtkSurfaceIntegralGPU::AddVolumeMoment(const std::string& name, int i, int j, int k)
{
  if (!AreValidPowers(i, j, k))
  {
    vtkErrorMacro("AddVolumeMoment: the powers " << i << ", " << j << ", " << k << " of '" << name
                                                 << "' must not be negative, their sum at most "
                                                 << LargestDegree << ".");
    return;
  }
  this->Implementation->Add(this, sm::Integrand::VolumeMoment(name, i, j, k));
}

void vtkSurfaceIntegralGPU::AddAreaMoment(const std::string& name, int i, int j, int k)
{
  if (!AreValidPowers(i, j, k))
  {
    vtkErrorMacro("AddAreaMoment: the powers " << i << ", " << j << ", " << k << " of '" << name
                                               << "' must not be negative, their sum at most "
                                               << LargestDegree << ".");
    return;
  }
  this->Implementation->Add(this, sm::Integrand::AreaMoment(name, i, j, k));
}

void vtkSurfaceIntegralGPU::AddFlux(
  const std::string& name, const std::string& x, const std::string& y, const std::string& z)
{
  this->AddIntegrand(name, "dot(dvec3(" + x + ", " + y + ", " + z + "), normal)", CLOSED_CHAIN);
}

void vtkSurfaceIntegralGPU::AddBendingEnergy(const std::string& name)
{
  sm::Integrand integrand =
    sm::Integrand::User(name, "(4 * meanCurvature * meanCurvature - 2 * gaussianCurvature) * dA", false, {});
  // It is the same for bodies of all sizes.
  integrand.ScalePower = -2;
  this->Implementation->Add(this, integrand);
}

void vtkSurfaceIntegralGPU::AddProjectedArea(const std::string& name, double x, double y, double z)
{
  const std::string direction = UnitVector(x, y, z);
  if (direction.empty())
  {
    vtkErrorMacro("AddProjectedArea: '" << name << "' has no direction; give a vector that is not 0.");
    return;
  }
  this->Implementation->Add(
    this, sm::Integrand::User(name, "0.5 * abs(dot(" + direction + ", normal))", false, {}));
}

void vtkSurfaceIntegralGPU::AddConstant(const std::string& name, double value)
{
  if (!sm::UserExpression::IsFree(name) || !std::isfinite(value))
  {
    vtkErrorMacro(
      "AddConstant: '" << name << "' = " << value
                       << ": the name must be an identifier without a meaning yet, the value finite.");
    return;
  }
  Internals& self = *this->Implementation;
  const auto found = self.Constants.find(name);
  if (found != self.Constants.end() && found->second == value)
  {
    return;
  }
  self.Constants[name] = value;
  for (sm::Integrand& integrand : self.Integrands)
  {
    if (integrand.Source)
    {
      const int scalePower = integrand.ScalePower;
      integrand =
        sm::Integrand::User(integrand.Name, integrand.Expression, integrand.ClosedChain, self.Constants);
      integrand.ScalePower = scalePower;
    }
  }
  this->Modified();
}

void vtkSurfaceIntegralGPU::AddFaceId(int id)
{
  if (this->Implementation->LocalTolerances)
  {
    vtkErrorMacro("AddFaceId: " << this->GetClassName()
                                << " integrates whole bodies. Use vtkSurfaceIntegralGPU for chosen faces.");
    return;
  }
  if (this->Implementation->FaceIds.insert(id).second)
  {
    this->Modified();
  }
}

void vtkSurfaceIntegralGPU::RemoveAllFaceIds()
{
  if (!this->Implementation->FaceIds.empty())
  {
    this->Implementation->FaceIds.clear();
    this->Modified();
  }
}

int vtkSurfaceIntegralGPU::GetNumberOfFaceIds() const
{
  return static_cast<int>(this->Implementation->FaceIds.size());
}

std::vector<std::size_t> vtkSurfaceIntegralGPU::Internals::ChooseTasks(std::vector<sm::FaceTask>& tasks)
{
  std::vector<std::size_t> chosen;
  if (this->FaceIds.empty())
  {
    return chosen;
  }
  std::set<int> missing = this->FaceIds;
  std::vector<sm::FaceTask> kept;
  for (sm::FaceTask& task : tasks)
  {
    const int id = task.Source->FileId;
    missing.erase(id);
    chosen.push_back(this->FaceIds.count(id) > 0 ? kept.size() : tasks.size());
    if (chosen.back() < tasks.size())
    {
      kept.push_back(std::move(task));
    }
  }
  tasks = std::move(kept);
  for (const int id : missing)
  {
    this->Last.Messages.push_back("there is no face #" + std::to_string(id) + " to integrate over");
  }
  return chosen;
}

void vtkSurfaceIntegralGPU::Internals::SpreadResults(
  const std::vector<std::size_t>& chosen, std::vector<sm::FaceIntegrals>& results) const
{
  if (chosen.empty())
  {
    return;
  }
  sm::FaceIntegrals nothing;
  const std::size_t count = this->Configured.size();
  for (std::size_t k = 0; k < count; ++k)
  {
    const double value =
      this->Integrator.GetObstacle(k).empty() ? 0.0 : std::numeric_limits<double>::quiet_NaN();
    for (std::vector<double>* values :
      { &nothing.Face, &nothing.Closing, &nothing.QuadratureError, &nothing.Rounding, &nothing.Conversion })
    {
      values->push_back(value);
    }
  }
  std::vector<sm::FaceIntegrals> all;
  for (const std::size_t result : chosen)
  {
    all.push_back(result < results.size() ? results[result] : nothing);
  }
  results = std::move(all);
}

void vtkSurfaceIntegralGPU::Internals::Add(vtkSurfaceIntegralGPU* self, const sm::Integrand& integrand)
{
  const std::string& name = integrand.Name;
  const std::string bound = sm::names::BoundSuffix;
  const bool exists = std::any_of(this->Integrands.begin(), this->Integrands.end(),
    [&](const sm::Integrand& other)
    { return other.Name == name || other.Name == name + bound || other.Name + bound == name; });
  const bool isBeside =
    std::find(std::begin(sm::names::ReservedColumnNames), std::end(sm::names::ReservedColumnNames), name) !=
    std::end(sm::names::ReservedColumnNames);
  if (name.empty() || exists || isBeside)
  {
    vtkErrorWithObjectMacro(self,
      "The name '" << name << "' of an integrand is empty, or a column of the outputs has it or would.");
    return;
  }
  if (this->LocalTolerances)
  {
    vtkErrorWithObjectMacro(self,
      "'" << integrand.Name << "' was not added: the integrands of " << self->GetClassName()
          << " are fixed. Use vtkSurfaceIntegralGPU for others.");
    return;
  }
  this->Integrands.push_back(integrand);
  self->Modified();
}

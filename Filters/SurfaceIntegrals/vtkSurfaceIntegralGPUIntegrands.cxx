// Integrands of vtkSurfaceIntegralGPU, by the user's expressions and predefined; constants, and the selection
// of faces.
#include "vtkSurfaceIntegralGPU.h"

#include "Engine/vtkSurfaceIntegralGPUInternals.h"
#include "smFormat.h"
#include "smGaussLegendre.h"
#include "smIntegralNames.h"
#include "smTrimText.h"
#include "smUserExpression.h"
#include "vtkNURBSDataSet.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
/// Largest degree for which caps and straight panels have Gauss rules in the table (OrderLadder).
constexpr int MaxDegree = 60;
static_assert((MaxDegree + 4) / 2 <= sm::MaximumRuleSize, "the points of a cap");
// 165 moments are computed by one shader, which drivers take seconds to compile; the time grows more than
// proportionally.
constexpr int MaxMomentDegree = 8;

bool AreValidPowers(int i, int j, int k)
{
  return std::min({ i, j, k }) >= 0 && std::max({ i, j, k }) <= MaxDegree && i + j + k <= MaxDegree;
}

/// Returns a dvec3 literal of the normalised direction; empty if there is none.
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

sm::Integrand MakeFlux(
  const std::string& name, const std::string& x, const std::string& y, const std::string& z)
{
  return sm::Integrand::User(name, "dot(dvec3(" + x + ", " + y + ", " + z + "), normal)", true);
}

sm::Integrand MakeBendingEnergy(const std::string& name)
{
  sm::Integrand integrand =
    sm::Integrand::User(name, "(4 * meanCurvature * meanCurvature - 2 * gaussianCurvature) * dA", false);
  // The integral does not depend on the size of the body.
  integrand.ScalePower = -2;
  return integrand;
}

sm::Integrand MakeProjectedArea(const std::string& name, const std::string& direction)
{
  return sm::Integrand::User(name, "0.5 * abs(dot(" + direction + ", normal))", false);
}

/// Returns true if the name, or the column of its bound, is the name or bound of another integrand.
bool HasClash(const std::vector<sm::Integrand>& integrands, const std::string& name)
{
  const std::string bound = sm::names::BoundSuffix;
  return std::any_of(integrands.begin(), integrands.end(),
    [&](const sm::Integrand& other)
    { return other.Name == name || other.Name == name + bound || other.Name + bound == name; });
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(sm::Trim(part));
  }
  return parts;
}
}

std::vector<sm::Integrand> vtkSurfaceIntegralGPU::Internals::GetIntegrands() const
{
  std::vector<sm::Integrand> all;
  const auto add = [&all](const sm::Integrand& integrand)
  {
    if (!HasClash(all, integrand.Name))
    {
      all.push_back(integrand);
    }
  };
  std::for_each(this->Added.begin(), this->Added.end(), add);
  std::for_each(this->OfText.begin(), this->OfText.end(), add);
  for (int total = 0; total <= this->MomentDegree; ++total)
  {
    for (int i = total; i >= 0; --i)
    {
      for (int j = total - i; j >= 0; --j)
      {
        const int k = total - i - j;
        add(sm::Integrand::VolumeMoment(
          "moment_" + std::to_string(i) + "_" + std::to_string(j) + "_" + std::to_string(k), i, j, k));
      }
    }
  }
  if (this->BendingEnergy)
  {
    add(MakeBendingEnergy("BendingEnergy"));
  }
  const double* d = this->ProjectedAreaDirection;
  const std::string direction = UnitVector(d[0], d[1], d[2]);
  if (!direction.empty())
  {
    add(MakeProjectedArea("ProjectedArea", direction));
  }
  for (sm::Integrand& integrand : all)
  {
    if (integrand.Source)
    {
      const int scalePower = integrand.ScalePower;
      integrand =
        sm::Integrand::User(integrand.Name, integrand.Expression, integrand.ClosedChain, this->Constants);
      integrand.ScalePower = scalePower;
    }
  }
  return all;
}

void vtkSurfaceIntegralGPU::Add(const sm::Integrand& integrand, std::vector<sm::Integrand>& integrands)
{
  const std::string& name = integrand.Name;
  const bool isReserved =
    std::find(std::begin(sm::names::ReservedColumnNames), std::end(sm::names::ReservedColumnNames), name) !=
      std::end(sm::names::ReservedColumnNames) ||
    name == vtkNURBSDataSet::FaceIndexArrayName();
  if (name.empty() || isReserved || HasClash(this->Implementation->GetIntegrands(), name))
  {
    vtkErrorMacro("The integrand " << (name.empty() ? "without a name is not used: give it one."
                                                    : "'" + name + "' is not used: " +
                        (isReserved ? "a column of the outputs has this name"
                                    : "another integrand has this name, or names its bound") +
                        ". Give it another one."));
    return;
  }
  integrands.push_back(integrand);
  this->Modified();
}

void vtkSurfaceIntegralGPU::AddIntegrand(const std::string& name, const std::string& expression, int support)
{
  if (expression.empty())
  {
    vtkErrorMacro(
      "AddIntegrand: the expression of '" << name << "' is empty; give GLSL of position and normal.");
    return;
  }
  this->Add(sm::Integrand::User(name, expression, support == CLOSED_CHAIN), this->Implementation->Added);
}

void vtkSurfaceIntegralGPU::AddVolumeMoment(const std::string& name, int i, int j, int k)
{
  if (!AreValidPowers(i, j, k))
  {
    vtkErrorMacro("AddVolumeMoment: the powers " << i << ", " << j << ", " << k << " of '" << name
                                                 << "' must not be negative, their sum at most " << MaxDegree
                                                 << ".");
    return;
  }
  this->Add(sm::Integrand::VolumeMoment(name, i, j, k), this->Implementation->Added);
}

void vtkSurfaceIntegralGPU::AddAreaMoment(const std::string& name, int i, int j, int k)
{
  if (!AreValidPowers(i, j, k))
  {
    vtkErrorMacro("AddAreaMoment: the powers " << i << ", " << j << ", " << k << " of '" << name
                                               << "' must not be negative, their sum at most " << MaxDegree
                                               << ".");
    return;
  }
  this->Add(sm::Integrand::AreaMoment(name, i, j, k), this->Implementation->Added);
}

void vtkSurfaceIntegralGPU::AddFlux(
  const std::string& name, const std::string& x, const std::string& y, const std::string& z)
{
  this->Add(MakeFlux(name, x, y, z), this->Implementation->Added);
}

void vtkSurfaceIntegralGPU::AddBendingEnergy(const std::string& name)
{
  this->Add(MakeBendingEnergy(name), this->Implementation->Added);
}

void vtkSurfaceIntegralGPU::AddProjectedArea(const std::string& name, double x, double y, double z)
{
  const std::string direction = UnitVector(x, y, z);
  if (direction.empty())
  {
    vtkErrorMacro("AddProjectedArea: '" << name << "' has no direction; give a vector that is not 0.");
    return;
  }
  this->Add(MakeProjectedArea(name, direction), this->Implementation->Added);
}

void vtkSurfaceIntegralGPU::AddConstant(const std::string& name, double value)
{
  if (!sm::UserExpression::IsFree(name) || !std::isfinite(value))
  {
    vtkErrorMacro(
      "AddConstant: '" << name << "' = " << sm::FormatDigits(value, 6)
                       << ": the name must be an identifier without a meaning yet, the value finite.");
    return;
  }
  const auto found = this->Implementation->Constants.find(name);
  if (found == this->Implementation->Constants.end() || found->second != value)
  {
    this->Implementation->Constants[name] = value;
    this->Modified();
  }
}

void vtkSurfaceIntegralGPU::RemoveAllIntegrands()
{
  Internals& self = *this->Implementation;
  self.Added.clear();
  self.OfText.clear();
  self.IntegrandText.clear();
  self.MomentDegree = -1;
  self.BendingEnergy = false;
  std::fill_n(self.ProjectedAreaDirection, 3, 0.0);
  this->Modified();
}

int vtkSurfaceIntegralGPU::GetNumberOfIntegrands() const
{
  return static_cast<int>(this->Implementation->GetIntegrands().size());
}

std::string vtkSurfaceIntegralGPU::GetIntegrandName(int index) const
{
  const std::vector<sm::Integrand> integrands = this->Implementation->GetIntegrands();
  return index >= 0 && index < static_cast<int>(integrands.size()) ? integrands[index].Name : "";
}

void vtkSurfaceIntegralGPU::SetIntegrandText(const std::string& text)
{
  Internals& self = *this->Implementation;
  if (self.IntegrandText == text)
  {
    return;
  }
  self.IntegrandText = text;
  self.OfText.clear();
  for (const std::string& line : Split(text, '\n'))
  {
    const std::string::size_type equals = line.find('=');
    const std::string name = sm::Trim(line.substr(0, equals));
    const std::vector<std::string> parts =
      equals == std::string::npos ? std::vector<std::string>() : Split(line.substr(equals + 1), ';');
    const bool complete =
      std::none_of(parts.begin(), parts.end(), [](const std::string& part) { return part.empty(); });
    if (line.empty())
    {
      continue;
    }
    if (name.empty() || !complete || (parts.size() != 1 && parts.size() != 3))
    {
      vtkErrorMacro(
        "'" << line
            << "' is not an integrand: write NAME = EXPRESSION, for example area = dA, or NAME = X ; Y ; Z "
               "for the flux of a vector.");
      continue;
    }
    this->Add(parts.size() == 3 ? MakeFlux(name, parts[0], parts[1], parts[2])
                                : sm::Integrand::User(name, parts[0], false),
      self.OfText);
  }
  this->Modified();
}

std::string vtkSurfaceIntegralGPU::GetIntegrandText() const
{
  return this->Implementation->IntegrandText;
}

void vtkSurfaceIntegralGPU::SetMomentDegree(int degree)
{
  const int clamped = std::clamp(degree, -1, MaxMomentDegree);
  if (this->Implementation->MomentDegree != clamped)
  {
    this->Implementation->MomentDegree = clamped;
    this->Modified();
  }
}

int vtkSurfaceIntegralGPU::GetMomentDegree() const
{
  return this->Implementation->MomentDegree;
}

void vtkSurfaceIntegralGPU::SetBendingEnergy(bool on)
{
  if (this->Implementation->BendingEnergy != on)
  {
    this->Implementation->BendingEnergy = on;
    this->Modified();
  }
}

bool vtkSurfaceIntegralGPU::GetBendingEnergy() const
{
  return this->Implementation->BendingEnergy;
}

void vtkSurfaceIntegralGPU::SetProjectedAreaDirection(double x, double y, double z)
{
  const double direction[3] = { x, y, z };
  if (!std::isfinite(x + y + z))
  {
    vtkErrorMacro(
      "The direction " << sm::FormatTriple(x, y, z)
                       << " of the projected area is not used: give a finite vector, or 0 0 0 for none.");
    return;
  }
  if (!std::equal(direction, direction + 3, this->Implementation->ProjectedAreaDirection))
  {
    std::copy_n(direction, 3, this->Implementation->ProjectedAreaDirection);
    this->Modified();
  }
}

double* vtkSurfaceIntegralGPU::GetProjectedAreaDirection()
{
  return this->Implementation->ProjectedAreaDirection;
}

void vtkSurfaceIntegralGPU::AddFaceId(vtkTypeInt64 id)
{
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

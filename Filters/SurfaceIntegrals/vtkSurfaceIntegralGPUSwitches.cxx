// Integrands that a user interface switches on and off, apart from those that a program adds one by one.
#include "vtkSurfaceIntegralGPU.h"

#include "vtkSurfaceIntegralGPUInternals.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// 165 moments are one shader, which drivers take seconds to compile, and longer than in proportion for more.
constexpr int LargestMomentDegree = 8;
const char* const WaterlineName = "Displaced";

std::string Trim(const std::string& text)
{
  const char* const blanks = " \t\r\n";
  const std::string::size_type first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(Trim(part));
  }
  return parts;
}
}

void vtkSurfaceIntegralGPU::Internals::Switch(
  vtkSurfaceIntegralGPU* self, const std::string& name, const std::function<void()>& add)
{
  const std::set<std::string> old = std::move(this->Switched[name]);
  this->Integrands.erase(std::remove_if(this->Integrands.begin(), this->Integrands.end(),
                           [&old](const sm::Integrand& integrand) { return old.count(integrand.Name) > 0; }),
    this->Integrands.end());
  const std::size_t before = this->Integrands.size();
  add();
  std::set<std::string>& added = this->Switched[name];
  for (std::size_t i = before; i < this->Integrands.size(); ++i)
  {
    added.insert(this->Integrands[i].Name);
  }
  self->Modified();
}

void vtkSurfaceIntegralGPU::SetIntegrandText(const std::string& text)
{
  Internals& self = *this->Implementation;
  if (self.IntegrandText == text)
  {
    return;
  }
  self.IntegrandText = text;
  const auto add = [this, &text]()
  {
    for (const std::string& line : Split(text, '\n'))
    {
      const std::string::size_type equals = line.find('=');
      const std::string name = Trim(line.substr(0, equals));
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
              << "' is no integrand: write NAME = EXPRESSION, for example area = dA, or NAME = X ; Y ; Z "
                 "for the flux of a vector.");
      }
      else if (parts.size() == 3)
      {
        this->AddFlux(name, parts[0], parts[1], parts[2]);
      }
      else
      {
        this->AddIntegrand(name, parts[0], FACES);
      }
    }
  };
  self.Switch(this, "IntegrandText", add);
}

std::string vtkSurfaceIntegralGPU::GetIntegrandText() const
{
  return this->Implementation->IntegrandText;
}

void vtkSurfaceIntegralGPU::SetMomentDegree(int degree)
{
  Internals& self = *this->Implementation;
  const int clamped = std::clamp(degree, -1, LargestMomentDegree);
  if (self.MomentDegree == clamped)
  {
    return;
  }
  self.MomentDegree = clamped;
  const auto add = [this, clamped]()
  {
    for (int total = 0; total <= clamped; ++total)
    {
      for (int i = total; i >= 0; --i)
      {
        for (int j = total - i; j >= 0; --j)
        {
          const int k = total - i - j;
          this->AddVolumeMoment(
            "moment_" + std::to_string(i) + "_" + std::to_string(j) + "_" + std::to_string(k), i, j, k);
        }
      }
    }
  };
  self.Switch(this, "MomentDegree", add);
}

int vtkSurfaceIntegralGPU::GetMomentDegree() const
{
  return this->Implementation->MomentDegree;
}

void vtkSurfaceIntegralGPU::SetBendingEnergy(bool on)
{
  Internals& self = *this->Implementation;
  if (self.BendingEnergy == on)
  {
    return;
  }
  self.BendingEnergy = on;
  const auto add = [this, on]()
  {
    if (on)
    {
      this->AddBendingEnergy("BendingEnergy");
    }
  };
  self.Switch(this, "BendingEnergy", add);
}

bool vtkSurfaceIntegralGPU::GetBendingEnergy() const
{
  return this->Implementation->BendingEnergy;
}

void vtkSurfaceIntegralGPU::SetProjectedAreaDirection(double x, double y, double z)
{
  Internals& self = *this->Implementation;
  const double direction[3] = { x, y, z };
  if (!std::isfinite(x + y + z))
  {
    vtkErrorMacro("SetProjectedAreaDirection: " << x << " " << y << " " << z
                                                << " is no direction; give a vector, or 0 0 0 for none.");
    return;
  }
  if (std::equal(direction, direction + 3, self.ProjectedAreaDirection))
  {
    return;
  }
  std::copy_n(direction, 3, self.ProjectedAreaDirection);
  const auto add = [this, x, y, z]()
  {
    if (x != 0.0 || y != 0.0 || z != 0.0)
    {
      this->AddProjectedArea("ProjectedArea", x, y, z);
    }
  };
  self.Switch(this, "ProjectedAreaDirection", add);
}

double* vtkSurfaceIntegralGPU::GetProjectedAreaDirection()
{
  return this->Implementation->ProjectedAreaDirection;
}

void vtkSurfaceIntegralGPU::Internals::SwitchWaterline(vtkSurfaceIntegralGPU* self)
{
  // Only one of its own: a program may have added another of this name.
  const auto found = std::find(this->WaterlineNames.begin(), this->WaterlineNames.end(), WaterlineName);
  if (!this->Switched["Waterline"].empty() && found != this->WaterlineNames.end())
  {
    const int index = static_cast<int>(found - this->WaterlineNames.begin());
    this->WaterlineNames.erase(found);
    this->Waterlines.erase(this->Waterlines.begin() + index);
    for (sm::Integrand& integrand : this->Integrands)
    {
      integrand.Waterline -= integrand.Waterline > index ? 1 : 0;
    }
  }
  const auto add = [this, self]()
  {
    const double* p = this->WaterlinePoint;
    const double* n = this->WaterlineNormal;
    if (this->HasWaterline)
    {
      self->AddBuoyancy(WaterlineName, p[0], p[1], p[2], n[0], n[1], n[2]);
    }
  };
  this->Switch(self, "Waterline", add);
}

void vtkSurfaceIntegralGPU::SetWaterline(bool on)
{
  if (this->Implementation->HasWaterline != on)
  {
    this->Implementation->HasWaterline = on;
    this->Implementation->SwitchWaterline(this);
  }
}

bool vtkSurfaceIntegralGPU::GetWaterline() const
{
  return this->Implementation->HasWaterline;
}

void vtkSurfaceIntegralGPU::SetWaterlinePoint(double x, double y, double z)
{
  const double point[3] = { x, y, z };
  if (!std::equal(point, point + 3, this->Implementation->WaterlinePoint))
  {
    std::copy_n(point, 3, this->Implementation->WaterlinePoint);
    this->Implementation->SwitchWaterline(this);
  }
}

double* vtkSurfaceIntegralGPU::GetWaterlinePoint()
{
  return this->Implementation->WaterlinePoint;
}

void vtkSurfaceIntegralGPU::SetWaterlineNormal(double x, double y, double z)
{
  const double normal[3] = { x, y, z };
  if (!std::equal(normal, normal + 3, this->Implementation->WaterlineNormal))
  {
    std::copy_n(normal, 3, this->Implementation->WaterlineNormal);
    this->Implementation->SwitchWaterline(this);
  }
}

double* vtkSurfaceIntegralGPU::GetWaterlineNormal()
{
  return this->Implementation->WaterlineNormal;
}

// TestHighMoments FOLDER BACKEND: all volume moments up to degree 8 of box, sphere, ellipsoid and torus
// against closed forms, each within its bound.
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkSurfaceIntegralGPU.h>

#include <functional>

namespace
{
using namespace smtest;
using Real = long double;

constexpr int Degree = 8;
/// The integral of x^i y^j z^k over a body.
using Moment = std::function<Real(int i, int j, int k)>;

Real Gamma(int twice)
{
  return std::tgamma(static_cast<Real>(twice) / 2);
}

bool IsOdd(int i)
{
  return i % 2 != 0;
}

/// Over the unit disk.
Real DiskMoment(int i, int j)
{
  return IsOdd(i) || IsOdd(j) ? 0 : 2 * Gamma(i + 1) * Gamma(j + 1) / ((i + j + 2) * Gamma(i + j + 2));
}

Moment Box(Real a, Real b, Real c)
{
  return [=](int i, int j, int k)
  { return std::pow(a, i + 1) / (i + 1) * std::pow(b, j + 1) / (j + 1) * std::pow(c, k + 1) / (k + 1); };
}

Moment Ellipsoid(Real a, Real b, Real c)
{
  return [=](int i, int j, int k) -> Real
  {
    const Real unit = IsOdd(i) || IsOdd(j) || IsOdd(k)
      ? 0
      : 2 * Gamma(i + 1) * Gamma(j + 1) * Gamma(k + 1) / ((i + j + k + 3) * Gamma(i + j + k + 3));
    return unit * std::pow(a, i + 1) * std::pow(b, j + 1) * std::pow(c, k + 1);
  };
}

/// About z: the angle's integral times that of distance^(i+j+1) z^k over the disk of radius r at distance R.
Moment Torus(Real R, Real r)
{
  return [=](int i, int j, int k) -> Real
  {
    if (IsOdd(i) || IsOdd(j))
    {
      return 0;
    }
    const int power = i + j + 1;
    Real binomial = 1;
    Real disk = 0;
    for (int m = 0; m <= power; ++m)
    {
      disk += binomial * std::pow(R, power - m) * std::pow(r, m + k + 2) * DiskMoment(m, k);
      binomial = binomial * (power - m) / (m + 1);
    }
    return 2 * Gamma(i + 1) * Gamma(j + 1) / Gamma(i + j + 2) * disk;
  };
}

void CheckMoments(const char* folder, const std::string& solid, int backend, const Moment& exact)
{
  const Expected part = Manifest(folder).GetSolid(solid, "plain")[0];
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(part.Path.c_str());
  UseCoarseMesh(reader);
  vtkNew<vtkSurfaceIntegralGPU> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetBackend(backend);
  std::vector<std::array<int, 3>> powers;
  for (int i = 0; i <= Degree; ++i)
  {
    for (int j = 0; i + j <= Degree; ++j)
    {
      for (int k = 0; i + j + k <= Degree; ++k)
      {
        // A shader of all would take long to compile: every power of each axis is among these.
        if (backend == vtkSurfaceIntegralGPU::CPU || i + j + k == 0 || (i + 2 * j + 5 * k) % 8 == 0)
        {
          powers.push_back({ i, j, k });
        }
      }
    }
  }
  const auto getName = [](const std::array<int, 3>& p)
  { return "x^" + std::to_string(p[0]) + " y^" + std::to_string(p[1]) + " z^" + std::to_string(p[2]); };
  for (const auto& p : powers)
  {
    filter->AddVolumeMoment(getName(p), p[0], p[1], p[2]);
  }
  filter->Update();
  CheckEqual(
    solid + " backend", backend == vtkSurfaceIntegralGPU::CPU ? "cpu" : "opengl", filter->GetBackendName());
  for (const auto& p : powers)
  {
    const double expected = static_cast<double>(exact(p[0], p[1], p[2]));
    const double bound = filter->GetIntegralBound(getName(p));
    // Volume times the size's power.
    const double scale = part.Volume * std::pow(part.Size, p[0] + p[1] + p[2]);
    Check(solid + " " + getName(p), expected, filter->GetIntegral(getName(p)), bound, "the bound");
    CheckRange(solid + " " + getName(p) + " bound", 0.0, bound, 1e-9 * scale);
  }
}
}

int TestHighMoments(int argc, char* argv[])
{
  RequireUsage(argc == 3, "TestHighMoments FOLDER opengl|cpu");
  const int backend =
    std::string(argv[2]) == "cpu" ? vtkSurfaceIntegralGPU::CPU : vtkSurfaceIntegralGPU::OPENGL;
  CheckMoments(argv[1], "box", backend, Box(30, 20, 10));
  CheckMoments(argv[1], "sphere", backend, Ellipsoid(10, 10, 10));
  CheckMoments(argv[1], "ellipsoid", backend, Ellipsoid(15, 10, 5));
  CheckMoments(argv[1], "torus", backend, Torus(20, 6));
  return Finish();
}

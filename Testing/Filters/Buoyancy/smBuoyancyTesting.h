/**
 * @file smBuoyancyTesting.h
 * @brief Waterlines, what is to be below them, and a filter on a file, for the tests of buoyancy
 */
#ifndef smBuoyancyTesting_h
#define smBuoyancyTesting_h

#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkBuoyancy.h>
#include <vtkNURBSTransform.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <string>
#include <utility>

namespace smtest
{
using Real = long double;
using Vector = std::array<Real, 3>;

constexpr Real Pi = 3.14159265358979323846264338327950288L;
/// The backend of all filters.
inline int Backend = vtkBuoyancy::OPENGL;

struct Part
{
  Real Volume = 0;
  /// First moments.
  Vector First{};
};

struct Plane
{
  std::string Name;
  Vector Point{};
  Vector Up{};
  Part Below;
};

inline Vector Scaled(const Vector& a, Real s)
{
  return { a[0] * s, a[1] * s, a[2] * s };
}

inline Vector Sum(const Vector& a, const Vector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline Real Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector Unit(const Vector& a)
{
  return Scaled(a, 1 / std::sqrt(Dot(a, a)));
}

/// The same plane with the other half of the body below it.
inline Plane Opposite(const Plane& plane, const Part& whole)
{
  Plane other = plane;
  other.Name += ", from above";
  other.Up = Scaled(plane.Up, -1);
  other.Below.Volume = whole.Volume - plane.Below.Volume;
  other.Below.First = Sum(whole.First, Scaled(plane.Below.First, -1));
  if (other.Below.Volume < 1e-17L * whole.Volume)
  {
    other.Below = {};
  }
  return other;
}

/// A filter on a file, moved perhaps.
struct Scene
{
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<vtkNURBSTransform> Move;
  vtkNew<vtkBuoyancy> Filter;

  explicit Scene(const std::string& path)
  {
    this->Reader->SetFileName(path.c_str());
    UseCoarseMesh(this->Reader);
    this->Move->SetInputConnection(this->Reader->GetOutputPort());
    this->Filter->SetInputConnection(this->Move->GetOutputPort());
    this->Filter->SetBackend(Backend);
  }
};

inline void SetPlane(vtkBuoyancy* filter, const Plane& plane)
{
  const auto number = [](Real x) { return static_cast<double>(x); };
  filter->SetPoint(number(plane.Point[0]), number(plane.Point[1]), number(plane.Point[2]));
  filter->SetNormal(number(plane.Up[0]), number(plane.Up[1]), number(plane.Up[2]));
}

inline void SetBackend(const char* name)
{
  Backend = std::strcmp(name, "cpu") == 0 ? vtkBuoyancy::CPU : vtkBuoyancy::OPENGL;
}

/// A check by the name of its mode.
using ModeCheck = std::pair<const char*, void (*)(const Manifest&)>;

/// The main function of the test `name` with the arguments FOLDER MODE BACKEND: sets the backend, runs the
/// check of this mode on the solids of the folder, and returns the exit status. A mode that there is not is a
/// failure.
inline int RunMode(int argc, char* argv[], const char* name, std::initializer_list<ModeCheck> checks)
{
  if (argc != 4)
  {
    std::fprintf(stderr, "usage: %s FOLDER MODE BACKEND\n", name);
    return 1;
  }
  SetBackend(argv[3]);
  const Manifest manifest(argv[1]);
  bool found = false;
  for (const auto& [mode, check] : checks)
  {
    if (std::strcmp(mode, argv[2]) == 0)
    {
      found = true;
      check(manifest);
    }
  }
  CheckTrue(std::string("there is a mode ") + argv[2], found);
  return Finish();
}
}

#endif

/**
 * @file smGradientSums.h
 * @brief Directional derivatives from gradients: sums over control points, with the sum of their bounds
 */
#ifndef smGradientSums_h
#define smGradientSums_h

#include "smMomentGradient.h"
#include "smTesting.h"
#include "vtkComputeContext.h"

#include <vtkNew.h>

#include <array>
#include <cmath>
#include <set>
#include <string>

namespace smtest
{
/// Where gradients are computed.
inline sm::BackendChoice GradientTestBackend = sm::BackendChoice::CPU;

/// Computes the gradients there, in one context for all calls.
inline sm::MomentGradientResult ComputeGradient(vtkDataObject* model, sm::MomentGradientOptions options)
{
  static const vtkNew<vtkComputeContext> context;
  options.Backend = GradientTestBackend;
  options.Context = context;
  const sm::MomentGradientResult result = sm::ComputeMomentGradient(model, options);
  if (!result.Faces.empty() && result.Backend != GradientTestBackend)
  {
    CheckTrue("computed where it was asked for", false, result.BackendReason);
  }
  return result;
}

/// A sum of products and the sum of their bounds and roundings.
struct GradientSum
{
  long double Value = 0;
  double Bound = 0.0;

  void Add(double factor, double value, double bound)
  {
    if (factor != 0.0)
    {
      this->Value += static_cast<long double>(factor) * value;
      // The factor itself is rounded a few times.
      this->Bound += std::abs(factor) * bound + 1e-15 * std::abs(factor * value);
    }
  }
};

/// The index of a quantity by its name.
inline int FindQuantity(const std::string& name)
{
  const auto& quantities = sm::GetGradientQuantities();
  for (std::size_t q = 0; q < quantities.size(); ++q)
  {
    if (name == quantities[q].Name)
    {
      return static_cast<int>(q);
    }
  }
  CheckTrue("quantity " + name, false);
  return 0;
}

/// The derivative of quantity q where each control point moves by the vector that direction(face, point)
/// returns, and its bound. With tied variables a variable counts once.
template <class Direction>
GradientSum SumOverPoints(const sm::MomentGradientResult& result, int q, const Direction& direction)
{
  GradientSum sum;
  std::set<std::int64_t> seen;
  for (const sm::FaceMomentGradient& face : result.Faces)
  {
    for (int i = 0; i < face.Count[0]; ++i)
    {
      for (int j = 0; j < face.Count[1]; ++j)
      {
        const std::size_t at = static_cast<std::size_t>(i) * face.Count[1] + j;
        if (!seen.insert(face.PointVariables[at]).second)
        {
          continue;
        }
        const std::array<double, 3> step = direction(face, face.Points[at]);
        for (int c = 0; c < 3; ++c)
        {
          const std::size_t place = face.GetIndex(i, j, c, q);
          sum.Add(step[c], face.Values[place], face.Bounds[place]);
        }
      }
    }
  }
  return sum;
}

/// The derivative of quantity q by a factor of all weights of one face, and its bound.
inline GradientSum SumOverWeights(const sm::FaceMomentGradient& face, int q)
{
  GradientSum sum;
  for (int i = 0; i < face.Count[0]; ++i)
  {
    for (int j = 0; j < face.Count[1]; ++j)
    {
      const std::size_t place = face.GetIndex(i, j, 3, q);
      const double weight = face.Points[static_cast<std::size_t>(i) * face.Count[1] + j][3];
      sum.Add(weight, face.Values[place], face.Bounds[place]);
    }
  }
  return sum;
}
}

#endif

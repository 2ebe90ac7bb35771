/**
 * @file smNetMoments.h
 * @brief Volume, centre and inertia of a solid of whole polynomial faces, by Gauss points that are exact for
 * its degree
 *
 * Nothing of the library's integration is used: the divergence theorem over every knot cell with 8 x 8
 * points, exact for polynomials of degree 15 in u and v; x^2 (r . n) of a bicubic patch has degree 14. The
 * control points may be moved first.
 */
#ifndef smNetMoments_h
#define smNetMoments_h

#include "smGaussRule.h"

#include <smNURBSSurface.h>
#include <vtkTrimmedNURBSModel.h>

#include <array>
#include <cmath>
#include <vector>

namespace smtest
{
class NetMoments
{
public:
  /// Moments of the present faces; the coordinates are those of the stored faces.
  explicit NetMoments(vtkTrimmedNURBSModel* model)
  {
    for (const sm::FacePointer& face : model->GetFaces())
    {
      this->Surfaces.push_back(face->Surface);
      this->Signs.push_back(face->Reversed ? -1.0 : 1.0);
    }
  }

  /// Moves every control point at `at`, to 1e-9, of all faces or of one; returns how many.
  int Move(const std::array<double, 3>& at, const std::array<double, 3>& by, int onlyFace = -1)
  {
    int count = 0;
    for (std::size_t f = 0; f < this->Surfaces.size(); ++f)
    {
      for (std::array<double, 4>& point : this->Surfaces[f].ControlPoints)
      {
        if ((onlyFace < 0 || onlyFace == static_cast<int>(f)) &&
          std::hypot(point[0] - at[0], point[1] - at[1], point[2] - at[2]) < 1e-9)
        {
          for (int c = 0; c < 3; ++c)
          {
            point[c] += by[c];
          }
          ++count;
        }
      }
    }
    return count;
  }

  void Integrate()
  {
    const GaussRule rule = MakeGaussRule(8);
    Real volume = 0;
    Real first[3] = {};
    Real second[6] = {}; // XX YY ZZ XY YZ XZ
    for (std::size_t f = 0; f < this->Surfaces.size(); ++f)
    {
      const sm::NURBSSurface& surface = this->Surfaces[f];
      const std::vector<double> u = surface.GetSpanBreaks(0);
      const std::vector<double> v = surface.GetSpanBreaks(1);
      for (std::size_t k = 0; k < (u.size() - 1) * (v.size() - 1) * 64; ++k)
      {
        const std::size_t cell = k / 64;
        const std::size_t i = cell % (u.size() - 1);
        const std::size_t j = cell / (u.size() - 1);
        const Real s = rule.Nodes[k % 8];
        const Real r = rule.Nodes[k / 8 % 8];
        double p[3];
        double du[3];
        double dv[3];
        surface.Evaluate(static_cast<double>(u[i] + s * (u[i + 1] - u[i])),
          static_cast<double>(v[j] + r * (v[j + 1] - v[j])), p, du, dv);
        const Real weight = this->Signs[f] * rule.Weights[k % 8] * rule.Weights[k / 8 % 8] *
          (u[i + 1] - u[i]) * (v[j + 1] - v[j]);
        const Real n[3] = { Real(du[1]) * dv[2] - Real(du[2]) * dv[1],
          Real(du[2]) * dv[0] - Real(du[0]) * dv[2], Real(du[0]) * dv[1] - Real(du[1]) * dv[0] };
        const Real flux = weight * (p[0] * n[0] + p[1] * n[1] + p[2] * n[2]);
        volume += flux / 3;
        for (int c = 0; c < 3; ++c)
        {
          first[c] += flux * p[c] / 4;
          second[c] += flux * p[c] * p[c] / 5;
          second[3 + c] += flux * p[c] * p[(c + 1) % 3] / 5;
        }
      }
    }
    this->Volume = static_cast<double>(volume);
    Real about[6];
    for (int c = 0; c < 3; ++c)
    {
      const int d = (c + 1) % 3;
      this->Center[c] = static_cast<double>(first[c] / volume);
      about[c] = second[c] - first[c] * first[c] / volume;
      about[3 + c] = second[3 + c] - first[c] * first[d] / volume;
    }
    for (int c = 0; c < 3; ++c)
    {
      const int d = (c + 1) % 3;
      this->Inertia[c][c] = static_cast<double>(about[(c + 1) % 3] + about[(c + 2) % 3]);
      this->Inertia[c][d] = this->Inertia[d][c] = static_cast<double>(-about[3 + c]);
    }
  }

  double Volume = 0.0;
  double Center[3] = {};
  double Inertia[3][3] = {};

private:
  std::vector<sm::NURBSSurface> Surfaces;
  std::vector<double> Signs;
};
}

#endif

#include "smShapeBounds.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Number of parts of each span of a curve, and of a surface in each direction, at whose ends it is
/// evaluated.
constexpr int Parts = 16;

class Box
{
public:
  void Add(const Vector3& p)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Low[c] = std::min(this->Low[c], p[c]);
      this->High[c] = std::max(this->High[c], p[c]);
    }
  }

  void Add(const EdgeShape& edge)
  {
    if (!edge.HasCurve())
    {
      return;
    }
    const bool isLine = edge.Curve->GetIf<LineCurve<3>>() != nullptr;
    const std::vector<double> breaks = edge.Curve->GetBreaks(edge.First, edge.Last);
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    {
      for (int i = 0; i <= (isLine ? 1 : Parts); ++i)
      {
        const double x = static_cast<double>(i) / (isLine ? 1 : Parts);
        this->Add(edge.Evaluate((1.0 - x) * breaks[k] + x * breaks[k + 1]));
      }
    }
  }

  /// Adds points of a surface; returns false for one without ends.
  bool Add(const FaceShape& face)
  {
    const ParameterRange domain[2] = { face.GetDomain(0), face.GetDomain(1) };
    for (const ParameterRange& d : domain)
    {
      if (!std::isfinite(d.Low) || !std::isfinite(d.High))
      {
        return false;
      }
    }
    for (int i = 0; i <= Parts; ++i)
    {
      for (int j = 0; j <= Parts; ++j)
      {
        const double u = domain[0].Low + i * (domain[0].High - domain[0].Low) / Parts;
        const double v = domain[1].Low + j * (domain[1].High - domain[1].Low) / Parts;
        this->Add(face.Location.MapPoint(face.Surface->Evaluate(u, v)));
      }
    }
    return true;
  }

  Vector3 Low{ 1e300, 1e300, 1e300 };
  Vector3 High{ -1e300, -1e300, -1e300 };
};
}

bool GetShapeBounds(const BodyShape& body, double bounds[6], int* unbounded)
{
  Box box;
  EdgeIndex edges;
  int skipped = 0;
  body.VisitFaces(
    [&](const FaceUse& use)
    {
      bool hasEdges = false;
      for (const WireShape& wire : use.Face->Wires)
      {
        for (const CoedgeShape& coedge : wire.Coedges)
        {
          hasEdges = hasEdges || coedge.Edge->HasCurve();
          if (edges.Find(coedge.Edge.get()) < 0)
          {
            edges.Add(coedge.Edge.get());
            box.Add(*coedge.Edge);
          }
        }
      }
      skipped += hasEdges || (use.Face->Surface && box.Add(*use.Face)) ? 0 : 1;
    });
  for (int c = 0; c < 3; ++c)
  {
    bounds[2 * c] = box.Low[c];
    bounds[2 * c + 1] = box.High[c];
  }
  if (unbounded)
  {
    *unbounded = skipped;
  }
  return box.Low[0] <= box.High[0];
}
}

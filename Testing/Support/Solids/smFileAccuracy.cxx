#include "smFileAccuracy.h"

#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace smtest
{
namespace
{
constexpr double UnitRoundoff = 1.1102230246251565e-16;

double GetDistance(const ExactMoments& moments)
{
  const Vector& c = moments.Center;
  return static_cast<double>(std::sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]));
}

/// Compares points of the moved shape with the exact placement of the original's.
class Comparison
{
public:
  explicit Comparison(const Placement& placement)
    : Move(placement)
  {
  }

  void Add(const gp_Pnt& original, const gp_Pnt& moved)
  {
    Real square = 0;
    for (int i = 0; i < 3; ++i)
    {
      Real exact = this->Move.Translation[i];
      for (int j = 0; j < 3; ++j)
      {
        exact += this->Move.Scale * this->Move.Rotation[i][j] * original.Coord(j + 1);
      }
      square += (moved.Coord(i + 1) - exact) * (moved.Coord(i + 1) - exact);
    }
    this->Largest = std::max(this->Largest, static_cast<double>(std::sqrt(square)));
  }

  void Add(const TopoDS_Face& original, const TopoDS_Face& moved)
  {
    const auto a = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(original));
    const auto b = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(moved));
    this->HasPoles = this->HasPoles && !a.IsNull() && !b.IsNull();
    for (int i = 1; !a.IsNull() && !b.IsNull() && i <= a->NbUPoles(); ++i)
    {
      for (int j = 1; j <= a->NbVPoles(); ++j)
      {
        this->Add(a->Pole(i, j), b->Pole(i, j));
      }
    }
  }

  void Add(const TopoDS_Edge& original, const TopoDS_Edge& moved)
  {
    double low = 0;
    double high = 0;
    const auto a = Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(original, low, high));
    const auto b = Handle(Geom_BSplineCurve)::DownCast(BRep_Tool::Curve(moved, low, high));
    for (int i = 1; !a.IsNull() && !b.IsNull() && i <= a->NbPoles(); ++i)
    {
      this->Add(a->Pole(i), b->Pole(i));
    }
  }

  const Placement& Move;
  double Largest = 0;
  /// All surfaces are B-splines.
  bool HasPoles = true;
};
}

FileAccuracy GetFileAccuracy(const ExactMoments& moments, double size, double displacement)
{
  const double volume = static_cast<double>(moments.Volume);
  const double area = static_cast<double>(moments.Area);
  FileAccuracy accuracy;
  accuracy.Volume = displacement * area;
  accuracy.Area = 2 * displacement * area / size * std::max(1.0, area * size / volume);
  accuracy.Center = displacement * (1.0 + area * size / volume);
  accuracy.Inertia = displacement * area * size * size;
  return accuracy;
}

double GetShortFormatDisplacement(const ExactMoments& moments, double size)
{
  // 12 digits after the point or, outside [0.1, 1000], 13 significant ones; a direction of 12 digits tilts a
  // plane by 5e-13 of its size.
  return 1e-12 * (1 + size) + 1e-12 * GetDistance(moments);
}

double GetDisplacement(const TopoDS_Shape& original, const TopoDS_Shape& moved, const Placement& placement,
  const ExactMoments& moments, double size)
{
  Comparison comparison(placement);
  for (const TopAbs_ShapeEnum type : { TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX })
  {
    TopExp_Explorer a(original, type);
    TopExp_Explorer b(moved, type);
    for (; a.More() && b.More(); a.Next(), b.Next())
    {
      if (type == TopAbs_FACE)
      {
        comparison.Add(TopoDS::Face(a.Current()), TopoDS::Face(b.Current()));
      }
      else if (type == TopAbs_EDGE)
      {
        comparison.Add(TopoDS::Edge(a.Current()), TopoDS::Edge(b.Current()));
      }
      else
      {
        comparison.Add(
          BRep_Tool::Pnt(TopoDS::Vertex(a.Current())), BRep_Tool::Pnt(TopoDS::Vertex(b.Current())));
      }
    }
    if (a.More() || b.More())
    {
      throw std::runtime_error("moving a shape has changed its parts");
    }
  }
  // The catalogue's own poles are rounded to doubles; weights, angles and directions too.
  const double own = 8 * UnitRoundoff * size;
  // An axis or a basis curve is a rounding of its coordinates away, and one more for what is added to it.
  const double unseen = comparison.HasPoles ? 0.0 : 2.25 * UnitRoundoff * GetDistance(moments);
  return own + comparison.Largest + unseen;
}
}

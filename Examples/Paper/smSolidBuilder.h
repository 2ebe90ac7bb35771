/**
 * @file smSolidBuilder.h
 * @brief Faces joined along edges, from surfaces and curves given as functions
 */
#ifndef smSolidBuilder_h
#define smSolidBuilder_h

#include <smFace.h>
#include <vtkNURBSDataSet.h>
#include <vtkSmartPointer.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace smfigure
{
using Point2 = std::array<double, 2>;
using Point3 = std::array<double, 3>;

/// Polynomial pieces that interpolate the function on `pieces` equal parts of [start, end]. The residual is
/// the largest distance sampled between the interpolation points.
template <int Dimension>
sm::PolynomialCurve<Dimension> FitCurve(
  const std::function<std::array<double, Dimension>(double)>& function, double start, double end, int pieces);

/// A straight line over [0,1].
template <int Dimension>
sm::PolynomialCurve<Dimension> MakeLine(
  const std::array<double, Dimension>& from, const std::array<double, Dimension>& to);

class SolidBuilder
{
public:
  using EdgePointer = std::shared_ptr<const sm::Edge>;

  EdgePointer AddEdge(const sm::EdgeCurve& curve);
  /// The straight edge between two points; further calls, in either direction, return the same edge.
  EdgePointer GetStraightEdge(const Point3& from, const Point3& to);

  static sm::Coedge MakeCoedge(const EdgePointer& edge, bool reversed, const sm::TrimCurve& curve);
  /// The coedge of the straight edge between two points that are at from2 and to2 on the face, in the
  /// direction from -> to.
  sm::Coedge MakeStraightCoedge(const Point3& from, const Point3& to, const Point2& from2, const Point2& to2);

  void AddFace(sm::NURBSSurface surface, std::vector<sm::Loop> loops, bool reversed = false);
  /// A parallelogram with straight edges, corners counter-clockwise seen from outside, u from corner 0 to 1;
  /// holes as loops.
  void AddPlane(const Point3 (&corners)[4], std::vector<sm::Loop> holes = {});

  /// The faces as one body about the origin, in a data set that has the corners of its box as points and no
  /// display mesh.
  vtkSmartPointer<vtkNURBSDataSet> Make(const char* name, bool solid, const double bounds[6]) const;

private:
  std::vector<sm::FacePointer> Faces;
  std::vector<EdgePointer> StraightEdges;
};

/// A parallelogram's bilinear surface over [0,1] x [0,1].
sm::NURBSSurface MakePlaneSurface(const Point3 (&corners)[4]);
}

#endif

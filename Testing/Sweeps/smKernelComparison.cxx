#include "smKernelComparison.h"

#include "smOCCTBounds.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_Surface.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <sstream>

namespace smtest
{
namespace
{
double Distance(const sm::Vector3& a, const double b[3])
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// The point of a plane below `p`.
sm::Vector3 GetFoot(const sm::Vector3& p, const Handle(Geom_Surface) & surface, const sm::AffineMap& map)
{
  const gp_Ax3& frame = Handle(Geom_Plane)::DownCast(surface)->Position();
  const sm::Vector3 o = map.MapPoint(frame.Location().XYZ());
  const sm::Vector3 n = map.MapVector(frame.Direction().XYZ());
  const double height = (p[0] - o[0]) * n[0] + (p[1] - o[1]) * n[1] + (p[2] - o[2]) * n[2];
  return { p[0] - height * n[0], p[1] - height * n[1], p[2] - height * n[2] };
}

/// The point of a sphere nearest to `p`.
sm::Vector3 GetFootOnSphere(
  const double p[3], const Handle(Geom_SphericalSurface) & sphere, const sm::AffineMap& map)
{
  const sm::Vector3 o = map.MapPoint(sphere->Location().XYZ());
  const double stretch = sphere->Radius() * map.GetScale() / Distance(o, p);
  return { o[0] + stretch * (p[0] - o[0]), o[1] + stretch * (p[1] - o[1]), o[2] + stretch * (p[2] - o[2]) };
}

/// OpenCASCADE's trim curve of a coedge.
struct NativeTrim
{
  Handle(Geom2d_Curve) Curve;
  double First = 0.0;
  double Last = 0.0;
  /// True if the file has the curve; otherwise OpenCASCADE computes one, on a plane only, with another
  /// parametrisation than the edge's.
  Standard_Boolean Stored = false;

  NativeTrim(const TopoDS_Edge& edge, const TopoDS_Face& face)
  {
    this->Curve = BRep_Tool::CurveOnSurface(edge, face, this->First, this->Last, &this->Stored);
  }
};

/// The point of the trim curve that is nearest to `point`, near parameter t: a curve whose 2D and 3D
/// parametrisations differ was given another parameter, and is to be the same curve.
sm::Vector3 GetNearest(const NativeTrim& trim, const Handle(Geom_Surface) & surface, const sm::AffineMap& map,
  double t, const double* point)
{
  sm::Vector3 nearest{};
  for (int step = 0; step < 8; ++step)
  {
    gp_Pnt2d uv;
    gp_Vec2d slope;
    trim.Curve->D1(t, uv, slope);
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    surface->D1(uv.X(), uv.Y(), p, du, dv);
    const gp_Vec along = du * slope.X() + dv * slope.Y();
    nearest = map.MapPoint(p.XYZ());
    const sm::Vector3 ahead = map.MapPoint(p.XYZ() + along.XYZ());
    double dot = 0.0;
    double squared = 0.0;
    for (int d = 0; d < 3; ++d)
    {
      const double tangent = ahead[d] - nearest[d];
      dot += (point[d] - nearest[d]) * tangent;
      squared += tangent * tangent;
    }
    t = std::clamp(t + (squared > 0.0 ? dot / squared : 0.0), trim.First, trim.Last);
  }
  return nearest;
}

/// One body: its distances and messages go to the result of the file.
class BodyComparison
{
public:
  BodyComparison(const sm::PartBody& part, const sm::ShapeTable& table, KernelComparison& result)
    : Trsf(part.Scale)
    , Result(result)
  {
    double bounds[6] = { 0, 0, 0, 0, 0, 0 };
    if (!sm::IsAsInFile(part.Shape, table) || !sm::GetEdgeBounds(part.Shape, bounds))
    {
      sm::GetShapeBounds(part.Shape, bounds);
    }
    for (int d = 0; d < 3; ++d)
    {
      this->Origin[d] = 0.5 * (bounds[2 * d] + bounds[2 * d + 1]);
    }
    this->Size = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]) +
      std::hypot(this->Origin[0], this->Origin[1], this->Origin[2]);
    this->Body = sm::ConvertBody(part.Shape, part.Scale, 1.0, this->Origin, table);
    result.MissingFaces += this->Body.MissingFaces;
    result.Defects += this->Body.Defects;
    result.Messages.insert(result.Messages.end(), this->Body.Messages.begin(), this->Body.Messages.end());
  }

  void Compare(std::mt19937& random)
  {
    for (const sm::ConvertedFace& face : this->Body.Faces)
    {
      TopLoc_Location location;
      const Handle(Geom_Surface) surface = sm::GetBasisSurface(BRep_Tool::Surface(face.Source, location));
      const sm::AffineMap map =
        sm::AffineMap::Make(this->Trsf * location.Transformation(), 1.0, this->Origin);
      FaceTally& tally = this->Result.Tallies[surface->DynamicType()->Name()];
      ++tally.Faces;
      for (int i = 0; i < 12; ++i)
      {
        this->CompareSurface(face, surface, map, random, tally);
      }
      this->ForEachCoedge(face,
        [&](const sm::Coedge& coedge, const TopoDS_Edge& edge)
        {
          this->CompareTrim(face, surface, map, coedge, edge, tally);
          this->CompareEdge(face, coedge, edge);
        });
    }
  }

  int GetNumberOfFaces() const { return static_cast<int>(this->Body.Faces.size()); }

  /// Edges whose signed uses do not cancel; after Compare().
  int GetNumberOfOpenEdges() const
  {
    return static_cast<int>(
      std::count_if(this->Uses.begin(), this->Uses.end(), [](const auto& use) { return use.second != 0; }));
  }

private:
  template <typename Function>
  void ForEachCoedge(const sm::ConvertedFace& face, const Function& function)
  {
    for (std::size_t l = 0; l < face.Result->Loops.size(); ++l)
    {
      const sm::Loop& loop = face.Result->Loops[l];
      for (std::size_t k = 0; k < loop.Coedges.size(); ++k)
      {
        // Poles and seams that the file leaves out are edges of the reader's own.
        if (!face.SourceEdges[l][k].IsNull())
        {
          function(loop.Coedges[k], face.SourceEdges[l][k]);
        }
      }
    }
  }

  void CompareSurface(const sm::ConvertedFace& face, const Handle(Geom_Surface) & surface,
    const sm::AffineMap& map, std::mt19937& random, FaceTally& tally)
  {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    double native[2];
    double ours[2];
    for (int d = 0; d < 2; ++d)
    {
      const sm::ParameterMap& m = face.Map[d];
      const bool bent = m.Type != sm::ParameterMap::Kind::Identity;
      const double low = bent ? m.Start : face.Result->Surface.GetDomainStart(d);
      const double high = bent ? m.GetBorder(m.Count) : face.Result->Surface.GetDomainEnd(d);
      const double x = uniform(random);
      native[d] = (1.0 - x) * low + x * high;
      ours[d] = m.Evaluate(native[d]);
    }
    sm::Vector3 expected = map.MapPoint(surface->Value(native[0], native[1]).XYZ());
    double actual[3];
    face.Result->Surface.Evaluate(ours[0], ours[1], actual);
    const auto sphere = Handle(Geom_SphericalSurface)::DownCast(surface);
    if (!sphere.IsNull() && !(Distance(expected, actual) <= SurfaceLimit * this->Size))
    {
      // Where a pole lay on an edge the reader's sphere has other poles.
      expected = GetFootOnSphere(actual, sphere, map);
    }
    // A surface may reach far beyond the body it bounds.
    double reach = std::max(this->Size, std::hypot(expected[0], expected[1], expected[2]));
    if (Handle(Geom_ElementarySurface)::DownCast(surface))
    {
      // Some systems put the origin of a cylinder half a kilometre from its face; everybody rounds there.
      reach = std::max(reach, std::abs(native[1]));
    }
    const double error = Distance(expected, actual) / reach;
    tally.Surface = std::max(tally.Surface, error);
    this->Result.Surface = std::max(this->Result.Surface, error);
    if (!(error <= SurfaceLimit))
    {
      std::ostringstream line;
      line << "surface of face #" << face.Result->FileId << " (" << surface->DynamicType()->Name() << ") at "
           << native[0] << " " << native[1] << ": " << error;
      this->Result.Messages.push_back(line.str());
      ++this->Result.AboveLimits;
    }
  }

  void CompareTrim(const sm::ConvertedFace& face, const Handle(Geom_Surface) & surface,
    const sm::AffineMap& map, const sm::Coedge& coedge, const TopoDS_Edge& edge, FaceTally& tally)
  {
    KernelComparison& result = this->Result;
    result.TrimPieces += coedge.Curve.GetNumberOfPieces();
    result.TrimResidual = std::max(result.TrimResidual, coedge.Curve.GetLargestResidual());
    const NativeTrim native(edge, face.Source);
    for (const double x : { 0.0, 0.25, 0.5, 1.0 })
    {
      // Also where the file gives no curve, and none was made.
      const double t = (1.0 - x) * coedge.Curve.GetStart() + x * coedge.Curve.GetEnd();
      const auto c = coedge.Curve.Evaluate(t);
      double actual[3];
      face.Result->Surface.Evaluate(c[0], c[1], actual);
      if (!coedge.Use->Degenerate)
      {
        result.MaxGap = std::max(result.MaxGap, Distance(coedge.Use->Curve.Evaluate(t), actual));
      }
    }
    if (native.Curve.IsNull())
    {
      return;
    }
    for (const double x : { 0.0, 0.137, 0.5, 0.811, 1.0 })
    {
      const double t = (1.0 - x) * coedge.Curve.GetStart() + x * coedge.Curve.GetEnd();
      const double nativeT = (1.0 - x) * native.First + x * native.Last;
      const gp_Pnt2d uv = native.Curve->Value(nativeT);
      // Without a stored curve the truth is the foot of the edge's point.
      const sm::Vector3 expected = native.Stored ? map.MapPoint(surface->Value(uv.X(), uv.Y()).XYZ())
                                                 : GetFoot(coedge.Use->Curve.Evaluate(t), surface, map);
      const auto c = coedge.Curve.Evaluate(t);
      double actual[3];
      face.Result->Surface.Evaluate(c[0], c[1], actual);
      if (!coedge.Use->Degenerate)
      {
        result.MaxGap = std::max(result.MaxGap, Distance(coedge.Use->Curve.Evaluate(t), actual));
      }
      double error = Distance(expected, actual) / this->Size;
      if (error > TrimLimit && native.Stored)
      {
        error = Distance(GetNearest(native, surface, map, nativeT, actual), actual) / this->Size;
      }
      tally.Trim = std::max(tally.Trim, error);
      result.Trim = std::max(result.Trim, error);
      if (!(error <= TrimLimit))
      {
        std::ostringstream line;
        line << "trim of face #" << face.Result->FileId << " (" << surface->DynamicType()->Name()
             << "), edge #" << coedge.Use->FileId << ", x=" << x << ": " << error << "; native " << uv.X()
             << " " << uv.Y() << " ours " << c[0] << " " << c[1] << " residual "
             << coedge.Curve.GetLargestResidual();
        result.Messages.push_back(line.str());
        ++result.AboveLimits;
      }
    }
  }

  /// Compares every edge once, and adds up the signs of its uses.
  void CompareEdge(const sm::ConvertedFace& face, const sm::Coedge& coedge, const TopoDS_Edge& edge)
  {
    if (coedge.Use->Degenerate)
    {
      return;
    }
    KernelComparison& result = this->Result;
    const bool known = this->Uses.count(coedge.Use.get()) > 0;
    this->Uses[coedge.Use.get()] += coedge.Reversed != face.Result->Reversed ? -1 : 1;
    TopLoc_Location location;
    double first;
    double last;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, location, first, last);
    if (known || curve.IsNull())
    {
      return;
    }
    result.EdgePieces += coedge.Use->Curve.GetNumberOfPieces();
    const sm::AffineMap map = sm::AffineMap::Make(this->Trsf * location.Transformation(), 1.0, this->Origin);
    for (const double x : { 0.0, 0.137, 0.333, 0.5, 0.811, 1.0 })
    {
      const double t = (1.0 - x) * first + x * last;
      const sm::Vector3 expected = map.MapPoint(curve->Value(t).XYZ());
      const double error = Distance(expected, coedge.Use->Curve.Evaluate(t).data()) /
        std::max(this->Size, 4.0 * std::abs(first));
      result.Edge = std::max(result.Edge, error);
      if (!(error <= EdgeLimit))
      {
        std::ostringstream line;
        line << "edge #" << coedge.Use->FileId << " (" << curve->DynamicType()->Name() << "), x=" << x << ": "
             << error << ", range " << first << " " << last << ", residual "
             << coedge.Use->Curve.GetLargestResidual();
        result.Messages.push_back(line.str());
        ++result.AboveLimits;
      }
    }
  }

  gp_Trsf Trsf;
  double Origin[3];
  /// Size of the body, plus its distance from the part's origin.
  double Size = 0.0;
  sm::ConvertedBody Body;
  std::map<const sm::Edge*, int> Uses;
  KernelComparison& Result;
};
}

KernelComparison CompareWithKernel(const sm::Document& document)
{
  KernelComparison result;
  std::mt19937 random(20240607);
  std::vector<std::array<int, 2>> counts;
  for (const sm::PartBody& part : document.Bodies)
  {
    BodyComparison body(part, document.Table, result);
    body.Compare(random);
    counts.push_back({ body.GetNumberOfFaces(), body.GetNumberOfOpenEdges() });
  }
  for (const sm::BodyInstance& instance : document.Instances)
  {
    (document.Bodies[instance.Body].Solid ? result.Solids : result.Shells) += 1;
    result.Faces += counts[instance.Body][0];
    result.OpenEdges += counts[instance.Body][1];
  }
  result.Faces += document.FreeFaces;
  return result;
}
}

#include "smKernelComparison.h"

#include "Shapes/smShapeBounds.h"
#include "smBodyConversion.h"
#include "smOCCTMakeGeometry.h"

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

/// A curve of the file in the parameters of a face, as OpenCASCADE evaluates it; one of several parts, of
/// which OpenCASCADE has no kind, as its own value does.
class StoredTrim
{
public:
  explicit StoredTrim(const sm::CoedgeShape& coedge)
    : First(coedge.First)
    , Last(coedge.Last)
    , Value(coedge.Trim)
  {
    if (this->Value && !this->Value->GetIf<sm::CompositeCurve<2>>())
    {
      this->Curve = sm::MakeKernelCurve(*this->Value);
    }
  }

  /// False if the file has no such curve.
  bool IsStored() const { return this->Value != nullptr; }

  void Evaluate(double t, gp_Pnt2d& point, gp_Vec2d& slope) const
  {
    if (!this->Curve.IsNull())
    {
      this->Curve->D1(t, point, slope);
      return;
    }
    sm::GeometricCurve<2>::Derivatives d;
    this->Value->Evaluate(t, 1, d);
    point.SetCoord(d[0][0], d[0][1]);
    slope.SetCoord(d[1][0], d[1][1]);
  }

  double First;
  double Last;

private:
  sm::CurvePointer<2> Value;
  Handle(Geom2d_Curve) Curve;
};

/// The point of the trim curve that is nearest to `point`, near parameter t: a curve whose 2D and 3D
/// parametrisations differ was given another parameter, and is to be the same curve.
sm::Vector3 GetNearest(const StoredTrim& trim, const Handle(Geom_Surface) & surface, const sm::AffineMap& map,
  double t, const double* point)
{
  sm::Vector3 nearest{};
  for (int step = 0; step < 8; ++step)
  {
    gp_Pnt2d uv;
    gp_Vec2d slope;
    trim.Evaluate(t, uv, slope);
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

/// The use in the file that a coedge was made of: that of the same edge, in the same direction if the face
/// uses it in both, and over the same range if a repair has divided the edge. Null for edges of the reader's
/// own.
const sm::CoedgeShape* FindSource(const sm::FaceShape& face, const sm::Coedge& coedge)
{
  const sm::CoedgeShape* best = nullptr;
  int bestScore = -1;
  for (const sm::WireShape& wire : face.Wires)
  {
    for (const sm::CoedgeShape& source : wire.Coedges)
    {
      const bool isSame = coedge.Use->FileId != 0 && source.Edge->Data.FileId == coedge.Use->FileId;
      const bool hasRange =
        source.Edge->First == coedge.Use->Curve.GetStart() && source.Edge->Last == coedge.Use->Curve.GetEnd();
      const int score = (hasRange ? 2 : 0) + (source.Reversed == coedge.Reversed ? 1 : 0);
      if (isSame && score > bestScore)
      {
        best = &source;
        bestScore = score;
      }
    }
  }
  return best;
}

/// The surface that a converted face was made of: that of the file, where the face is within one period of
/// it, and otherwise the periodic one that was made of it.
const sm::SurfacePointer& GetSurface(const sm::ConvertedFace& face)
{
  const sm::FaceShape& source = *face.Source;
  if (!source.Own.Surface)
  {
    return source.Surface;
  }
  sm::NativeBox box;
  for (int d = 0; d < 2; ++d)
  {
    box.Low[d] = face.Result->Surface.GetDomainStart(d);
    box.High[d] = face.Result->Surface.GetDomainEnd(d);
  }
  return sm::CoverBox(source.Own, source.Surface, box) ? source.Own.Surface : source.Surface;
}

/// One body: its distances and messages go to the result of the file.
class BodyComparison
{
public:
  BodyComparison(const sm::PartBody& part, KernelComparison& result)
    : Scale(part.Scale)
    , Result(result)
  {
    double bounds[6];
    if (!sm::GetShapeBounds(part.Shape, bounds))
    {
      std::fill(bounds, bounds + 6, 0.0);
    }
    for (int d = 0; d < 3; ++d)
    {
      this->Origin[d] = 0.5 * (bounds[2 * d] + bounds[2 * d + 1]);
    }
    this->Size = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]) +
      std::hypot(this->Origin[0], this->Origin[1], this->Origin[2]);
    this->Body = sm::ConvertBody(part.Shape, part.Scale, 1.0, this->Origin);
    result.MissingFaces += this->Body.MissingFaces;
    result.Defects += this->Body.Defects;
    result.Messages.insert(result.Messages.end(), this->Body.Messages.begin(), this->Body.Messages.end());
  }

  void Compare(std::mt19937& random)
  {
    for (const sm::ConvertedFace& face : this->Body.Faces)
    {
      const Handle(Geom_Surface) surface = sm::MakeKernelSurface(*GetSurface(face));
      const sm::AffineMap map = this->MakeMap(face.Source->Location);
      FaceTally& tally = this->Result.Tallies[surface->DynamicType()->Name()];
      ++tally.Faces;
      for (int i = 0; i < 12; ++i)
      {
        this->CompareSurface(face, surface, map, random, tally);
      }
      for (const sm::Loop& loop : face.Result->Loops)
      {
        for (const sm::Coedge& coedge : loop.Coedges)
        {
          // Poles and seams that the file leaves out are edges of the reader's own.
          if (const sm::CoedgeShape* source = FindSource(*face.Source, coedge))
          {
            this->CompareTrim(face, surface, map, coedge, *source, tally);
            this->CompareEdge(face, coedge, *source->Edge);
          }
        }
      }
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
  /// From the coordinates of a shape with this location to those of the converted body.
  sm::AffineMap MakeMap(const sm::Placement& location) const
  {
    sm::AffineMap map = sm::Compose(this->Scale, location);
    for (int d = 0; d < 3; ++d)
    {
      map.Translation[d] -= this->Origin[d];
    }
    return map;
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
    const sm::AffineMap& map, const sm::Coedge& coedge, const sm::CoedgeShape& source, FaceTally& tally)
  {
    KernelComparison& result = this->Result;
    result.TrimPieces += coedge.Curve.GetNumberOfPieces();
    result.TrimResidual = std::max(result.TrimResidual, coedge.Curve.GetMaxResidual());
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
    const StoredTrim native(source);
    if (!native.IsStored() && Handle(Geom_Plane)::DownCast(surface).IsNull())
    {
      return;
    }
    for (const double x : { 0.0, 0.137, 0.5, 0.811, 1.0 })
    {
      const double t = (1.0 - x) * coedge.Curve.GetStart() + x * coedge.Curve.GetEnd();
      const double nativeT = (1.0 - x) * native.First + x * native.Last;
      gp_Pnt2d uv;
      gp_Vec2d slope;
      if (native.IsStored())
      {
        native.Evaluate(nativeT, uv, slope);
      }
      // Without a stored curve the truth is the foot of the edge's point.
      const sm::Vector3 expected = native.IsStored() ? map.MapPoint(surface->Value(uv.X(), uv.Y()).XYZ())
                                                     : GetFoot(coedge.Use->Curve.Evaluate(t), surface, map);
      const auto c = coedge.Curve.Evaluate(t);
      double actual[3];
      face.Result->Surface.Evaluate(c[0], c[1], actual);
      if (!coedge.Use->Degenerate)
      {
        result.MaxGap = std::max(result.MaxGap, Distance(coedge.Use->Curve.Evaluate(t), actual));
      }
      double error = Distance(expected, actual) / this->Size;
      if (error > TrimLimit && native.IsStored())
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
             << coedge.Curve.GetMaxResidual();
        result.Messages.push_back(line.str());
        ++result.AboveLimits;
      }
    }
  }

  /// Compares every edge once, and adds up the signs of its uses.
  void CompareEdge(const sm::ConvertedFace& face, const sm::Coedge& coedge, const sm::EdgeShape& edge)
  {
    if (coedge.Use->Degenerate)
    {
      return;
    }
    KernelComparison& result = this->Result;
    const bool known = this->Uses.count(coedge.Use.get()) > 0;
    this->Uses[coedge.Use.get()] += coedge.Reversed != face.Result->Reversed ? -1 : 1;
    if (known || !edge.Curve)
    {
      return;
    }
    // A curve of several parts, or on a surface, of which OpenCASCADE has no kind, by its own evaluation.
    const bool isOwn = edge.Curve->GetIf<sm::CompositeCurve<3>>() || edge.Curve->GetIf<sm::CurveOnSurface>();
    const Handle(Geom_Curve) curve = isOwn ? Handle(Geom_Curve)() : sm::MakeKernelCurve(*edge.Curve);
    const double first = edge.First;
    const double last = edge.Last;
    result.EdgePieces += coedge.Use->Curve.GetNumberOfPieces();
    const sm::AffineMap map = this->MakeMap(edge.Location);
    for (const double x : { 0.0, 0.137, 0.333, 0.5, 0.811, 1.0 })
    {
      const double t = (1.0 - x) * first + x * last;
      const sm::Vector3 expected =
        isOwn ? map.MapPoint(edge.Curve->Evaluate(t)) : map.MapPoint(curve->Value(t).XYZ());
      const double error = Distance(expected, coedge.Use->Curve.Evaluate(t).data()) /
        std::max(this->Size, 4.0 * std::abs(first));
      result.Edge = std::max(result.Edge, error);
      if (!(error <= EdgeLimit))
      {
        std::ostringstream line;
        line << "edge #" << coedge.Use->FileId << " ("
             << (isOwn ? "of several parts" : curve->DynamicType()->Name()) << "), x=" << x << ": " << error
             << ", range " << first << " " << last << ", residual " << coedge.Use->Curve.GetMaxResidual();
        result.Messages.push_back(line.str());
        ++result.AboveLimits;
      }
    }
  }

  sm::Placement Scale;
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
    BodyComparison body(part, result);
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

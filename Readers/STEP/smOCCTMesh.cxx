#include "smOCCTMesh.h"

#include "smFormat.h"
#include "smOCCTFailure.h"
#include "smOCCTFile.h"
#include "smOCCTGridMesh.h"
#include "smVector.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
/// Per direction, of the grid that stands in where the kernel's mesher fails.
constexpr int GridCells = 160;
/// The same where many faces need it.
constexpr int FewGridCells = 24;
constexpr int ManyFaces = 20;

/// Share of the mesher's time for a body that one face gets after the mesher was stopped.
constexpr double FaceShare = 0.1;

/// A unit vector, or zero when `v` is too short to have a direction.
Vector3 Normalized(const Vector3& v, double least)
{
  const double length = Norm(v);
  return length > least ? Vector3{ v[0] / length, v[1] / length, v[2] / length } : Vector3{ 0.0, 0.0, 0.0 };
}

/// Native parameter of a mesh node to ours; a node beyond the domain comes back by whole periods.
double MapParameter(const ConvertedFace& face, int direction, double native)
{
  const ParameterMap& map = face.Map[direction];
  const NURBSSurface& surface = face.Result->Surface;
  const bool bent = map.Type != ParameterMap::Kind::Identity;
  const double low = bent ? map.Start : surface.GetDomainStart(direction);
  const double high = bent ? map.GetBorder(map.Count) : surface.GetDomainEnd(direction);
  const double period = face.Period[direction];
  if (period > 0.0)
  {
    const double slack = 1e-6 * period;
    if (native < low - slack)
    {
      native += period *
        std::max(0.0,
          std::min(std::ceil((low - slack - native) / period), std::floor((high + slack - native) / period)));
    }
    else if (native > high + slack)
    {
      native -= period *
        std::max(0.0,
          std::min(std::ceil((native - high - slack) / period), std::floor((native - low + slack) / period)));
    }
  }
  return map.Evaluate(native);
}

/// Su x Sv as a unit vector; at a pole, where one derivative vanishes, that of a point just beside it. Zero when
/// the surface has no direction there either.
Vector3 EvaluateNormal(const NURBSSurface& surface, const std::array<double, 2>& uv)
{
  Vector3 position;
  Vector3 du;
  Vector3 dv;
  for (const double step : { 0.0, 1e-6, 1e-3 })
  {
    double at[2];
    for (int d = 0; d < 2; ++d)
    {
      const double middle = 0.5 * (surface.GetDomainStart(d) + surface.GetDomainEnd(d));
      at[d] = (1.0 - step) * uv[d] + step * middle;
    }
    surface.Evaluate(at[0], at[1], position.data(), du.data(), dv.data());
    const Vector3 normal = Normalized(Cross(du, dv), 1e-10 * std::sqrt(Dot(du, du) * Dot(dv, dv)));
    if (Dot(normal, normal) > 0.0 && std::min(Dot(du, du), Dot(dv, dv)) > 0.0)
    {
      return normal;
    }
  }
  return { 0.0, 0.0, 0.0 };
}

/// Triangles of one face, counter-clockwise in (u,v).
struct FaceTriangles
{
  std::vector<Vector3> Points;
  std::vector<std::array<double, 2>> Parameters;
  std::vector<std::array<int, 3>> Triangles;
};

bool GetKernelTriangles(const ConvertedFace& face, const gp_Trsf& trsf, double unit, FaceTriangles& result)
{
  TopLoc_Location location;
  const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face.Source, location);
  if (triangles.IsNull() || triangles->NbTriangles() == 0 || !triangles->HasUVNodes())
  {
    return false;
  }
  const double zero[3] = { 0.0, 0.0, 0.0 };
  const AffineMap map = AffineMap::Make(trsf * location.Transformation(), unit, zero);
  for (int i = 1; i <= triangles->NbNodes(); ++i)
  {
    const gp_Pnt2d uv = triangles->UVNode(i);
    result.Points.push_back(map.MapPoint(triangles->Node(i).XYZ()));
    result.Parameters.push_back({ MapParameter(face, 0, uv.X()), MapParameter(face, 1, uv.Y()) });
  }
  for (int i = 1; i <= triangles->NbTriangles(); ++i)
  {
    std::array<int, 3> t;
    triangles->Triangle(i).Get(t[0], t[1], t[2]);
    result.Triangles.push_back({ t[0] - 1, t[1] - 1, t[2] - 1 });
  }
  return true;
}

/// For a face that the kernel's mesher gave up on.
bool GetGridTriangles(const ConvertedFace& face, int cells, const double origin[3], FaceTriangles& result)
{
  GridMesh grid = MakeGridMesh(*face.Result, cells);
  result = FaceTriangles();
  for (const auto& uv : grid.Parameters)
  {
    Vector3 p;
    face.Result->Surface.Evaluate(uv[0], uv[1], p.data());
    result.Points.push_back({ p[0] + origin[0], p[1] + origin[1], p[2] + origin[2] });
  }
  result.Parameters = std::move(grid.Parameters);
  result.Triangles = std::move(grid.Triangles);
  return !result.Triangles.empty();
}

/// False when there is no box, or an infinite one.
bool GetFiniteBox(const TopoDS_Shape& shape, double bounds[6])
{
  bool finite = false;
  const std::string failure = CatchFailure(
    [&]()
    {
      Bnd_Box box;
      BRepBndLib::Add(shape, box, true);
      if (box.IsVoid() || box.IsOpen())
      {
        return;
      }
      box.SetGap(0.0);
      box.Get(bounds[0], bounds[2], bounds[4], bounds[1], bounds[3], bounds[5]);
      finite =
        std::all_of(bounds, bounds + 6, [](double b) { return std::abs(b) < 0.5 * Precision::Infinite(); });
    });
  return failure.empty() && finite;
}

/// One by one, the faces that a stopped mesher left, but the first: it had held up the others.
void MeshRemainder(const TopoDS_Shape& shape, const IMeshTools_Parameters& parameters,
  const ProgressCallback& progress, double seconds)
{
  const double start = GetThreadSeconds();
  bool culprit = true;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
  {
    if (GetThreadSeconds() - start >= seconds || (progress && !progress(1.0)))
    {
      return;
    }
    TopLoc_Location location;
    if (!BRep_Tool::Triangulation(TopoDS::Face(faces.Current()), location).IsNull())
    {
      continue;
    }
    if (!culprit)
    {
      const Handle(KernelProgress) indicator = new KernelProgress({}, FaceShare * seconds);
      BRepMesh_IncrementalMesh(faces.Current(), parameters, indicator->Start());
    }
    culprit = false;
  }
}

/// Appends a face with outward winding and exact normals.
void AddFace(const FaceTriangles& from, const Face& face, int index, DisplayMesh& mesh)
{
  const int first = static_cast<int>(mesh.Points.size());
  std::vector<Vector3> fallback(from.Points.size(), Vector3{ 0.0, 0.0, 0.0 });
  for (std::array<int, 3> t : from.Triangles)
  {
    if (face.Reversed)
    {
      std::swap(t[1], t[2]);
    }
    const Vector3& p = from.Points[t[0]];
    const Vector3 n = Cross(Subtract(from.Points[t[1]], p), Subtract(from.Points[t[2]], p));
    for (const int k : t)
    {
      for (int d = 0; d < 3; ++d)
      {
        fallback[k][d] += n[d];
      }
    }
    mesh.Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
    mesh.TriangleFace.push_back(index);
  }
  for (std::size_t i = 0; i < from.Points.size(); ++i)
  {
    mesh.Points.push_back(from.Points[i]);
    mesh.Parameters.push_back(from.Parameters[i]);
    mesh.PointFace.push_back(index);
    Vector3 normal = EvaluateNormal(face.Surface, from.Parameters[i]);
    if (face.Reversed)
    {
      normal = { -normal[0], -normal[1], -normal[2] };
    }
    mesh.Normals.push_back(Dot(normal, normal) > 0.0 ? normal : Normalized(fallback[i], 0.0));
  }
}
}

bool GetShapeBounds(const TopoDS_Shape& shape, double bounds[6], int* unbounded)
{
  if (GetFiniteBox(shape, bounds))
  {
    return true;
  }
  bool any = false;
  int skipped = 0;
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
  {
    double own[6];
    if (!GetFiniteBox(faces.Current(), own))
    {
      ++skipped;
      continue;
    }
    for (int d = 0; d < 3; ++d)
    {
      bounds[2 * d] = any ? std::min(bounds[2 * d], own[2 * d]) : own[2 * d];
      bounds[2 * d + 1] = any ? std::max(bounds[2 * d + 1], own[2 * d + 1]) : own[2 * d + 1];
    }
    any = true;
  }
  if (unbounded)
  {
    *unbounded = skipped;
  }
  return any;
}

bool GetEdgeBounds(const TopoDS_Shape& shape, double bounds[6])
{
  TopoDS_Compound edges;
  BRep_Builder builder;
  builder.MakeCompound(edges);
  for (TopExp_Explorer it(shape, TopAbs_EDGE); it.More(); it.Next())
  {
    builder.Add(edges, it.Current());
  }
  return GetFiniteBox(edges, bounds);
}

double LimitDeflection(double deflection, double diagonal)
{
  const double wanted = deflection > 0.0 ? deflection : 1e-3 * diagonal;
  return std::max({ wanted, 1e-5 * diagonal, 10.0 * Precision::Confusion() });
}

std::string TriangulateShape(const TopoDS_Shape& shape, double deflection, double angle,
  const ProgressCallback& progress, double seconds)
{
  bool stopped = false;
  const std::string failure = CatchFailure(
    [&]()
    {
      IMeshTools_Parameters parameters;
      parameters.Deflection = deflection;
      parameters.Angle = angle;
      parameters.Relative = false;
      parameters.InParallel = false;
      parameters.MinSize = std::max(0.01 * deflection, Precision::Confusion());
      const Handle(KernelProgress) indicator = new KernelProgress(progress, seconds);
      BRepMesh_IncrementalMesh(shape, parameters, indicator->Start());
      indicator->Rethrow();
      if (indicator->IsTimedOut())
      {
        stopped = true;
        MeshRemainder(shape, parameters, progress, seconds);
      }
    });
  if (!failure.empty())
  {
    return "OpenCASCADE's mesher failed (" + failure + "); parts of the display mesh are missing.";
  }
  return stopped ? "OpenCASCADE's mesher took more than " + FormatDigits(seconds, 3) +
      " s and was stopped; the display mesh of some faces may be coarse."
                 : std::string();
}

DisplayMesh BuildMesh(ConvertedBody& body, const gp_Trsf& trsf, double unit, const double origin[3])
{
  DisplayMesh mesh;
  int coarse = 0;
  int missing = 0;
  std::vector<FaceTriangles> kernel(body.Faces.size());
  std::vector<bool> meshed(body.Faces.size());
  int failed = 0;
  for (std::size_t i = 0; i < body.Faces.size(); ++i)
  {
    meshed[i] = GetKernelTriangles(body.Faces[i], trsf, unit, kernel[i]);
    failed += meshed[i] ? 0 : 1;
  }
  for (std::size_t i = 0; i < body.Faces.size(); ++i)
  {
    const ConvertedFace& face = body.Faces[i];
    FaceTriangles triangles = std::move(kernel[i]);
    if (!meshed[i])
    {
      const bool found =
        GetGridTriangles(face, failed > ManyFaces ? FewGridCells : GridCells, origin, triangles);
      coarse += found ? 1 : 0;
      missing += found ? 0 : 1;
    }
    AddFace(triangles, *face.Result, static_cast<int>(i), mesh);
  }
  if (coarse > 0)
  {
    body.Messages.push_back("OpenCASCADE's mesher gave up on " + std::to_string(coarse) +
      " faces; they are shown on a plain grid. Their exact geometry is not touched.");
  }
  if (missing > 0)
  {
    body.Messages.push_back(
      std::to_string(missing) + " faces have no display triangles; their exact geometry is there.");
  }
  const Vector3 center{ origin[0], origin[1], origin[2] };
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Vector3 a = Subtract(mesh.Points[t[0]], center);
    const Vector3 n =
      Cross(Subtract(mesh.Points[t[1]], mesh.Points[t[0]]), Subtract(mesh.Points[t[2]], mesh.Points[t[0]]));
    mesh.Area += 0.5 * std::sqrt(Dot(n, n));
    mesh.Volume += Dot(a, n) / 6.0;
  }
  mesh.Volume = std::abs(mesh.Volume);
  return mesh;
}
}

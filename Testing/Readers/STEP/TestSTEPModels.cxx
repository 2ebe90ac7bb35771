/**
 * @file TestSTEPModels.cxx
 * @brief Real STEP files: our faces, trims and edges against OpenCASCADE's own evaluation, point by point
 *
 * Usage: TestSTEPModels FOLDER [INDEX.tsv REFERENCE.jsonl] [id ...]. Prints one line a file and the worst
 * residual by surface type. Fails when a residual, a count or a closed loop is not what it should be.
 */
#include "smOCCTDocument.h"
#include "smOCCTMesh.h"

#include "vtkTimerLog.h"

#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_ElementarySurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_Surface.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>

namespace
{
/// Relative to the size of the body plus its distance from the part's origin, where OpenCASCADE rounds.
constexpr double SurfaceLimit = 2e-13;
/// A trim curve is fitted to 1e-13 of an arc; OpenCASCADE's own evaluation adds rounding.
constexpr double TrimLimit = 2e-12;
constexpr double EdgeLimit = 1e-13;
/// Far more than the reader gives the mesher for one body, so that a busy machine does not change what is checked.
constexpr double MeshSeconds = 120.0;

struct Tally
{
  double Surface = 0.0;
  double Trim = 0.0;
  int Faces = 0;
};

struct FileResult
{
  int Solids = 0;
  int Shells = 0;
  int Faces = 0;
  int OpenEdges = 0;
  int MissingFaces = 0;
  int Defects = 0;
  std::size_t Pieces = 0;
  std::size_t EdgePieces = 0;
  double Surface = 0.0;
  double Trim = 0.0;
  double Edge = 0.0;
  double TrimResidual = 0.0;
  double MaxGap = 0.0;
  double ReadSeconds = 0.0;
  double ConvertSeconds = 0.0;
  double MeshTime = 0.0;
  int BadNormals = 0;
  double MeshVolume = 0.0;
  std::vector<std::string> Messages;
};

double Distance(const sm::Vector3& a, const double b[3])
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

sm::Vector3 GetFoot(const sm::Vector3& p, const Handle(Geom_Surface) & surface, const sm::AffineMap& map)
{
  const gp_Ax3& frame = Handle(Geom_Plane)::DownCast(surface)->Position();
  const sm::Vector3 o = map.MapPoint(frame.Location().XYZ());
  const sm::Vector3 n = map.MapVector(frame.Direction().XYZ());
  const double height = (p[0] - o[0]) * n[0] + (p[1] - o[1]) * n[1] + (p[2] - o[2]) * n[2];
  return { p[0] - height * n[0], p[1] - height * n[1], p[2] - height * n[2] };
}

/// The point of the file's trim curve that is nearest to `point`, near parameter t: a curve out of step with its edge was given
/// another parameter, and is to be the same curve.
sm::Vector3 GetNearest(const Handle(Geom2d_Curve) & curve, const Handle(Geom_Surface) & surface,
  const sm::AffineMap& map, double t, const double range[2], const double* point)
{
  sm::Vector3 nearest{};
  for (int step = 0; step < 8; ++step)
  {
    gp_Pnt2d uv;
    gp_Vec2d slope;
    curve->D1(t, uv, slope);
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
    t = std::clamp(t + (squared > 0.0 ? dot / squared : 0.0), range[0], range[1]);
  }
  return nearest;
}

void CheckTrims(const sm::ConvertedFace& face, const sm::AffineMap& map, const Handle(Geom_Surface) & surface,
  double size, FileResult& result, Tally& tally)
{
  for (std::size_t l = 0; l < face.Result->Loops.size(); ++l)
  {
    const sm::Loop& loop = face.Result->Loops[l];
    for (std::size_t k = 0; k < loop.Coedges.size(); ++k)
    {
      const sm::Coedge& coedge = loop.Coedges[k];
      result.Pieces += coedge.Curve.GetNumberOfPieces();
      result.TrimResidual = std::max(result.TrimResidual, coedge.Curve.GetLargestResidual());
      double first;
      double last;
      Standard_Boolean stored = false;
      const Handle(Geom2d_Curve) native =
        BRep_Tool::CurveOnSurface(face.SourceEdges[l][k], face.Source, first, last, &stored);
      if (native.IsNull())
      {
        continue;
      }
      for (const double x : { 0.0, 0.137, 0.5, 0.811, 1.0 })
      {
        const double t = (1.0 - x) * coedge.Curve.GetStart() + x * coedge.Curve.GetEnd();
        const gp_Pnt2d uv = native->Value((1.0 - x) * first + x * last);
        // On a plane without a pcurve of its own OpenCASCADE makes one up, at another speed than the edge has: the
        // truth is the foot of the edge's point.
        const sm::Vector3 expected = stored ? map.MapPoint(surface->Value(uv.X(), uv.Y()).XYZ())
                                            : GetFoot(coedge.Use->Curve.Evaluate(t), surface, map);
        const auto c = coedge.Curve.Evaluate(t);
        double actual[3];
        face.Result->Surface.Evaluate(c[0], c[1], actual);
        if (!coedge.Use->Degenerate)
        {
          result.MaxGap = std::max(result.MaxGap, Distance(coedge.Use->Curve.Evaluate(t), actual));
        }
        double error = Distance(expected, actual) / size;
        if (error > TrimLimit && stored)
        {
          const double range[2] = { first, last };
          error =
            Distance(GetNearest(native, surface, map, (1.0 - x) * first + x * last, range, actual), actual) /
            size;
        }
        tally.Trim = std::max(tally.Trim, error);
        result.Trim = std::max(result.Trim, error);
        if (error > TrimLimit && result.Messages.size() < 200)
        {
          char line[300];
          std::snprintf(line, sizeof(line),
            "trim of face #%d (%s), edge #%d, x=%.3f: %.2e; native %.17g %.17g ours %.17g %.17g residual "
            "%.1e stored-curve %s",
            face.Result->FileId, surface->DynamicType()->Name(), coedge.Use->FileId, x, error, uv.X(), uv.Y(),
            c[0], c[1], coedge.Curve.GetLargestResidual(), native->DynamicType()->Name());
          result.Messages.push_back(line);
        }
      }
    }
  }
}

void CheckFace(const sm::ConvertedFace& face, const gp_Trsf& trsf, const double origin[3], double size,
  FileResult& result, std::map<std::string, Tally>& tallies, std::mt19937& random)
{
  TopLoc_Location location;
  const Handle(Geom_Surface) surface = sm::GetBasisSurface(BRep_Tool::Surface(face.Source, location));
  Tally& tally = tallies[surface->DynamicType()->Name()];
  ++tally.Faces;
  const sm::AffineMap map = sm::AffineMap::Make(trsf * location.Transformation(), 1.0, origin);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 12; ++i)
  {
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
    const sm::Vector3 expected = map.MapPoint(surface->Value(native[0], native[1]).XYZ());
    double actual[3];
    face.Result->Surface.Evaluate(ours[0], ours[1], actual);
    // A surface may reach far beyond the body it bounds.
    double reach = std::max(size, std::hypot(expected[0], expected[1], expected[2]));
    if (Handle(Geom_ElementarySurface)::DownCast(surface))
    {
      // Some systems put the origin of a cylinder half a kilometre from its face; everybody rounds there.
      reach = std::max(reach, std::abs(native[1]));
    }
    const double error = Distance(expected, actual) / reach;
    tally.Surface = std::max(tally.Surface, error);
    result.Surface = std::max(result.Surface, error);
    if (error > SurfaceLimit)
    {
      std::ostringstream line;
      line << "surface of face #" << face.Result->FileId << " (" << surface->DynamicType()->Name() << ") at "
           << native[0] << " " << native[1] << ": " << error;
      result.Messages.push_back(line.str());
    }
  }
  CheckTrims(face, map, surface, size, result, tally);
}

void CheckEdges(
  const sm::ConvertedBody& body, const gp_Trsf& trsf, const double origin[3], double size, FileResult& result)
{
  std::map<const sm::Edge*, int> uses;
  for (const sm::ConvertedFace& face : body.Faces)
  {
    for (std::size_t l = 0; l < face.Result->Loops.size(); ++l)
    {
      const sm::Loop& loop = face.Result->Loops[l];
      for (std::size_t k = 0; k < loop.Coedges.size(); ++k)
      {
        const sm::Coedge& coedge = loop.Coedges[k];
        if (coedge.Use->Degenerate)
        {
          continue;
        }
        const bool known = uses.count(coedge.Use.get()) > 0;
        uses[coedge.Use.get()] += coedge.Reversed != face.Result->Reversed ? -1 : 1;
        TopLoc_Location location;
        double first;
        double last;
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(face.SourceEdges[l][k], location, first, last);
        if (known || curve.IsNull())
        {
          continue;
        }
        result.EdgePieces += coedge.Use->Curve.GetNumberOfPieces();
        const sm::AffineMap map = sm::AffineMap::Make(trsf * location.Transformation(), 1.0, origin);
        for (const double x : { 0.0, 0.137, 0.333, 0.5, 0.811, 1.0 })
        {
          const double t = (1.0 - x) * first + x * last;
          const sm::Vector3 expected = map.MapPoint(curve->Value(t).XYZ());
          const double error =
            Distance(expected, coedge.Use->Curve.Evaluate(t).data()) / std::max(size, 4.0 * std::abs(first));
          result.Edge = std::max(result.Edge, error);
          if (error > EdgeLimit)
          {
            std::ostringstream line;
            line << "edge #" << coedge.Use->FileId << " (" << curve->DynamicType()->Name() << "), x=" << x
                 << ": " << error << ", range " << first << " " << last << ", residual "
                 << coedge.Use->Curve.GetLargestResidual();
            result.Messages.push_back(line.str());
          }
        }
      }
    }
  }
  for (const auto& use : uses)
  {
    result.OpenEdges += use.second != 0 ? 1 : 0;
  }
  for (const std::string& message : body.Messages)
  {
    result.Messages.push_back(message);
  }
}

FileResult CheckModel(const std::string& path, std::map<std::string, Tally>& tallies)
{
  FileResult result;
  std::mt19937 random(20240607);
  double start = vtkTimerLog::GetUniversalTime();
  const sm::Document document = sm::ReadDocument(path, [](double) { return true; });
  result.ReadSeconds = vtkTimerLog::GetUniversalTime() - start;
  if (document.Status != sm::ReadStatus::Ok)
  {
    result.Messages.push_back(document.Problem);
  }
  for (const std::string& message : document.Messages)
  {
    result.Messages.push_back(message);
  }
  std::vector<FileResult> bodies;
  for (const sm::PartBody& part : document.Bodies)
  {
    FileResult own;
    double bounds[6] = { 0, 0, 0, 0, 0, 0 };
    sm::GetShapeBounds(part.Shape, bounds);
    const double origin[3] = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
      0.5 * (bounds[4] + bounds[5]) };
    const double diagonal = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
    const double size = diagonal + std::hypot(origin[0], origin[1], origin[2]);
    start = vtkTimerLog::GetUniversalTime();
    sm::ConvertedBody body = sm::ConvertBody(part.Shape, part.Scale, 1.0, origin, document.Table);
    own.ConvertSeconds = vtkTimerLog::GetUniversalTime() - start;
    for (const sm::ConvertedFace& face : body.Faces)
    {
      CheckFace(face, part.Scale, origin, size, own, tallies, random);
    }
    CheckEdges(body, part.Scale, origin, size, own);
    own.Faces = static_cast<int>(body.Faces.size());
    result.MissingFaces += body.MissingFaces;
    result.Defects += body.Defects + (part.Misplaced ? 1 : 0);
    start = vtkTimerLog::GetUniversalTime();
    sm::TriangulateShape(part.Shape, sm::LimitDeflection(0.001 * diagonal, diagonal), 0.35, {}, MeshSeconds);
    own.MeshTime = vtkTimerLog::GetUniversalTime() - start;
    start = vtkTimerLog::GetUniversalTime();
    const sm::DisplayMesh mesh = sm::BuildMesh(body, part.Scale, 1.0, origin);
    own.ConvertSeconds += vtkTimerLog::GetUniversalTime() - start;
    own.MeshVolume = mesh.Volume;
    for (const sm::Vector3& n : mesh.Normals)
    {
      own.BadNormals += std::abs(std::hypot(n[0], n[1], n[2]) - 1.0) > 1e-6 ? 1 : 0;
    }
    bodies.push_back(own);
  }
  for (const FileResult& own : bodies)
  {
    result.Pieces += own.Pieces;
    result.EdgePieces += own.EdgePieces;
    result.Surface = std::max(result.Surface, own.Surface);
    result.Trim = std::max(result.Trim, own.Trim);
    result.Edge = std::max(result.Edge, own.Edge);
    result.TrimResidual = std::max(result.TrimResidual, own.TrimResidual);
    result.MaxGap = std::max(result.MaxGap, own.MaxGap);
    result.ConvertSeconds += own.ConvertSeconds;
    result.MeshTime += own.MeshTime;
    result.BadNormals += own.BadNormals;
    result.Messages.insert(result.Messages.end(), own.Messages.begin(), own.Messages.end());
  }
  for (const sm::BodyInstance& instance : document.Instances)
  {
    const FileResult& own = bodies[instance.Body];
    (document.Bodies[instance.Body].Solid ? result.Solids : result.Shells) += 1;
    result.Faces += own.Faces;
    result.OpenEdges += own.OpenEdges;
    result.MeshVolume += own.MeshVolume;
  }
  result.Faces += document.FreeFaces;
  return result;
}

/// A number after "key": in a line of JSON; -1 when it is null or not there.
double FindNumber(const std::string& line, const std::string& key)
{
  const std::size_t at = line.find("\"" + key + "\": ");
  if (at == std::string::npos)
  {
    return -1.0;
  }
  const char* text = line.c_str() + at + key.size() + 4;
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  return end == text ? -1.0 : value;
}
}

int TestSTEPModels(int argc, char* argv[])
{
  if (argc < 3)
  {
    std::fprintf(stderr, "usage: %s FOLDER REFERENCE.jsonl [id ...]\n", argv[0]);
    return 1;
  }
  const std::string folder = argv[1];
  std::ifstream reference(argv[2]);
  const std::set<std::string> wanted(argv + 3, argv + argc);
  std::map<std::string, Tally> tallies;
  int failures = 0;
  double seconds[3] = { 0.0, 0.0, 0.0 };
  std::size_t pieces = 0;
  std::printf("%-24s %6s %6s %6s %7s %7s %8s %8s %8s %8s %6s %6s %6s\n", "file", "solids", "faces", "open",
    "pieces", "edges", "surface", "trim", "edge", "resid", "read", "conv", "mesh");
  for (std::string line; std::getline(reference, line);)
  {
    const std::size_t begin = line.find("\"id\": \"") + 7;
    const std::string id = line.substr(begin, line.find('"', begin) - begin);
    const std::string path = folder + "/" + id + ".step";
    if ((!wanted.empty() && wanted.count(id) == 0) || !std::ifstream(path))
    {
      continue;
    }
    const FileResult r = CheckModel(path, tallies);
    std::printf("%-24s %6d %6d %6d %7zu %7zu %8.1e %8.1e %8.1e %8.1e %6.2f %6.3f %6.2f\n", id.c_str(),
      r.Solids, r.Faces, r.OpenEdges, r.Pieces, r.EdgePieces, r.Surface, r.Trim, r.Edge, r.TrimResidual,
      r.ReadSeconds, r.ConvertSeconds, r.MeshTime);
    const auto expect = [&](const char* what, double actual, double expected)
    {
      if (actual != expected)
      {
        std::printf("  FAIL %s: %g instead of %g\n", what, actual, expected);
        ++failures;
      }
    };
    const auto limit = [&](const char* what, double actual, double largest)
    {
      if (!(actual <= largest))
      {
        std::printf("  FAIL %s: %g above %g\n", what, actual, largest);
        ++failures;
      }
    };
    expect("solids", r.Solids, FindNumber(line, "solids"));
    expect("faces", r.Faces, FindNumber(line, "faces"));
    if (r.Solids > 0)
    {
      expect("open edges", r.OpenEdges, std::max(0.0, FindNumber(line, "open_edges")));
    }
    expect("missing faces", r.MissingFaces, 0);
    expect("defects", r.Defects, std::max(0.0, FindNumber(line, "open_loops")));
    expect("normals without direction", r.BadNormals, 0);
    limit("surface", r.Surface, SurfaceLimit);
    limit("trim", r.Trim, TrimLimit);
    limit("edge", r.Edge, EdgeLimit);
    // The reference samples the gap between coedge and edge far more densely; what we see is never more.
    if (r.Solids > 0)
    {
      limit("gap between coedges and edges (mm)", r.MaxGap, 1.05 * FindNumber(line, "max_gap") + 1e-8);
    }
    const double volume = FindNumber(line, "volume");
    if (volume > 0.0 && r.Solids > 0)
    {
      limit("mesh volume", std::abs(r.MeshVolume / volume - 1.0), 0.03);
    }
    const std::size_t shown = std::min<std::size_t>(r.Messages.size(), wanted.empty() ? 4 : 50);
    for (std::size_t i = 0; i < shown; ++i)
    {
      std::printf("    %s\n", r.Messages[i].c_str());
    }
    seconds[0] += r.ReadSeconds;
    seconds[1] += r.ConvertSeconds;
    seconds[2] += r.MeshTime;
    pieces += r.Pieces;
    std::fflush(stdout);
  }
  std::printf("\n%-32s %7s %9s %9s\n", "surface type", "faces", "surface", "trim");
  for (const auto& tally : tallies)
  {
    std::printf("%-32s %7d %9.1e %9.1e\n", tally.first.c_str(), tally.second.Faces, tally.second.Surface,
      tally.second.Trim);
  }
  std::printf("%zu trim pieces; read %.1f s, conversion %.1f s, mesh %.1f s; %d failures\n", pieces,
    seconds[0], seconds[1], seconds[2], failures);
  return failures ? 1 : 0;
}

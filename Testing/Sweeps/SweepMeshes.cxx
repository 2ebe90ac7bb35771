// SweepMeshes [options] FILE.step...: the display mesh of every body compared with that of OpenCASCADE's
// mesher, in one run on one core: seconds, triangles, faces without triangles, open sides of closed solids,
// inverted triangles, and the largest distance from the surface, all at the same deflection. For ours, the
// seconds of bounds of surfaces and points of edges alone; for both, triangles times distance: at equal
// distance, the ratio of triangles. Exit status 1 where ours breaks its promise, or has faces without
// triangles, triangles inverted, or open sides of closed bodies that it gives no reason for.
//     --deflection X   a part of the diagonal, 0.001 by default
//     --threads N      meshes on N threads; seconds are those of the clock on the wall then
//     --alone          without OpenCASCADE
//     --repeat N       meshes each body N times and counts the smallest seconds
//     --quick          the same without measures: only seconds, triangles and the bits of the mesh
//     --triangles FILE.csv   writes the triangles of both, which MeshPictures.py draws
//     --verbose        says so of every face
#include "Shapes/smShapeBounds.h"
#include "smBodySize.h"
#include "smDocument.h"
#include "smKernelMesh.h"
#include "smMeshMeasures.h"

#include <vtkCellArray.h>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtkTimerLog.h>

#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <map>
#include <memory>
#include <unordered_map>

namespace
{
double Deflection = 0.001;
/// Bodies with smaller distances, as a part of the deflection, are flat.
constexpr double FlatShare = 0.01;
int Threads = 1;
int Repeats = 1;
bool Alone = false;
bool Quick = false;
bool Verbose = false;
std::ofstream TriangleFile;

void WriteTriangles(const sm::Face& face, bool isOurs, const sm::FaceMesh& mesh)
{
  sm::NURBSSurface::Walker walker(face.Surface);
  for (const auto& triangle : mesh.Triangles)
  {
    TriangleFile << face.FileId << ',' << isOurs << ',' << smtest::IsInverted(face, walker, mesh, triangle);
    for (const int corner : triangle)
    {
      const sm::Vector3& p = mesh.Points[corner];
      TriangleFile << ',' << p[0] << ',' << p[1] << ',' << p[2];
    }
    TriangleFile << '\n';
  }
}

double GetSeconds()
{
  return Threads > 1 ? vtkTimerLog::GetUniversalTime() : static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Totals
{
  double Seconds[2] = { 0, 0 };
  double EdgeSeconds = 0.0;
  /// Sums of triangles times the largest distance as a part of the deflection, over bodies that are not flat.
  double Effort[2] = { 0, 0 };
  /// Faces without triangles and without a reason, and open sides of closed bodies whose faces have no
  /// reason.
  int Unexplained = 0;
  /// Bodies whose edges cancel, those of them whose meshes have boundary edges, and the number of these where
  /// no face has a reason.
  int ClosedBodies = 0;
  int BodiesWithBoundary = 0;
  int BoundaryEdges = 0;
  /// Faces on which the normal turns within a triangle by at most the wanted angle, by more, and without a
  /// bound.
  int Turns[3] = { 0, 0, 0 };
  smtest::MeshMeasures Mesh[2];
};

void Add(const smtest::MeshMeasures& from, double deflection, smtest::MeshMeasures& to)
{
  to.Points += from.Points;
  to.Triangles += from.Triangles;
  to.EmptyFaces += from.EmptyFaces;
  to.OpenSides += from.OpenSides;
  to.Inverted += from.Inverted;
  to.Named += from.Named;
  to.Deviation = std::max(to.Deviation, from.Deviation / deflection);
  to.WorstShare = std::max(to.WorstShare, from.WorstShare);
  to.WorstTurnShare = std::max(to.WorstTurnShare, from.WorstTurnShare);
}

Totals All;
/// A hash of the coordinates and triangles of all meshes: a change that must not move one is shown not to.
std::uint64_t Bits = 14695981039346656037u;

void AddBits(const void* data, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    Bits = (Bits ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211u;
  }
}

/// Returns true if the directions in which faces use each edge cancel.
bool IsClosed(const std::vector<sm::FacePointer>& faces)
{
  std::unordered_map<const sm::Edge*, int> directions;
  for (const sm::FacePointer& face : faces)
  {
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        directions[coedge.Use.get()] += coedge.Reversed ? -1 : 1;
      }
    }
  }
  return std::all_of(directions.begin(), directions.end(), [](const auto& d) { return d.second == 0; });
}

/// Number of edges that vtkFeatureEdges finds to belong to one triangle only, where points with the same bits
/// are one.
vtkIdType CountBoundaryEdges(const std::vector<sm::FaceMesh>& meshes)
{
  std::map<std::array<double, 3>, vtkIdType> places;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (const sm::FaceMesh& mesh : meshes)
  {
    for (const std::array<int, 3>& t : mesh.Triangles)
    {
      vtkIdType ids[3];
      for (int k = 0; k < 3; ++k)
      {
        const std::array<double, 3>& p = mesh.Points[t[k]];
        const auto [place, isNew] = places.emplace(p, points->GetNumberOfPoints());
        ids[k] = isNew ? points->InsertNextPoint(p.data()) : place->second;
      }
      // The two sides of a triangle that is a line cancel.
      if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0])
      {
        triangles->InsertNextCell(3, ids);
      }
    }
  }
  vtkNew<vtkPolyData> body;
  body->SetPoints(points);
  body->SetPolys(triangles);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(body);
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

/// Seconds of what comes before the first triangle: bounds of the surfaces, and points of edges that suit
/// them.
double MeasureEdges(const std::vector<sm::FacePointer>& faces, const sm::MeshLimits& limits)
{
  const double start = GetSeconds();
  std::vector<std::unique_ptr<sm::SurfaceBlocks>> blocks;
  std::unordered_map<const sm::Edge*, std::vector<sm::EdgeUse>> uses;
  for (const sm::FacePointer& face : faces)
  {
    sm::ParameterBox box{ { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        for (const auto& c : coedge.Curve.Coefficients)
        {
          box.Add(c);
        }
      }
    }
    if (!(box.Low[0] < box.High[0]))
    {
      continue;
    }
    blocks.push_back(std::make_unique<sm::SurfaceBlocks>(face->Surface, box, limits));
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        if (coedge.Use && coedge.Curve.GetNumberOfPieces() > 0 && coedge.Use->Curve.GetNumberOfPieces() > 0)
        {
          uses[coedge.Use.get()].push_back({ blocks.back().get(), &coedge.Curve });
        }
      }
    }
  }
  for (const auto& edge : uses)
  {
    for (const double t : sm::SampleEdge(*edge.first, edge.second, limits, 1).T)
    {
      edge.first->Curve.Evaluate(t);
    }
  }
  return GetSeconds() - start;
}

class MeshReader : public vtkSTEPReader
{
public:
  static MeshReader* New();
  vtkTypeMacro(MeshReader, vtkSTEPReader);

protected:
  void InspectDocument(const sm::Document& document) override
  {
    for (const sm::PartBody& part : document.Bodies)
    {
      double bounds[6];
      if (!sm::GetShapeBounds(part.Shape, bounds))
      {
        continue;
      }
      double origin[3];
      for (int d = 0; d < 3; ++d)
      {
        origin[d] = 0.5 * (bounds[2 * d] + bounds[2 * d + 1]);
      }
      sm::ConvertedBody body = sm::ConvertBody(part.Shape, sm::Placement(), 1.0, origin);
      std::vector<sm::FacePointer> faces;
      for (const sm::ConvertedFace& face : body.Faces)
      {
        faces.push_back(face.Result);
      }
      // The diagonal of a coarse mesh; edges alone would leave out what bulges between them.
      const double size = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
      const auto box = sm::MeasureBody(sm::MeshFaces(faces, { 0.01 * size, sm::MeshLimits().Angle })).Bounds;
      sm::MeshLimits limits;
      limits.Deflection = Deflection * std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
      double start = 0.0;
      double minimum = HUGE_VAL;
      double edges = HUGE_VAL;
      std::vector<sm::FaceMesh> ours;
      for (int i = 0; i < Repeats; ++i)
      {
        start = GetSeconds();
        ours = sm::MeshFaces(faces, limits);
        minimum = std::min(minimum, GetSeconds() - start);
        edges = std::min(edges, MeasureEdges(faces, limits));
      }
      All.Seconds[0] += minimum;
      All.EdgeSeconds += edges;
      for (const sm::FaceMesh& mesh : ours)
      {
        AddBits(mesh.Points.data(), mesh.Points.size() * sizeof(mesh.Points[0]));
        AddBits(mesh.Triangles.data(), mesh.Triangles.size() * sizeof(mesh.Triangles[0]));
        All.Mesh[0].Triangles += Quick ? static_cast<long long>(mesh.Triangles.size()) : 0;
      }
      if (Quick)
      {
        continue;
      }
      const smtest::KernelBody kernel = Alone ? smtest::KernelBody() : smtest::MakeKernelBody(part.Shape);
      start = GetSeconds();
      if (!Alone)
      {
        smtest::MeshByKernel(kernel.Shape, limits.Deflection, limits.Angle);
      }
      All.Seconds[1] += GetSeconds() - start;
      const std::vector<sm::FaceMesh> theirs =
        smtest::GetKernelMeshes(body, kernel, origin, limits.Deflection);
      const smtest::MeshMeasures a = smtest::MeasureMesh(faces, ours);
      const smtest::MeshMeasures b = smtest::MeasureMesh(faces, theirs);
      Add(a, limits.Deflection, All.Mesh[0]);
      Add(b, limits.Deflection, All.Mesh[1]);
      if (std::min(a.Deviation, b.Deviation) > FlatShare * limits.Deflection)
      {
        All.Effort[0] += static_cast<double>(a.Triangles) * a.Deviation / limits.Deflection;
        All.Effort[1] += static_cast<double>(b.Triangles) * b.Deviation / limits.Deflection;
      }
      const bool explained =
        std::any_of(ours.begin(), ours.end(), [](const sm::FaceMesh& m) { return !m.Reason.empty(); });
      if (IsClosed(faces))
      {
        const auto boundary = static_cast<int>(CountBoundaryEdges(ours));
        ++All.ClosedBodies;
        All.BodiesWithBoundary += boundary > 0 ? 1 : 0;
        All.BoundaryEdges += explained ? 0 : boundary;
        if (!explained && a.OpenSides + boundary > 0)
        {
          All.Unexplained += a.OpenSides + boundary;
          std::printf("    closed except for its mesh\n");
        }
      }
      for (std::size_t f = 0; f < faces.size(); ++f)
      {
        All.Unexplained += ours[f].Triangles.empty() && ours[f].Reason.empty() ? 1 : 0;
        if (TriangleFile.is_open())
        {
          WriteTriangles(*faces[f], false, theirs[f]);
          WriteTriangles(*faces[f], true, ours[f]);
        }
        ReportInverted(*faces[f], ours[f], theirs[f]);
        if (!Verbose)
        {
          continue;
        }
        std::printf(
          "    face #%lld: %zu triangles (OpenCASCADE %zu) deviation %.3g degrees %d %d%s spans %zu "
          "%zu loops %zu\n",
          static_cast<long long>(faces[f]->FileId), ours[f].Triangles.size(), theirs[f].Triangles.size(),
          ours[f].Deviation / limits.Deflection, faces[f]->Surface.Degree[0], faces[f]->Surface.Degree[1],
          faces[f]->Surface.Rational ? " rational" : "", faces[f]->Surface.GetSpanBreaks(0).size() - 1,
          faces[f]->Surface.GetSpanBreaks(1).size() - 1, faces[f]->Loops.size());
      }
      this->Report(ours, faces, part, a, b, limits);
    }
  }

  static void ReportInverted(const sm::Face& face, const sm::FaceMesh& ours, const sm::FaceMesh& theirs)
  {
    const sm::FaceMesh* const meshes[2] = { &ours, &theirs };
    long long count[2] = { 0, 0 };
    sm::NURBSSurface::Walker walker(face.Surface);
    for (int i = 0; i < 2; ++i)
    {
      count[i] = std::count_if(meshes[i]->Triangles.begin(), meshes[i]->Triangles.end(),
        [&](const auto& t) { return smtest::IsInverted(face, walker, *meshes[i], t); });
    }
    if (count[0] > 0)
    {
      std::printf("    face #%lld: %lld of %zu triangles inverted (OpenCASCADE %lld of %zu)\n",
        static_cast<long long>(face.FileId), count[0], ours.Triangles.size(), count[1],
        theirs.Triangles.size());
    }
  }

  void Report(const std::vector<sm::FaceMesh>& ours, const std::vector<sm::FacePointer>& faces,
    const sm::PartBody& part, const smtest::MeshMeasures& a, const smtest::MeshMeasures& b,
    const sm::MeshLimits& limits)
  {
    const double deflection = limits.Deflection;
    double promised = 0.0;
    for (std::size_t f = 0; f < ours.size(); ++f)
    {
      promised = std::max(promised, ours[f].Deviation);
      const double turn = ours[f].NormalTurn;
      ++All.Turns[turn <= limits.Angle ? 0 : turn < vtkMath::Pi() ? 1 : 2];
      if (!ours[f].Reason.empty() || ours[f].Triangles.empty())
      {
        std::printf("    face #%lld: %s\n", static_cast<long long>(faces[f]->FileId), ours[f].Reason.c_str());
      }
      if (Verbose && ours[f].Deviation > deflection)
      {
        std::printf("    face #%lld: deviation %.3g of the deflection, %zu triangles\n",
          static_cast<long long>(faces[f]->FileId), ours[f].Deviation / deflection, ours[f].Triangles.size());
      }
    }
    if (Verbose || a.EmptyFaces + a.OpenSides + a.Inverted > 0 || promised > 1.0001 * deflection ||
      std::max(a.WorstShare, a.WorstTurnShare) > 1.0)
    {
      std::printf("  %s #%lld: %zu faces, %lld triangles (OpenCASCADE %lld), empty %d (%d), open sides %d "
                  "(%d), inverted %d (%d), "
                  "deviation %.3g (%.3g), promise %.3g of the deflection, reached %.3g of it, normals %.3g\n",
        part.Name.c_str(), static_cast<long long>(part.FileId), faces.size(), a.Triangles, b.Triangles,
        a.EmptyFaces, b.EmptyFaces, a.OpenSides, b.OpenSides, a.Inverted, b.Inverted,
        a.Deviation / deflection, b.Deviation / deflection, promised / deflection, a.WorstShare,
        a.WorstTurnShare);
    }
  }
};
vtkStandardNewMacro(MeshReader);
}

int main(int argc, char* argv[])
{
  for (int i = 1; i < argc; ++i)
  {
    if (std::strcmp(argv[i], "--deflection") == 0 && i + 1 < argc)
    {
      Deflection = std::atof(argv[++i]);
      continue;
    }
    if (std::strcmp(argv[i], "--repeat") == 0 && i + 1 < argc)
    {
      Repeats = std::max(std::atoi(argv[++i]), 1);
      continue;
    }
    if (std::strcmp(argv[i], "--threads") == 0 && i + 1 < argc)
    {
      Threads = std::atoi(argv[++i]);
      vtkSMPTools::SetBackend("STDThread");
      vtkSMPTools::Initialize(Threads);
      continue;
    }
    if (std::strcmp(argv[i], "--triangles") == 0 && i + 1 < argc)
    {
      TriangleFile.open(argv[++i]);
      TriangleFile << "face,ours,inverted,x0,y0,z0,x1,y1,z1,x2,y2,z2\n";
      continue;
    }
    bool* const flag = std::strcmp(argv[i], "--verbose") == 0 ? &Verbose
      : std::strcmp(argv[i], "--alone") == 0                  ? &Alone
      : std::strcmp(argv[i], "--quick") == 0                  ? &Quick
                                                              : nullptr;
    if (flag)
    {
      *flag = true;
      continue;
    }
    const Totals before = All;
    vtkNew<MeshReader> reader;
    reader->SetLinearDeflection(0.1);
    // OpenCASCADE's mesher needs the parameter curves that its repair makes.
    reader->SetRepair(Alone || Quick ? vtkSTEPReader::ON_NEED : vtkSTEPReader::ALWAYS);
    reader->SetFileName(argv[i]);
    reader->Update();
    std::printf("%-40s %8lld triangles (OpenCASCADE %8lld)  %.3f s (%.3f s)\n",
      std::strrchr(argv[i], '/') ? std::strrchr(argv[i], '/') + 1 : argv[i],
      All.Mesh[0].Triangles - before.Mesh[0].Triangles, All.Mesh[1].Triangles - before.Mesh[1].Triangles,
      All.Seconds[0] - before.Seconds[0], All.Seconds[1] - before.Seconds[1]);
    std::fflush(stdout);
  }
  std::printf("bits %016llx\n", static_cast<unsigned long long>(Bits));
  const char* names[2] = { "ours", "OpenCASCADE" };
  for (int k = 0; k < (Alone || Quick ? 1 : 2); ++k)
  {
    const smtest::MeshMeasures& m = All.Mesh[k];
    std::printf(
      "%-12s %.3f s, %lld points, %lld triangles, %.3g million a second; faces without triangles "
      "%d, open sides %d, inverted "
      "%d (%d named); deviation %.3g of the deflection, %.3g of what is stated, normals %.3g of that\n",
      names[k], All.Seconds[k], m.Points, m.Triangles,
      1e-6 * static_cast<double>(m.Triangles) / All.Seconds[k], m.EmptyFaces, m.OpenSides, m.Inverted,
      m.Named, m.Deviation, m.WorstShare, m.WorstTurnShare);
  }
  if (!Quick)
  {
    std::printf(
      "%d closed bodies: %d boundary edges (vtkFeatureEdges), besides those of %d bodies with a reason\n",
      All.ClosedBodies, All.BoundaryEdges, All.BodiesWithBoundary);
  }
  std::printf(
    "turn of the normal in a triangle: within the angle on %d faces, more on %d, not bounded on %d\n",
    All.Turns[0], All.Turns[1], All.Turns[2]);
  std::printf("bounds of surfaces and points of edges alone: %.3f s; triangles times distance, ours to "
              "OpenCASCADE's: %.3g\n",
    All.EdgeSeconds, All.Effort[0] / All.Effort[1]);
  return std::max(All.Mesh[0].WorstShare, All.Mesh[0].WorstTurnShare) <= 1.0 && All.Unexplained == 0 &&
      All.Mesh[0].Inverted <= All.Mesh[0].Named
    ? 0
    : 1;
}

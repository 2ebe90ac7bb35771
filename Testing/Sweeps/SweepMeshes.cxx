// SweepMeshes [--deflection X] FILE.step...: the display mesh of every body beside that of OpenCASCADE's mesher, in one run on one
// core: seconds, triangles, faces without triangles, open sides of closed solids, inverted triangles, and the largest distance from the
// surface, all at the same deflection (a part X of the diagonal, 0.001 by default). Exit status 1 where ours breaks its promise.
#include "smKernelMesh.h"
#include "smMeshMeasures.h"
#include "smOCCTBody.h"
#include "smOCCTBounds.h"
#include "smOCCTDocument.h"

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkSTEPReader.h>

#include <cstring>
#include <ctime>

namespace
{
double GetSeconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Totals
{
  double Seconds[2] = { 0, 0 };
  double Share = 0.0;
  double Relative = 0.0;
  smtest::MeshMeasures Mesh[2];
};

void Add(const smtest::MeshMeasures& from, double deflection, smtest::MeshMeasures& to)
{
  to.Points += from.Points;
  to.Triangles += from.Triangles;
  to.EmptyFaces += from.EmptyFaces;
  to.OpenSides += from.OpenSides;
  to.Inverted += from.Inverted;
  to.Deviation = std::max(to.Deviation, from.Deviation / deflection);
  to.WorstShare = std::max(to.WorstShare, from.WorstShare);
}

double Deflection = 0.001;
bool Verbose = false;
Totals All;

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
      const double size = std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
      sm::ConvertedBody body = sm::ConvertBody(part.Shape, gp_Trsf(), 1.0, origin, document.Table);
      std::vector<sm::FacePointer> faces;
      for (const sm::ConvertedFace& face : body.Faces)
      {
        faces.push_back(face.Result);
      }
      sm::MeshLimits limits;
      limits.Deflection = Deflection * size;
      double start = GetSeconds();
      const std::vector<sm::FaceMesh> ours = sm::MeshFaces(faces, limits);
      All.Seconds[0] += GetSeconds() - start;
      start = GetSeconds();
      smtest::MeshByKernel(part.Shape, limits.Deflection, limits.Angle);
      All.Seconds[1] += GetSeconds() - start;
      const std::vector<sm::FaceMesh> theirs = smtest::GetKernelMeshes(body, origin, limits.Deflection);
      const smtest::MeshMeasures a = smtest::MeasureMesh(faces, ours);
      const smtest::MeshMeasures b = smtest::MeasureMesh(faces, theirs);
      Add(a, limits.Deflection, All.Mesh[0]);
      Add(b, limits.Deflection, All.Mesh[1]);
      for (std::size_t f = 0; Verbose && f < faces.size(); ++f)
      {
        std::printf("    face #%d: %zu triangles (OpenCASCADE %zu) deviation %.3g degrees %d %d%s spans %zu "
                    "%zu loops %zu\n",
          faces[f]->FileId, ours[f].Triangles.size(), theirs[f].Triangles.size(),
          ours[f].Deviation / limits.Deflection, faces[f]->Surface.Degree[0], faces[f]->Surface.Degree[1],
          faces[f]->Surface.Rational ? " rational" : "", faces[f]->Surface.GetSpanBreaks(0).size() - 1,
          faces[f]->Surface.GetSpanBreaks(1).size() - 1, faces[f]->Loops.size());
      }
      this->Report(ours, faces, part, a, b, limits.Deflection);
    }
  }

  void Report(const std::vector<sm::FaceMesh>& ours, const std::vector<sm::FacePointer>& faces,
    const sm::PartBody& part, const smtest::MeshMeasures& a, const smtest::MeshMeasures& b, double deflection)
  {
    double promised = 0.0;
    for (std::size_t f = 0; f < ours.size(); ++f)
    {
      promised = std::max(promised, ours[f].Deviation);
      if (!ours[f].Reason.empty() || ours[f].Triangles.empty())
      {
        std::printf("    face #%d: %s\n", faces[f]->FileId, ours[f].Reason.c_str());
      }
      if (Verbose && ours[f].Deviation > deflection)
      {
        std::printf("    face #%d: deviation %.3g of the deflection, %zu triangles\n", faces[f]->FileId,
          ours[f].Deviation / deflection, ours[f].Triangles.size());
      }
    }
    if (Verbose || a.EmptyFaces + a.OpenSides + a.Inverted > 0 || promised > 1.0001 * deflection ||
      a.WorstShare > 1.0)
    {
      std::printf("  %s #%d: %zu faces, %lld triangles (OpenCASCADE %lld), empty %d (%d), open sides %d "
                  "(%d), inverted %d (%d), "
                  "deviation %.3g (%.3g), promise %.3g of the deflection, reached %.3g of it\n",
        part.Name.c_str(), part.FileId, faces.size(), a.Triangles, b.Triangles, a.EmptyFaces, b.EmptyFaces,
        a.OpenSides, b.OpenSides, a.Inverted, b.Inverted, a.Deviation / deflection, b.Deviation / deflection,
        promised / deflection, a.WorstShare);
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
    if (std::strcmp(argv[i], "--verbose") == 0)
    {
      Verbose = true;
      continue;
    }
    const Totals before = All;
    vtkNew<MeshReader> reader;
    reader->SetLinearDeflection(0.1);
    reader->SetFileName(argv[i]);
    reader->Update();
    std::printf("%-40s %8lld triangles (OpenCASCADE %8lld)  %.3f s (%.3f s)\n",
      std::strrchr(argv[i], '/') ? std::strrchr(argv[i], '/') + 1 : argv[i],
      All.Mesh[0].Triangles - before.Mesh[0].Triangles, All.Mesh[1].Triangles - before.Mesh[1].Triangles,
      All.Seconds[0] - before.Seconds[0], All.Seconds[1] - before.Seconds[1]);
    std::fflush(stdout);
  }
  const char* names[2] = { "ours", "OpenCASCADE" };
  for (int k = 0; k < 2; ++k)
  {
    const smtest::MeshMeasures& m = All.Mesh[k];
    std::printf("%-12s %.3f s, %lld points, %lld triangles, %.3g million a second; faces without triangles "
                "%d, open sides %d, inverted "
                "%d; deviation %.3g of the deflection, %.3g of what is stated\n",
      names[k], All.Seconds[k], m.Points, m.Triangles,
      1e-6 * static_cast<double>(m.Triangles) / All.Seconds[k], m.EmptyFaces, m.OpenSides, m.Inverted,
      m.Deviation, m.WorstShare);
  }
  return All.Mesh[0].WorstShare <= 1.0 && All.Mesh[0].EmptyFaces + All.Mesh[0].Inverted == 0 ? 0 : 1;
}

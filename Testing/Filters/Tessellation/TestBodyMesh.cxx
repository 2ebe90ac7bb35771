// TestBodyMesh FOLDER: meshes of the exact solids are closed, keep their promise on dense samples, have no
// triangle inverted, converge to the exact volume, and have the same bits for any number of threads.
#include "smMeshMeasures.h"
#include "smTestFaces.h"
#include "smTestManifest.h"
#include "smTesting.h"

#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSMPTools.h>
#include <vtkSTEPReader.h>
#include <vtkTrimmedNURBSModel.h>

namespace
{
using namespace smtest;

std::vector<sm::FacePointer> ReadFaces(const std::string& path)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  auto* leaf = vtkNURBSDataSet::SafeDownCast(reader->GetOutput()->GetPartitionAsDataObject(0, 0));
  return leaf && leaf->GetModel() ? leaf->GetModel()->GetFaces() : std::vector<sm::FacePointer>();
}

bool IsPolyhedron(const std::vector<sm::FacePointer>& faces)
{
  return std::all_of(faces.begin(), faces.end(),
    [](const sm::FacePointer& face)
    {
      const auto isStraight = [](const sm::Coedge& c)
      { return c.Use->Curve.Coefficients.size() == 2 && c.Curve.Coefficients.size() == 2; };
      return face->Surface.ControlPoints.size() == 4 && !face->Surface.Rational &&
        std::all_of(face->Loops.begin(), face->Loops.end(),
          [&](const sm::Loop& loop)
          { return std::all_of(loop.Coedges.begin(), loop.Coedges.end(), isStraight); });
    });
}

/// Largest part of a stated turn of the normal that was measured, over all solids.
double MaxTurnShare = 0.0;

void CheckSolid(const Expected& solid)
{
  const std::vector<sm::FacePointer> faces = ReadFaces(solid.Path);
  CheckTrue(solid.Solid + " is read", !faces.empty());
  for (int i = 0; i < 2; ++i)
  {
    sm::MeshLimits limits;
    limits.Deflection = (i == 0 ? 4e-3 : 1e-3) * solid.Size;
    limits.Angle = 1.0;
    const std::vector<sm::FaceMesh> meshes = sm::MeshFaces(faces, limits);
    const MeshMeasures m = MeasureMesh(faces, meshes);
    CheckEqual(solid.Solid + ": faces without triangles", 0, m.EmptyFaces);
    CheckEqual(solid.Solid + ": open sides", 0, m.OpenSides);
    CheckEqual(solid.Solid + ": triangles inverted", 0, m.Inverted);
    CheckRange(solid.Solid + ": distance / stated", 0.0, m.WorstShare, 1.0);
    CheckRange(solid.Solid + ": turn of the normal / stated", 0.0, m.WorstTurnShare, 1.0);
    MaxTurnShare = std::max(MaxTurnShare, m.WorstTurnShare);
    double stated = 0.0;
    double turn = 0.0;
    for (const sm::FaceMesh& mesh : meshes)
    {
      stated = std::max(stated, mesh.Deviation);
      turn = std::max(turn, mesh.NormalTurn);
    }
    if (IsPolyhedron(faces))
    {
      CheckRange(solid.Solid + ": stated turn", 0.0, turn, 1e-9);
    }
    CheckRange(solid.Solid + ": stated / deflection", 0.0, stated / limits.Deflection, 1.0);
    // The closed mesh lies within the stated distance of the surface; rounding of 1e5 triangles, where the
    // solid is a polyhedron.
    CheckRange(solid.Solid + ": error of the volume", 0.0, std::abs(m.Volume - solid.Volume),
      1.1 * m.Area * stated + 1e-12 * solid.Volume, "linear in the deflection");
  }
}

/// The error of the volume falls at least linearly with the deflection; that of a polyhedron is rounding.
void CheckConvergence(const Expected& solid)
{
  const std::vector<sm::FacePointer> faces = ReadFaces(solid.Path);
  const double deflections[2] = { 8e-3 * solid.Size, 5e-4 * solid.Size };
  double errors[2];
  double area = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const MeshMeasures m = MeasureMesh(faces, sm::MeshFaces(faces, { deflections[i], 1.2 }));
    errors[i] = std::abs(m.Volume - solid.Volume);
    area = m.Area;
  }
  if (IsPolyhedron(faces))
  {
    Check(solid.Solid + ": error of a polyhedron's volume", 0.0, std::max(errors[0], errors[1]),
      1e-13 * solid.Volume, "rounding of a few triangles");
    return;
  }
  // Numbers of triangles are whole, so that meshes do not use the deflection alike; and errors of both signs
  // may cancel in the coarse mesh.
  const double coarse = std::max(errors[0], 0.01 * area * deflections[0]);
  CheckRange(solid.Solid + ": error of the volume with a 16th of the deflection", 0.0, errors[1],
    2.5 / 16.0 * coarse, "linear, and a factor 2.5");
}

/// Points that equal steps put next to the end of a piece of an edge, by rounding, are at the end: else
/// chords were halved there until points of a face fell together.
void CheckManyDeflections(const Expected& solid)
{
  const std::vector<sm::FacePointer> faces = ReadFaces(solid.Path);
  int open = 0;
  double shortest = HUGE_VAL;
  for (int i = 0; i < 60; ++i)
  {
    const double deflection = 1e-3 * std::pow(1.05, i) * solid.Size;
    const std::vector<sm::FaceMesh> meshes = sm::MeshFaces(faces, { deflection, 0.35 });
    open += MeasureMesh(faces, meshes, 1 << 20).OpenSides;
    for (const sm::FaceMesh& mesh : meshes)
    {
      for (const auto& t : mesh.Triangles)
      {
        for (int k = 0; k < 3; ++k)
        {
          const sm::Vector3 side = sm::Subtract(mesh.Points[t[k]], mesh.Points[t[(k + 1) % 3]]);
          shortest = std::min(shortest, sm::Norm(side) / deflection);
        }
      }
    }
  }
  CheckEqual(solid.Solid + " at 60 deflections: open sides", 0, open);
  CheckRange(solid.Solid + " at 60 deflections: shortest side / deflection", 0.1, shortest, 100.0);
}

void CheckThreads(const Expected& solid)
{
  const std::vector<sm::FacePointer> faces = ReadFaces(solid.Path);
  std::vector<sm::FaceMesh> meshes[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkSMPTools::SetBackend(i == 0 ? "Sequential" : "STDThread");
    meshes[i] = sm::MeshFaces(faces, { 1e-3 * solid.Size, 0.35 });
  }
  int different = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    different +=
      meshes[0][f].Points == meshes[1][f].Points && meshes[0][f].Triangles == meshes[1][f].Triangles ? 0 : 1;
  }
  CheckEqual("faces that differ on several threads", 0, different);
}

using Coefficients2 = std::vector<std::array<double, 2>>;
using Coefficients3 = std::vector<std::array<double, 3>>;

/// An edge with the Bernstein coefficients of its curve in space and in (u,v).
sm::Coedge MakeCoedge(const Coefficients3& curve, const Coefficients2& trim)
{
  auto edge = std::make_shared<sm::Edge>();
  edge->Curve.Breaks.push_back(0.0);
  edge->Curve.AppendPiece(1.0, curve.data(), static_cast<int>(curve.size()) - 1);
  edge->StartVertex = curve.front();
  edge->EndVertex = curve.back();
  sm::Coedge coedge;
  coedge.Use = edge;
  coedge.Curve.Breaks.push_back(0.0);
  coedge.Curve.AppendPiece(1.0, trim.data(), static_cast<int>(trim.size()) - 1);
  return coedge;
}

sm::Coedge MakeReversed(sm::Coedge coedge)
{
  coedge.Reversed = true;
  return coedge;
}

/// A square of side 3, with (u,v) from 0 to 2, that is trimmed by polygons in (u,v).
sm::FacePointer MakeTrimmedSquare(const std::vector<Coefficients2>& polygons)
{
  auto face = std::make_shared<sm::Face>(*MakeSquare(3.0, 2));
  for (const Coefficients2& polygon : polygons)
  {
    face->Loops.emplace_back();
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Coefficients2 trim{ polygon[i], polygon[(i + 1) % polygon.size()] };
      Coefficients3 ends(2);
      for (int k = 0; k < 2; ++k)
      {
        face->Surface.Evaluate(trim[k][0], trim[k][1], ends[k].data());
      }
      face->Loops.back().Coedges.push_back(MakeCoedge(ends, trim));
    }
  }
  return face;
}

/// Loops as no file should have them: each face has the triangles of what its loops wind around, or a reason.
void CheckLoops()
{
  const Coefficients2 whole{ { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
  const Coefficients2 clockwise{ { 0, 0 }, { 0, 2 }, { 2, 2 }, { 2, 0 } };
  const struct
  {
    std::string Name;
    std::vector<Coefficients2> Polygons;
    /// In cells of 1.5 by 1.5.
    double Area;
    std::string Reason;
  } cases[] = {
    { "no loops", {}, 4.0, "" },
    { "a loop that crosses itself", { { { 0.2, 0.2 }, { 1.8, 1.8 }, { 1.8, 0.2 }, { 0.2, 1.8 } } }, 0.64,
      "" },
    { "a loop that crosses itself in three places",
      { { { 0.1, 0.1 }, { 1.9, 0.1 }, { 1.9, 1.7 }, { 0.7, 0.0 }, { 0.6, 1.9 }, { 0.2, 0.05 } } }, -1.0,
      "cross" },
    { "a clockwise loop", { clockwise }, 4.0, "" },
    { "two squares that touch in a vertex",
      { { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 }, { 1, 1 }, { 0, 1 } } }, 2.0, "" },
    { "a hole that touches the border", { whole, { { 1, 0 }, { 0.5, 1 }, { 1.5, 1 } } }, 3.5, "" },
    { "a hole with a side on the border", { whole, { { 0.5, 0 }, { 0.5, 1 }, { 1.5, 1 }, { 1.5, 0 } } }, 3.0,
      "" },
    { "a hole that reaches beyond the border",
      { whole, { { 0.5, 1.4 }, { 0.6, 2.3 }, { 1.5, 2.7 }, { 1.4, 1.3 } } }, -1.0, "cross" },
    { "a loop with a spike", { { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 0, 2 } } },
      4.0, "" },
    { "a loop that is used twice", { whole, whole }, 4.0, "" },
    { "a hole as large as the face", { whole, clockwise }, 0.0, "encloses no area" },
    { "a loop forth and back", { { { 0.2, 0.2 }, { 1.8, 1.0 } } }, 0.0, "encloses no area" },
    { "a loop that is a point on a knot", { { { 1, 1 }, { 1, 1 } } }, 0.0, "encloses no area" },
  };
  for (const auto& c : cases)
  {
    const sm::FacePointer face = MakeTrimmedSquare(c.Polygons);
    const std::vector<sm::FaceMesh> meshes = sm::MeshFaces({ face }, { 1e-3, 0.35 });
    const MeshMeasures m = MeasureMesh({ face }, meshes);
    if (c.Area >= 0.0)
    {
      Check(c.Name + ": area", 2.25 * c.Area, m.Area, 1e-6, "steps of the grid");
    }
    else
    {
      CheckTrue(c.Name + ": triangles", m.Area > 1.0);
    }
    CheckEqual(c.Name + ": a reason", !c.Reason.empty(), !meshes[0].Reason.empty());
    CheckTrue(
      c.Name + ": \"" + meshes[0].Reason + "\"", meshes[0].Reason.find(c.Reason) != std::string::npos);
  }
}

/// (u, u^2 + width v, 0) on the unit square, with edges along its borders; the one at v = 1 has a vertex at u
/// = 0.3. `lift`: how far the edge at v = 0 lies off the surface, towards v = 1.
sm::FacePointer MakeBentStrip(double width, double lift)
{
  auto face = std::make_shared<sm::Face>(*MakeSquare(1.0, 1));
  sm::NURBSSurface& s = face->Surface;
  s.Degree[0] = 2;
  s.Degree[1] = 1;
  s.Knots[0] = { 0, 0, 0, 1, 1, 1 };
  s.Knots[1] = { 0, 0, 1, 1 };
  s.NumberOfControlPoints[0] = 3;
  s.NumberOfControlPoints[1] = 2;
  s.ControlPoints = { { 0, 0, 0, 1 }, { 0.5, 0, 0, 1 }, { 1, 1, 0, 1 }, { 0, width, 0, 1 },
    { 0.5, width, 0, 1 }, { 1, 1 + width, 0, 1 } };
  const double y = width;
  face->Loops = { { {
    MakeCoedge({ { 0, 0, 0 }, { 0.5, lift, 0 }, { 1, 1, 0 } }, { { 0, 0 }, { 1, 0 } }),
    MakeCoedge({ { 1, 1, 0 }, { 1, 1 + y, 0 } }, { { 1, 0 }, { 1, 1 } }),
    MakeReversed(
      MakeCoedge({ { 0.3, 0.09 + y, 0 }, { 0.65, 0.3 + y, 0 }, { 1, 1 + y, 0 } }, { { 0.3, 1 }, { 1, 1 } })),
    MakeReversed(MakeCoedge({ { 0, y, 0 }, { 0.15, y, 0 }, { 0.3, 0.09 + y, 0 } }, { { 0, 1 }, { 0.3, 1 } })),
    MakeReversed(MakeCoedge({ { 0, 0, 0 }, { 0, y, 0 } }, { { 0, 0 }, { 0, 1 } })),
  } } };
  return face;
}

/// Faces that are narrower than the deflection: their chords would cross in space, or lie on one line.
void CheckNarrowFaces()
{
  const sm::FacePointer strip = MakeBentStrip(0.01, 0.0);
  std::vector<sm::FaceMesh> meshes = sm::MeshFaces({ strip }, { 0.3, 1.0 });
  CheckEqual("triangles of a narrow strip that are inverted", 0, MeasureMesh({ strip }, meshes).Inverted);
  CheckTrue("and no reason", meshes[0].Reason.empty() && !meshes[0].Triangles.empty());
  const sm::FacePointer gap = MakeBentStrip(0.01, 0.1);
  meshes = sm::MeshFaces({ gap }, { 0.3, 1.0 });
  const int inverted = MeasureMesh({ gap }, meshes).Inverted;
  CheckRange("triangles inverted by an edge beyond the other side", 1.0, inverted, 10.0, "22 without repair");
  CheckRange("triangles there", 1.0, static_cast<double>(meshes[0].Triangles.size()), 150.0,
    "229 if chords were halved for the gap, too");
  CheckEqual("and the mesh says so", inverted, meshes[0].InvertedTriangles);
  CheckTrue("by a sentence", meshes[0].Reason.find("inverted") != std::string::npos);

  // Between y = 1 and a parabola that is 0.05 below it, both with one chord.
  const sm::FacePointer square = MakeSquare(3.0, 1);
  auto lens = std::make_shared<sm::Face>(*square);
  lens->Loops = { { { MakeCoedge({ { 0.3, 1, 0 }, { 1.5, 0.9, 0 }, { 2.7, 1, 0 } },
                        { { 0.1, 1.0 / 3 }, { 0.5, 0.3 }, { 0.9, 1.0 / 3 } }),
    MakeReversed(MakeCoedge({ { 0.3, 1, 0 }, { 2.7, 1, 0 } }, { { 0.1, 1.0 / 3 }, { 0.9, 1.0 / 3 } })) } } };
  meshes = sm::MeshFaces({ lens }, { 0.1, 1.0 });
  CheckTrue("a lens that is thinner than the deflection has triangles", !meshes[0].Triangles.empty());
}

/// (500 + t, 500 + height (1 - t^2), 0) for t from -1 to 1, of two pieces, in the plane of MakeSquare(1000.0,
/// 1).
sm::Coedge MakeParabola(double height)
{
  const double c = 500.0;
  const double y = c + height;
  const Coefficients3 pieces[2] = { { { c - 1.0, c, 0 }, { c - 0.5, y, 0 }, { c, y, 0 } },
    { { c, y, 0 }, { c + 0.5, y, 0 }, { c + 1.0, c, 0 } } };
  auto edge = std::make_shared<sm::Edge>();
  edge->StartVertex = pieces[0].front();
  edge->EndVertex = pieces[1].back();
  edge->Curve.Breaks.push_back(-1.0);
  sm::Coedge coedge;
  coedge.Use = edge;
  coedge.Curve.Breaks.push_back(-1.0);
  for (int k = 0; k < 2; ++k)
  {
    Coefficients2 trim;
    for (const auto& p : pieces[k])
    {
      trim.push_back({ 1e-3 * p[0], 1e-3 * p[1] });
    }
    edge->Curve.AppendPiece(k, pieces[k].data(), 2);
    coedge.Curve.AppendPiece(k, trim.data(), 2);
  }
  return coedge;
}

/// Chords that begin a rounding step before a break at 0: the piece that they only touch is not part of them.
void CheckBreaksAtZero()
{
  const sm::Coedge upper = MakeParabola(1.0);
  const sm::Coedge lower = MakeParabola(-1.0);
  auto plate = std::make_shared<sm::Face>(*MakeSquare(1000.0, 1));
  auto fill = std::make_shared<sm::Face>(*plate);
  plate->Loops.emplace_back();
  const Coefficients2 corners{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  for (int i = 0; i < 4; ++i)
  {
    const auto& [u, v] = corners[i];
    const auto& [s, t] = corners[(i + 1) % 4];
    plate->Loops[0].Coedges.push_back(
      MakeCoedge({ { 1e3 * u, 1e3 * v, 0 }, { 1e3 * s, 1e3 * t, 0 } }, { { u, v }, { s, t } }));
  }
  plate->Loops.push_back({ { upper, MakeReversed(lower) } });
  fill->Loops = { { { lower, MakeReversed(upper) } } };
  int open = 0;
  for (int i = 0; i < 300; ++i)
  {
    const std::vector<sm::FacePointer> faces{ plate, fill };
    open += MeasureMesh(faces, sm::MeshFaces(faces, { 1e-4 * std::pow(1.02, i), 1.2 }), 1 << 20).OpenSides;
  }
  CheckEqual("breaks at zero: open sides, those of the border", 4 * 300, open);
}

/// A roof so flat that its ridge is not a crease: the stated deviation holds all the same.
void CheckFlatRidge()
{
  auto face = std::make_shared<sm::Face>(*MakeSquare(1000.0, 2));
  for (int j = 0; j < 3; ++j)
  {
    face->Surface.ControlPoints[1 + 3 * j][2] = 1e-6;
  }
  const MeshMeasures m = MeasureMesh({ face }, sm::MeshFaces({ face }, { 10.0, 1.0 }));
  CheckRange("a flat ridge: distance", 1e-7, m.Deviation, 2e-6);
  CheckRange("a flat ridge: distance / stated", 0.01, m.WorstShare, 1.0);
}
}

int TestBodyMesh(int argc, char* argv[])
{
  if (argc < 2)
  {
    return 1;
  }
  const Manifest manifest(argv[1]);
  for (const Expected& solid : manifest.GetVariant("plain"))
  {
    CheckSolid(solid);
    CheckConvergence(solid);
    if (solid.Solid == "sphere" || solid.Solid == "bicylinder" || solid.Solid == "slanted_hole")
    {
      CheckManyDeflections(solid);
    }
  }
  CheckRange("largest turn of a normal / stated, all solids", 0.5, MaxTurnShare, 1.0);
  CheckThreads(manifest.GetVariant("plain").front());
  CheckLoops();
  CheckNarrowFaces();
  CheckFlatRidge();
  CheckBreaksAtZero();
  return Finish();
}

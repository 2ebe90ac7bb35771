// Boundaries that cross themselves are distinguished from those that touch, are thin, have voids, or are
// coarsely meshed; with any number of threads; and an edit is not checked again.
#include "smBoxBodies.h"
#include "smMassIntegrands.h"
#include "smMeshTriangles.h"
#include "smSelfCrossing.h"
#include "smTesting.h"
#include "smVector.h"

#include <vtkDoubleArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <cmath>

namespace
{
using namespace smtest;

/// The body of a leaf whose faces' exact integrals are those of its mesh, in which all normals point
/// outwards.
sm::BodyIntegrals MakeBody(vtkNURBSDataSet* leaf)
{
  sm::BodyIntegrals body;
  body.Model = leaf->GetModel();
  body.Mesh = leaf;
  body.Status = sm::Status::Ok;
  std::copy_n(leaf->GetPlacementData(), 16, body.Placement.begin());
  std::vector<sm::FaceIntegrals> faces(static_cast<std::size_t>(body.Model->GetNumberOfFaces()));
  body.Value.assign(sm::NumberOfMassIntegrands, 0.0);
  for (sm::FaceIntegrals& face : faces)
  {
    face.Face.assign(sm::NumberOfMassIntegrands, 0.0);
  }
  sm::VisitTriangles(leaf, faces.size(),
    [&](std::size_t f, const auto& corners, const auto&)
    {
      const sm::Vector3 twice =
        sm::Cross(sm::Subtract(corners[1], corners[0]), sm::Subtract(corners[2], corners[0]));
      const double side = body.Model->GetFaces()[f]->Reversed ? -1.0 : 1.0;
      for (int d = 0; d < 3; ++d)
      {
        faces[f].Face[sm::MassVectorArea + d] += 0.5 * side * twice[d];
      }
      faces[f].Face[sm::MassVolume] += side * sm::Dot(corners[0], twice) / 6.0;
      faces[f].Face[sm::MassArea] += 0.5 * sm::Norm(twice);
      body.Value[sm::MassArea] += 0.5 * sm::Norm(twice);
    });
  body.Faces = std::make_shared<const std::vector<sm::FaceIntegrals>>(std::move(faces));
  return body;
}

sm::BodyIntegrals MakeBoxes(const std::vector<BoxShell>& boxes)
{
  BoxBody maker;
  for (const BoxShell& box : boxes)
  {
    maker.Add(box);
  }
  return MakeBody(maker.Make());
}

/// A torus about the z axis for each height, with the exact normals, as one face. With tube > ring it is a
/// spindle.
sm::BodyIntegrals MakeTori(double ring, double tube, int n, const std::vector<double>& heights)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIntArray> faces;
  faces->SetName(vtkNURBSDataSet::FaceIndexArrayName());
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (const double height : heights)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    for (int k = 0; k < (n + 1) * (n + 1); ++k)
    {
      const int i = k / (n + 1);
      const int j = k % (n + 1);
      const double a = 2.0 * vtkMath::Pi() * i / n;
      const double b = 2.0 * vtkMath::Pi() * j / n;
      const double normal[3] = { std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b) };
      normals->InsertNextTuple(normal);
      points->InsertNextPoint(ring * std::cos(a) + tube * normal[0], ring * std::sin(a) + tube * normal[1],
        height + tube * normal[2]);
      if (i < n && j < n)
      {
        const vtkIdType p = first + k;
        const vtkIdType halves[2][3] = { { p, p + n + 1, p + n + 2 }, { p, p + n + 2, p + 1 } };
        triangles->InsertNextCell(3, halves[0]);
        triangles->InsertNextCell(3, halves[1]);
        faces->InsertNextValue(0);
        faces->InsertNextValue(0);
      }
    }
  }
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->FileId = 77;
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetFaces({ face });
  double bounds[6];
  points->GetBounds(bounds);
  model->SetLocalBounds(bounds);
  vtkNew<vtkNURBSDataSet> leaf;
  leaf->SetPoints(points);
  leaf->SetPolys(triangles);
  leaf->GetPointData()->SetNormals(normals);
  leaf->GetCellData()->AddArray(faces);
  leaf->SetModel(model);
  return MakeBody(leaf);
}

sm::SelfCrossing CheckWinding(const char* name, const sm::BodyIntegrals& body, int winding)
{
  const sm::SelfCrossing found = sm::FindSelfCrossing({ &body });
  CheckEqual(std::string(name) + ": checked", "", found.Unchecked);
  CheckEqual(std::string(name) + ": winding number", winding, found.Winding);
  CheckTrue(std::string(name) + ": points", found.Samples >= 400, std::to_string(found.Samples));
  return found;
}

void CheckBoxes()
{
  const BoxShell box{ { 0, 0, 0 }, { 10, 12, 14 } };
  const auto with = [&box](const BoxShell& other) { return MakeBoxes({ box, other }); };
  CheckWinding("a box", MakeBoxes({ box }), 0);
  CheckWinding("a thin wall", MakeBoxes({ { { 0, 0, 0 }, { 10, 12, 1e-4 } } }), 0);
  CheckWinding("a box with a void", with({ { 3, 3, 3 }, { 5, 5, 5 }, false }), 0);
  CheckWinding("a void 1e-6 from the wall", with({ { 3, 3, 1e-6 }, { 5, 5, 5 }, false }), 0);
  CheckWinding("a box that touches another at an edge", with({ { 10, 12, 0 }, { 20, 20, 14 } }), 0);
  CheckWinding("at a corner", with({ { 10, 12, 14 }, { 20, 20, 20 } }), 0);
  CheckWinding("on a face", with({ { 10, 0, 0 }, { 20, 12, 14 } }), 0);
  CheckWinding("on a part of a face", with({ { 10, 2, 3 }, { 20, 6, 6 } }), 0);
  CheckWinding("a box 1e-6 from another", with({ { 10 + 1e-6, 0, 0 }, { 20, 12, 14 } }), 0);
  const sm::SelfCrossing half = CheckWinding("boxes that overlap", with({ { 5, 6, 7 }, { 15, 18, 21 } }), 2);
  for (int d = 0; d < 3; ++d)
  {
    CheckRange("the point lies in both", 5.0 + d, half.Point[d], 10.0 + 2.0 * d);
  }
  CheckWinding("boxes that overlap by a hundredth", with({ { 9.9, 0.1, 0.1 }, { 19, 11, 13 } }), 2);
  CheckWinding("by a millionth", with({ { 10 - 1e-5, 0.1, 0.1 }, { 19, 11, 13 } }), 2);
  CheckWinding("a box in a box", with({ { 3, 3, 3 }, { 5, 5, 5 } }), 2);
  CheckWinding("a void that leaves its box", with({ { 3, 3, -1 }, { 5, 5, 5 }, false }), -1);
  CheckWinding(
    "three boxes", MakeBoxes({ box, { { 1, 1, 1 }, { 9, 11, 13 } }, { { 2, 2, 2 }, { 8, 10, 12 } } }), 2);
}

/// Gaps excuse an overlap, the uncertainty that the file states does not; what the run reversed is reversed
/// here.
void CheckStates()
{
  sm::BodyIntegrals body = MakeBoxes({ { { 0, 0, 0 }, { 10, 12, 14 } }, { { 9.9, 0, 0 }, { 19, 11, 13 } } });
  body.MaxGap = 0.2;
  CheckWinding("an overlap smaller than the gaps", body, 0);
  body.MaxGap = vtkMath::Nan();
  CheckWinding("gaps that are not known", body, 2);
  body.Model->SetFileUncertainty(0.2);
  CheckWinding("an overlap smaller than the file's uncertainty", body, 2);

  body = MakeBoxes({ { { 0, 0, 0 }, { 10, 12, 14 }, false } });
  CheckWinding("a box inside out", body, -1);
  body.InsideOut = true;
  CheckWinding("one that the run reversed", body, 0);
  body.InsideOut = false;
  body.Sides.assign(6, -1);
  CheckWinding("shell by shell", body, 0);

  BoxBody maker;
  maker.Add({ { 0, 0, 0 }, { 10, 12, 14 } });
  maker.Add({ { 5, 5, 5 }, { 11, 13, 15 } });
  const auto leaf = maker.Make();
  body = MakeBody(leaf);
  body.Placement = { -1, 0, 0, 0, 0, 1, 0, 100, 0, 0, 1, 0, 0, 0, 0, 1 };
  for (vtkIdType i = 0; i < leaf->GetNumberOfPoints(); ++i)
  {
    double p[3];
    leaf->GetPoint(i, p);
    leaf->GetPoints()->SetPoint(i, -p[0], p[1] + 100.0, p[2]);
  }
  const sm::SelfCrossing placed = CheckWinding("a mirrored part", body, 2);
  CheckRange("the point is the part's", 5.0, placed.Point[0], 10.0);

  body = MakeBoxes({ { { 0, 0, 0 }, { 10, 12, 14 } } });
  std::vector<sm::FaceIntegrals> larger = *body.Faces;
  larger[2].Face[sm::MassArea] *= 2.0;
  body.Faces = std::make_shared<const std::vector<sm::FaceIntegrals>>(larger);
  CheckEqual("a face of twice the area of its mesh", "the display mesh of face #102 does not cover it once",
    sm::FindSelfCrossing({ &body }).Unchecked);
  body.Mesh = nullptr;
  CheckEqual("no mesh", "it has no display mesh", sm::FindSelfCrossing({ &body }).Unchecked);
}

void CheckTori()
{
  for (const int n : { 12, 60 })
  {
    CheckWinding("a ring torus", MakeTori(10.0, 3.0, n, { 0.0 }), 0);
    CheckWinding("a ring with a narrow hole", MakeTori(10.0, 9.99, n, { 0.0 }), 0);
    // Its core is a void.
    CheckWinding("a spindle torus", MakeTori(4.0, 6.0, n, { 0.0 }), 0);
    CheckWinding("two rings that overlap", MakeTori(10.0, 3.0, n, { 0.0, 3.0 }), 2);
    CheckWinding("two rings that touch", MakeTori(10.0, 3.0, n, { 0.0, 6.0 }), 0);
  }
  // The overlap is 0.2 high, less than the deviation of the coarse mesh.
  CheckWinding("two rings that overlap slightly, on a coarse mesh", MakeTori(10.0, 3.0, 6, { 0.0, 5.8 }), 0);
  const sm::BodyIntegrals fine = MakeTori(10.0, 3.0, 200, { 0.0, 5.8 });
  CheckWinding("on a fine mesh", fine, 2);
  const sm::SelfCrossing stopped = sm::FindSelfCrossing({ &fine }, []() { return false; });
  CheckTrue("stopped", stopped.Winding == 0 && !stopped.Unchecked.empty(), stopped.Unchecked);
}

void CheckThreads()
{
  const sm::BodyIntegrals body = MakeTori(10.0, 3.0, 90, { 0.0, 3.0 });
  vtkSMPTools::Initialize(1);
  const sm::SelfCrossing one = sm::FindSelfCrossing({ &body });
  vtkSMPTools::Initialize(4);
  const sm::SelfCrossing four = sm::FindSelfCrossing({ &body });
  CheckTrue("one thread and four find the same point",
    one.Point == four.Point && one.Samples == four.Samples && one.Undecided == four.Undecided);
}

/// A body, its edits and its instances share one result; another body has its own.
void CheckCache()
{
  const BoxShell box{ { 0, 0, 0 }, { 10, 12, 14 } };
  std::vector<sm::BodyIntegrals> bodies = { MakeBoxes({ box, { { 5, 6, 7 }, { 15, 18, 21 } } }),
    MakeBoxes({ box }) };
  sm::SelfCrossingCheck check;
  const std::vector<sm::BodyIntegrals> before = bodies;
  check.Run(bodies, true);
  CheckEqual("suspect", sm::GetText(sm::Status::Suspect), sm::GetText(bodies[0].Status));
  CheckEqual("ok", sm::GetText(sm::Status::Ok), sm::GetText(bodies[1].Status));
  CheckTrue("says where, and what it means",
    bodies[0].Reason.find("crosses itself: near face #1") != std::string::npos &&
      bodies[0].Reason.find("its winding number is 2: the volume there counts 2 times") != std::string::npos,
    bodies[0].Reason);
  CheckEqual("nothing is said of a sound one", 0, static_cast<long long>(bodies[1].Messages.size()));

  // The mesh of a crossing body with the faces of a sound one, all of them or but one: as known.
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(before[1].Model);
  auto changed = std::make_shared<sm::Face>(*model->GetFaces()[0]);
  changed->Id = sm::NewId();
  model->SetFace(0, changed);
  bodies = { before[1] };
  bodies[0].Model = model;
  bodies[0].Mesh = before[0].Mesh;
  check.Run(bodies, false);
  CheckEqual("an edit is not checked", sm::GetText(sm::Status::Ok), sm::GetText(bodies[0].Status));
  CheckEqual("and gets no note", 0, static_cast<long long>(bodies[0].Messages.size()));
  bodies = { before[1] };
  bodies[0].Mesh = nullptr;
  check.Run(bodies, true);
  CheckEqual("the body before the edit is still known", 0, static_cast<long long>(bodies[0].Messages.size()));
  // The crossing body as an edit of the sound one: one of its faces is a face of that.
  for (const bool checkEdits : { false, true })
  {
    sm::SelfCrossingCheck edits;
    bodies = { before[1] };
    edits.Run(bodies, checkEdits);
    bodies = { before[0] };
    model->ShallowCopy(before[0].Model);
    auto shared = std::make_shared<sm::Face>(*model->GetFaces()[0]);
    shared->Id = before[1].Model->GetFaces()[0]->Id;
    model->SetFace(0, shared);
    bodies[0].Model = model;
    edits.Run(bodies, checkEdits);
    CheckEqual("an edit is checked only where it is asked for",
      sm::GetText(checkEdits ? sm::Status::Suspect : sm::Status::Ok), sm::GetText(bodies[0].Status));
  }
  // The first is checked, the second is not.
  bodies = before;
  sm::SelfCrossingCheck stopped;
  stopped.Run(bodies, true, []() { return false; });
  CheckEqual("before the run is stopped", sm::GetText(sm::Status::Suspect), sm::GetText(bodies[0].Status));
  CheckEqual("after it: a note", 1, static_cast<long long>(bodies[1].Messages.size()));
  bodies = before;
  stopped.Run(bodies, true);
  CheckEqual("checked in the next", 0, static_cast<long long>(bodies[1].Messages.size()));
  check.Clear();
  bodies = { before[1] };
  bodies[0].Mesh = nullptr;
  check.Run(bodies, true);
  CheckEqual("not known any more", 1, static_cast<long long>(bodies[0].Messages.size()));
  bodies = { before[0] };
  check.Run(bodies, true);
  CheckEqual("checked again", sm::GetText(sm::Status::Suspect), sm::GetText(bodies[0].Status));
  bodies = { before[0] };
  bodies[0].OpenEdges = 1;
  check.Run(bodies, true);
  CheckEqual("an open body is not", 0, static_cast<long long>(bodies[0].Messages.size()));
}
}

int TestSelfCrossing(int, char*[])
{
  CheckBoxes();
  CheckStates();
  CheckTori();
  CheckThreads();
  CheckCache();
  return Finish();
}

// Checks of drags and weights of a body that has a placement.
#include "smEditPartChecks.h"
#include "smNetMoments.h"

#include <vtkNURBSDataSet.h>
#include <vtkNURBSTransform.h>

namespace smtest
{
namespace
{
Point3 GetStored(EditSession& session, const sm::Grip& grip)
{
  std::array<double, 4> point{};
  sm::GetControlPoint(session.Part.GetBody(grip.Body)->GetModel(), grip.Face, grip.Index, point);
  return { point[0] / point[3], point[1] / point[3], point[2] / point[3] };
}

/// Drags a point along the normal of its face, then cancels the drag.
void CheckNormal(EditSession& session, const sm::Grip& grip)
{
  std::printf("--- along the normal\n");
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> before = GetFieldNumbers(mass);
  const Point3 now = GetWorld(session, grip);
  const Point3 normal = session.Part.GetNormal(grip);
  const std::array<int, 2> start = session.ToPixel(now);
  // The direction of the drag on the screen is that of the normal.
  const std::array<int, 2> tip =
    session.ToPixel({ now[0] + 10.0 * normal[0], now[1] + 10.0 * normal[1], now[2] + 10.0 * normal[2] });
  session.AddDrag(start[0], start[1], tip[0] - start[0], tip[1] - start[1], EditSession::Shift);
  session.Play();
  const Point3 pulled = GetWorld(session, grip);
  const Point3 pull{ pulled[0] - now[0], pulled[1] - now[1], pulled[2] - now[2] };
  const double along = vtkMath::Dot(pull, normal);
  Check("along the normal", std::hypot(pull[0], pull[1], pull[2]), along, 1e-9 * along);
  CheckRange("about 10", 7.0, along, 13.0, "pixels are whole, and nearer is larger");
  CheckTrue("outwards: more volume", mass->GetVolume() > before[0]);

  std::printf("--- cancelled\n");
  session.AddKey("z", EditSession::Control); // not in the middle of a drag
  session.AddKey("Escape");
  session.Add("LeftButtonReleaseEvent", tip[0], tip[1]);
  session.Play();
  CheckTrue("the bits before the drag", HaveSameBits(before, GetFieldNumbers(mass)));
}

void CheckWeight(EditSession& session, const sm::Grip& grip)
{
  std::printf("--- weight\n");
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> before = GetFieldNumbers(mass);
  const Point3 now = GetWorld(session, grip);
  const std::array<int, 2> start = session.ToPixel(now);
  session.Add("MouseWheelForwardEvent", start[0], start[1], EditSession::Control);
  session.Play();
  double weight = 0.0;
  session.Part.GetWeight(grip, weight);
  Check("weight", 1.25, weight, 0.0);
  CheckVector("the same position", now, GetWorld(session, grip), 1e-12 * 600.0);
  CheckTrue("other numbers", !HaveSameBits(before, GetFieldNumbers(mass)));
  CheckTrue("the bits of a full run", HaveSameBits(GetFieldNumbers(mass), RunAnew(session)));
  session.AddKey("z", EditSession::Control);
  session.Play();
  CheckTrue("undone, the same bits", HaveSameBits(before, GetFieldNumbers(mass)));
}

void CheckView(EditSession& session)
{
  std::printf("--- the view alone\n");
  const std::vector<double> before = GetFieldNumbers(session.Scene.GetMass());
  const std::size_t updates = session.Scene.GetTimes().size();
  session.AddDrag(20, 500, 60, 30);
  session.Add("LeftButtonReleaseEvent", 80, 530);
  session.Add("MouseWheelForwardEvent", 360, 280);
  session.Play();
  CheckTrue("changes no number", HaveSameBits(before, GetFieldNumbers(session.Scene.GetMass())));
  CheckEqual("and is not an update", static_cast<long long>(updates),
    static_cast<long long>(session.Scene.GetTimes().size()));
}
}

void CheckPlaced(vtkSTEPReader* reader, const std::string& folder)
{
  vtkNew<vtkNURBSTransform> place;
  place->SetInputData(reader->GetOutput());
  place->SetRotation(35.0, -20.0, 110.0);
  place->SetMirror(vtkNURBSTransform::X);
  place->SetTranslation(300.0, -500.0, 40.0);
  place->Update();
  EditSession session(
    vtkPartitionedDataSetCollection::SafeDownCast(place->GetOutputDataObject(0)), "placed", folder);
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> first = GetFieldNumbers(mass);
  // Where a user would click; then a point inside the face that was hit.
  int body = -1;
  int face = -1;
  for (int y = 150; y < 400 && face < 0; y += 10)
  {
    session.Scene.PickFace(360, y, body, face);
  }
  if (!CheckTrue("a face in the middle", face >= 0))
  {
    return;
  }
  session.ShowNet(body, face);
  const sm::Grip grip{ body, face, { 2, 2 } };
  NetMoments net(session.Part.GetBody(body)->GetModel());

  const Point3 was = GetWorld(session, grip);
  const Point3 stored = GetStored(session, grip);
  const std::array<int, 2> pixel = session.ToPixel(was);
  // Grabbed two pixels off: it must not jump.
  session.AddDrag(pixel[0] + 2, pixel[1] - 1, 37, 24);
  session.Add("LeftButtonReleaseEvent", pixel[0] + 39, pixel[1] + 23);
  const Point3 expected = session.ToDisplacement(was, 37, 24);
  session.Play();
  const int hit = session.Scene.GetNet().GetSelection();
  const sm::Grip dragged = session.Scene.GetNet().GetGrip(hit);
  CheckEqual("the point that was meant", 2 * 5 + 2, hit);
  CheckTrue("in its face", dragged.Face == face);
  const Point3 now = GetWorld(session, grip);
  const double length = std::hypot(expected[0], expected[1], expected[2]);
  CheckVector(
    "displacement", { was[0] + expected[0], was[1] + expected[1], was[2] + expected[2] }, now, 1e-8 * length);
  const Point3 storedNow = GetStored(session, grip);
  const Point3 storedBy{ storedNow[0] - stored[0], storedNow[1] - stored[1], storedNow[2] - stored[2] };
  Check("of the same length in the model", length, std::hypot(storedBy[0], storedBy[1], storedBy[2]),
    1e-8 * length);
  net.Move(stored, storedBy);
  net.Integrate();
  Check("volume", net.Volume, mass->GetVolume(), 1e-12 * net.Volume + mass->GetVolumeBound());
  CheckTrue("is another", std::fabs(mass->GetVolume() - first[0]) > 1.0);
  const std::vector<double> second = GetFieldNumbers(mass);
  CheckTrue("the bits of a full run", HaveSameBits(second, RunAnew(session)));

  CheckNormal(session, grip);
  CheckWeight(session, grip);
  CheckView(session);
}
}

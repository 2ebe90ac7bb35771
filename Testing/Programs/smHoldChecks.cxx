// Checks of drags with the volume held.
#include "smEditPartChecks.h"
#include "smNetMoments.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkNURBSDataSet.h>
#include <vtkSTEPWriter.h>
#include <vtkTimerLog.h>

#include <algorithm>

namespace smtest
{
namespace
{
namespace names = sm::names;

/// Looks at the part after each motion of the mouse, when the style has handled it.
struct Watch
{
  EditSession* Session = nullptr;
  double Held = 0.0;
  std::size_t Updates = 0;
  double WorstOfFilter = 0.0;
  double WorstOfFormula = 0.0;

  void Look()
  {
    const std::size_t updates = this->Session->Scene.GetTimes().size() - 1;
    if (updates == this->Updates)
    {
      return;
    }
    this->Updates = updates;
    const double volume = this->Session->Scene.GetMass()->GetVolume();
    NetMoments formula(this->Session->Part.GetBody(0)->GetModel());
    formula.Integrate();
    this->WorstOfFilter = std::max(this->WorstOfFilter, std::abs(volume / this->Held - 1.0));
    this->WorstOfFormula = std::max(this->WorstOfFormula, std::abs(formula.Volume / this->Held - 1.0));
  }
};

std::vector<Point3> GetNet(EditSession& session, int face)
{
  const sm::NURBSSurface& surface = session.Part.GetFace(0, face)->Surface;
  std::vector<Point3> points;
  for (const std::array<double, 4>& point : surface.ControlPoints)
  {
    points.push_back(sm::ToWorld(session.Part.GetBody(0), point));
  }
  return points;
}

void PrintTimes(EditSession& session)
{
  std::vector<double> seconds;
  const std::vector<sm::UpdateTimes>& times = session.Scene.GetTimes();
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    seconds.push_back(times[i].GetComputing());
  }
  std::sort(seconds.begin(), seconds.end());
  const double median = seconds.at(seconds.size() / 2);
  std::printf(
    "     %zu updates, median %.1f ms = %.0f a second without the picture; a drag begins in %.1f ms\n",
    seconds.size(), 1e3 * median, 1.0 / median, 1e3 * session.Scene.GetHold().GetBeginSeconds());
}

/// A drag that the part cannot make up for, and a weight: refused, with the volume as it is.
void CheckRefusals(EditSession& session, double held)
{
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  sm::VolumeHold& hold = session.Scene.GetHold();
  const std::vector<double> before = GetFieldNumbers(mass);
  vtkRenderWindowInteractor* interactor = session.Interactor;
  const int face = session.Scene.GetNet().GetFace();
  const std::array<int, 2> pixel = session.ToPixel(GetWorld(session, { 0, face, { 2, 2 } }));
  interactor->SetEventInformation(pixel[0], pixel[1]);
  interactor->LeftButtonPressEvent();
  interactor->SetEventInformation(pixel[0], pixel[1] + 20000);
  interactor->MouseMoveEvent();
  CheckTrue("a drag too far is refused", hold.GetMessage().find("cannot be held") != std::string::npos,
    hold.GetMessage());
  CheckTrue("nothing changed", HaveSameBits(before, GetFieldNumbers(mass)));
  interactor->LeftButtonReleaseEvent();
  interactor->SetEventInformation(pixel[0], pixel[1], 1);
  interactor->MouseWheelForwardEvent();
  CheckTrue("a weight is refused", HaveSameBits(before, GetFieldNumbers(mass)));
  Check("the volume", held, mass->GetVolume(), 1e-9 * held, "asked");
}
}

namespace
{
/// The volume of the part when it was saved and read again; NaN if that fails.
double GetVolumeOfSaved(const sm::EditedPart& part, const std::string& path)
{
  vtkNew<vtkSTEPWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputDataObject(part.GetBodies());
  writer->Write();
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  UseCoarseMesh(reader);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputConnection(reader->GetOutputPort());
  mass->SetBackend(vtkMassPropertiesGPU::CPU);
  mass->Update();
  return mass->GetVolume();
}

}

/// A corner of each net, which opens edges, and a point inside each fillet, which opens none.
void CheckHoldOfTrimmed(const std::string& file, const std::string& folder)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(file.c_str());
  UseCoarseMesh(reader);
  reader->Update();
  sm::EditedPart part(reader->GetOutput());
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetInputData(part.GetBodies());
  mass->SetBackend(vtkMassPropertiesGPU::CPU);
  mass->SetCheckEditedSolids(false);
  mass->Update();
  const double volume = mass->GetVolume();
  const int faces = part.GetBody(0)->GetModel()->GetNumberOfFaces();
  int closed = 0;
  for (int k = 0; k < 2 * faces; ++k)
  {
    const int face = k / 2;
    const int* count = part.GetFace(0, face)->Surface.NumberOfControlPoints;
    const bool isInside = k % 2 == 1;
    if (isInside && std::min(count[0], count[1]) < 3)
    {
      continue;
    }
    const sm::Grip grip{ 0, face, { isInside ? count[0] / 2 : 0, isInside ? count[1] / 2 : 0 } };
    sm::VolumeHold hold;
    hold.SetOn(true);
    CheckTrue(
      "a drag begins", hold.Begin(part, grip, sm::EditRule::MoveSharedBoundary, volume), hold.GetMessage());
    double seconds = 0.0;
    const int updates = isInside ? 5 : 1;
    for (int step = 1; step <= updates; ++step)
    {
      const double d = 0.2 * step / updates;
      const double start = vtkTimerLog::GetUniversalTime();
      const vtkSmartPointer<vtkTrimmedNURBSModel> model = hold.Solve({ 0.5 * d, -d, 0.5 * d });
      CheckTrue("solved", model && part.Replace(0, model), hold.GetMessage());
      mass->Update();
      seconds += vtkTimerLog::GetUniversalTime() - start;
      Check("volume", volume, mass->GetVolume(), 1e-9 * volume, "asked");
    }
    const std::size_t opened = part.GetOpened(0).size();
    std::printf("     face %d, point %d of %d, %d of %d: %zu edges opened, %.0f updates a second\n", face,
      grip.Index.U, count[0], grip.Index.V, count[1], opened, updates / seconds);
    if (opened == 0)
    {
      ++closed;
      Check("saved and read again", volume, GetVolumeOfSaved(part, folder + "/held.step"), 1e-9 * volume,
        "asked");
    }
    part.Cancel();
  }
  CheckRange("drags without an opened edge", 6, closed, 1e3);
}

void CheckHold(vtkSTEPReader* reader, const std::string& events, const std::string& folder)
{
  // The same events without, for the positions of dragged points and the volume that they would give.
  std::vector<Point3> free;
  double freeVolume = 0.0;
  {
    EditSession session(reader->GetOutput(), "free", folder);
    CheckEqual("played", "", sm::PlayEvents(session.Interactor, events));
    const int face = session.Scene.GetNet().GetFace();
    free = GetNet(session, face);
    freeVolume = session.Scene.GetMass()->GetVolume();
  }
  EditSession session(reader->GetOutput(), "held", folder);
  vtkMassPropertiesGPU* mass = session.Scene.GetMass();
  const std::vector<double> first = GetFieldNumbers(mass);
  Watch watch;
  watch.Session = &session;
  watch.Held = mass->GetVolume();
  session.AddKey("v");
  session.Play();
  CheckTrue("the key switches it on", session.Scene.GetHold().IsOn());
  vtkNew<vtkCallbackCommand> look;
  look->SetClientData(&watch);
  look->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { static_cast<Watch*>(client)->Look(); });
  // Below the priority of the style, which handles the event first.
  const unsigned long tag = session.Interactor->AddObserver(vtkCommand::MouseMoveEvent, look, -1.0f);
  CheckEqual("played", "", sm::PlayEvents(session.Interactor, events));
  session.Interactor->RemoveObserver(tag);
  CheckRange("updates that were looked at", 25.0, static_cast<double>(watch.Updates), 1e3);
  std::printf(
    "     largest deviation of the volume: %.1e by the filter, %.1e by Gauss sums; without, the same "
    "events change it by %.1e of itself\n",
    watch.WorstOfFilter, watch.WorstOfFormula, freeVolume / watch.Held - 1.0);
  CheckRange("held at each update", 0.0, watch.WorstOfFilter, 1e-9, "asked");
  CheckRange("and by Gauss sums", 0.0, watch.WorstOfFormula, 1e-9, "asked");
  Check("as it is stated", watch.WorstOfFilter, session.Scene.GetHold().GetMaxDeviation(), 1e-15);
  CheckTrue("without, it changes", std::abs(freeVolume / watch.Held - 1.0) > 1e-2);
  PrintTimes(session);

  CheckEqual("status", names::StatusOk, mass->GetStatus());
  CheckEqual("nothing opened", 0, static_cast<long long>(session.Part.GetOpened(0).size()));
  const std::vector<Point3> net = GetNet(session, session.Scene.GetNet().GetFace());
  CheckEqual("control points", static_cast<long long>(free.size()), static_cast<long long>(net.size()));
  double off = 0.0;
  for (std::size_t i = 0; i < std::min(free.size(), net.size()); ++i)
  {
    off = std::max(off, std::sqrt(vtkMath::Distance2BetweenPoints(free[i].data(), net[i].data())));
  }
  CheckRange("dragged points are where the mouse has them", 0.0, off, 1e-9);
  const std::vector<double> last = GetFieldNumbers(mass);
  CheckTrue("the bits of a full run", HaveSameBits(last, RunAnew(session)));
  CheckRefusals(session, watch.Held);
  session.AddKey("r");
  session.Play();
  CheckTrue("reset, the first bits", HaveSameBits(first, GetFieldNumbers(mass)));
  CheckTrue("and the volume of the next drag", !session.Scene.GetHold().GetVolume());
}
}

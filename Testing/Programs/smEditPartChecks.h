/**
 * @file smEditPartChecks.h
 * @brief Checks of TestEditPart that have a file of their own, and what they share
 */
#ifndef smEditPartChecks_h
#define smEditPartChecks_h

#include "smEditSession.h"
#include "smTestPipeline.h"

#include <string>
#include <vector>

namespace smtest
{
/// The results of a new filter for the part.
inline std::vector<double> RunAnew(EditSession& session)
{
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetRenderWindow(session.Window);
  mass->ShowPrincipalAxesOn();
  mass->SetInputData(session.Part.GetBodies());
  mass->Update();
  CheckTrue(
    "a full run evaluates everything", mass->GetEvaluations() > session.Scene.GetMass()->GetEvaluations());
  return GetFieldNumbers(mass);
}

inline Point3 GetWorld(EditSession& session, const sm::Grip& grip)
{
  Point3 world{};
  session.Part.GetPosition(grip, world);
  return world;
}

inline void CheckVector(const std::string& what, const Point3& expected, const Point3& actual, double limit)
{
  for (int c = 0; c < 3; ++c)
  {
    Check(what + " " + "xyz"[c], expected[c], actual[c], limit);
  }
}

/// The shipped recording: values against a full run and against a formula, picture, undo. The arguments are
/// vtkTesting's.
void CheckDrag(
  vtkSTEPReader* reader, const std::string& events, const std::string& folder, int argc, char* argv[]);

/// A rotated, mirrored, translated body: drags along the screen and the normal, a cancelled drag, weights.
void CheckPlaced(vtkSTEPReader* reader, const std::string& folder);

/// The shipped recording with the volume held: the volume after each update, by the filter and by Gauss sums.
void CheckHold(vtkSTEPReader* reader, const std::string& events, const std::string& folder);
/// Holds the volume of a part with trim curves inside the nets of its faces, also in files that are saved.
void CheckHoldOfTrimmed(const std::string& file, const std::string& folder);
}

#endif

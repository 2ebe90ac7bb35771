// Results that no body has are suspect, each with its own sentence; what is not a number is never printed as
// one.
#include "smBoxBodies.h"
#include "smTestPipeline.h"

#include <vtkDataSetAttributes.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>

#include <regex>

namespace
{
using namespace smtest;
namespace names = sm::names;

std::string GetText(vtkSurfaceIntegralBase* filter)
{
  return GetFieldText(vtkTable::SafeDownCast(filter->GetOutputDataObject(2))->GetRowData(), names::Text);
}

/// Checks that no number that is NaN or infinite is printed in the messages or in the text of the ParaView
/// view.
void CheckWords(vtkSurfaceIntegralBase* filter)
{
  const std::string all = GetMessages(filter) + GetText(filter);
  const std::regex number("\\b(nan|inf|infinity|ind)\\b", std::regex::icase);
  CheckTrue("nothing printed as a number is none", !std::regex_search(all, number) && !all.empty(), all);
}

/// A face without loops, a part of a plane: it has no edge to be open, but four borders.
sm::FacePointer MakeBareFace(double x)
{
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->FileId = 7;
  face->Surface.Knots[0] = face->Surface.Knots[1] = { 0.0, 0.0, 1.0, 1.0 };
  face->Surface.NumberOfControlPoints[0] = face->Surface.NumberOfControlPoints[1] = 2;
  face->Surface.ControlPoints = { { x, -10, -5, 1 }, { x, 10, -5, 1 }, { x, -10, 5, 1 }, { x, 10, 5, 1 } };
  return face;
}

vtkSmartPointer<vtkNURBSDataSet> AddFace(vtkNURBSDataSet* leaf, const sm::FacePointer& face)
{
  std::vector<sm::FacePointer> faces = leaf->GetModel()->GetFaces();
  faces.push_back(face);
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(leaf->GetModel());
  model->SetFaces(faces);
  auto copy = vtkSmartPointer<vtkNURBSDataSet>::New();
  copy->ShallowCopy(leaf);
  copy->SetModel(model);
  return copy;
}

void CheckCenter()
{
  std::printf("--- a centre outside its solid\n");
  // A void alone, of 800, and one wall at x = 15 with a flux of 1000: 200 is left, whose centre lies at
  // (15 * 15 * 200 / 4 + 800 * 7) / 200 = 84.25.
  BoxBody body;
  body.Add({ { -12, -5, -4 }, { -2, 5, 4 }, false });
  const auto leaf = AddFace(body.Make(), MakeBareFace(15.0));
  vtkNew<vtkMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  mass->SetInputData(leaf);
  mass->Update();
  Check("volume of the nonsense", 200.0, mass->GetVolume(), 1e-9);
  double center[3];
  mass->GetCenterOfMass(center);
  Check("its centre", 84.25, center[0], 1e-9);
  CheckEqual("status", names::StatusOpen, mass->GetStatus());
  const std::string said = GetMessages(mass);
  CheckTrue("the centre is named",
    said.find("the centre of mass lies outside the box of the solid, by 69.2") != std::string::npos, said);
  CheckTrue("the moments are named", said.find("not positive definite") != std::string::npos, said);
  CheckWords(mass);
}

void CheckNoBound()
{
  std::printf("--- a face is missing: no bound is known\n");
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { 1, 2, 3 } });
  const auto leaf = body.Make();
  leaf->GetModel()->SetNumberOfMissingFaces(1);
  vtkNew<vtkMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  mass->SetInputData(leaf);
  mass->Update();
  CheckTrue("the bound is infinite", std::isinf(mass->GetVolumeBound()));
  CheckTrue("the text says so", GetText(mass).find("Volume: 6 mm^3 (bound not known)") != std::string::npos,
    GetText(mass));
  CheckWords(mass);
  vtkNew<vtkSurfaceIntegralGPU> integral;
  MessageTrap integralTrap(integral);
  integral->AddVolumeMoment("V", 0, 0, 0);
  integral->SetInputData(leaf);
  integral->Update();
  CheckTrue("so does the integral's", GetText(integral).find("V = 6 (bound not known)") != std::string::npos,
    GetText(integral));
  CheckWords(integral);
}

void CheckNoNumber()
{
  std::printf("--- a control point that is not a number\n");
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { 1, 2, 3 } });
  auto leaf = body.Make();
  auto face = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[2]);
  face->Id = sm::NewId();
  face->Surface.ControlPoints[1][2] = std::numeric_limits<double>::quiet_NaN();
  leaf->GetModel()->SetFace(2, face);
  vtkNew<vtkMassPropertiesGPU> mass;
  MessageTrap trap(mass);
  mass->SetInputData(leaf);
  mass->Update();
  CheckEqual("status", names::StatusSuspect, mass->GetStatus());
  CheckTrue("no volume", !std::isfinite(mass->GetVolume()) || std::isinf(mass->GetVolumeBound()));
  CheckWords(mass);
  vtkNew<vtkSurfaceIntegralGPU> integral;
  MessageTrap integralTrap(integral);
  integral->AddAreaMoment("A", 0, 0, 0);
  integral->SetInputData(leaf);
  integral->Update();
  CheckEqual("status of the integral", names::StatusSuspect, integral->GetStatus());
  CheckWords(integral);
}

/// A cube of side 10 about whose top the file's surface ends before its edges, by a share of the side; the
/// plane is continued.
vtkSmartPointer<vtkNURBSDataSet> MakeShrunken(double share)
{
  BoxBody body;
  body.Add({ { 0, 0, 0 }, { 10, 10, 10 } });
  auto leaf = body.Make();
  auto face = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[5]);
  face->Id = sm::NewId();
  const std::array<double, 4> corner = face->Surface.ControlPoints[0];
  for (std::array<double, 4>& p : face->Surface.ControlPoints)
  {
    for (int d = 0; d < 3; ++d)
    {
      p[d] = corner[d] + (1.0 - share) * (p[d] - corner[d]);
    }
  }
  for (sm::Coedge& coedge : face->Loops[0].Coedges)
  {
    for (std::array<double, 2>& c : coedge.Curve.Coefficients)
    {
      c = { c[0] / (1.0 - share), c[1] / (1.0 - share) };
    }
  }
  leaf->GetModel()->SetFace(5, face);
  return leaf;
}

/// A box some of whose faces have loops that run the wrong way: no area is below 0.
void CheckNegativeAreas()
{
  for (const int turned : { 0, 1, 6 })
  {
    std::printf("--- a box with %d faces whose loops run the wrong way\n", turned);
    BoxBody body;
    body.Add({ { 0, 0, 0 }, { 10, 10, 10 } });
    const auto leaf = body.Make();
    for (int i = 0; i < turned; ++i)
    {
      auto face = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[i]);
      face->Id = sm::NewId();
      std::reverse(face->Loops[0].Coedges.begin(), face->Loops[0].Coedges.end());
      for (sm::Coedge& coedge : face->Loops[0].Coedges)
      {
        coedge.Reversed = !coedge.Reversed;
      }
      leaf->GetModel()->SetFace(i, face);
    }
    vtkNew<vtkMassPropertiesGPU> mass;
    MessageTrap trap(mass);
    mass->SetInputData(leaf);
    mass->Update();
    // The edges of a single face that is reversed do not cancel.
    CheckEqual("status",
      turned == 0     ? names::StatusOk
        : turned == 1 ? names::StatusOpen
                      : names::StatusSuspect,
      mass->GetStatus());
    CheckEqual("a negative area is said", turned > 0, Says(mass, "face #100: its area is negative, -100"));
    if (turned == 6)
    {
      CheckTrue("the area is not a number", std::isnan(mass->GetSurfaceArea()));
    }
    else
    {
      Check("area", 600.0 - 200.0 * turned, mass->GetSurfaceArea(), 1e-10);
    }
  }
}

void CheckOverhang()
{
  std::printf("--- trim curves beyond the domain of their surface\n");
  const double diagonal = 10.0 * std::sqrt(3.0);
  for (const double share : { 1e-4, 7e-4, 5e-3 })
  {
    const double gap = 10.0 * share;
    vtkNew<vtkMassPropertiesGPU> mass;
    MessageTrap trap(mass);
    mass->SetInputData(MakeShrunken(share));
    mass->Update();
    Check("volume of the continued surface", 1000.0, mass->GetVolume(), mass->GetVolumeBound(), "its bound");
    CheckRange("bound", 0.0, mass->GetVolumeBound(), 1e-9);
    CheckEqual("status where the surface lacks " + std::to_string(100.0 * gap / diagonal) + " % of the size",
      share < 8e-4 ? names::StatusOk : names::StatusSuspect, mass->GetStatus());
    CheckTrue("the face is named", Says(mass, "face #105: a trim curve leaves the surface by at most"));
    // The corner is gap sqrt(2) away; the bound adds both directions.
    vtkFieldData* fields = mass->GetOutput()->GetFieldData();
    CheckRange("it is a gap", std::sqrt(2.0) * gap, GetField(fields, names::MaxGap), 2.1 * gap);
    CheckRange(
      "of this squared integral", 20.0 * gap * gap, GetField(fields, names::GapSquared), 90.0 * gap * gap);
    mass->SetGapLimit(1.0);
    mass->Update();
    CheckEqual("status where every gap is accepted", names::StatusOk, mass->GetStatus());
  }
}
}

int TestMassPropertiesPlausibility(int, char*[])
{
  CheckCenter();
  CheckNoBound();
  CheckNoNumber();
  CheckNegativeAreas();
  CheckOverhang();
  return Finish();
}

// Open edges, wide gaps and faces that count wrongly are drawn where they are, with the figures that they put
// in doubt.
#include "Outputs/smFlaggedPlaces.h"
#include "smBoxBodies.h"
#include "smIntegralNames.h"
#include "smMessageTrap.h"
#include "smTesting.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <cmath>
#include <limits>

namespace
{
using namespace smtest;
namespace names = sm::names;

/// Coordinates and areas of boxes are exact except for a few roundings of numbers below 100.
constexpr double Rounding = 1e-13;
const double Nan = std::numeric_limits<double>::quiet_NaN();

struct Run
{
  explicit Run(vtkNURBSDataSet* body)
  {
    this->Mass->SetBackend(vtkMassPropertiesGPU::CPU);
    this->Mass->SetInputData(body);
    MessageTrap messages(this->Mass);
    this->Mass->Update();
    this->Flagged = vtkPolyData::SafeDownCast(this->Mass->GetOutputDataObject(6));
    this->Summary = vtkTable::SafeDownCast(this->Mass->GetOutputDataObject(2))->GetValue(0, 0).ToString();
  }
  double Get(const char* name, vtkIdType cell) const
  {
    vtkDataArray* array = this->Flagged->GetCellData()->GetArray(name);
    return array && cell < array->GetNumberOfTuples() ? array->GetComponent(cell, 0) : -1.0;
  }
  std::string GetText(vtkIdType cell) const
  {
    auto* array = vtkStringArray::SafeDownCast(this->Flagged->GetCellData()->GetAbstractArray(names::Text));
    return array && cell < array->GetNumberOfValues() ? array->GetValue(cell) : std::string();
  }
  bool Says(const std::string& words) const { return this->Summary.find(words) != std::string::npos; }

  vtkNew<vtkMassPropertiesGPU> Mass;
  vtkPolyData* Flagged = nullptr;
  std::string Summary;
};

void CheckCells(const std::string& what, const Run& run, const char* status, int lines, int triangles)
{
  CheckEqual(what + ": status", status, run.Mass->GetStatus());
  CheckEqual(what + ": lines", lines, static_cast<long long>(run.Flagged->GetNumberOfLines()));
  CheckEqual(what + ": triangles", triangles, static_cast<long long>(run.Flagged->GetNumberOfPolys()));
}

void CheckFigures(
  const std::string& what, const Run& run, vtkIdType cell, int flag, double area, double volume)
{
  CheckEqual(what + ": number", flag, static_cast<long long>(run.Get(names::Flag, cell)));
  for (const auto& [name, expected] :
    { std::pair(names::AreaInDoubt, area), std::pair(names::VolumeInDoubt, volume) })
  {
    const double value = run.Get(name, cell);
    if (std::isnan(expected))
    {
      CheckTrue(what + ": " + name + " is not known", std::isnan(value));
    }
    else
    {
      Check(what + ": " + name, expected, value, Rounding);
    }
  }
}

void CheckBounds(const std::string& what, const Run& run, const std::array<double, 6>& expected)
{
  double bounds[6];
  run.Flagged->GetBounds(bounds);
  for (int i = 0; i < 6; ++i)
  {
    Check(what + ": bound " + std::to_string(i), expected[i], bounds[i], Rounding);
  }
}

/// A box of 1 x 2 x 3 without its lid.
void CheckOpening()
{
  BoxBody box;
  box.Add({ { 0, 0, 0 }, { 1, 2, 3 }, true, 5 });
  const auto leaf = box.Make();
  leaf->GetModel()->SetOrigin(0.0, 0.0, 0.25);
  vtkNew<vtkMatrix4x4> placement;
  placement->SetElement(0, 3, 10.0);
  leaf->SetPlacement(placement);
  const Run run(leaf);
  CheckCells("no lid", run, names::StatusOpen, 4, 0);
  CheckBounds("no lid", run, { 10, 11, 0, 2, 3.25, 3.25 });
  const double volume = 2.0 * std::sqrt(14.0) / 3.0;
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    const std::string what = "edge " + std::to_string(cell);
    CheckFigures(what, run, cell, 1, 2.0, volume);
    CheckEqual(what + ": solid", 0, static_cast<long long>(run.Get(names::Solid, cell)));
    CheckEqual(what + ": face", 0, static_cast<long long>(run.Get(names::FaceId, cell)));
    CheckTrue(what + ": id of the edge", run.Get(names::EdgeId, cell) >= 1000.0);
    Check(what + ": gap", 0.0, run.Get(names::MaxGap, cell), Rounding);
  }
  // The share of the missing face is within the figure.
  const double missing = 6.0 - run.Mass->GetVolume();
  CheckTrue(
    "the volume lacks no more than that", missing > 1.0 && missing <= volume, std::to_string(missing));
  const std::string text = run.GetText(0);
  CheckTrue("text", text.find("boxes: opening at 4 edges #10") == 0, text);
  CheckTrue("figures", text.find(", about 2 mm^2 and 2.494 mm^3 in doubt") != std::string::npos, text);
  CheckTrue("the summary has it", run.Says("[1] boxes: opening at 4 edges"), run.Summary);
}

/// Openings at both ends, whose vector areas cancel; a surface; a sound box.
void CheckOthers()
{
  BoxBody tube;
  tube.Add({ { 0, 0, 0 }, { 1, 2, 3 }, true, 4 });
  const Run ends(tube.Make());
  CheckCells("tube", ends, names::StatusOpen, 8, 0);
  for (vtkIdType cell = 0; cell < 8; ++cell)
  {
    CheckFigures(
      "tube, edge " + std::to_string(cell), ends, cell, cell < 4 ? 1 : 2, 2.0, 2.0 * std::sqrt(14.0) / 3.0);
  }
  const Run surface(tube.Make(false));
  CheckCells("surface", surface, names::StatusOpen, 8, 0);
  CheckFigures("surface", surface, 0, 1, Nan, Nan);
  CheckTrue("surface: text", surface.GetText(0).find("border of a surface, 4 edges") != std::string::npos);

  BoxBody box;
  box.Add({ { 0, 0, 0 }, { 1, 2, 3 } });
  const Run sound(box.Make());
  CheckCells("sound", sound, names::StatusOk, 0, 0);
  CheckEqual("sound: points", 0, static_cast<long long>(sound.Flagged->GetNumberOfPoints()));
  CheckTrue("sound: summary", !sound.Says("in doubt"), sound.Summary);
}

/// A parabola from (0,0) over (1,1) to (2,0) and its chord, as the open edges of a box. The polygon of n
/// chords has 1 - 1/n^2 of the area 4/3.
void CheckCurvedEdges()
{
  BoxBody box;
  box.Add({ { 0, 0, 0 }, { 1, 2, 3 } });
  const auto leaf = box.Make();
  sm::Edge arc;
  sm::Edge chord;
  arc.EndVertex = chord.EndVertex = { 2, 0, 0 };
  const std::array<double, 3> parabola[3] = { { 0, 0, 0 }, { 1, 2, 0 }, { 2, 0, 0 } };
  const std::array<double, 3> line[2] = { parabola[0], parabola[2] };
  arc.Curve.Breaks = chord.Curve.Breaks = { 0.0 };
  arc.Curve.AppendPiece(1.0, parabola, 2);
  chord.Curve.AppendPiece(1.0, line, 1);
  std::vector<sm::EdgeGap> edges(2);
  edges[0].Source = &arc;
  edges[1].Source = &chord;
  edges[0].SignedUses = 1;
  edges[1].SignedUses = -1;
  sm::BodyIntegrals body;
  body.Model = leaf->GetModel();
  body.Mesh = leaf;
  body.Status = sm::Status::Open;
  body.Edges = std::make_shared<const std::vector<sm::EdgeGap>>(edges);
  const std::vector<sm::FlaggedPlace> places = sm::FindFlaggedPlaces({ body });
  CheckEqual("curved: openings", 1, static_cast<long long>(places.size()));
  Check("curved: area", 4.0 / 3.0 * (1.0 - 1.0 / 1024.0), places[0].AreaInDoubt, Rounding);
  // Edges in one direction do not close.
  edges[1].SignedUses = 1;
  body.Edges = std::make_shared<const std::vector<sm::EdgeGap>>(edges);
  CheckTrue("not closed: area is not known", std::isnan(sm::FindFlaggedPlaces({ body })[0].AreaInDoubt));
}

/// The lid lies 0.3 above its edges. A gap of constant width w along an edge of length l: area w l; the trim
/// curve may be w away on the lid, with the edge and its foot a triangle, closing spread w^2 l / 2.
void CheckGap()
{
  BoxBody box;
  box.Add({ { 0, 0, 0 }, { 1, 2, 3 } });
  const auto leaf = box.Make();
  auto lid = std::make_shared<sm::Face>(*leaf->GetModel()->GetFaces()[5]);
  lid->Id = sm::NewId();
  for (std::array<double, 4>& point : lid->Surface.ControlPoints)
  {
    point[2] += 0.3;
  }
  leaf->GetModel()->SetFace(5, lid);
  const Run run(leaf);
  CheckCells("gap", run, names::StatusSuspect, 4, 0);
  CheckBounds("gap", run, { 0, 1, 0, 2, 3, 3 });
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    const double length = cell < 2 ? 2.0 : 1.0;
    const std::string what = "gap " + std::to_string(cell);
    CheckFigures(what, run, cell, static_cast<int>(cell) + 1, 0.3 * length, 0.045 * length);
    Check(what + ": width", 0.3, run.Get(names::MaxGap, cell), Rounding);
  }
  CheckTrue(
    "gap: text", run.GetText(0).find("gap of 0.3 mm at edge #10") != std::string::npos, run.GetText(0));
  CheckTrue("gap: the summary has them", run.Says("\n[4] boxes: gap of"), run.Summary);

  run.Mass->SetGapLimit(1.0);
  run.Mass->Update();
  CheckCells("gaps that are accepted", run, names::StatusOk, 0, 0);
}

/// A void outside its solid, and two shells that cross: their faces.
void CheckFaces()
{
  BoxBody outside;
  outside.Add({ { 0, 0, 0 }, { 1, 1, 1 } });
  outside.Add({ { 2, 0, 0 }, { 4, 2, 2 }, false });
  const auto leaf = outside.Make();
  leaf->GetModel()->SetNumberOfOuterShells(1);
  const Run run(leaf);
  CheckCells("void outside", run, names::StatusSuspect, 0, 12);
  CheckBounds("void outside", run, { 2, 4, 0, 2, 0, 2 });
  for (vtkIdType cell = 0; cell < 12; ++cell)
  {
    const std::string what = "void outside, cell " + std::to_string(cell);
    CheckFigures(what, run, cell, 1, 24.0, 8.0);
    CheckTrue(what + ": ids", run.Get(names::FaceId, cell) >= 106.0 && run.Get(names::EdgeId, cell) == 0.0);
  }
  CheckTrue("void outside: text",
    run.GetText(0).find("boxes: 6 faces #106, #107, #108, #109, #110, ...: a void lies outside") == 0,
    run.GetText(0));

  BoxBody crossing;
  crossing.Add({ { 0, 0, 0 }, { 2, 2, 2 } });
  crossing.Add({ { 1, 1, 1 }, { 3, 3, 3 } });
  crossing.Add({ { 10, 0, 0 }, { 11, 1, 1 } });
  const Run crossed(crossing.Make(true, true, true));
  CheckEqual("crossing: status", names::StatusSuspect, crossed.Mass->GetStatus());
  CheckTrue("crossing: faces are drawn, not those of the third box",
    crossed.Flagged->GetNumberOfPolys() > 0 && crossed.Flagged->GetBounds()[1] < 4.0);
  CheckTrue(
    "crossing: they are named", crossed.GetText(0).find("boxes: 12 faces #100") == 0, crossed.GetText(0));
}
}

int TestFlaggedPlaces(int, char*[])
{
  CheckOpening();
  CheckOthers();
  CheckCurvedEdges();
  CheckGap();
  CheckFaces();
  return Finish();
}

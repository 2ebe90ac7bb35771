// Bodies that no reader makes, but a program may: several length units in one input, placements that are not
// finite or project, and bodies without faces. No filter may give them a total that has no meaning, or the
// status ok.
#include "smBoxBodies.h"
#include "smTestPipeline.h"

#include <vtkBuoyancy.h>
#include <vtkMassPropertiesGPU.h>
#include <vtkMatrix4x4.h>
#include <vtkNURBSDeform.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkSolidSection.h>
#include <vtkSurfaceIntegralGPU.h>
#include <vtkTable.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace smtest;

/// The filters over one input, each with the total that is checked.
struct Filters
{
  vtkNew<vtkMassPropertiesGPU> Mass;
  vtkNew<vtkSurfaceIntegralGPU> Integral;
  vtkNew<vtkBuoyancy> Buoyancy;
  vtkNew<vtkSolidSection> Section;

  explicit Filters(vtkDataObject* input)
  {
    this->Integral->AddVolumeMoment("volume", 0, 0, 0);
    this->Buoyancy->SetPoint(0, 0, 1);
    this->Section->SetPoint(0, 0, 1);
    this->Visit(
      [input](const std::string&, vtkSurfaceIntegralBase* filter, double)
      {
        const MessageTrap trap(filter);
        filter->SetBackend(vtkSurfaceIntegralBase::CPU);
        filter->SetInputDataObject(input);
        filter->Update();
      });
  }

  /// Calls visit(name, filter, total) for each.
  void Visit(const std::function<void(const std::string&, vtkSurfaceIntegralBase*, double)>& visit)
  {
    visit("mass", this->Mass, this->Mass->GetVolume());
    visit("integral", this->Integral, this->Integral->GetIntegral("volume"));
    visit("buoyancy", this->Buoyancy, this->Buoyancy->GetDisplacedVolume());
    visit("section", this->Section, this->Section->GetSectionArea());
  }
};

vtkSmartPointer<vtkNURBSDataSet> MakeBox(double x)
{
  BoxBody body;
  body.Add({ { x, 0, 0 }, { x + 1, 2, 3 } });
  return body.Make();
}

/// One part in mm and one in inches: each has its row, and there is no sum.
void CheckUnits()
{
  vtkNew<vtkPartitionedDataSetCollection> parts;
  const auto inches = MakeBox(5.0);
  inches->GetModel()->SetLengthUnit("inch");
  parts->SetPartition(0, 0, MakeBox(0.0));
  parts->SetPartition(1, 0, inches);
  Filters filters(parts);
  filters.Visit(
    [](const std::string& name, vtkSurfaceIntegralBase* filter, double total)
    {
      CheckTrue("two units, " + name + ": no total", std::isnan(total));
      CheckTrue("two units, " + name + ": said", Says(filter, "different length units"));
      CheckEqual("two units, " + name + ": rows", 2,
        vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetNumberOfRows());
    });
  // The same in one unit.
  inches->GetModel()->SetLengthUnit("mm");
  Filters equal(parts);
  Check("one unit, mass", 12.0, equal.Mass->GetVolume(), equal.Mass->GetVolumeBound());
  Check("one unit, integral", 12.0, equal.Integral->GetIntegral("volume"),
    equal.Integral->GetIntegralBound("volume"));
  Check("one unit, buoyancy", 4.0, equal.Buoyancy->GetDisplacedVolume(),
    equal.Buoyancy->GetDisplacedVolumeBound());
  Check("one unit, section", 4.0, equal.Section->GetSectionArea(), equal.Section->GetSectionAreaBound());
}

/// `status`: of mass properties, which are integrated in the part's own coordinates; `elsewhere`: of the
/// other filters.
void CheckPlacement(const std::string& what, int row, int column, double value, const std::string& status,
  const std::string& elsewhere)
{
  const auto box = MakeBox(0.0);
  vtkNew<vtkMatrix4x4> placement;
  placement->SetElement(row, column, value);
  box->SetPlacement(placement);
  Filters filters(box);
  filters.Visit([&](const std::string& name, vtkSurfaceIntegralBase* filter, double)
    { CheckEqual(what + ", " + name, name == "mass" ? status : elsewhere, filter->GetStatus()); });
}

using Profile = std::vector<std::array<double, 3>>;

/// A surface of revolution without loops, of a profile of (radius, height) with weights. Its seam is rotated
/// by quarters of a turn, and its axis shifted in x.
sm::FacePointer MakeRevolvedFace(
  const Profile& profile, int degree, const std::vector<double>& knots, int quarters = 0, double shift = 0.0)
{
  const double h = std::sqrt(0.5);
  const int x[9] = { 1, 1, 0, -1, -1, -1, 0, 1, 1 };
  const int y[9] = { 0, 1, 1, 1, 0, -1, -1, -1, 0 };
  auto face = std::make_shared<sm::Face>();
  face->Id = sm::NewId();
  face->Surface.Degree[0] = 2;
  face->Surface.Degree[1] = degree;
  face->Surface.Knots[0] = { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 };
  face->Surface.Knots[1] = knots;
  face->Surface.NumberOfControlPoints[0] = 9;
  face->Surface.NumberOfControlPoints[1] = static_cast<int>(profile.size());
  face->Surface.Rational = true;
  for (const auto& [radius, height, weight] : profile)
  {
    for (int i = 0; i < 9; ++i)
    {
      const double w = weight * (i % 2 == 0 ? 1.0 : h);
      const int at = (i + 2 * quarters) % 8;
      face->Surface.ControlPoints.push_back(
        { w * (radius * x[at] + shift), w * radius * y[at], w * height, w });
    }
  }
  return face;
}

vtkSmartPointer<vtkNURBSDataSet> MakeLeaf(const std::vector<sm::FacePointer>& faces)
{
  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetFaces(faces);
  auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
  leaf->SetModel(model);
  return leaf;
}

vtkSmartPointer<vtkNURBSDataSet> MakeRevolved(
  const Profile& profile, int degree, const std::vector<double>& knots)
{
  return MakeLeaf({ MakeRevolvedFace(profile, degree, knots) });
}

/// A tube of radius 1 between the heights 0 and 2, with discs whose seams lie elsewhere, or which touch the
/// tube at one point of its seam only.
void CheckTubeWithDiscs()
{
  const std::vector<double> line = { 0, 0, 1, 1 };
  const auto make = [&line](int quarters, double radius)
  {
    return MakeLeaf({ MakeRevolvedFace({ { 1, 0, 1 }, { 1, 2, 1 } }, 1, line),
      MakeRevolvedFace({ { 0, 0, 1 }, { radius, 0, 1 } }, 1, line, quarters, 1.0 - radius),
      MakeRevolvedFace({ { radius, 2, 1 }, { 0, 2, 1 } }, 1, line, quarters, 1.0 - radius) });
  };
  for (const int quarters : { 0, 1 })
  {
    Filters closed(make(quarters, 1.0));
    CheckEqual("tube with discs", "ok", closed.Mass->GetStatus());
    Check("tube with discs, volume", 2.0 * std::acos(-1.0), closed.Mass->GetVolume(),
      closed.Mass->GetVolumeBound() + 1e-14);
  }
  Filters open(make(0, 0.5));
  CheckEqual("tube with small discs", "open", open.Mass->GetStatus());
  CheckTrue("tube with small discs, said", Says(open.Mass, "4 borders"));
}

/// Squares of areas, and second moments, of so small a body are 0 in doubles, and so are their bounds.
void CheckSize(double size, const std::string& status)
{
  BoxBody box;
  box.Add({ { 0, 0, 0 }, { size, 2.0 * size, 3.0 * size } });
  Filters filters(box.Make());
  const std::string what = "box of 1e" + std::to_string(std::lround(std::log10(size)));
  CheckEqual(what + ", mass", status, filters.Mass->GetStatus());
  CheckEqual(what + ", integral", status, filters.Integral->GetStatus());
}

/// A ball of two halves without loops, a ring, and a tube with discs, whose borders differ: no edge and no
/// ribbon closes what is between.
void CheckApart(double gap)
{
  const double h = std::sqrt(0.5);
  const std::vector<double> line = { 0, 0, 1, 1 };
  const std::vector<double> quarter = { 0, 0, 0, 1, 1, 1 };
  const std::pair<std::string, vtkSmartPointer<vtkNURBSDataSet>> bodies[] = {
    { "halves of a ball",
      MakeLeaf({ MakeRevolvedFace({ { 0, -2, 1 }, { 2, -2, h }, { 2, 0, 1 } }, 2, quarter),
        MakeRevolvedFace({ { 2, gap, 1 }, { 2, 2 + gap, h }, { 0, 2 + gap, 1 } }, 2, quarter) }) },
    { "tube with discs",
      MakeLeaf({ MakeRevolvedFace({ { 1, 0, 1 }, { 1, 2, 1 } }, 1, line),
        MakeRevolvedFace({ { 0, 0, 1 }, { 1, 0, 1 } }, 1, line, 1),
        MakeRevolvedFace({ { 1, 2 + gap, 1 }, { 0, 2 + gap, 1 } }, 1, line) }) },
    { "ring",
      MakeRevolved({ { 4, 0, 1 }, { 4, 1, 1 }, { 2, 1, 1 }, { 2, -1, 1 }, { 4, -1, 1 }, { 4, -gap, 1 } }, 1,
        { 0, 0, 1, 2, 3, 4, 5, 5 }) }
  };
  for (const auto& [name, body] : bodies)
  {
    const Filters filters(body);
    const std::string label = name + ", " + std::to_string(gap * 1e9) + "e-9 apart";
    CheckEqual(label, gap == 0.0 ? "ok" : "suspect", filters.Mass->GetStatus());
    CheckTrue(label + ", said", (gap > 0.0) == Says(filters.Mass, "no edge closes the gap"));
  }
}

/// Faces without loops: a ball and a ring are closed by themselves, a tube and a cone are not, although the
/// vector area of the tube is 0.
void CheckWithoutLoops()
{
  const double h = std::sqrt(0.5);
  const double pi = std::acos(-1.0);
  const std::vector<double> quarters = { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 };
  Filters ball(MakeRevolved(
    { { 0, -2, 1 }, { 2, -2, h }, { 2, 0, 1 }, { 2, 2, h }, { 0, 2, 1 } }, 2, { 0, 0, 0, 1, 1, 2, 2, 2 }));
  CheckEqual("ball", "ok", ball.Mass->GetStatus());
  Check("ball, volume", 32.0 / 3.0 * pi, ball.Mass->GetVolume(), ball.Mass->GetVolumeBound() + 1e-14);
  Check(
    "ball, section", 3.0 * pi, ball.Section->GetSectionArea(), ball.Section->GetSectionAreaBound() + 1e-14);
  Filters ring(MakeRevolved({ { 4, 0, 1 }, { 4, 1, h }, { 3, 1, 1 }, { 2, 1, h }, { 2, 0, 1 }, { 2, -1, h },
                              { 3, -1, 1 }, { 4, -1, h }, { 4, 0, 1 } },
    2, quarters));
  CheckEqual("ring", "ok", ring.Mass->GetStatus());
  Check("ring, volume", 6.0 * pi * pi, ring.Mass->GetVolume(), ring.Mass->GetVolumeBound() + 1e-13);
  const std::pair<std::string, vtkSmartPointer<vtkNURBSDataSet>> surfaces[] = {
    { "tube", MakeRevolved({ { 1, 0, 1 }, { 1, 2, 1 } }, 1, { 0, 0, 1, 1 }) },
    { "cone", MakeRevolved({ { 1, 0, 1 }, { 0, 2, 1 } }, 1, { 0, 0, 1, 1 }) }
  };
  for (const auto& [name, surface] : surfaces)
  {
    Filters filters(surface);
    filters.Visit([what = name](const std::string& filter, vtkSurfaceIntegralBase* integral, double)
      { CheckEqual(what + ", " + filter, "open", integral->GetStatus()); });
    CheckTrue(name + ", said", Says(filters.Mass, name == "tube" ? "2 borders" : "1 border"));
    CheckTrue(name + ", no section", std::isnan(filters.Section->GetSectionArea()));
    surface->GetModel()->SetBody(vtkTrimmedNURBSModel::SHELL);
    Filters shell(surface);
    CheckTrue(name + " as a surface, no volume", std::isnan(shell.Mass->GetVolume()));
    CheckEqual(name + " as a surface", "open", shell.Mass->GetStatus());
  }
}

/// The top of a box, lifted off its edges: a wide gap is reported by every filter whose values it changes.
void CheckGaps()
{
  vtkNew<vtkNURBSDeform> lift;
  lift->SetInputDataObject(MakeBox(0.0));
  lift->AddFace(5);
  lift->KeepClosedOff();
  for (const double height : { 1.0, 1e-5 })
  {
    const std::string what = "lifted by " + std::to_string(height);
    const std::string status = height > 0.01 ? "suspect" : "ok";
    lift->SetDisplacement(0, 0, height);
    lift->Update();
    Filters filters(lift->GetOutputDataObject(0));
    CheckEqual(what + ", mass", status, filters.Mass->GetStatus());
    CheckEqual(what + ", section", status, filters.Section->GetStatus());
    CheckEqual(what + ", nothing below", "ok", filters.Buoyancy->GetStatus());
    filters.Buoyancy->SetPoint(0, 0, 9);
    const MessageTrap trap(filters.Buoyancy);
    filters.Buoyancy->Update();
    CheckEqual(what + ", all below", status, filters.Buoyancy->GetStatus());
    // A small gap is not a message of these filters, but stands in their tables.
    CheckTrue(what + ", said", Says(filters.Section, "widest gap") == (status == "suspect"));
    for (vtkSurfaceIntegralBase* filter : { static_cast<vtkSurfaceIntegralBase*>(filters.Section),
           static_cast<vtkSurfaceIntegralBase*>(filters.Buoyancy) })
    {
      auto* edges = vtkTable::SafeDownCast(filter->GetOutputDataObject(4));
      Check(what + ", in the table of edges", height, edges->GetValueByName(0, "MaxGap").ToDouble(), 1e-12);
    }
  }
}

/// An integral called like a column that the table of faces has, or like the bound of one, would stand in its
/// place.
void CheckNames()
{
  vtkNew<vtkSurfaceIntegralGPU> integral;
  for (const char* name : { "MaxGap", "FaceId", "FaceIndex", "Solid" })
  {
    const MessageTrap trap(integral);
    integral->AddAreaMoment(name, 0, 0, 0);
    CheckEqual(std::string("an integral called ") + name, 1, trap.NumberOfErrors);
  }
  CheckEqual("no integral", 0, integral->GetNumberOfIntegrands());
}

/// A length unit that has no metres leaves a solid without a mass, which is said.
void CheckUnknownUnit()
{
  const auto box = MakeBox(0.0);
  box->GetModel()->SetLengthUnit("parsec");
  Filters without(box);
  CheckTrue("no density, nothing said", !Says(without.Mass, "parsec"));
  box->GetModel()->SetDensity(1000.0);
  Filters filters(box);
  Check("unknown unit, volume", 6.0, filters.Mass->GetVolume(), filters.Mass->GetVolumeBound());
  CheckTrue("unknown unit, no mass", std::isnan(filters.Mass->GetMass()));
  CheckTrue("unknown unit, said", Says(filters.Mass, "\"parsec\""));
}

/// A solid without faces, alone and next to a box: what is not there has no section.
void CheckEmptyBody()
{
  vtkNew<vtkPartitionedDataSetCollection> parts;
  const auto empty = vtkSmartPointer<vtkNURBSDataSet>::New();
  vtkNew<vtkTrimmedNURBSModel> none;
  empty->SetModel(none);
  parts->SetPartition(0, 0, empty);
  for (const std::string what : { "no faces", "no faces, and a box" })
  {
    Filters filters(parts);
    filters.Visit([&](const std::string& name, vtkSurfaceIntegralBase* filter, double)
      { CheckTrue(what + ", " + name + ": flagged", filter->GetStatus() != "ok", filter->GetStatus()); });
    CheckTrue(what + ": no section", std::isnan(filters.Section->GetSectionArea()));
    CheckEqual(what + ", section", "suspect", filters.Section->GetStatus());
    parts->SetPartition(1, 0, MakeBox(0.0));
  }
}
}

int TestUnusualBodies(int, char*[])
{
  CheckUnits();
  const double infinity = std::numeric_limits<double>::infinity();
  CheckPlacement("the identity", 0, 0, 1.0, "ok", "ok");
  for (int row = 0; row < 3; ++row)
  {
    CheckPlacement("infinitely far", row, 3, infinity, "suspect", "not-computed");
    CheckPlacement("nowhere", row, 3, std::nan(""), "suspect", "not-computed");
  }
  CheckPlacement("scaled by the last entry", 3, 3, 2.0, "suspect", "suspect");
  CheckPlacement("a projection", 3, 0, 0.1, "suspect", "suspect");
  CheckPlacement("stretched", 0, 0, 1.5, "suspect", "suspect");
  // The centre is known to 1e285: its distance from the origin must not hide that.
  const auto far = MakeBox(0.0);
  vtkNew<vtkMatrix4x4> placement;
  placement->SetElement(0, 3, 1e300);
  far->SetPlacement(placement);
  CheckEqual("1e300 away", "tolerance-not-met", Filters(far).Mass->GetStatus());
  CheckWithoutLoops();
  for (const double gap : { 0.0, 1e-12, 1e-9, 1e-6, 1e-3 })
  {
    CheckApart(gap);
  }
  for (const double size : { 1e-100, 1e-64, 1e50, 1e100 })
  {
    CheckSize(size, "suspect");
  }
  CheckSize(1e-30, "ok");
  CheckTubeWithDiscs();
  CheckGaps();
  CheckNames();
  CheckUnknownUnit();
  CheckEmptyBody();
  return Finish();
}

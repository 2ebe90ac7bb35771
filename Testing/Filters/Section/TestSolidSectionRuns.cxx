// TestSolidSectionRuns FOLDER MODE BACKEND: outputs of a run, planes that touch, shells inside out, open
// bodies, spline solids
#include "Detail/smSectionRow.h"
#include "smSectionNames.h"
#include "smSectionTesting.h"
#include "smWrongSamples.h"

#include <vtkBoundingBox.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkDataSetAttributes.h>
#include <vtkFeatureEdges.h>
#include <vtkMath.h>
#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTriangle.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

namespace
{
using namespace smtest;

/// A plane that touches a face or runs along it: areas up to `maximum` are within what the numbers are
/// accurate to.
void CheckTouch(const std::string& what, SectionScene& scene, const Vector& point, const Vector& normal,
  double maximum, double widest, bool isDetermined)
{
  for (const int sense : { 1, -1 })
  {
    scene.Set(point, Scaled(normal, sense));
    scene.Filter->Update();
    const double area = scene.Filter->GetSectionArea();
    const double bound = scene.Filter->GetSectionAreaBound();
    Check(what + ", nothing", 0.0, area, bound, "the bound");
    Check(what + ", all that touches", maximum, area, bound, "the bound");
    CheckRange(what + ", bound", 0.0, bound, widest);
    CheckEqual(what + ", status", isDetermined ? "ok" : "tolerance-not-met", scene.Filter->GetStatus());
    if (!isDetermined)
    {
      CheckTrue(what + ", said", Says(scene.Filter, "Move the plane"), GetMessages(scene.Filter));
    }
  }
}

void CheckTouching(const Manifest& manifest)
{
  {
    SectionScene box(manifest.GetSolid("box", "plain")[0].Path);
    CheckTouch("top of a box", box, { 3, 4, 10 }, { 0, 0, 1 }, 600.0, 601.0, false);
    CheckTouch("bottom of a box", box, { 3, 4, 0 }, { 0, 0, 1 }, 600.0, 601.0, false);
    CheckTouch("edge of a box", box, { 30, 5, 10 }, { 1, 0, 2 }, 0.0, 1e-9, true);
    CheckTouch("corner of a box", box, { 30, 20, 10 }, { 1, 1, 2 }, 0.0, 1e-9, true);
  }
  {
    SectionScene ball(manifest.GetSolid("sphere", "plain")[0].Path);
    // The tolerance of 1e-9 leaves 1.3e-6.
    CheckTouch("ball, at its pole", ball, { 1, 2, 10 }, { 0, 0, 1 }, 0.0, 5e-7, true);
    CheckTouch("ball, at its equator", ball, { 10, 2, 1 }, { 1, 0, 0 }, 0.0, 5e-7, true);
  }
  {
    // A plane that rounding has moved into the cylinder by 1e-15 cuts a strip, 2 sqrt(2 r 1e-15) wide and 25
    // long; of the torus, a ring of such a width around the axis.
    SectionScene cylinder(manifest.GetSolid("cylinder", "plain")[0].Path);
    CheckTouch(
      "cylinder, along a line", cylinder, { 8, 2, 1 }, { 1, 0, 0 }, 25 * 2 * std::sqrt(16e-15), 1e-3, false);
  }
  SectionScene torus(manifest.GetSolid("torus", "plain")[0].Path);
  CheckTouch("torus, along a circle", torus, { 1, 2, 6 }, { 0, 0, 1 },
    2 * 3.14159 * 20 * 2 * std::sqrt(12e-15), 1e-2, false);
}

/// Area of the cells of the section in the picture.
double GetCapArea(vtkPolyData* mesh)
{
  vtkDataArray* caps = mesh->GetCellData()->GetArray(sm::names::SectionCap);
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    mesh->GetCellPoints(cell, ids);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds() && caps->GetComponent(cell, 0) == 1.0; ++i)
    {
      double a[3];
      double b[3];
      double c[3];
      mesh->GetPoint(ids->GetId(0), a);
      mesh->GetPoint(ids->GetId(i - 1), b);
      mesh->GetPoint(ids->GetId(i), c);
      area += vtkTriangle::TriangleArea(a, b, c);
    }
  }
  return area;
}

/// Returns the picture of the first solid.
vtkPolyData* GetClipped(vtkSolidSection* filter)
{
  auto* clipped = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(7));
  return vtkPolyData::SafeDownCast(clipped->GetPartitionAsDataObject(0, 0));
}

/// The box has five faces below the plane, whose cells lie in the plane of their face; the section has none.
void CheckFaceIndices(vtkPolyData* mesh)
{
  vtkDataArray* indices = mesh->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  vtkDataArray* caps = mesh->GetCellData()->GetArray(sm::names::SectionCap);
  if (!CheckTrue("clipped cells have the index of their face", indices && caps))
  {
    return;
  }
  std::map<int, vtkBoundingBox> boxes;
  bool isCap = true;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    double bounds[6];
    mesh->GetCellBounds(cell, bounds);
    const int index = static_cast<int>(indices->GetComponent(cell, 0));
    boxes[index].AddBounds(bounds);
    isCap = isCap && (index == -1) == (caps->GetComponent(cell, 0) != 0.0);
  }
  CheckTrue("-1 on the section only", isCap);
  CheckEqual("five faces and the section", 6, static_cast<long long>(boxes.size()));
  for (const auto& [index, box] : boxes)
  {
    double sides[3];
    box.GetLengths(sides);
    CheckRange("thickness of face " + std::to_string(index), 0.0, *std::min_element(sides, sides + 3), 1e-9);
  }
}

/// Number of edges of the mesh that one cell has, with points at one place merged.
vtkIdType CountOpenEdges(vtkPolyData* mesh)
{
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(mesh);
  clean->SetTolerance(1e-9);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(clean->GetOutputPort());
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

void CheckOutputs(const Manifest& manifest)
{
  SectionScene scene(manifest.GetSolid("box", "plain")[0].Path);
  vtkSolidSection* filter = scene.Filter;
  CheckTrue("no area before the first run", std::isnan(filter->GetSectionArea()));
  filter->SetDensity(7850.0);
  scene.Set({ 0, 0, 2.5L }, { 0, 0, 2 });
  filter->Update(7);
  CheckEqual("status", "ok", filter->GetStatus());
  vtkFieldData* fields = filter->GetOutput()->GetFieldData();
  vtkFieldData* rows = vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetRowData();
  namespace names = sm::names;
  const std::pair<const char*, std::vector<double>> exact[] = { { names::SectionArea, { 600 } },
    { names::SectionCentroid, { 15, 10, 2.5 } },
    { names::SectionSecondMoments, { 45000, 20000, 0, 0, 0, 0 } },
    { names::SectionPrincipalMoments, { 20000, 45000 } }, { names::VolumeBelow, { 1500 } },
    { names::CenterBelow, { 15, 10, 1.25 } }, { names::MassBelow, { 1500e-9 * 7850 } },
    { names::VolumeAbove, { 4500 } }, { names::CenterAbove, { 15, 10, 6.25 } },
    { names::MassAbove, { 4500e-9 * 7850 } } };
  for (const auto& [name, values] : exact)
  {
    const double bound = GetFieldBound(fields, name);
    CheckRange(std::string(name) + ", bound", 0.0, bound, 1e-7 * values[0] + 1e-6);
    for (std::size_t c = 0; c < values.size(); ++c)
    {
      Check(name, values[c], GetField(fields, name, static_cast<int>(c)), bound);
      Check(std::string(name) + " of the solid", values[c],
        rows->GetArray(name)->GetComponent(0, static_cast<int>(c)), bound);
    }
  }
  // The largest second moment is along x.
  Check("direction of the largest moment", 1.0,
    std::abs(GetField(fields, names::SectionPrincipalDirections, 3)), 1e-12);
  Check("direction of the smallest moment", 1.0,
    std::abs(GetField(fields, names::SectionPrincipalDirections, 1)), 1e-12);
  auto* faces = vtkTable::SafeDownCast(filter->GetOutputDataObject(3));
  double sum = 0.0;
  for (vtkIdType row = 0; row < faces->GetNumberOfRows(); ++row)
  {
    sum += faces->GetValueByName(row, names::VolumeBelow).ToDouble();
  }
  Check("sum of the faces", 1500.0, sum, filter->GetVolumeBelowBound());
  auto* mesh = GetClipped(filter);
  Check("area of the cap", 600.0, GetCapArea(mesh), 1e-9);
  CheckEqual("the picture is closed", 0, static_cast<long long>(CountOpenEdges(mesh)));
  double bounds[6];
  mesh->GetBounds(bounds);
  Check("the picture ends at the plane", 2.5, bounds[5], 1e-12);
  CheckFaceIndices(mesh);
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(scene.Reader->GetOutputDataObject(0));
  auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartition(0, 0));
  leaf->GetBounds(bounds);
  CheckTrue("the input stays what it is",
    leaf->GetModel() != nullptr && bounds[5] == 10.0 && !leaf->GetCellData()->HasArray(names::SectionCap));
  filter->Modified();
  filter->Update();
  CheckTrue("cut once, integrated once", filter->GetEvaluations() == 0);
  scene.Set({ 15, 0, 0 }, { 1e200L, 0, 1e-200L });
  filter->Update();
  Check("area across a normal of 1e200", 200.0, filter->GetSectionArea(), filter->GetSectionAreaBound());
  Check("its cap", 200.0, GetCapArea(GetClipped(filter)), 1e-9);
  scene.Set({ 0, 0, 35.5L }, { 0, 0, -1 });
  filter->Update(2);
  const std::string text =
    GetFieldText(vtkTable::SafeDownCast(filter->GetOutputDataObject(2))->GetRowData(), names::Text);
  CheckTrue("a plane that misses the part",
    text.find("does not meet the solids: their box is 25.5 mm away.") != std::string::npos, text);
  filter->SetDensity(0.0);
  filter->Update();
  CheckTrue(
    "no density, no mass", std::isnan(GetField(filter->GetOutput()->GetFieldData(), names::MassBelow, 0)));
  MessageTrap messages(filter);
  filter->SetDensity(-1.0);
  CheckEqual("errors of a negative density", 1, messages.NumberOfErrors);
  filter->SetNormal(0, 0, 0);
  CheckEqual("errors of no direction", 2, messages.NumberOfErrors);

  // A void, which the picture has as a hole of the section.
  SectionScene hollow(manifest.GetSolid("hollow_sphere", "plain")[0].Path, false);
  hollow.Set({ 0, 0, -1.5L }, { 0, 0, 1 });
  hollow.Filter->Update(7);
  const double ring = 3.14159265358979323846 * (100.0 - 2.25 - 36.0);
  Check("ring", ring, hollow.Filter->GetSectionArea(), hollow.Filter->GetSectionAreaBound());
  auto* half = GetClipped(hollow.Filter);
  Check("ring in the picture", ring, GetCapArea(half), 0.1 * ring);
  CheckEqual("the picture of the ring is closed", 0, static_cast<long long>(CountOpenEdges(half)));

  // Sums over several solids.
  SectionScene two(manifest.GetSpecial("two_solids").Path);
  two.Set({ 0, 0, 5 }, { 0.1L, 0.2L, 1 });
  two.Filter->Update();
  CheckEqual("two solids, status", "ok", two.Filter->GetStatus());
  rows = vtkTable::SafeDownCast(two.Filter->GetOutputDataObject(1))->GetRowData();
  Region both;
  for (vtkIdType row = 0; row < 2; ++row)
  {
    Region own;
    own.Area = rows->GetArray(names::SectionArea)->GetComponent(row, 0);
    const int entries[3][3] = { { 0, 3, 5 }, { 3, 1, 4 }, { 5, 4, 2 } };
    for (int i = 0; i < 3; ++i)
    {
      own.Centroid[i] = rows->GetArray(names::SectionCentroid)->GetComponent(row, i);
      for (int j = 0; j < 3; ++j)
      {
        own.Second[i][j] = rows->GetArray(names::SectionSecondMoments)->GetComponent(row, entries[i][j]);
      }
    }
    both = row == 0 ? own : Combine(both, own, 1);
  }
  Check("two solids, area", static_cast<double>(both.Area), two.Filter->GetSectionArea(),
    2 * two.Filter->GetSectionAreaBound());
  double second[6];
  two.Filter->GetSectionSecondMoments(second);
  Check("two solids, second moment", static_cast<double>(both.Second[0][0]), second[0],
    2 * two.Filter->GetSectionSecondMomentsBound());
  Check("two solids, mixed second moment", static_cast<double>(both.Second[0][2]), second[5],
    2 * two.Filter->GetSectionSecondMomentsBound());
}

/// Runs that are stopped, or may not evaluate enough: nothing is computed, or the bounds say what is missing.
void CheckLimits(const Manifest& manifest)
{
  const std::string path = manifest.GetSolid("torus", "plain")[0].Path;
  const double exact = 3.14159265358979323846 * (26.0 * 26.0 - 14.0 * 14.0);
  {
    SectionScene slow(path);
    MessageTrap trap(slow.Filter);
    slow.Filter->SetMaximumSeconds(1e-9);
    slow.Filter->Update(7);
    CheckEqual("no time, status", sm::names::StatusNotComputed, slow.Filter->GetStatus());
    CheckTrue("no time, no area", std::isnan(slow.Filter->GetSectionArea()));
    CheckTrue("no time, said", Says(slow.Filter, "the maximum seconds were over"), GetMessages(slow.Filter));
    CheckTrue(
      "no time, but the picture, which needs no integral", GetClipped(slow.Filter)->GetNumberOfPolys() > 0);
    slow.Filter->SetMaximumSeconds(0.0);
    slow.Filter->Update();
    Check("the next run", exact, slow.Filter->GetSectionArea(), slow.Filter->GetSectionAreaBound());
  }
  SectionScene few(path);
  MessageTrap trap(few.Filter);
  few.Filter->SetMaximumEvaluations(100);
  few.Filter->Update();
  CheckEqual("few evaluations, status", "tolerance-not-met", few.Filter->GetStatus());
  Check(
    "few evaluations", exact, few.Filter->GetSectionArea(), few.Filter->GetSectionAreaBound(), "the bound");
  Check("few evaluations, volume", 3.14159265358979323846 * 3.14159265358979323846 * 20.0 * 36.0,
    few.Filter->GetVolumeAbove(), few.Filter->GetVolumeAboveBound(), "the bound");
  // The shaders are what the numbers come from.
  few.Filter->SetMaximumEvaluations(2000000000);
  const WrongSamples wrong(few.Filter, 1.0 + 1e-4);
  few.Filter->Update();
  CheckRange("perturbed shaders", 1e-5 * exact, std::abs(few.Filter->GetSectionArea() - exact), 1e-3 * exact);
}

/// A void whose face points outwards counts as material: that must not pass.
void CheckShells(const Manifest& manifest)
{
  SectionScene scene(manifest.GetSolid("hollow_sphere", "plain")[0].Path);
  scene.Reader->Update();
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(scene.Reader->GetOutputDataObject(0));
  auto* leaf = vtkNURBSDataSet::SafeDownCast(parts->GetPartition(0, 0));
  CheckEqual("faces of the hollow ball", 2, leaf->GetModel()->GetNumberOfFaces());
  for (const int reversed : { 0, 1 })
  {
    vtkNew<vtkTrimmedNURBSModel> model;
    model->ShallowCopy(leaf->GetModel());
    auto face = std::make_shared<sm::Face>(*model->GetFaces()[reversed]);
    face->Id = sm::NewId();
    face->Reversed = !face->Reversed;
    model->SetFace(reversed, face);
    vtkNew<vtkNURBSDataSet> copy;
    copy->ShallowCopy(leaf);
    copy->SetModel(model);
    scene.Filter->SetInputData(copy);
    scene.Filter->Update();
    CheckEqual("a shell inside out, status", "suspect", scene.Filter->GetStatus());
    CheckTrue("a shell inside out, said", Says(scene.Filter, "point inwards"), GetMessages(scene.Filter));
  }
  vtkNew<vtkTrimmedNURBSModel> model;
  model->ShallowCopy(leaf->GetModel());
  model->SetNumberOfOuterShells(2);
  vtkNew<vtkNURBSDataSet> copy;
  copy->ShallowCopy(leaf);
  copy->SetModel(model);
  scene.Filter->SetInputData(copy);
  scene.Filter->Update();
  CheckEqual("a void outside, status", "suspect", scene.Filter->GetStatus());
  CheckTrue("a void outside, said", Says(scene.Filter, "a void lies outside the outer shell"),
    GetMessages(scene.Filter));
}

/// A centroid that is known lies on the plane within its bound.
void CheckOnPlane(
  const std::string& what, const Vector& point, const Vector& normal, const double centroid[3], double bound)
{
  if (std::isfinite(bound))
  {
    const Vector way = Sum({ centroid[0], centroid[1], centroid[2] }, Scaled(point, -1));
    Check(what + ", distance from the plane", 0.0, static_cast<double>(Dot(way, Unit(normal))), bound);
  }
}

/// Several bodies: the centroid stays on a plane that passes bodies by, and is that of the bodies which the
/// plane cuts.
void CheckBodies(const Manifest& manifest)
{
  SectionScene two(manifest.GetSpecial("two_solids").Path);
  const Vector planes[][2] = { { { 0, 0, 12 }, { 0, 0, 1 } }, { { 0, 0, -3 }, { 0, 0, 1 } },
    { { 55, 0, 0 }, { 1, 0, 0 } }, { { 0, 0, 5 }, { 0.1L, 0.2L, 1 } }, { { 5e5L, 0, 12 }, { 0, 0, 1 } } };
  for (const auto& [point, axis] : planes)
  {
    for (const int sense : { 1, -1 })
    {
      const Vector normal = Scaled(axis, sense);
      two.Set(point, normal);
      two.Filter->Update();
      double centroid[3];
      two.Filter->GetSectionCentroid(centroid);
      CheckTrue("two solids, the centroid is known", std::isfinite(two.Filter->GetSectionCentroidBound()));
      CheckOnPlane("two solids, all", point, normal, centroid, two.Filter->GetSectionCentroidBound());
      auto* rows = vtkTable::SafeDownCast(two.Filter->GetOutputDataObject(1))->GetRowData();
      for (vtkIdType row = 0; row < 2; ++row)
      {
        rows->GetArray(sm::names::SectionCentroid)->GetTuple(row, centroid);
        CheckOnPlane("two solids, one", point, normal, centroid,
          rows->GetArray((std::string(sm::names::SectionCentroid) + sm::names::BoundSuffix).c_str())
            ->GetComponent(row, 0));
      }
      if (point[2] == 12)
      {
        two.Filter->GetSectionCentroid(centroid);
        const double exact[3] = { 60, 10, 12 };
        for (int c = 0; c < 3; ++c)
        {
          Check("two solids, centroid of the higher one", exact[c], centroid[c],
            two.Filter->GetSectionCentroidBound());
        }
      }
    }
  }
}

/// Results of both sides that differ by more than their bounds, or a centroid off the plane, are found.
void CheckContradictions(const Manifest&)
{
  const sm::Waterline plane{ { 7, 0, 5 }, { 0, 0, 2 } };
  sm::SectionMoments below;
  below.Origin = { 1, 2, 5 };
  below.Axes = { { { 1, 0, 0 }, { 0, 1, 0 } } };
  below.Area = 4.0;
  below.Second = { 3.0, 2.0, 0.5 };
  below.AreaBound = 1e-9;
  below.FirstBound = { 1e-9, 1e-9 };
  below.SecondBound = { 1e-9, 1e-9, 1e-9 };
  const auto find = [&](const sm::SectionMoments& above) { return FindContradiction(below, above, plane); };
  CheckEqual("no contradiction", std::string(), find(below));
  sm::SectionMoments above = below;
  above.Area += 1e-8;
  CheckTrue("areas", find(above).find("areas") != std::string::npos);
  above = below;
  above.First[1] += 1e-7;
  CheckTrue("centroids", find(above).find("centroids") != std::string::npos);
  above = below;
  above.Second[2] += 1e-7;
  CheckTrue("second moments", find(above).find("second moments") != std::string::npos);
  below.Origin[2] += 1e-8;
  CheckTrue("off the plane", find(below).find("off the plane") != std::string::npos);
  CheckEqual("an empty section is not a contradiction", std::string(), FindContradiction({}, {}, plane));
}

void CheckOpen(const Manifest& manifest)
{
  SectionScene solid(manifest.GetSpecial("open_solid").Path);
  for (const double sense : { 1.0, -1.0 })
  {
    solid.Set({ 15, 10, 5 }, { sense, 0, 0 });
    solid.Filter->Update();
    CheckEqual("open solid, status", "open", solid.Filter->GetStatus());
    CheckTrue("open solid, said", Says(solid.Filter, "are not defined"), GetMessages(solid.Filter));
    vtkFieldData* fields = solid.Filter->GetOutput()->GetFieldData();
    vtkFieldData* rows = vtkTable::SafeDownCast(solid.Filter->GetOutputDataObject(1))->GetRowData();
    for (const char* name :
      { sm::names::SectionArea, sm::names::SectionCentroid, sm::names::SectionSecondMoments,
        sm::names::VolumeBelow, sm::names::CenterBelow, sm::names::VolumeAbove, sm::names::CenterAbove })
    {
      const std::string bound = std::string(name) + sm::names::BoundSuffix;
      for (const std::string& column : { std::string(name), bound })
      {
        CheckTrue("open solid, no " + column,
          std::isnan(fields->GetArray(column.c_str())->GetComponent(0, 0)) &&
            std::isnan(rows->GetArray(column.c_str())->GetComponent(0, 0)));
      }
    }
  }
  SectionScene shell(manifest.GetSpecial("open_shell").Path);
  shell.Set({ 0, 0, 5 }, { 0, 0, 1 });
  shell.Filter->Update();
  CheckEqual("open shell, status", "open", shell.Filter->GetStatus());
  CheckTrue("open shell, no area", std::isnan(shell.Filter->GetSectionArea()));
  CheckTrue("open shell, no volume", std::isnan(shell.Filter->GetVolumeBelow()));
  SectionScene none(manifest.GetSpecial("points_only").Path);
  none.Filter->Update();
  CheckTrue("no solid, no area", std::isnan(none.Filter->GetSectionArea()));
}

/// Extruded splines: a section across the walls alone has the area of the profile over the cosine. Others:
/// both sides agree.
void CheckSplines(const Manifest& manifest)
{
  for (const auto& [name, height] : { std::make_pair("airfoil", 40.0), std::make_pair("gear", 12.0) })
  {
    const Expected part = manifest.GetSolid(name, "plain")[0];
    SectionScene scene(part.Path);
    for (const double slope : { 0.0, 0.02, 0.08 })
    {
      scene.Set({ part.Center[0], part.Center[1], 0.5 * height }, { slope, -0.5 * slope, 1 });
      scene.Filter->Update();
      const double secant = std::sqrt(1.0 + 1.25 * slope * slope);
      const std::string label = std::string(name) + ", slope " + std::to_string(slope);
      Check(label, part.Volume / height * secant, scene.Filter->GetSectionArea(),
        scene.Filter->GetSectionAreaBound() + part.VolumeAccuracy / height + 1e-15 * part.Volume,
        "the bound");
      CheckRange(label + ", bound", 0.0, scene.Filter->GetSectionAreaBound(), 2e-9 * part.Area);
      CheckEqual(label + ", status", "ok", scene.Filter->GetStatus());
    }
  }
  for (const char* name :
    { "bicylinder", "ellipsoid", "spline_ring", "wavy_plate", "graph_9_9", "rational_block", "moebius_1000" })
  {
    const Expected part = manifest.GetSolid(name, "plain")[0];
    SectionScene scene(part.Path);
    const Vector center = { part.Center[0], part.Center[1], part.Center[2] };
    double areas[2];
    double bounds[2];
    for (const int sense : { 0, 1 })
    {
      scene.Set(center, Scaled({ 0.3L, -0.5L, 0.8L }, sense ? -1 : 1));
      scene.Filter->Update();
      areas[sense] = scene.Filter->GetSectionArea();
      bounds[sense] = scene.Filter->GetSectionAreaBound();
      std::printf("     %s: %g +- %.2g, %g evaluations, %.2g s\n", name, areas[sense], bounds[sense],
        static_cast<double>(scene.Filter->GetEvaluations()),
        scene.Filter->GetPrepareSeconds() + scene.Filter->GetIntegrateSeconds());
      CheckEqual(std::string(name) + ", status", "ok", scene.Filter->GetStatus());
      std::printf("%s", scene.Filter->GetStatus() == "ok" ? "" : GetMessages(scene.Filter).c_str());
    }
    Check(std::string(name) + " from either side", areas[0], areas[1], bounds[0] + bounds[1], "the bounds");
    CheckRange(std::string(name) + ", area", 1.0, areas[0], part.Area);
  }
}
}

int TestSolidSectionRuns(int argc, char* argv[])
{
  return RunMode(argc, argv, "TestSolidSectionRuns",
    { { "touching", CheckTouching }, { "outputs", CheckOutputs }, { "limits", CheckLimits },
      { "shells", CheckShells }, { "bodies", CheckBodies }, { "contradictions", CheckContradictions },
      { "open", CheckOpen }, { "splines", CheckSplines } });
}

/**
 * @file TestEqualBodies.cxx
 * @brief Bodies that equal another one except for a translation share its conversion, and nothing else
 *
 * The shapes are OpenCASCADE's, in one file each; the volumes are closed forms.
 */
#include "smReaderTesting.h"

#include "smComputeMassProperties.h"

#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkTrimmedNURBSModel.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <STEPControl_Writer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

/// CopyPlaces of the bodies in a file; the first one is not moved.
const std::vector<std::array<double, 3>> CopyPlaces = { { 0.0, 0.0, 0.0 }, { 31.7, -0.3, 12.9 },
  { 0.1, 250.0, 0.0 }, { -1234.567, 0.0, -76.25 } };

struct CopiedShape
{
  std::string Name;
  TopoDS_Shape Value;
  double Volume;
  double Area;
  std::array<double, 3> Center;
};

TopoDS_Shape MoveShape(const TopoDS_Shape& shape, const std::array<double, 3>& by)
{
  gp_Trsf motion;
  motion.SetTranslation(gp_Vec(by[0], by[1], by[2]));
  // With a copy the numbers of the geometry are moved, and no placement is written.
  return BRepBuilderAPI_Transform(shape, motion, true).Shape();
}

std::string WriteCopies(const std::string& name, const std::vector<TopoDS_Shape>& shapes)
{
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes)
  {
    builder.Add(all, shape);
  }
  STEPControl_Writer writer;
  writer.Transfer(all, STEPControl_AsIs);
  const std::string path = Folder + "/equal_" + name + ".step";
  writer.Write(path.c_str());
  return path;
}

std::vector<CopiedShape> MakeCopiedShapes()
{
  const double pi = vtkMath::Pi();
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(2.0, 3.0, 4.0).Shape();
  const TopoDS_Shape drill =
    BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(1, 1.5, -1), gp_Dir(0, 0, 1)), 0.5, 6.0).Shape();
  return {
    { "ball", BRepPrimAPI_MakeSphere(gp_Pnt(0.3, 0.1, 0.2), 0.3).Shape(), 4.0 / 3.0 * pi * 0.027,
      4.0 * pi * 0.09, { 0.3, 0.1, 0.2 } },
    { "ring", BRepPrimAPI_MakeTorus(2.0, 0.5).Shape(), 2.0 * pi * pi * 2.0 * 0.25, 4.0 * pi * pi * 2.0 * 0.5,
      { 0.0, 0.0, 0.0 } },
    { "block with a hole", BRepAlgoAPI_Cut(block, drill).Shape(), 24.0 - pi,
      2.0 * (6.0 + 8.0 + 12.0) - 2.0 * pi * 0.25 + 2.0 * pi * 0.5 * 4.0, { 1.0, 1.5, 2.0 } },
  };
}

void CheckCopy(
  const CopiedShape& shape, const std::array<double, 3>& place, const sm::BodyMassProperties& solid)
{
  CheckEqual("  status", "ok", solid.Status);
  Check("  volume", shape.Volume, solid.Volume.Value, solid.Volume.Bound + 4e-16 * shape.Volume, "its bound");
  Check("  area", shape.Area, solid.Area.Value, solid.Area.Bound + 4e-16 * shape.Area, "its bound");
  CheckTrue("  the bound of the volume is useful", solid.Volume.Bound <= 1e-9 * shape.Volume);
  for (int c = 0; c < 3; ++c)
  {
    const double expected = shape.Center[c] + place[c];
    Check("  centre", expected, solid.Center.Value[c], solid.Center.Bound + 4e-16 * std::abs(expected),
      "its bound");
  }
}

/// Returns the models of a file, and checks their values.
std::vector<vtkTrimmedNURBSModel*> ReadCopies(const CopiedShape& shape, vtkSTEPReader* reader)
{
  std::vector<TopoDS_Shape> shapes;
  for (const std::array<double, 3>& place : CopyPlaces)
  {
    shapes.push_back(MoveShape(shape.Value, place));
  }
  reader->SetFileName(WriteCopies(shape.Name.substr(0, 5), shapes).c_str());
  reader->Update();
  const sm::MassPropertiesResult result = sm::ComputeMassProperties(reader->GetOutputDataObject(0));
  CheckEqual(shape.Name, static_cast<int>(CopyPlaces.size()), static_cast<int>(result.Solids.size()));
  std::vector<vtkTrimmedNURBSModel*> models;
  for (std::size_t i = 0; i < std::min(CopyPlaces.size(), result.Solids.size()); ++i)
  {
    CheckCopy(shape, CopyPlaces[i], result.Solids[i]);
    models.push_back(GetLeaf(reader, static_cast<unsigned int>(i))->GetModel());
  }
  return models;
}

/// The copies have the geometry of the first body, and entities, ids and places of their own.
void CheckCopies()
{
  for (const CopiedShape& shape : MakeCopiedShapes())
  {
    vtkNew<vtkSTEPReader> reader;
    const std::vector<vtkTrimmedNURBSModel*> models = ReadCopies(shape, reader);
    std::set<std::int64_t> entities;
    std::set<std::uint64_t> ids;
    std::size_t faces = 0;
    for (std::size_t i = 0; i < models.size(); ++i)
    {
      const std::vector<sm::FacePointer>& own = models[i]->GetFaces();
      CheckTrue("  integrated once", models[i]->GetEqualFaces() == models[0]->GetFaces());
      CheckTrue("  with faces of its own", (own != models[0]->GetFaces()) == (i > 0));
      faces += own.size();
      for (std::size_t f = 0; f < own.size(); ++f)
      {
        entities.insert(own[f]->FileId);
        ids.insert(own[f]->Id);
        CheckTrue("  same coordinates",
          own[f]->Surface.ControlPoints == models[0]->GetFaces()[f]->Surface.ControlPoints);
      }
      CheckTrue("  entity of its own", i == 0 || models[i]->GetFileId() != models[i - 1]->GetFileId());
    }
    CheckEqual("  entity numbers of faces", static_cast<int>(faces), static_cast<int>(entities.size()));
    CheckEqual("  ids of faces", static_cast<int>(faces), static_cast<int>(ids.size()));
  }
}

/// An edit of one body changes that one alone, whichever it is.
void CheckEdits()
{
  const CopiedShape ball = MakeCopiedShapes()[0];
  for (const std::size_t edited : { 0, 2 })
  {
    vtkNew<vtkSTEPReader> reader;
    const std::vector<vtkTrimmedNURBSModel*> models = ReadCopies(ball, reader);
    if (models.size() != CopyPlaces.size())
    {
      return;
    }
    auto face = std::make_shared<sm::Face>(*models[edited]->GetFaces()[0]);
    face->Id = sm::NewId();
    for (std::array<double, 4>& p : face->Surface.ControlPoints)
    {
      // Its origin is the middle of its box, nearly its centre.
      std::for_each(p.begin(), p.begin() + 3, [](double& x) { x *= 2.0; });
    }
    face->Loops.clear();
    models[edited]->SetFace(0, face);
    CheckTrue(
      "an edited body equals no other", models[edited]->GetEqualFaces() == models[edited]->GetFaces());
    const sm::MassPropertiesResult result = sm::ComputeMassProperties(reader->GetOutputDataObject(0));
    for (std::size_t i = 0; i < models.size(); ++i)
    {
      const double expected = (i == edited ? 8.0 : 1.0) * ball.Volume;
      Check("  volume", expected, result.Solids[i].Volume.Value, 1e-9 * expected);
    }
  }
}

/// Bodies that nearly equal another one are bodies of their own.
void CheckUnequalBodies()
{
  const double radius = 0.3;
  const double other = 0.3 * (1.0 + 1e-9);
  std::vector<TopoDS_Shape> shapes;
  for (const double r : { radius, other, radius })
  {
    shapes.push_back(BRepPrimAPI_MakeSphere(gp_Pnt(static_cast<double>(shapes.size()), 0.0, 0.0), r).Shape());
  }
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(WriteCopies("others", shapes).c_str());
  reader->Update();
  const auto getFaces = [&reader](unsigned int i) { return GetLeaf(reader, i)->GetModel()->GetEqualFaces(); };
  CheckTrue("another radius", getFaces(1) != getFaces(0));
  CheckTrue("the same radius", getFaces(2) == getFaces(0));

  vtkNew<vtkTrimmedNURBSModel> model;
  model->SetFaces(getFaces(0));
  ErrorLog log;
  log.Watch(model);
  std::vector<sm::FacePointer> two = getFaces(0);
  two.push_back(two[0]);
  model->SetEqualFaces(two);
  model->SetEqualFaces({ nullptr });
  CheckEqual("faces that cannot be equal", 2, log.Count);
  CheckTrue("  are refused", model->GetEqualFaces() == model->GetFaces());
}
}

int TestEqualBodies(int argc, char* argv[])
{
  if (argc < 2)
  {
    return 1;
  }
  Folder = argv[1];
  CheckCopies();
  CheckEdits();
  CheckUnequalBodies();
  return Finish();
}

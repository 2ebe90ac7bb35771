// TestMassPropertiesEdits opengl|cpu: closed forms of edited solids, undo, bits and cost of an edit, moves
// and deformations.
#include "smLatticeBody.h"
#include "smModelEdit.h"
#include "smTestPipeline.h"

#include <vtkComputeContext.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkNURBSDeform.h>
#include <vtkNURBSTransform.h>
#include <vtkPoints.h>
#include <vtkTable.h>

namespace
{
using namespace smtest;
namespace names = sm::names;

void Weigh(vtkMassPropertiesGPU* mass, vtkNURBSDataSet* like, vtkTrimmedNURBSModel* model)
{
  vtkNew<vtkNURBSDataSet> leaf;
  leaf->ShallowCopy(like);
  leaf->SetModel(model);
  mass->SetInputData(leaf);
  mass->Update();
}

void CheckVolumes(int backend)
{
  std::printf("--- a control point moves\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetBackend(backend);
  mass->SetRelativeTolerance(1e-13);
  mass->SetInputData(leaf);
  mass->Update();
  Check("volume", body.GetVolume(), mass->GetVolume(), 1e-13 * body.GetVolume());
  const std::vector<double> first = GetFieldNumbers(mass);
  const int last = body.GetNumberOfPoints() - 1;
  const LatticeBody::Point moved{ 0.15, -0.2, 0.35 };
  for (const std::array<int, 2> at : { std::array<int, 2>{ 2, 1 }, { 0, 2 }, { 3, 4 }, { 0, 0 }, { 4, 0 } })
  {
    const auto index = LatticeBody::ToFace(1, last, at[0], at[1]);
    const sm::ModelEdit edit = sm::MoveControlPoints(
      leaf->GetModel(), 5, { { index[0], index[1] } }, moved, sm::EditRule::MoveSharedBoundary);
    Weigh(mass, leaf, edit.Model);
    const double expected = body.GetVolume() + body.GetVolumeChange(at[0], at[1], last, moved);
    const std::string name = "point " + std::to_string(at[0]) + "," + std::to_string(at[1]);
    CheckEqual(name + ": status", names::StatusOk, mass->GetStatus());
    Check(name + ": volume", expected, mass->GetVolume(), 1e-12 * body.GetVolume());
    Check(
      name + ": within its bound", expected, mass->GetVolume(), mass->GetVolumeBound() + 1e-15 * expected);
    Check(name + ": gap", 0.0, GetField(mass->GetOutput()->GetFieldData(), names::MaxGap), 1e-14,
      "rounding of 5");
    CheckTrue(name + ": other numbers", !HaveSameBits(first, GetFieldNumbers(mass)));
    // By value, with faces of new ids; and by the faces that were there.
    std::array<double, 4> point;
    sm::GetControlPoint(leaf->GetModel(), 5, { index[0], index[1] }, point);
    const sm::ModelEdit back = sm::SetControlPoints(
      edit.Model, 5, { { { index[0], index[1] }, point } }, sm::EditRule::MoveSharedBoundary);
    Weigh(mass, leaf, back.Model);
    CheckTrue(name + ": set back, the same bits", HaveSameBits(first, GetFieldNumbers(mass)));
    CheckTrue(name + ": by evaluating again", mass->GetEvaluations() > 0);
    Weigh(mass, leaf, sm::ReplaceFaces(edit.Model, edit.Replaced).Model);
    CheckTrue(name + ": undone, the same bits", HaveSameBits(first, GetFieldNumbers(mass)));
    CheckEqual(name + ": for nothing", 0, mass->GetEvaluations());
  }
}

/// 84 bodies of one model, apart from each other.
vtkSmartPointer<vtkTrimmedNURBSModel> MakeManyFaces()
{
  std::vector<sm::FacePointer> faces;
  std::vector<std::vector<int>> shells;
  for (int i = 0; i < 84; ++i)
  {
    LatticeBody body;
    body.Degree = 2 + i % 3;
    body.Knots.assign(body.Degree + 1, 0.0);
    body.Knots.resize(2 * body.Degree + 2, 1.0);
    const auto shift = [i](const LatticeBody::Point& p) {
      return LatticeBody::Point{ p[0] + 4.0 * (i % 10), p[1] + 5.0 * (i / 10), p[2] };
    };
    const sm::ModelEdit edit =
      sm::MapControlPoints(body.Make()->GetModel(), {}, shift, sm::EditRule::OneFace);
    shells.emplace_back();
    for (const sm::FacePointer& face : edit.Model->GetFaces())
    {
      shells.back().push_back(static_cast<int>(faces.size()));
      faces.push_back(face);
    }
  }
  auto model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  model->SetFaces(faces);
  model->SetShells(shells);
  const double bounds[6] = { 0.0, 38.0, 0.0, 43.0, 0.0, 5.0 };
  model->SetLocalBounds(bounds);
  return model;
}

void CheckCost(int backend)
{
  std::printf("--- one face of 504\n");
  const auto model = MakeManyFaces();
  vtkNew<vtkNURBSDataSet> leaf;
  const auto weigh = [&](vtkMassPropertiesGPU* mass, vtkTrimmedNURBSModel* what)
  {
    mass->SetBackend(backend);
    Weigh(mass, leaf, what);
    return mass->GetEvaluations();
  };
  vtkNew<vtkMassPropertiesGPU> mass;
  const auto original = weigh(mass, model);
  const std::vector<double> first = GetFieldNumbers(mass);
  Check("volume", 84 * 30.0, mass->GetVolume(), 1e-9 * 84 * 30.0);
  // A point inside a face of degree 4, a lid.
  const int face = 6 * 50 + 5;
  const sm::ModelEdit edit =
    sm::MoveControlPoints(model, face, { { 2, 1 } }, { 0.1, 0.2, 0.4 }, sm::EditRule::MoveSharedBoundary);
  CheckEqual("one face is new", 1, static_cast<long long>(edit.Replaced.size()));
  const auto edited = weigh(mass, edit.Model);
  const std::vector<double> incremental = GetFieldNumbers(mass);
  vtkNew<vtkMassPropertiesGPU> fresh;
  const auto full = weigh(fresh, edit.Model);
  CheckTrue("the bits of a full run", HaveSameBits(GetFieldNumbers(fresh), incremental));
  CheckTrue("not those from before", !HaveSameBits(first, incremental));
  // Evaluations of the face before the edit, by a filter that has results of all others.
  const auto before = weigh(fresh, model);
  CheckTrue("back again, the first bits", HaveSameBits(first, GetFieldNumbers(fresh)));
  CheckRange("evaluations of the edit", 1.0, static_cast<double>(edited), static_cast<double>(full) / 10.0);
  CheckEqual("are exactly the face's of a full run", full - (original - before), edited);
  CheckEqual("undone, none at all", 0, weigh(mass, model));
  mass->CacheFaceResultsOff();
  CheckEqual("none kept, all of them", original, weigh(mass, model));
  CheckTrue("for the same bits", HaveSameBits(first, GetFieldNumbers(mass)));
  mass->CacheFaceResultsOn();
  mass->SetRelativeTolerance(1e-12);
  CheckTrue("another tolerance is another question", weigh(mass, model) >= original);
}

/// A result of one context is not reported as that of another.
void CheckContexts()
{
  std::printf("--- another context\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetBackend(vtkMassPropertiesGPU::OPENGL);
  mass->SetInputData(leaf);
  mass->Update();
  const auto evaluations = mass->GetEvaluations();
  CheckTrue("evaluated", evaluations > 0);
  mass->Modified();
  mass->Update();
  CheckEqual("again, for nothing", 0, mass->GetEvaluations());
  mass->GetComputeContext()->Stop();
  mass->Modified();
  mass->Update();
  CheckEqual("in the next context anew", evaluations, mass->GetEvaluations());
}

/// A run fills arrays of the one before again, but not those that somebody holds.
void CheckHeldOutputs(int backend)
{
  std::printf("--- outputs that are held\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetBackend(backend);
  mass->SetInputData(leaf);
  mass->Update();
  const auto getArray = [&mass](const std::string& name)
  { return mass->GetOutput()->GetFieldData()->GetArray(name.c_str()); };
  const auto getTable = [&mass]() { return vtkTable::SafeDownCast(mass->GetOutputDataObject(1)); };
  const double volume = mass->GetVolume();
  const double area = mass->GetSurfaceArea();
  const double x = mass->GetOutput()->GetPoint(0)[0];
  const vtkSmartPointer<vtkDataArray> held = getArray(names::Volume);
  CheckTrue("the range of an area", getArray(names::SurfaceArea)->GetRange()[1] == area);
  getArray(names::SurfaceArea)->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "mm^2");
  getArray(names::CenterOfMass)->SetComponentName(0, "x");
  vtkNew<vtkTable> table;
  table->ShallowCopy(getTable());
  const vtkSmartPointer<vtkPoints> glyph = mass->GetOutput()->GetPoints();
  const vtkAbstractArray* const unheld = getArray(std::string(names::Volume) + names::BoundSuffix);
  const auto lookUpBound = [&]()
  { return getArray(std::string(names::Volume) + names::BoundSuffix)->LookupValue(mass->GetVolumeBound()); };
  CheckEqual("a bound is found by its value", 0, static_cast<int>(lookUpBound()));
  const vtkMTimeType time = mass->GetOutput()->GetFieldData()->GetMTime();

  const sm::ModelEdit edit = sm::MoveControlPoints(
    leaf->GetModel(), 5, { { 2, 2 } }, { 0.1, 0.2, 0.3 }, sm::EditRule::MoveSharedBoundary);
  Weigh(mass, leaf, edit.Model);
  CheckTrue("another volume", mass->GetVolume() != volume);
  Check("in an array of its own", mass->GetVolume(), getArray(names::Volume)->GetTuple1(0), 0.0);
  Check("the held array", volume, held->GetTuple1(0), 0.0);
  Check("the held table", volume,
    vtkDataArray::SafeDownCast(table->GetColumnByName(names::Volume))->GetTuple1(0), 0.0);
  Check("the new table", mass->GetVolume(),
    vtkDataArray::SafeDownCast(getTable()->GetColumnByName(names::Volume))->GetTuple1(0), 0.0);
  Check("the held glyph", x, glyph->GetPoint(0)[0], 0.0);
  CheckTrue("the new glyph", mass->GetOutput()->GetPoint(0)[0] != x);
  Check(
    "the range of the new area", mass->GetSurfaceArea(), getArray(names::SurfaceArea)->GetRange()[1], 0.0);
  CheckTrue("no information stays",
    !getArray(names::SurfaceArea)->GetInformation()->Has(vtkDataArray::UNITS_LABEL()));
  CheckTrue("nor names of components", !getArray(names::CenterOfMass)->HasAComponentName());
  CheckTrue("an array that nobody holds is filled again",
    getArray(std::string(names::Volume) + names::BoundSuffix) == unheld);
  CheckEqual("and found by its new value", 0, static_cast<int>(lookUpBound()));
  CheckTrue(
    "and is newer", unheld && getArray(std::string(names::Volume) + names::BoundSuffix)->GetMTime() > time);
}

void CheckFilters(int backend)
{
  std::printf("--- moved and deformed\n");
  LatticeBody body;
  const auto leaf = body.Make();
  vtkNew<vtkNURBSTransform> move;
  move->SetInputData(leaf);
  vtkNew<vtkMassPropertiesGPU> mass;
  mass->SetBackend(backend);
  mass->SetInputConnection(move->GetOutputPort());
  mass->Update();
  const double volume = mass->GetVolume();
  move->SetRotation(0.0, 0.0, 90.0);
  move->SetMirror(vtkNURBSTransform::X);
  move->SetTranslation(10.0, 20.0, 30.0);
  mass->Update();
  CheckEqual("a move costs nothing", 0, mass->GetEvaluations());
  Check("and keeps the volume", volume, mass->GetVolume(), 1e-14 * volume, "rounding");
  // (1, 1.5, 2.5) mirrored to (-1, 1.5, 2.5) and rotated to (-1.5, -1, 2.5).
  const double expected[3] = { 8.5, 19.0, 32.5 };
  double center[3];
  mass->GetCenterOfMass(center);
  for (int c = 0; c < 3; ++c)
  {
    Check("centre", expected[c], center[c], 1e-12);
  }
  vtkNew<vtkNURBSDeform> deform;
  deform->SetInputConnection(move->GetOutputPort());
  deform->SetMode(vtkNURBSDeform::LATTICE);
  for (int k = 0; k < 4; ++k)
  {
    deform->SetLatticeDisplacement(k % 2, k / 2, 1, 0.0, 0.5, 1.0);
  }
  mass->SetInputConnection(deform->GetOutputPort());
  mass->Update();
  CheckEqual("status", names::StatusOk, mass->GetStatus());
  Check("stretched from 5 to 6", 36.0, mass->GetVolume(), 1e-11);
  CheckTrue("evaluated", mass->GetEvaluations() > 0);
  // A solid that parts at its edges has a volume still, with the gap next to it: rows of a face of its own.
  vtkNew<vtkNURBSDeform> torn;
  torn->SetInputData(leaf);
  torn->AddFace(5);
  torn->KeepClosedOff();
  torn->SetDisplacement(0.0, 0.0, 0.25);
  mass->SetInputConnection(torn->GetOutputPort());
  mass->Update();
  Check("the gap of a torn solid", torn->GetMaxGap(),
    GetField(mass->GetOutput()->GetFieldData(), names::MaxGap), 1e-9);

  leaf->GetPoints()->SetPoint(0, 9.0, 9.0, 9.0);
  leaf->GetPoints()->Modified();
  vtkNew<vtkMassPropertiesGPU> withheld;
  MessageTrap trap(withheld);
  MessageTrap executive(withheld->GetExecutive());
  withheld->SetInputData(leaf);
  withheld->Update();
  CheckTrue("moved points: the message names the filter",
    trap.Errors.find("NURBS Transform") != std::string::npos, trap.Errors);
}
}

int TestMassPropertiesEdits(int argc, char* argv[])
{
  const std::string name = argc == 2 ? argv[1] : "";
  if (name != "opengl" && name != "cpu")
  {
    std::fprintf(stderr, "usage: TestMassPropertiesEdits opengl|cpu\n");
    return 2;
  }
  const int backend = name == "cpu" ? vtkMassPropertiesGPU::CPU : vtkMassPropertiesGPU::OPENGL;
  CheckVolumes(backend);
  CheckCost(backend);
  CheckHeldOutputs(backend);
  CheckFilters(backend);
  if (backend == vtkMassPropertiesGPU::OPENGL)
  {
    CheckContexts();
  }
  return Finish();
}

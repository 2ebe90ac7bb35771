// TestWriters solids|edits SOLIDS OUTPUT PART: files of vtkSTEPWriter and vtkBREPWriter, read again, equal
// their input.
#include "smLatticeBody.h"
#include "smModelEdit.h"
#include "smRoundTrip.h"
#include "smTestManifest.h"
#include "smWriterFiles.h"

#include <vtkNURBSDataSet.h>
#include <vtkNURBSDeform.h>

namespace
{
using namespace smtest;

void CheckLabels(const std::string& name, vtkDataObject* before, vtkDataObject* after)
{
  const auto a = GetModels(before);
  const auto b = GetModels(after);
  bool same = a.size() == b.size() && !a.empty();
  for (std::size_t m = 0; same && m < a.size(); ++m)
  {
    same = a[m]->GetName() == b[m]->GetName() && a[m]->GetFileId() == b[m]->GetFileId() &&
      a[m]->GetFileId() > 0 && a[m]->GetNumberOfFaces() == b[m]->GetNumberOfFaces() &&
      a[m]->GetNumberOfEdges() == b[m]->GetNumberOfEdges() && a[m]->GetShells() == b[m]->GetShells();
    for (vtkIdType f = 0; same && f < a[m]->GetNumberOfFaces(); ++f)
    {
      const sm::Face& x = *a[m]->GetFaces()[f];
      const sm::Face& y = *b[m]->GetFaces()[f];
      same = x.FileId == y.FileId && x.FileId > 0 && x.Name == y.Name && x.Reversed == y.Reversed &&
        x.Loops.size() == y.Loops.size();
    }
  }
  CheckTrue(name + ": names, numbers, shells", same);
}

void CheckSolids(const std::string& folder, const std::string& sample)
{
  for (const char* variant : { "plain", "turned", "mirrored", "tiny", "far", "distant", "inch", "reversed" })
  {
    for (const Expected& expected : Manifest(folder).GetVariant(variant))
    {
      // Every solid as it is and far away; those with seams, poles and voids every way.
      const std::string all = "plain far inch";
      const std::string some =
        "cylinder cone sphere torus bicylinder hollow_sphere gear slanted_hole graph_20_2";
      if (all.find(variant) == std::string::npos && some.find(expected.Solid) == std::string::npos)
      {
        continue;
      }
      const std::string name = expected.Solid + "-" + variant;
      const auto before = ReadFile(expected.Path);
      const auto after = Save(name, before);
      CompareProperties(name, before, after, 2e-14, expected.GetDistance());
      CheckLabels(name, before, after);
      if (std::string(variant) == "plain" || std::string(variant) == "mirrored")
      {
        const double area = std::isnan(expected.Area) ? Weigh(before).Area : expected.Area;
        CheckKernel(Output + "/" + name + ".brep", name, before, expected.Volume, area);
      }
      const bool inch = std::string(variant) == "inch";
      CheckEqual(
        name + ": in inches", inch, ReadAll(Output + "/" + name + ".step").find("INCH") != std::string::npos);
    }
  }
  const auto before = ReadFile(sample);
  CompareProperties("sample part", before, Save("sample_part", before), 1e-14);
  CheckLabels("sample part", before, ReadFile(Output + "/sample_part.step"));
  const Properties p = Weigh(before);
  CheckKernel(Output + "/sample_part.brep", "sample_part", before, p.Volume, p.Area);
}

void CheckEdits(const std::string& folder, const std::string& sample)
{
  LatticeBody body;
  body.Origin = { 100.0, -40.0, 7.0 };
  const auto leaf = body.Make();
  const auto edited = vtkSmartPointer<vtkNURBSDataSet>::New();
  edited->ShallowCopy(leaf);
  const int last = body.GetNumberOfPoints() - 1;
  const LatticeBody::Point moved{ 0.15, -0.2, 0.35 };
  for (const std::array<int, 2> at : { std::array<int, 2>{ 2, 1 }, { 0, 2 }, { 4, 0 } })
  {
    const auto index = LatticeBody::ToFace(1, last, at[0], at[1]);
    const sm::ModelEdit edit = sm::MoveControlPoints(
      leaf->GetModel(), 5, { { index[0], index[1] } }, moved, sm::EditRule::MoveSharedBoundary);
    edited->SetModel(edit.Model);
    const std::string name = "point_" + std::to_string(at[0]) + "_" + std::to_string(at[1]);
    std::string messages;
    const auto after = Save(name, edited, &messages);
    CompareProperties(name, edited, after, 1e-14, 110.0);
    const double expected = body.GetVolume() + body.GetVolumeChange(at[0], at[1], last, moved);
    Check(name + ": volume", expected, after ? Weigh(after).Volume : 0.0, 1e-12 * expected, "closed form");
    CheckKernel(Output + "/" + name + ".brep", name, edited, expected, Weigh(edited).Area);
    CheckTrue(name + ": nothing to say", messages.empty(), messages);
  }
  // A corner of one face alone: the body gapes, and is saved so.
  const auto corner = LatticeBody::ToFace(1, last, 0, 2);
  const sm::ModelEdit open = sm::MoveControlPoints(
    leaf->GetModel(), 5, { { corner[0], corner[1] } }, { 0.0, 0.0, 0.01 }, sm::EditRule::OneFace);
  CheckTrue("opened: the edit opened it", !open.Opened.empty());
  edited->SetModel(open.Model);
  std::string messages;
  const auto after = Save("opened", edited, &messages);
  CompareProperties("opened", edited, after, 1e-12, 110.0);
  CheckTrue("opened: a message says how far", messages.find("lie off 1 of their edges") != std::string::npos,
    messages);
  CheckKernel(Output + "/opened.brep", "opened", edited, body.GetVolume(), Weigh(leaf).Area);

  for (const std::string& path : { sample, Manifest(folder).GetSolid("slanted_hole", "turned")[0].Path })
  {
    vtkNew<vtkSTEPReader> reader;
    reader->SetFileName(path.c_str());
    vtkNew<vtkNURBSDeform> deform;
    deform->SetInputConnection(reader->GetOutputPort());
    deform->SetMode(vtkNURBSDeform::LATTICE);
    deform->SetLatticeSize(2, 2, 2);
    deform->SetLatticeDisplacement(1, 1, 1, 2.0, -1.0, 1.5);
    deform->Update();
    vtkDataObject* data = deform->GetOutputDataObject(0);
    const auto saved = Save("deformed", data);
    const Properties p = Weigh(data);
    CheckTrue("deformed: it was", std::fabs(p.Volume / Weigh(reader->GetOutput()).Volume - 1.0) > 1e-4);
    // The lattice leaves faces off their edges, which OpenCASCADE's reading then approximates again within
    // the gap.
    CompareProperties("deformed", data, saved, 1e-12 + p.GapSquared / p.Volume);
    CheckKernel(Output + "/deformed.brep", "deformed", data, p.Volume, p.Area);
  }
}
}

int TestWriters(int argc, char* argv[])
{
  const std::string mode = argc == 5 ? argv[1] : "";
  if (mode != "solids" && mode != "edits")
  {
    std::fprintf(stderr, "usage: TestWriters solids|edits SOLIDS OUTPUT PART\n");
    return 1;
  }
  Output = MakeFolder(argv[3], "writers-" + mode);
  if (mode == "solids")
  {
    CheckSolids(argv[2], argv[4]);
  }
  else
  {
    CheckEdits(argv[2], argv[4]);
  }
  return Finish();
}

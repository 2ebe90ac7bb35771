// TestDrawingTolerances FOLDER: tolerances of the drawing in a file are field data of the reader's output, in
// its length unit; a filter takes them from there. A
// ball with the radius 5 mm, whose only face may be off by 0.1 mm; FOLDER takes the file.
#include "smCensusSamples.h"
#include "smDrawingTolerances.h"
#include "smFileState.h"
#include "smReaderTesting.h"

#include <vtkFieldData.h>
#include <vtkMassTolerances.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPolyData.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
using namespace smtest;

/// A profile of the face, a narrower one, one of the whole shape, and a flatness that says not where the face
/// is.
const char Drawing[] = R"(#70=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.2),#2);
#71=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(0.5),#2);
#72=SHAPE_ASPECT('','',#45,.T.);
#73=GEOMETRIC_ITEM_SPECIFIC_USAGE('','',#72,$,#29);
#74=DATUM('','',#45,.F.,'A');
#75=(GEOMETRIC_TOLERANCE('','',#71,#72)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#74))SURFACE_PROFILE_TOLERANCE());
#76=(GEOMETRIC_TOLERANCE('','',#70,#72)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#74))SURFACE_PROFILE_TOLERANCE());
#77=(GEOMETRIC_TOLERANCE('','',#71,#45)GEOMETRIC_TOLERANCE_WITH_DATUM_REFERENCE((#74))SURFACE_PROFILE_TOLERANCE());
#78=FLATNESS_TOLERANCE('','',#70,#72);
)";

void CheckArrays(vtkSTEPReader* reader, const std::string& what, double unit)
{
  const std::vector<sm::DrawingTolerance> list = sm::GetDrawingTolerances(reader->GetOutput());
  if (!CheckTrue(what + ": four tolerances", list.size() == 4, std::to_string(list.size())))
  {
    return;
  }
  const double limits[] = { 0.25, 0.1, 0.25 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    const sm::DrawingTolerance& tolerance = list[i];
    CheckEqual("number", 75 + static_cast<long long>(i), static_cast<long long>(tolerance.Id));
    CheckEqual("kind", i < 3 ? "surface profile" : "flatness", tolerance.Kind);
    CheckEqual("of all faces", i == 2, tolerance.IsForAll);
    CheckTrue("of the face", (i == 2) == tolerance.Faces.empty() && (i == 2 || tolerance.Faces[0] == 29));
    if (i < 3)
    {
      Check("upper limit", limits[i] / unit, tolerance.Upper, 1e-15);
      Check("lower limit", -limits[i] / unit, tolerance.Lower, 1e-15);
      CheckEqual("no problem", "", tolerance.Problem);
    }
    else
    {
      CheckTrue("not used", std::isnan(tolerance.Upper) && !tolerance.Problem.empty());
    }
  }
}

void CheckVolume(vtkSTEPReader* reader)
{
  vtkNew<vtkMassTolerances> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  const auto getUpper = [&filter]()
  {
    filter->Update();
    return filter->GetOutput()->GetFieldData()->GetArray("VolumeUpper")->GetComponent(0, 0);
  };
  const double pi = std::acos(-1.0);
  const auto ball = [pi](double radius) { return 4.0 / 3.0 * pi * radius * radius * radius; };
  Check("without the drawing", ball(5.0), getUpper(), 1e-8);
  filter->UseDrawingOn();
  Check("with it: the narrowest of the face", ball(5.1), getUpper(), 1e-6);
  filter->AddTolerance("face", "#29", -0.05, 0.05);
  Check("rules come before it", ball(5.05), getUpper(), 1e-6);
  CheckTrue("the arrays are not the result's",
    !filter->GetOutput()->GetFieldData()->HasArray(sm::DrawingToleranceKindName));
}
}

int TestDrawingTolerances(int argc, char* argv[])
{
  Folder = argc > 1 ? argv[1] : ".";
  const std::string path = Make("drawing_tolerances.step", MakeStepText(GetBallText() + Drawing));
  vtkNew<vtkSTEPReader> file;
  file->SetFileName(path.c_str());
  file->Update();
  CheckEqual("status", "ok", file->GetStatusAsString());
  CheckArrays(file, "in mm", 1.0);
  file->SetOutputUnit("inch");
  file->Update();
  CheckArrays(file, "in inches", 25.4);
  file->SetOutputUnit("mm");
  file->Update();
  CheckVolume(file);
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(Make("no_tolerances.step", MakeStepText(GetBallText())).c_str());
  reader->Update();
  CheckTrue("a file without tolerances has no arrays",
    !reader->GetOutput()->GetFieldData()->HasArray(sm::DrawingToleranceIdName));
  // Arrays that do not belong together are none.
  std::vector<sm::DrawingTolerance> one(1);
  sm::SetDrawingTolerances(reader->GetOutput(), one);
  CheckEqual("one", 1, static_cast<long long>(sm::GetDrawingTolerances(reader->GetOutput()).size()));
  reader->GetOutput()->GetFieldData()->GetAbstractArray(sm::DrawingToleranceKindName)->SetNumberOfTuples(0);
  CheckTrue("an array is too short", sm::GetDrawingTolerances(reader->GetOutput()).empty());
  sm::RemoveFileState(reader->GetOutput());
  CheckTrue("removed", !reader->GetOutput()->GetFieldData()->HasArray(sm::DrawingToleranceIdName));
  return Finish();
}

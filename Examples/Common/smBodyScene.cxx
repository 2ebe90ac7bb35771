#include "smBodyScene.h"

#include "smSafeFile.h"
#include "smText.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <map>
#include <utility>

namespace sm
{
const double InkColor[3] = { 0.13, 0.19, 0.28 };
const double GreenColor[3] = { 0.05, 0.72, 0.20 };

namespace
{
const char* const ColorName = "Color"; // of vtkSTEPReader
const unsigned char Steel[3] = { 102, 143, 199 };
}

void AddColors(vtkPolyData* part)
{
  if (!part->GetCellData()->GetArray(ColorName))
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName(ColorName);
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(part->GetNumberOfCells());
    for (int c = 0; c < 3; ++c)
    {
      colors->FillComponent(c, Steel[c]);
    }
    part->GetCellData()->AddArray(colors);
  }
  part->GetCellData()->SetActiveScalars(ColorName);
}

vtkSmartPointer<vtkPolyData> JoinParts(vtkPartitionedDataSetCollection* parts)
{
  vtkNew<vtkAppendPolyData> append;
  auto iterator = vtkSmartPointer<vtkDataObjectTreeIterator>::New();
  iterator->SetDataSet(parts);
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (auto* part = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      vtkNew<vtkPolyData> colored;
      colored->ShallowCopy(part);
      AddColors(colored);
      append->AddInputData(colored);
    }
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
  }
  return append->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeOutlines(vtkPolyData* mesh)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> uses;
  vtkNew<vtkIdList> cell;
  vtkCellArray* polygons = mesh->GetPolys();
  for (vtkIdType i = 0; i < polygons->GetNumberOfCells(); ++i)
  {
    polygons->GetCellAtId(i, cell);
    const vtkIdType count = cell->GetNumberOfIds();
    for (vtkIdType k = 0; k < count; ++k)
    {
      const vtkIdType p = cell->GetId(k);
      const vtkIdType q = cell->GetId((k + 1) % count);
      ++uses[std::minmax(p, q)];
    }
  }
  vtkNew<vtkCellArray> lines;
  for (const auto& [ends, count] : uses)
  {
    if (count == 1)
    {
      const vtkIdType line[2] = { ends.first, ends.second };
      lines->InsertNextCell(2, line);
    }
  }
  auto outlines = vtkSmartPointer<vtkPolyData>::New();
  outlines->SetPoints(mesh->GetPoints());
  outlines->SetLines(lines);
  return outlines;
}

vtkSmartPointer<vtkActor> AddActor(
  vtkRenderer* renderer, vtkPolyData* data, const double* color, double opacity)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScalarVisibility(!color);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  if (color)
  {
    actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  }
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> AddBody(vtkRenderer* renderer, vtkPolyData* mesh)
{
  vtkSmartPointer<vtkActor> body = AddActor(renderer, mesh, nullptr, 0.40);
  body->GetProperty()->SetSpecular(0.35);
  body->GetProperty()->SetSpecularPower(30.0);
  return body;
}

vtkSmartPointer<vtkActor> AddOutlines(vtkRenderer* renderer, vtkPolyData* lines)
{
  vtkSmartPointer<vtkActor> outlines = AddActor(renderer, lines, InkColor, 0.75);
  outlines->GetProperty()->LightingOff();
  outlines->GetProperty()->SetLineWidth(1.2f);
  return outlines;
}

void AddMark(vtkRenderer* body, vtkRenderer* front, vtkPolyData* mark)
{
  AddActor(body, mark, GreenColor, 1.0);
  AddActor(front, mark, GreenColor, 0.55);
}

void AddDrawing(vtkRenderer* body, vtkRenderer* front, vtkPolyData* drawing)
{
  for (vtkRenderer* layer : { body, front })
  {
    vtkSmartPointer<vtkActor> actor = AddActor(layer, drawing, nullptr, layer == body ? 1.0 : 0.55);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(3.0f);
  }
}

vtkSmartPointer<vtkTextActor> AddText(
  vtkRenderer* renderer, const std::string& text, int size, bool bold, int x, int y, bool hanging)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  SetText(actor, text);
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetFontSize(size);
  style->SetBold(bold);
  style->SetColor(0.12, 0.15, 0.20);
  style->SetLineSpacing(1.15);
  if (hanging)
  {
    style->SetVerticalJustificationToTop();
  }
  actor->SetDisplayPosition(x, y);
  renderer->AddViewProp(actor);
  return actor;
}

void SetText(vtkTextActor* actor, const std::string& text)
{
  // A file name may be in any encoding; VTK's fonts take UTF-8 only.
  actor->SetInput(MakeUtf8(text).c_str());
}

std::string RaiseDigits(std::string text)
{
  for (const auto& [plain, raised] : { std::pair("^2", "\xC2\xB2"), std::pair("^3", "\xC2\xB3") })
  {
    for (size_t i = text.find(plain); i != std::string::npos; i = text.find(plain, i))
    {
      text.replace(i, 2, raised);
    }
  }
  return text;
}

void SetUpLayers(vtkRenderWindow* window, vtkRenderer* body, vtkRenderer* front, int peels)
{
  body->SetGradientBackground(true);
  body->SetBackground(0.86, 0.89, 0.93);
  body->SetBackground2(0.99, 0.99, 1.0);
  body->SetUseFXAA(true);
  body->SetUseDepthPeeling(1);
  body->SetMaximumNumberOfPeels(peels);
  body->SetOcclusionRatio(0.0);
  front->SetLayer(1);
  front->InteractiveOff();
  front->SetActiveCamera(body->GetActiveCamera());
  window->SetAlphaBitPlanes(1);
  window->SetMultiSamples(0);
  window->SetNumberOfLayers(2);
  window->AddRenderer(body);
  window->AddRenderer(front);
}

void SetView(vtkRenderer* body, const double bounds[6], double zoom, double shift)
{
  vtkCamera* camera = body->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(-1.0, -1.7, 1.1);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(20.0);
  body->ResetCamera(bounds);
  camera->Zoom(zoom);
  camera->SetWindowCenter(0.0, shift);
  body->ResetCameraClippingRange();
}

vtkSmartPointer<vtkImageData> GrabImage(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->Update();
  return grab->GetOutput();
}

std::string WriteImage(vtkImageData* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  const std::string problem = writer->GetErrorCode() != vtkErrorCode::NoError || !bytes
    ? std::string("the picture cannot be encoded")
    : SaveFile(fileName,
        std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)), bytes->GetNumberOfValues()));
  return problem.empty() ? problem : fileName + " cannot be written: " + problem;
}
}

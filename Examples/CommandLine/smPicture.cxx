#include "smPicture.h"

#include "smReport.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkErrorCode.h"
#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPNGWriter.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

namespace
{
const int Width = 900;
const int Height = 700;
const int Margin = 20;
const char* const ColorName = "Color"; // of vtkSTEPReader
const unsigned char Steel[3] = { 102, 143, 199 };

/// A copy of a part with a colour in every cell: the file's, or steel.
vtkSmartPointer<vtkPolyData> Colored(vtkPolyData* part)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(part);
  if (!copy->GetCellData()->GetArray(ColorName))
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName(ColorName);
    colors->SetNumberOfComponents(3);
    colors->SetNumberOfTuples(copy->GetNumberOfCells());
    for (int c = 0; c < 3; ++c)
    {
      colors->FillComponent(c, Steel[c]);
    }
    copy->GetCellData()->AddArray(colors);
  }
  copy->GetCellData()->SetActiveScalars(ColorName);
  return copy;
}

/// All parts in one mesh. Faces share no points, so shading breaks where they meet.
vtkSmartPointer<vtkPolyData> JoinParts(vtkPartitionedDataSetCollection* parts)
{
  vtkNew<vtkAppendPolyData> append;
  auto iterator = vtkSmartPointer<vtkDataObjectTreeIterator>::New();
  iterator->SetDataSet(parts);
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    if (auto* part = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject()))
    {
      append->AddInputData(Colored(part));
    }
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
  }
  return append->GetOutput();
}

/// The borders of all faces, which are open borders of the mesh.
vtkSmartPointer<vtkPolyData> Outlines(vtkPolyData* mesh)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(mesh);
  edges->BoundaryEdgesOn();
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput();
}

/// Without a color the cells have their own.
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

/// Text of a file name may be in any encoding; VTK's fonts take UTF-8 only.
std::string MakeUtf8(const std::string& text)
{
  using sm::Json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

void AddText(vtkRenderer* renderer, const std::string& text, int size, bool bold, int height, bool fromTop)
{
  vtkNew<vtkTextActor> actor;
  actor->SetInput(MakeUtf8(text).c_str());
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetFontSize(size);
  style->SetBold(bold);
  style->SetColor(0.12, 0.15, 0.20);
  style->SetLineSpacing(1.15);
  if (fromTop)
  {
    style->SetVerticalJustificationToTop();
  }
  actor->SetDisplayPosition(Margin, height);
  renderer->AddActor2D(actor);
}

/// The fonts of a picture have what a plain terminal may not: raised digits.
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

/// The values that there are, and the status when it is not ok.
std::string Caption(const sm::Json& file)
{
  const sm::Json& total = file["total"];
  const sm::Json& bounds = total["bounds"];
  std::string text;
  const auto add = [&](const std::string& label, const std::string& value, int power)
  {
    if (value != "-")
    {
      text += (text.empty() ? "" : "\n") + label + "  " + value + " " + sm::FormatUnit(file, power);
    }
  };
  add("volume", sm::FormatValue(total["volume"], bounds["volume"]), 3);
  add("area", sm::FormatValue(total["area"], bounds["area"]), 2);
  add("centre of mass", sm::FormatVector(total["center_of_mass"], bounds["center_of_mass"]), 1);
  if (!total["stability"].is_null())
  {
    text += "\nstability  " + total["stability"]["verdict"].get<std::string>();
    add("margin", sm::FormatValue(total["stability"]["margin"], total["stability"]["bounds"]["margin"]), 1);
  }
  if (file["status"] != "ok")
  {
    text += "\nstatus  " + file["status"].get<std::string>();
  }
  return RaiseDigits(text);
}

void SetUpScene(const sm::Picture& picture, vtkRenderer* body, vtkRenderer* front)
{
  const double ink[3] = { 0.13, 0.19, 0.28 };
  const double green[3] = { 0.05, 0.72, 0.20 };
  const vtkSmartPointer<vtkPolyData> mesh = JoinParts(picture.Body);

  vtkSmartPointer<vtkActor> part = AddActor(body, mesh, nullptr, 0.40);
  part->GetProperty()->SetSpecular(0.35);
  part->GetProperty()->SetSpecularPower(30.0);
  vtkSmartPointer<vtkActor> lines = AddActor(body, Outlines(mesh), ink, 0.75);
  lines->GetProperty()->LightingOff();
  lines->GetProperty()->SetLineWidth(1.2f);
  // Once in its place, and once faintly over everything, for thick walls hide what is inside.
  AddActor(body, picture.Mark, green, 1.0);
  AddActor(front, picture.Mark, green, 0.55);
  for (vtkRenderer* layer : { body, front })
  {
    if (picture.Stability)
    {
      vtkSmartPointer<vtkActor> standing =
        AddActor(layer, picture.Stability, nullptr, layer == body ? 1.0 : 0.55);
      standing->GetProperty()->LightingOff();
      standing->GetProperty()->SetLineWidth(3.0f);
    }
  }

  body->SetGradientBackground(true);
  body->SetBackground(0.86, 0.89, 0.93);
  body->SetBackground2(0.99, 0.99, 1.0);
  body->SetUseFXAA(true);
  body->SetUseDepthPeeling(1);
  body->SetMaximumNumberOfPeels(12);
  body->SetOcclusionRatio(0.0);

  vtkCamera* camera = body->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(-1.0, -1.7, 1.1);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(20.0);
  body->ResetCamera();
  camera->Zoom(1.05);
  camera->SetWindowCenter(0.0, -0.06); // room for the caption below
  front->SetActiveCamera(camera);
  body->ResetCameraClippingRange();

  const std::string path = (*picture.Result)["file"].get<std::string>();
  AddText(front, path.substr(path.find_last_of('/') + 1), 18, true, Height - Margin, true);
  AddText(front, Caption(*picture.Result), 18, false, Margin, false);
}

std::string WriteImage(vtkOpenGLRenderWindow* window, const std::string& fileName)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(fileName.c_str());
  writer->Write();
  return writer->GetErrorCode() == vtkErrorCode::NoError
    ? std::string()
    : fileName + " cannot be written: " + vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
}
}

namespace sm
{
std::string WritePicture(const Picture& picture, const std::string& fileName)
{
  vtkNew<vtkRenderer> body;
  vtkNew<vtkRenderer> front;
  SetUpScene(picture, body, front);
  vtkOpenGLRenderWindow* window = picture.Window;
  window->SetOffScreenRendering(1);
  window->SetAlphaBitPlanes(1);
  window->SetMultiSamples(0);
  window->SetSize(Width, Height);
  window->SetNumberOfLayers(2);
  front->SetLayer(1);
  front->InteractiveOff();
  window->AddRenderer(body);
  window->AddRenderer(front);
  window->Render();
  std::string error = WriteImage(window, fileName);
  window->RemoveRenderer(front);
  window->RemoveRenderer(body);
  return error;
}
}

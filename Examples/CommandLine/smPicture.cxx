#include "smPicture.h"

#include "smBodyScene.h"
#include "smReport.h"
#include "smText.h"

#include "vtkBoundingBox.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

namespace
{
const int Width = 900;
const int Height = 700;
const int Margin = 20;

/// The values that exist, and the status when it is not ok.
std::string Caption(const sm::Json& file)
{
  const sm::Json& total = file["total"];
  const sm::Json& bounds = total["bounds"];
  std::string text;
  const auto add = [&](const std::string& label, const sm::Json& value, const sm::Json& bound, int power)
  {
    if (!value.is_null())
    {
      text += (text.empty() ? "" : "\n") + label + "  " +
        (value.is_array() ? sm::FormatVector(value, bound) : sm::FormatValue(value, bound)) + " " +
        sm::FormatUnit(file, power) + (bound.is_null() ? " (no bound)" : "");
    }
  };
  add("volume", total["volume"], bounds["volume"], 3);
  add("area", total["area"], bounds["area"], 2);
  add("centre of mass", total["center_of_mass"], bounds["center_of_mass"], 1);
  if (!total["stability"].is_null())
  {
    text += "\nstability  " + total["stability"]["verdict"].get<std::string>();
    add("stability margin", total["stability"]["stability_margin"],
      total["stability"]["bounds"]["stability_margin"], 1);
  }
  if (file["status"] != "ok")
  {
    text += "\nstatus  " + file["status"].get<std::string>();
  }
  return sm::RaiseDigits(text);
}

void SetUpScene(const sm::Picture& picture, vtkRenderer* body, vtkRenderer* front)
{
  const vtkSmartPointer<vtkPolyData> mesh = sm::JoinParts(picture.Body);
  sm::AddBody(body, mesh);
  sm::AddOutlines(body, sm::MakeOutlines(mesh));
  sm::AddMark(body, front, picture.Mark);
  vtkBoundingBox box(mesh->GetBounds());
  if (picture.Stability)
  {
    sm::AddDrawing(body, front, picture.Stability);
    box.AddBounds(picture.Stability->GetBounds());
  }
  double bounds[6];
  box.GetBounds(bounds);
  sm::SetUpLayers(picture.Window, body, front, 12);
  sm::SetView(body, bounds, 1.05, -0.06); // room for the caption below

  const std::string path = (*picture.Result)["file"].get<std::string>();
  sm::AddText(front, sm::GetFileName(path), 18, true, Margin, Height - Margin, true);
  sm::AddText(front, Caption(*picture.Result), 18, false, Margin, Margin, false);
}
}

namespace sm
{
std::string WritePicture(const Picture& picture, const std::string& fileName)
{
  vtkNew<vtkRenderer> body;
  vtkNew<vtkRenderer> front;
  vtkOpenGLRenderWindow* window = picture.Window;
  window->SetOffScreenRendering(1);
  window->SetSize(Width, Height);
  SetUpScene(picture, body, front);
  window->Render();
  std::string error = WriteImage(GrabImage(window), fileName);
  window->RemoveRenderer(front);
  window->RemoveRenderer(body);
  return error;
}
}

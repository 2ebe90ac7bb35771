#include "smExportColors.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNURBSDataSet.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <map>

namespace sm
{
namespace
{
constexpr Color None{ -1.0, -1.0, -1.0 };

/// Reads the colour of each face from the cell array; a face without triangles has none. Returns false if the
/// leaf has no such array.
bool ReadShown(vtkNURBSDataSet* leaf, std::vector<Color>& shown)
{
  auto* colors = vtkUnsignedCharArray::SafeDownCast(leaf->GetCellData()->GetArray("Color"));
  vtkDataArray* faces = leaf->GetCellData()->GetArray(vtkNURBSDataSet::FaceIndexArrayName());
  if (!colors || colors->GetNumberOfComponents() != 3 || !faces ||
    faces->GetNumberOfTuples() != colors->GetNumberOfTuples())
  {
    return false;
  }
  for (vtkIdType i = 0; i < faces->GetNumberOfTuples(); ++i)
  {
    const double face = faces->GetComponent(i, 0);
    if (face >= 0.0 && face < static_cast<double>(shown.size()))
    {
      Color& color = shown[static_cast<std::size_t>(face)];
      for (int c = 0; c < 3 && color[c] < 0.0; ++c)
      {
        color[c] = colors->GetComponent(i, c) / 255.0;
      }
    }
  }
  return true;
}

bool LookAlike(const Color& a, const Color& b)
{
  for (int c = 0; c < 3; ++c)
  {
    if (std::lround(255.0 * a[c]) != std::lround(255.0 * b[c]))
    {
      return false;
    }
  }
  return true;
}
}

void ReadColors(vtkNURBSDataSet* leaf, ExportBody& body, Color& instance)
{
  const std::vector<FacePointer>& faces = body.Model->GetFaces();
  body.FaceColors.resize(faces.size(), None);
  std::vector<Color> shown(faces.size(), None);
  if (!ReadShown(leaf, shown))
  {
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      body.FaceColors[i] = faces[i]->Color;
    }
    return;
  }
  bool differs = false;
  std::map<Color, int> seen;
  std::map<Color, int> ofBody;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (shown[i][0] >= 0.0)
    {
      const bool own = faces[i]->Color[0] >= 0.0;
      differs = differs || (own && !LookAlike(faces[i]->Color, shown[i]));
      ++seen[shown[i]];
      ofBody[shown[i]] += own ? 0 : 1;
    }
  }
  if (differs && seen.size() == 1)
  {
    instance = seen.begin()->first;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      body.FaceColors[i] = faces[i]->Color;
    }
    return;
  }
  int maximum = 0;
  for (const auto& [color, count] : ofBody)
  {
    if (count > maximum)
    {
      maximum = count;
      body.BodyColor = color;
    }
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const bool own = faces[i]->Color[0] >= 0.0;
    if (own && (shown[i][0] < 0.0 || LookAlike(faces[i]->Color, shown[i])))
    {
      body.FaceColors[i] = faces[i]->Color;
    }
    else if (shown[i][0] >= 0.0 && shown[i] != body.BodyColor)
    {
      body.FaceColors[i] = shown[i];
    }
  }
}

Color GetDifference(const std::vector<ExportBody>& part, const std::vector<ExportBody>& other)
{
  Color one = None;
  bool same = true;
  for (std::size_t b = 0; b < other.size(); ++b)
  {
    for (std::size_t i = 0; i < other[b].FaceColors.size(); ++i)
    {
      const Color& a = part[b].FaceColors[i][0] >= 0.0 ? part[b].FaceColors[i] : part[b].BodyColor;
      const Color& c = other[b].FaceColors[i][0] >= 0.0 ? other[b].FaceColors[i] : other[b].BodyColor;
      same = same && LookAlike(a, c);
      if (c[0] < 0.0 || (one[0] >= 0.0 && !LookAlike(one, c)))
      {
        return None;
      }
      one = c;
    }
  }
  return same ? None : one;
}
}

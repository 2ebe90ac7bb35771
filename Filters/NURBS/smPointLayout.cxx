#include "smPointLayout.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <cmath>

namespace sm
{
namespace
{
constexpr double DegenerateNormal = 1e-6;
constexpr double Nudge = 1.0 / 4096.0;

/// Index of the break that starts the span of `x`.
std::uint32_t FindCell(const std::vector<double>& breaks, double x)
{
  const auto after = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, x);
  return static_cast<std::uint32_t>(after - breaks.begin() - 1);
}
}

PointLayout::PointLayout(vtkDataArray* faceIndex, vtkDataArray* parameters, std::size_t faces)
  : Parameters(parameters)
  , Firsts(faces + 1, 0)
  , Faces(faces)
{
  const vtkIdType count = faceIndex->GetNumberOfTuples();
  std::vector<std::int64_t> faceOf(count, -1);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double face = faceIndex->GetComponent(i, 0);
    if (face >= 0.0 && face < static_cast<double>(faces))
    {
      faceOf[i] = static_cast<std::int64_t>(face);
      ++this->Firsts[faceOf[i] + 1];
    }
  }
  for (std::size_t f = 0; f < faces; ++f)
  {
    this->Firsts[f + 1] += this->Firsts[f];
  }
  this->Ids.resize(this->Firsts[faces]);
  this->Points.resize(this->Firsts[faces]);
  std::vector<std::size_t> next(this->Firsts.begin(), this->Firsts.end() - 1);
  for (vtkIdType i = 0; i < count; ++i)
  {
    if (faceOf[i] >= 0)
    {
      this->Ids[next[faceOf[i]]++] = i;
    }
  }
}

void PointLayout::Sort(const NURBSSurface& surface, std::size_t index)
{
  FacePatches& patches = this->Faces[index];
  for (int d = 0; d < 2; ++d)
  {
    patches.Knots[d] = surface.Knots[d];
    patches.Degree[d] = surface.Degree[d];
  }
  ++patches.Version;
  patches.Cells.clear();
  const std::vector<double> u = surface.GetSpanBreaks(0);
  const std::vector<double> v = surface.GetSpanBreaks(1);
  struct Place
  {
    std::array<std::uint32_t, 2> Cell;
    std::int64_t Id;
  };
  std::vector<Place> places;
  const std::size_t first = this->GetFirst(index);
  for (std::size_t i = first; i < first + this->GetCount(index); ++i)
  {
    const std::int64_t id = this->Ids[i];
    places.push_back({ { FindCell(u, this->Parameters->GetComponent(id, 0)),
                         FindCell(v, this->Parameters->GetComponent(id, 1)) },
      id });
  }
  std::sort(places.begin(), places.end(),
    [](const Place& a, const Place& b)
    {
      return a.Cell[1] != b.Cell[1] ? a.Cell[1] < b.Cell[1]
        : a.Cell[0] != b.Cell[0]    ? a.Cell[0] < b.Cell[0]
                                    : a.Id < b.Id;
    });
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Place& place = places[i];
    if (patches.Cells.empty() || patches.Cells.back() != place.Cell)
    {
      patches.Cells.push_back(place.Cell);
    }
    const auto [column, row] = place.Cell;
    this->Ids[first + i] = place.Id;
    this->Points[first + i] = { (this->Parameters->GetComponent(place.Id, 0) - u[column]) /
        (u[column + 1] - u[column]),
      (this->Parameters->GetComponent(place.Id, 1) - v[row]) / (v[row + 1] - v[row]),
      static_cast<std::uint32_t>(patches.Cells.size() - 1), static_cast<std::uint32_t>(index) };
  }
}

CutFacePointer PointLayout::MakePatches(const FacePointer& face, std::size_t index)
{
  const NURBSSurface& surface = face->Surface;
  FacePatches& patches = this->Faces[index];
  if (patches.Version == 0 || patches.Degree[0] != surface.Degree[0] ||
    patches.Degree[1] != surface.Degree[1] || patches.Knots[0] != surface.Knots[0] ||
    patches.Knots[1] != surface.Knots[1])
  {
    this->Sort(surface, index);
  }
  auto cut = std::make_shared<CutFace>();
  cut->Source = face;
  cut->Degree[0] = surface.Degree[0];
  cut->Degree[1] = surface.Degree[1];
  const std::vector<double> u = surface.GetSpanBreaks(0);
  const std::vector<double> v = surface.GetSpanBreaks(1);
  for (const auto& [column, row] : patches.Cells)
  {
    cut->Panels.Patches.push_back(
      MakePatch(surface, u[column], u[column + 1], v[row], v[row + 1], cut->Panels.Points));
  }
  return cut;
}

PointAndNormal EvaluateDisplayPoint(
  const Patch& patch, const std::array<double, 4>* points, double s, double r)
{
  double position[3];
  double normal[3];
  double square = 0.0;
  const double minimum = DegenerateNormal * patch.Stretch[0] * patch.Stretch[1];
  for (int attempt = 0; attempt < 2; ++attempt)
  {
    double at[3];
    double ds[3];
    double dr[3];
    EvaluatePatch(patch, points, s, r, at, ds, dr);
    square = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const int x = (c + 1) % 3;
      const int y = (c + 2) % 3;
      position[c] = attempt == 0 ? at[c] : position[c];
      normal[c] = ds[x] * dr[y] - ds[y] * dr[x];
      square += normal[c] * normal[c];
    }
    if (square > minimum * minimum)
    {
      break;
    }
    s += Nudge * (0.5 - s);
    r += Nudge * (0.5 - r);
  }
  const double length = std::sqrt(square);
  PointAndNormal result;
  for (int c = 0; c < 3; ++c)
  {
    result[c] = position[c] + patch.Center[c];
    result[3 + c] = length > 0.0 ? normal[c] / length : 0.0;
  }
  return result;
}
}

#include "Detail/smModelGradient.h"

#include "smBodyScales.h"
#include "smModelEdit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace sm
{
namespace
{
// Points closer than this, relative to the diagonal of the model's box, coincide.
constexpr double CoincidentPoints = 1e-9;
// Largest relative difference of the ratios of weights of rows that coincide.
constexpr double EqualRatio = 1e-12;

/// Union-find over numbers.
class Groups
{
public:
  explicit Groups(std::vector<std::vector<int>> numbers)
    : Numbers(std::move(numbers))
  {
    int largest = -1;
    for (const std::vector<int>& face : this->Numbers)
    {
      largest = face.empty() ? largest : std::max(largest, *std::max_element(face.begin(), face.end()));
    }
    this->Other.resize(largest + 1);
    std::iota(this->Other.begin(), this->Other.end(), 0);
  }

  void Join(std::size_t face, std::size_t a, std::size_t b)
  {
    const int first = this->Find(this->Numbers[face][a]);
    const int second = this->Find(this->Numbers[face][b]);
    this->Other[std::max(first, second)] = std::min(first, second);
  }

  std::vector<std::vector<int>> Get()
  {
    for (std::vector<int>& face : this->Numbers)
    {
      for (int& number : face)
      {
        number = this->Find(number);
      }
    }
    return this->Numbers;
  }

private:
  int Find(int at) const
  {
    while (this->Other[at] != at)
    {
      at = this->Other[at];
    }
    return at;
  }

  std::vector<std::vector<int>> Numbers;
  std::vector<int> Other;
};

/// The net of a surface by index in a direction and across it.
struct Net
{
  const NURBSSurface& Surface;
  int Direction;

  int GetLength() const { return this->Surface.NumberOfControlPoints[this->Direction]; }
  int GetWidth() const { return this->Surface.NumberOfControlPoints[1 - this->Direction]; }
  std::size_t GetEntry(int along, int across) const
  {
    const int i = this->Direction == 0 ? along : across;
    const int j = this->Direction == 0 ? across : along;
    return i + static_cast<std::size_t>(this->Surface.NumberOfControlPoints[0]) * j;
  }
  const std::array<double, 4>& Get(int along, int across) const
  {
    return this->Surface.ControlPoints[this->GetEntry(along, across)];
  }
  /// Returns true if the row at index `along` is one point.
  bool IsPoint(int along, double tolerance) const
  {
    for (int k = 1; k < this->GetWidth(); ++k)
    {
      if (!AreClose(this->Get(along, 0), this->Get(along, k), tolerance))
      {
        return false;
      }
    }
    return true;
  }
  /// Returns true if two rows have the same points and weights of one ratio.
  bool AreRowsEqual(int first, int second, double tolerance) const
  {
    const double ratio = this->Get(second, 0)[3] / this->Get(first, 0)[3];
    for (int k = 0; k < this->GetWidth(); ++k)
    {
      const std::array<double, 4>& a = this->Get(first, k);
      const std::array<double, 4>& b = this->Get(second, k);
      if (!AreClose(a, b, tolerance) || std::abs(b[3] - ratio * a[3]) > EqualRatio * b[3])
      {
        return false;
      }
    }
    return true;
  }
  static bool AreClose(const std::array<double, 4>& a, const std::array<double, 4>& b, double tolerance)
  {
    return std::hypot(a[0] / a[3] - b[0] / b[3], a[1] / a[3] - b[1] / b[3], a[2] / a[3] - b[2] / b[3]) <=
      tolerance;
  }
  /// Returns the number of rows at either end that coincide: 1 where the knots are clamped, the degree where
  /// they are not, 0 if the net is not closed.
  int GetClosedRows(double tolerance) const
  {
    const std::vector<double>& knots = this->Surface.Knots[this->Direction];
    const int degree = this->Surface.Degree[this->Direction];
    const int rows =
      knots[1] == knots[degree] && knots[knots.size() - 2] == knots[knots.size() - 1 - degree] ? 1 : degree;
    const int last = this->GetLength() - rows;
    for (int k = 0; k < rows; ++k)
    {
      if (last <= k || !this->AreRowsEqual(k, last + k, tolerance))
      {
        return 0;
      }
    }
    return rows;
  }
};
}

TiedVariables TiedVariables::MakeSeparate(vtkTrimmedNURBSModel* model)
{
  TiedVariables tied;
  int next = 0;
  for (const FacePointer& face : model->GetFaces())
  {
    std::vector<int> numbers(face->Surface.ControlPoints.size());
    std::iota(numbers.begin(), numbers.end(), next);
    next += static_cast<int>(numbers.size());
    tied.Points.push_back(numbers);
  }
  tied.Weights = tied.Points;
  return tied;
}

TiedVariables TiedVariables::Find(vtkTrimmedNURBSModel* model)
{
  const std::vector<std::vector<int>> rows = FindTiedPoints(model);
  Groups points(rows);
  Groups weights(rows);
  const double tolerance = CoincidentPoints * 2.0 * GetRadius(*model);
  for (std::size_t f = 0; f < rows.size(); ++f)
  {
    for (int direction = 0; direction < 2; ++direction)
    {
      const Net net{ model->GetFaces()[f]->Surface, direction };
      for (const int end : { 0, net.GetLength() - 1 })
      {
        for (int k = 1; net.IsPoint(end, tolerance) && k < net.GetWidth(); ++k)
        {
          points.Join(f, net.GetEntry(end, 0), net.GetEntry(end, k));
        }
      }
      const int closed = net.GetClosedRows(tolerance);
      for (int row = 0; row < closed; ++row)
      {
        for (int k = 0; k < net.GetWidth(); ++k)
        {
          const std::size_t a = net.GetEntry(row, k);
          const std::size_t b = net.GetEntry(net.GetLength() - closed + row, k);
          points.Join(f, a, b);
          weights.Join(f, a, b);
        }
      }
    }
  }
  return { points.Get(), weights.Get() };
}

std::vector<bool> TiedVariables::AddFollowers(const std::vector<bool>& faces) const
{
  std::set<int> variables;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    if (faces[f])
    {
      variables.insert(this->Points[f].begin(), this->Points[f].end());
    }
  }
  std::vector<bool> all = faces;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    all[f] = all[f] ||
      std::any_of(this->Points[f].begin(), this->Points[f].end(),
        [&variables](int number) { return variables.count(number) > 0; });
  }
  return all;
}
}

/**
 * @file smPolynomialCurve.h
 * @brief A piecewise polynomial curve in Bernstein form: trim curves (2D) and edge curves (3D)
 *
 * Piece k covers the parameter interval [Breaks[k], Breaks[k+1]]; its Bernstein coefficients belong to
 * the local parameter (t - Breaks[k]) / (Breaks[k+1] - Breaks[k]) in [0,1]. The last coefficient of a
 * piece and the first of the next are the same doubles, so that neighbours share their end point exactly.
 */
#ifndef smPolynomialCurve_h
#define smPolynomialCurve_h

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace sm
{
/// Highest degree of a surface or a curve piece that the library evaluates.
constexpr int MaximumDegree = 25;

/// A polynomial on [0,1] in Bernstein form, given by degree + 1 coefficients that somebody else owns.
template <int Dimension>
struct BernsteinPiece
{
  const std::array<double, Dimension>* Coefficients = nullptr;
  int Degree = 0;

  /// Point (and derivative, if not null) at local parameter x in [0,1], by de Casteljau's scheme.
  std::array<double, Dimension> Evaluate(double x, std::array<double, Dimension>* derivative = nullptr) const
  {
    std::array<double, Dimension> b[MaximumDegree + 1];
    b[0] = this->Coefficients[0];
    for (int i = 1; i <= this->Degree; ++i)
    {
      b[i] = this->Coefficients[i];
    }
    if (derivative)
    {
      derivative->fill(0.0);
    }
    for (int level = this->Degree; level > 0; --level)
    {
      if (level == 1 && derivative)
      {
        for (int d = 0; d < Dimension; ++d)
        {
          (*derivative)[d] = this->Degree * (b[1][d] - b[0][d]);
        }
      }
      for (int i = 0; i < level; ++i)
      {
        for (int d = 0; d < Dimension; ++d)
        {
          b[i][d] = (1.0 - x) * b[i][d] + x * b[i + 1][d];
        }
      }
    }
    return b[0];
  }
};

template <int Dimension>
struct PolynomialCurve
{
  using Point = std::array<double, Dimension>;

  /// Increasing parameters, NumberOfPieces() + 1 of them.
  std::vector<double> Breaks;
  /// Index into Coefficients of each piece's first coefficient, and one past the end.
  std::vector<std::size_t> Offsets{ 0 };
  std::vector<Point> Coefficients;
  /// Largest distance of each coordinate from the curve it was made from; 0: exact.
  Point Residual{};
  /// The same for each piece, of a curve of which a few pieces are much farther from the original than the
  /// others; else empty.
  std::vector<Point> PieceResiduals;

  double GetMaxResidual() const { return *std::max_element(this->Residual.begin(), this->Residual.end()); }
  void RaiseResidual(int coordinate, double residual)
  {
    this->Residual[coordinate] = std::max(this->Residual[coordinate], residual);
    for (Point& r : this->PieceResiduals)
    {
      r[coordinate] = std::max(r[coordinate], residual);
    }
  }
  void AddResidual(int coordinate, double residual)
  {
    this->Residual[coordinate] += residual;
    for (Point& r : this->PieceResiduals)
    {
      r[coordinate] += residual;
    }
  }
  const Point& GetResidual(int piece) const
  {
    return this->PieceResiduals.empty() ? this->Residual : this->PieceResiduals[piece];
  }

  int GetNumberOfPieces() const { return static_cast<int>(this->Offsets.size()) - 1; }
  int GetDegree(int piece) const
  {
    return static_cast<int>(this->Offsets[piece + 1] - this->Offsets[piece]) - 1;
  }
  BernsteinPiece<Dimension> GetPiece(int piece) const
  {
    return { this->Coefficients.data() + this->Offsets[piece], this->GetDegree(piece) };
  }

  /// Appends a piece that ends at parameter `end`; the first call needs Breaks to hold the start.
  /// The first coefficient is replaced by the last one of the piece before, bit for bit.
  void AppendPiece(double end, const Point* coefficients, int degree)
  {
    const std::size_t first = this->Coefficients.size();
    this->Coefficients.insert(this->Coefficients.end(), coefficients, coefficients + degree + 1);
    if (first > 0)
    {
      this->Coefficients[first] = this->Coefficients[first - 1];
    }
    this->Offsets.push_back(this->Coefficients.size());
    this->Breaks.push_back(end);
  }

  double GetStart() const { return this->Breaks.front(); }
  double GetEnd() const { return this->Breaks.back(); }
  const Point& GetStartPoint() const { return this->Coefficients.front(); }
  const Point& GetEndPoint() const { return this->Coefficients.back(); }

  /// Index of the piece that holds parameter t; the nearest one outside the curve's range.
  int FindPiece(double t) const
  {
    int low = 0;
    int high = this->GetNumberOfPieces() - 1;
    while (low < high)
    {
      const int middle = (low + high) / 2;
      (t < this->Breaks[middle + 1] ? high : low) = t < this->Breaks[middle + 1] ? middle : middle + 1;
    }
    return low;
  }

  /// Point (and derivative with respect to t, if not null) at parameter t.
  Point Evaluate(double t, Point* derivative = nullptr) const
  {
    const int piece = this->FindPiece(t);
    const double width = this->Breaks[piece + 1] - this->Breaks[piece];
    const Point point = this->GetPiece(piece).Evaluate((t - this->Breaks[piece]) / width, derivative);
    if (derivative)
    {
      for (double& d : *derivative)
      {
        d /= width;
      }
    }
    return point;
  }
};

using TrimCurve = PolynomialCurve<2>;
using EdgeCurve = PolynomialCurve<3>;
}

#endif

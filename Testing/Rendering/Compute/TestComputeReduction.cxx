// Sums, minima and maxima against the CPU; same bits whatever is reduced next to a segment.
#include "smComputeTesting.h"
#include "smReduction.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <random>

using namespace smtest;

namespace
{
using Segments = std::vector<std::pair<unsigned int, unsigned int>>;
using Operation = sm::Reduction::Operation;

constexpr double Epsilon = std::numeric_limits<double>::epsilon() / 2.0;

/// Sum and sum of magnitudes in the extended precision of long double, with an error far below the bounds
/// checked.
struct Sums
{
  long double Sum = 0.0L;
  long double Magnitude = 0.0L;
};

Sums GetSums(const std::vector<double>& values, unsigned int stride, unsigned int column,
  std::pair<unsigned int, unsigned int> segment)
{
  Sums sums;
  long double error = 0.0L;
  for (unsigned int row = segment.first; row < segment.second; ++row)
  {
    const long double value = values[static_cast<std::size_t>(row) * stride + column];
    const volatile long double sum = sums.Sum + value;
    const volatile long double part = sum - sums.Sum;
    error += (sums.Sum - (sum - part)) + (value - part);
    sums.Sum = sum;
    sums.Magnitude += std::fabs(value);
  }
  sums.Sum += error;
  return sums;
}

void CheckSums(const std::string& what, const std::vector<double>& values, unsigned int stride,
  unsigned int columns, const Segments& segments, const std::vector<double>& result)
{
  if (!CheckEqual(what + ": results", static_cast<long long>(segments.size() * columns),
        static_cast<long long>(result.size())))
  {
    return;
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (unsigned int column = 0; column < columns; ++column)
    {
      const Sums sums = GetSums(values, stride, column, segments[i]);
      const double n = segments[i].second - segments[i].first;
      const double g = 2.0 * n * Epsilon / (1.0 - 2.0 * n * Epsilon);
      // The header's bound.
      const double bound = static_cast<double>(Epsilon * std::fabs(sums.Sum) + g * g * sums.Magnitude);
      const double error = static_cast<double>(std::fabs(result[i * columns + column] - sums.Sum));
      worst = std::max(worst, error > bound ? (bound > 0.0 ? error / bound : 2.0) : 0.0);
    }
  }
  CheckRange(what + ": error beyond its bound", 0.0, worst, 0.0, "see smReduction.h");
}

void CheckExtremes(const std::string& what, const std::vector<double>& values, unsigned int stride,
  unsigned int columns, const Segments& segments, bool minimum, const std::vector<double>& result)
{
  long wrong = result.size() == segments.size() * columns ? 0 : -1;
  for (std::size_t i = 0; wrong >= 0 && i < segments.size(); ++i)
  {
    for (unsigned int column = 0; column < columns; ++column)
    {
      const double infinity = std::numeric_limits<double>::infinity();
      double expected = minimum ? infinity : -infinity;
      for (unsigned int row = segments[i].first; row < segments[i].second; ++row)
      {
        const double value = values[static_cast<std::size_t>(row) * stride + column];
        expected = minimum ? std::min(expected, value) : std::max(expected, value);
      }
      wrong += result[i * columns + column] == expected ? 0 : 1;
    }
  }
  CheckEqual(what + ": wrong values", 0, wrong);
}

bool SameBits(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

std::vector<double> MakeRandom(std::size_t count, unsigned int seed)
{
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> mantissa(-1.0, 1.0);
  std::uniform_int_distribution<int> exponent(-60, 60);
  std::vector<double> values(count);
  for (double& value : values)
  {
    value = std::ldexp(mantissa(generator), exponent(generator));
  }
  return values;
}

/// Segments of every length around the tree's corners, adjacent, empty ones among them.
Segments MakeSegments(unsigned int& rows)
{
  Segments segments;
  rows = 0;
  for (const unsigned int length :
    { 1u, 0u, 2u, 3u, 63u, 64u, 65u, 127u, 128u, 129u, 4095u, 4096u, 4097u, 0u, 5000u, 1u, 262145u })
  {
    segments.emplace_back(rows, rows + length);
    rows += length;
  }
  return segments;
}

void TestAgainstCPU(vtkComputeContext* context)
{
  unsigned int rows = 0;
  const Segments segments = MakeSegments(rows);
  const unsigned int stride = 7;
  const unsigned int columns = 5;
  const std::vector<double> values = MakeRandom(static_cast<std::size_t>(rows) * stride, 1);
  sm::ComputeBuffer buffer(context);
  CheckTrue("upload", buffer.Upload(values), buffer.GetError());
  sm::Reduction reduction(context);
  std::vector<double> result;
  CheckTrue(
    "sum", reduction.Reduce(buffer, stride, columns, segments, Operation::SUM, result), reduction.GetError());
  CheckSums("sum", values, stride, columns, segments, result);
  CheckTrue("empty segment sums to 0", result[columns] == 0.0);
  CheckTrue("minimum", reduction.Reduce(buffer, stride, columns, segments, Operation::MINIMUM, result));
  CheckExtremes("minimum", values, stride, columns, segments, true, result);
  CheckTrue("maximum", reduction.Reduce(buffer, stride, columns, segments, Operation::MAXIMUM, result));
  CheckExtremes("maximum", values, stride, columns, segments, false, result);

  // Overlapping and out of order.
  const Segments mixed = { { 500, 6000 }, { 0, rows }, { 499, 6000 }, { 10, 11 } };
  CheckTrue("mixed", reduction.Reduce(buffer, stride, columns, mixed, Operation::SUM, result));
  CheckSums("mixed", values, stride, columns, mixed, result);

  // Terms that cancel: 1e16 + 1 - 1e16, over more than one block and level.
  std::vector<double> cancelling(3 * 4096);
  for (std::size_t i = 0; i < 4096; ++i)
  {
    cancelling[i] = 1e16;
    cancelling[4096 + i] = 1.0;
    cancelling[2 * 4096 + i] = -1e16;
  }
  CheckTrue("upload", buffer.Upload(cancelling));
  CheckTrue("cancelling", reduction.Reduce(buffer, 1, 1, { { 0, 3 * 4096 } }, Operation::SUM, result));
  // g^2 sum|x| = (2 * 12288 * 1.1e-16)^2 * 8.2e19 = 6e-4, and the result is 4096.
  Check("cancelling", 4096.0, result[0], 1e-3, "bound of the header");
}

/// Terms of very different sizes that cancel in each segment: nothing but rounding errors of the second order
/// is left, so that every change of the tree changes the result. Well-conditioned sums would hide it.
std::vector<double> MakeCancelling(unsigned int rows, unsigned int columns, const Segments& segments)
{
  std::vector<double> values = MakeRandom(static_cast<std::size_t>(rows) * columns, 2);
  std::mt19937_64 generator(3);
  for (const auto& segment : segments)
  {
    const unsigned int half = (segment.second - segment.first) / 2;
    std::vector<unsigned int> order(half);
    std::iota(order.begin(), order.end(), segment.first);
    std::shuffle(order.begin(), order.end(), generator);
    for (unsigned int i = 0; i < half * columns; ++i)
    {
      const std::size_t from = static_cast<std::size_t>(order[i / columns]) * columns + i % columns;
      values[static_cast<std::size_t>(segment.first + half) * columns + i] = -values[from];
    }
  }
  return values;
}

void TestSameBits(vtkComputeContext* context)
{
  unsigned int rows = 0;
  Segments segments = MakeSegments(rows);
  const unsigned int columns = 3;
  const std::vector<double> values = MakeCancelling(rows, columns, segments);
  sm::ComputeBuffer buffer(context);
  CheckTrue("upload", buffer.Upload(values));
  sm::Reduction reduction(context);
  for (const Operation operation : { Operation::SUM, Operation::MINIMUM, Operation::MAXIMUM })
  {
    std::vector<double> together;
    CheckTrue("together", reduction.Reduce(buffer, columns, columns, segments, operation, together));
    std::vector<double> again;
    sm::Reduction other(context);
    CheckTrue("again", other.Reduce(buffer, columns, columns, segments, operation, again));
    CheckTrue("same bits in a second run", SameBits(together, again));

    // Each alone, moved to another place of another buffer with another stride.
    std::vector<double> alone;
    for (const auto& segment : segments)
    {
      const unsigned int length = segment.second - segment.first;
      const unsigned int stride = columns + 2;
      std::vector<double> moved((static_cast<std::size_t>(length) + 17) * stride, 1e30);
      for (unsigned int row = 0; row < length; ++row)
      {
        for (unsigned int column = 0; column < columns; ++column)
        {
          moved[static_cast<std::size_t>(row + 17) * stride + column] =
            values[static_cast<std::size_t>(segment.first + row) * columns + column];
        }
      }
      sm::ComputeBuffer place(context);
      std::vector<double> one;
      if (!place.Upload(moved) ||
        !reduction.Reduce(place, stride, columns, { { 17, 17 + length } }, operation, one))
      {
        CheckTrue("alone", false, place.GetError() + reduction.GetError());
      }
      alone.insert(alone.end(), one.begin(), one.end());
    }
    CheckTrue("same bits alone and elsewhere", SameBits(together, alone));
  }
}

void TestNotFinite(vtkComputeContext* context)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const double huge = std::numeric_limits<double>::max();
  sm::ComputeBuffer buffer(context);
  sm::Reduction reduction(context);
  std::vector<double> result;
  for (const unsigned int at : { 0u, 1u, 70u, 4999u })
  {
    // Column 0 has the NaN, column 1 does not.
    std::vector<double> values(2 * 5000, 1.0);
    values[2 * at] = nan;
    CheckTrue("upload", buffer.Upload(values));
    for (const Operation operation : { Operation::SUM, Operation::MINIMUM, Operation::MAXIMUM })
    {
      CheckTrue("reduce", reduction.Reduce(buffer, 2, 2, { { 0, 5000 } }, operation, result));
      CheckTrue("NaN stays", std::isnan(result[0]));
      Check("the other column", operation == Operation::SUM ? 5000.0 : 1.0, result[1], 0.0, "small integers");
    }
  }
  std::vector<double> values(5000, huge);
  CheckTrue("upload", buffer.Upload(values));
  CheckTrue("overflow", reduction.Reduce(buffer, 1, 1, { { 0, 5000 } }, Operation::SUM, result));
  CheckTrue("overflow is infinite", result[0] == infinity, std::to_string(result[0]));
  CheckTrue("nothing", reduction.Reduce(buffer, 1, 1, { { 3, 3 } }, Operation::MINIMUM, result));
  CheckTrue("minimum of nothing", result[0] == infinity);
  CheckTrue("nothing", reduction.Reduce(buffer, 1, 1, { { 3, 3 } }, Operation::MAXIMUM, result));
  CheckTrue("maximum of nothing", result[0] == -infinity);
  CheckTrue("no segments", reduction.Reduce(buffer, 1, 1, {}, Operation::SUM, result) && result.empty());
}

void TestMistakes(vtkComputeContext* context)
{
  sm::ComputeBuffer buffer(context);
  sm::Reduction reduction(context);
  std::vector<double> result(1, 5.0);
  CheckTrue("upload", buffer.Upload(std::vector<double>(10, 1.0)));
  CheckTrue("a segment outside", !reduction.Reduce(buffer, 2, 2, { { 0, 6 } }, Operation::SUM, result));
  CheckTrue("no result", result.empty() && !reduction.GetError().empty(), reduction.GetError());
  CheckTrue("a segment backwards", !reduction.Reduce(buffer, 2, 2, { { 2, 1 } }, Operation::SUM, result));
  CheckTrue(
    "more columns than doubles", !reduction.Reduce(buffer, 2, 3, { { 0, 1 } }, Operation::SUM, result));
  CheckTrue("no columns", !reduction.Reduce(buffer, 2, 0, { { 0, 1 } }, Operation::SUM, result));
}

/// Larger than one shader storage block on llvmpipe, and more than 65535 groups of the level's invocations.
void TestLarge(vtkComputeContext* context)
{
  const unsigned int rows = 1000000;
  const unsigned int columns = 30;
  std::vector<double> values(static_cast<std::size_t>(rows) * columns);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = static_cast<double>((i * 2654435761u) % 1000003u);
  }
  sm::ComputeBuffer buffer(context);
  CheckTrue("upload of 240 MB", buffer.Upload(values), buffer.GetError());
  Segments segments;
  for (unsigned int begin = 0; begin < rows; begin += 333333)
  {
    segments.emplace_back(begin, std::min(rows, begin + 333333));
  }
  sm::Reduction reduction(context);
  std::vector<double> result;
  for (int i = 0; i < 2; ++i)
  {
    context->ResetCounters();
    const auto start = std::chrono::steady_clock::now();
    CheckTrue("reduces", reduction.Reduce(buffer, columns, columns, segments, Operation::SUM, result),
      reduction.GetError());
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("1e6 x 30 in %.3f s, %llu dispatches\n", seconds.count(),
      static_cast<unsigned long long>(context->GetNumberOfDispatches()));
  }
  long wrong = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (unsigned int column = 0; column < columns; ++column)
    {
      // Integers below 2^53 add without error.
      double sum = 0.0;
      for (unsigned int row = segments[i].first; row < segments[i].second; ++row)
      {
        sum += values[static_cast<std::size_t>(row) * columns + column];
      }
      wrong += result[i * columns + column] == sum ? 0 : 1;
    }
  }
  CheckEqual("wrong sums", 0, wrong);

  // Segments of one row each: blocks x columns / 64 groups, two of them beyond an axis.
  Segments single;
  for (unsigned int row = 0; row < 150000; ++row)
  {
    single.emplace_back(row, row + 1);
  }
  CheckTrue("many short segments", reduction.Reduce(buffer, columns, columns, single, Operation::SUM, result),
    reduction.GetError());
  CheckTrue("are copied",
    result.size() == 150000u * columns && std::equal(result.begin(), result.end(), values.begin()));
}
}

int TestComputeReduction(int, char*[])
{
  return RunInContext({ TestAgainstCPU, TestSameBits, TestNotFinite, TestMistakes, TestLarge });
}

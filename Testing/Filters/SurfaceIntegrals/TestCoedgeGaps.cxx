// Gaps of a face with many loops: the same list as a search through all coedges gives, in n log n time.
#include "smCoedgeGaps.h"
#include "smFace.h"
#include "smTesting.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

namespace
{
/// A plate with round holes: a loop of four coedges around it, two coedges for each hole, and some loops
/// without coedges.
sm::Face MakePlate(int holes)
{
  sm::Face face;
  face.Loops.resize(holes + 1);
  face.Loops[0].Coedges.resize(4);
  for (int i = 1; i <= holes; ++i)
  {
    face.Loops[i].Coedges.resize(i % 7 == 0 ? 0 : 2);
  }
  return face;
}

int CountCoedges(const sm::Face& face)
{
  int count = 0;
  for (const sm::Loop& loop : face.Loops)
  {
    count += static_cast<int>(loop.Coedges.size());
  }
  return count;
}

/// Every coedge in two parts, the second parts in a run of their own, from the last coedge to the first.
void Measure(const sm::Face& face, int coedges, std::vector<sm::CoedgeGap>& gaps)
{
  {
    sm::CoedgeGaps first(face, gaps);
    for (int i = 0; i < coedges; ++i)
    {
      first.Add(i, { 0, 0, 0.1 * i, 0.3 * i, 0.7 * i });
    }
  }
  sm::CoedgeGaps second(face, gaps);
  for (int i = coedges - 1; i >= 0; --i)
  {
    second.Add(
      i, { 0, 0, 0.2 * i, 0.4 * i, i % 3 == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.6 * i });
  }
}

double GetSeconds()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The shortest time of five runs.
double TimePlate(int holes)
{
  const sm::Face face = MakePlate(holes);
  const int coedges = CountCoedges(face);
  double minimum = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 5; ++run)
  {
    std::vector<sm::CoedgeGap> gaps;
    const double start = GetSeconds();
    Measure(face, coedges, gaps);
    minimum = std::min(minimum, GetSeconds() - start);
  }
  return minimum;
}
}

int TestCoedgeGaps(int, char*[])
{
  const sm::Face face = MakePlate(50);
  const int coedges = CountCoedges(face);
  std::vector<sm::CoedgeGap> gaps;
  Measure(face, coedges, gaps);
  smtest::CheckEqual("entries", coedges, static_cast<long long>(gaps.size()));
  int wrong = 0;
  int i = 0;
  for (std::size_t l = 0; l < face.Loops.size(); ++l)
  {
    for (std::size_t c = 0; c < face.Loops[l].Coedges.size(); ++c, ++i)
    {
      const sm::CoedgeGap& gap = gaps.at(i);
      const bool same = gap.Loop == static_cast<int>(l) && gap.Coedge == static_cast<int>(c) &&
        gap.GapSquared == 0.1 * i + 0.2 * i && gap.GapArea == 0.3 * i + 0.4 * i &&
        (i % 3 == 0 ? std::isnan(gap.MaxGap) : gap.MaxGap == 0.7 * i);
      wrong += same ? 0 : 1;
    }
  }
  smtest::CheckEqual("entries that are wrong", 0, wrong);

  const double few = TimePlate(2000);
  const double many = TimePlate(16000);
  smtest::CheckRange("growth exponent of the time, 2000 to 16000 holes", 0.0,
    std::log(many / few) / std::log(8.0), 1.5, "2 for a search through all coedges");
  return smtest::Finish();
}

#include "smCoedgeGaps.h"

#include "smFace.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace sm
{
CoedgeGaps::CoedgeGaps(const Face& face, std::vector<CoedgeGap>& gaps)
  : Gaps(gaps)
{
  int count = 0;
  for (const Loop& loop : face.Loops)
  {
    this->LoopStarts.push_back(count);
    count += static_cast<int>(loop.Coedges.size());
  }
  this->Places.assign(count, -1);
  for (std::size_t i = 0; i < gaps.size(); ++i)
  {
    this->Places[this->LoopStarts[gaps[i].Loop] + gaps[i].Coedge] = static_cast<int>(i);
  }
}

void CoedgeGaps::Add(int coedge, const CoedgeGap& measured)
{
  int& place = this->Places[coedge];
  if (place < 0)
  {
    // The last loop that starts at or before the coedge; those before it with the same start are empty.
    const auto after = std::upper_bound(this->LoopStarts.begin(), this->LoopStarts.end(), coedge);
    place = static_cast<int>(this->Gaps.size());
    this->Gaps.push_back(measured);
    this->Gaps.back().Loop = static_cast<int>(after - this->LoopStarts.begin()) - 1;
    this->Gaps.back().Coedge = coedge - *(after - 1);
    return;
  }
  CoedgeGap& known = this->Gaps[place];
  known.GapSquared += measured.GapSquared;
  known.GapArea += measured.GapArea;
  known.MaxGap = GetLargerGap(known.MaxGap, measured.MaxGap);
}

void AddGaps(const FaceIntegrals& part, FaceIntegrals& face)
{
  face.GapSquared += part.GapSquared;
  face.GapArea += part.GapArea;
  face.MaxGap = GetLargerGap(face.MaxGap, part.MaxGap);
  std::map<std::pair<int, int>, std::size_t> places;
  for (std::size_t i = 0; i < face.Gaps.size(); ++i)
  {
    places[{ face.Gaps[i].Loop, face.Gaps[i].Coedge }] = i;
  }
  for (const CoedgeGap& gap : part.Gaps)
  {
    const auto [place, isNew] = places.emplace(std::pair(gap.Loop, gap.Coedge), face.Gaps.size());
    if (isNew)
    {
      face.Gaps.push_back(gap);
      continue;
    }
    CoedgeGap& known = face.Gaps[place->second];
    known.GapSquared += gap.GapSquared;
    known.GapArea += gap.GapArea;
    known.MaxGap = GetLargerGap(known.MaxGap, gap.MaxGap);
  }
}
}

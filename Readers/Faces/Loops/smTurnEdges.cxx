#include "smTurnEdges.h"

#include <algorithm>
#include <utility>

namespace sm
{
namespace
{
void Turn(DraftCoedge& coedge)
{
  coedge.Reversed = !coedge.Reversed;
  std::swap(coedge.Start, coedge.End);
}

/// Reverses all coedges behind the first that would not begin where the one before ends; returns false if
/// they make no closed chain.
bool TurnToChain(DraftLoop& loop, int& turned)
{
  for (std::size_t i = 1; i < loop.size(); ++i)
  {
    if (!Meet(loop[i - 1], loop[i]))
    {
      Turn(loop[i]);
      ++turned;
      if (!Meet(loop[i - 1], loop[i]))
      {
        return false;
      }
    }
  }
  return Meet(loop.back(), loop.front());
}
}

void TurnEdges(DraftFace& face)
{
  if (face.Loops.size() != 1 || face.Loops[0].size() < 3 || face.Period[0] > 0.0 || face.Period[1] > 0.0)
  {
    return;
  }
  DraftLoop& loop = face.Loops[0];
  bool isChain = true;
  bool hasTrim = false;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    isChain = isChain && Meet(loop[i], loop[(i + 1) % loop.size()]);
    hasTrim = hasTrim || !(loop[i].Projected || loop[i].NeedsFeet);
  }
  for (const bool isFirstReversed : { false, true })
  {
    if (isChain || hasTrim)
    {
      return;
    }
    DraftLoop turned = loop;
    int count = isFirstReversed ? 1 : 0;
    if (isFirstReversed)
    {
      Turn(turned[0]);
    }
    if (TurnToChain(turned, count))
    {
      loop = std::move(turned);
      face.ReversedEdges = count;
      return;
    }
  }
}

void TurnLoop(DraftFace& face)
{
  DraftLoop& loop = face.Loops[0];
  std::reverse(loop.begin(), loop.end());
  for (DraftCoedge& coedge : loop)
  {
    Turn(coedge);
  }
  face.ReversedEdges = static_cast<int>(loop.size()) - face.ReversedEdges;
}
}

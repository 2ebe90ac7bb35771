#include "smReverseEdges.h"

#include <algorithm>
#include <utility>

namespace sm
{
namespace
{
void Reverse(DraftCoedge& coedge)
{
  coedge.Reversed = !coedge.Reversed;
  std::swap(coedge.Start, coedge.End);
}

/// Reverses all coedges after the first that would not begin where the one before ends; returns false if
/// they make no closed chain.
bool ReverseToChain(DraftLoop& loop, int& reversed)
{
  for (std::size_t i = 1; i < loop.size(); ++i)
  {
    if (!Meet(loop[i - 1], loop[i]))
    {
      Reverse(loop[i]);
      ++reversed;
      if (!Meet(loop[i - 1], loop[i]))
      {
        return false;
      }
    }
  }
  return Meet(loop.back(), loop.front());
}
}

void ReverseEdges(DraftFace& face)
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
    DraftLoop reversed = loop;
    int count = isFirstReversed ? 1 : 0;
    if (isFirstReversed)
    {
      Reverse(reversed[0]);
    }
    if (ReverseToChain(reversed, count))
    {
      loop = std::move(reversed);
      face.ReversedEdges = count;
      return;
    }
  }
}

void ReverseLoop(DraftFace& face)
{
  DraftLoop& loop = face.Loops[0];
  std::reverse(loop.begin(), loop.end());
  for (DraftCoedge& coedge : loop)
  {
    Reverse(coedge);
  }
  face.ReversedEdges = static_cast<int>(loop.size()) - face.ReversedEdges;
}
}

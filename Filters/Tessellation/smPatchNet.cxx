#include "smPatchNet.h"

#include "smPatchParts.h"

namespace sm
{
PatchNet Derive(const PatchNet& from, int direction)
{
  PatchNet to;
  const int degree = direction == 0 ? from.P : from.Q;
  to.Resize(
    direction == 0 ? std::max(from.P - 1, 0) : from.P, direction == 1 ? std::max(from.Q - 1, 0) : from.Q);
  for (int j = 0; degree > 0 && j <= to.Q; ++j)
  {
    for (int i = 0; i <= to.P; ++i)
    {
      const Homogeneous& a = from.At(i, j);
      const Homogeneous& b = direction == 0 ? from.At(i + 1, j) : from.At(i, j + 1);
      for (int c = 0; c < 4; ++c)
      {
        to.At(i, j)[c] = degree * (b[c] - a[c]);
      }
    }
  }
  return to;
}

void Elevate(PatchNet& net, int p, int q)
{
  while (net.P < p || net.Q < q)
  {
    const bool alongU = net.P < p;
    const PatchNet from = net;
    const int n = (alongU ? from.P : from.Q) + 1;
    net.Resize(from.P + (alongU ? 1 : 0), from.Q + (alongU ? 0 : 1));
    for (int j = 0; j <= net.Q; ++j)
    {
      for (int i = 0; i <= net.P; ++i)
      {
        const int k = alongU ? i : j;
        const double share = static_cast<double>(k) / n;
        for (int c = 0; c < 4; ++c)
        {
          const double before = k > 0 ? (alongU ? from.At(i - 1, j) : from.At(i, j - 1))[c] : 0.0;
          const double here = k < n ? from.At(i, j)[c] : 0.0;
          net.At(i, j)[c] = share * before + (1.0 - share) * here;
        }
      }
    }
  }
}

Homogeneous Evaluate(const PatchNet& net, double s, double r)
{
  Homogeneous column[MaximumDegree + 1] = {};
  for (int j = 0; j <= net.Q; ++j)
  {
    column[j] = BernsteinPiece<4>{ &net.At(0, j), net.P }.Evaluate(s);
  }
  return BernsteinPiece<4>{ column, net.Q }.Evaluate(r);
}

PatchNet Restrict(const PatchNet& net, double s0, double s1, double r0, double r1)
{
  PatchNet part = net;
  for (int j = 0; (s0 != 0.0 || s1 != 1.0) && j <= net.Q; ++j)
  {
    RestrictBernstein(&part.At(0, j), net.P, 1, s0, s1);
  }
  for (int i = 0; (r0 != 0.0 || r1 != 1.0) && i <= net.P; ++i)
  {
    RestrictBernstein(&part.At(i, 0), net.Q, net.P + 1, r0, r1);
  }
  return part;
}
}

#include "smBernsteinNet.h"

#include "smBernstein.h"

namespace sm
{
BernsteinNet Derive(const BernsteinNet& from, int direction)
{
  BernsteinNet to;
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

NetMiddle EvaluateMiddle(const BernsteinNet& net)
{
  Homogeneous column[MaximumDegree + 1];
  Homogeneous slopes[MaximumDegree + 1];
  // For compilers that do not see that there is a row.
  column[0] = slopes[0] = {};
  for (int j = 0; j <= net.Q; ++j)
  {
    column[j] = BernsteinPiece<4>{ &net.At(0, j), net.P }.Evaluate(0.5, &slopes[j]);
  }
  Homogeneous hv;
  const Homogeneous h = BernsteinPiece<4>{ column, net.Q }.Evaluate(0.5, &hv);
  const Homogeneous hu = BernsteinPiece<4>{ slopes, net.Q }.Evaluate(0.5);
  NetMiddle middle;
  middle.Position = Project(h);
  middle.First[0] = ProjectDerivative(hu, middle.Position, h[3]);
  middle.First[1] = ProjectDerivative(hv, middle.Position, h[3]);
  return middle;
}

void SplitInMiddle(BernsteinNet& net, int direction, BernsteinNet& rest)
{
  rest = net;
  const int degree = direction == 0 ? net.P : net.Q;
  const int lines = direction == 0 ? net.Q : net.P;
  const int stride = direction == 0 ? 1 : net.P + 1;
  for (int line = 0; line <= lines; ++line)
  {
    Homogeneous* const low = net.B.data() + line * (direction == 0 ? net.P + 1 : 1);
    Homogeneous* const high = rest.B.data() + (low - net.B.data());
    HalveBernstein(low, high, degree, stride);
  }
}

BernsteinNet Restrict(const BernsteinNet& net, double s0, double s1, double r0, double r1)
{
  BernsteinNet part = net;
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

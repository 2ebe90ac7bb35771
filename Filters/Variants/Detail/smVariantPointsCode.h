// Code of AddPoints for registers of SM_VARIANT_BYTES bytes. Nothing here but plain loops may be inlined from
// elsewhere: other files are compiled for other processors.
#include "Detail/smVariantPoints.h"

namespace
{
constexpr int PackSize = SM_VARIANT_BYTES / 8;
using Pack = double __attribute__((vector_size(SM_VARIANT_BYTES)));
// Two registers side by side, as smVariantKernelsCode.h has them.
constexpr int Packs = 2;
constexpr int Lanes = PackSize * Packs;

struct Vector
{
  Pack X, Y, Z;
};

Vector operator+(const Vector& a, const Vector& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
Vector operator-(const Vector& a, const Vector& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
Vector operator*(double f, const Vector& a)
{
  return { f * a.X, f * a.Y, f * a.Z };
}

/// Sum of basis times net, x, y and z of which are `count` numbers apart.
Vector Combine(const double* basis, const Pack* net, int count)
{
  Vector sum{ basis[0] * net[0], basis[0] * net[Packs * count], basis[0] * net[2 * Packs * count] };
  for (int i = 1; i < count; ++i)
  {
    sum.X += basis[i] * net[Packs * i];
    sum.Y += basis[i] * net[Packs * (count + i)];
    sum.Z += basis[i] * net[Packs * (2 * count + i)];
  }
  return sum;
}

/// Sums of 64 samples, which go to compensated ones.
struct MomentSums
{
  Pack Part[10];
  int Count = 0;
  double* Sums;
  double* Carries;
  int Offset;

  void Clear()
  {
    for (Pack& part : this->Part)
    {
      part = Pack{};
    }
    this->Count = 0;
  }
  void Add(double weight, const Vector& x, const Vector& first, const Vector& second)
  {
    const Pack normal[3] = { first.Y * second.Z - first.Z * second.Y, first.Z * second.X - first.X * second.Z,
      first.X * second.Y - first.Y * second.X };
    const Pack flux = weight * (x.X * normal[0] + x.Y * normal[1] + x.Z * normal[2]);
    const Pack byX = flux * x.X;
    const Pack byY = flux * x.Y;
    const Pack byZ = flux * x.Z;
    this->Part[0] += flux;
    this->Part[1] += byX;
    this->Part[2] += byY;
    this->Part[3] += byZ;
    this->Part[4] += byX * x.X;
    this->Part[5] += byY * x.Y;
    this->Part[6] += byZ * x.Z;
    this->Part[7] += byX * x.Y;
    this->Part[8] += byY * x.Z;
    this->Part[9] += byX * x.Z;
    if (++this->Count == 64)
    {
      this->Flush();
    }
  }
  void Flush()
  {
    for (int m = 0; m < 10; ++m)
    {
      const double divisor = m == 0 ? 3.0 : m < 4 ? 4.0 : 5.0;
      double* sum = this->Sums + m * Lanes + this->Offset;
      double* carry = this->Carries + m * Lanes + this->Offset;
      for (int lane = 0; lane < PackSize; ++lane)
      {
        // Knuth's sum with its error.
        const double value = this->Part[m][lane] / divisor;
        const double total = sum[lane] + value;
        const double added = total - sum[lane];
        carry[lane] += (sum[lane] - (total - added)) + (value - added);
        sum[lane] = total;
      }
    }
    this->Clear();
  }
};

Vector GetPoint(const Pack* net)
{
  return { net[0], net[Packs], net[2 * Packs] };
}

void AddPanel(const sm::PointsBlock& block, const double* record, const Pack* net, MomentSums& sums)
{
  const std::size_t size = block.RecordSize;
  const Vector center = GetPoint(net);
  const Pack* points = net + 3 * Packs;
  const Pack* stepsS = points + 3 * Packs * block.Points;
  const Pack* stepsR = stepsS + 3 * Packs * block.StepsS;
  for (std::size_t i = 0; i < block.Count; ++i, record += size)
  {
    const double* basis = record + 3;
    const Vector local = Combine(basis, points, block.Points);
    Vector first = Combine(basis + block.Points, stepsS, block.StepsS);
    Vector second = Combine(basis + block.Points + block.StepsS, stepsR, block.StepsR);
    if (record[1] != 0.0 || record[2] != 0.0)
    {
      first = first + record[1] * local;
      second = second + record[2] * local;
    }
    sums.Add(record[0], center + local, first, second);
  }
}

// Gauss-Legendre with three points.
constexpr double Node = 0.1127016653792583;
constexpr double RibbonNodes[3] = { Node, 0.5, 1.0 - Node };
constexpr double RibbonWeights[3] = { 5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0 };

void AddRibbon(
  const sm::PointsBlock& block, const double* record, const Pack* net, const Pack* edge, MomentSums& sums)
{
  const std::size_t size = block.RecordSize;
  const Vector center = GetPoint(net);
  const Pack* points = net + 3 * Packs;
  const Pack* stepsS = points + 3 * Packs * block.Points;
  const Pack* stepsR = stepsS + 3 * Packs * block.StepsS;
  for (std::size_t i = 0; i < block.Count; ++i, record += size)
  {
    const double* basis = record + 2;
    const double* ofEdge = basis + block.Points + block.StepsS + block.StepsR;
    const Vector a = Combine(basis, points, block.Points);
    const Vector da = Combine(basis + block.Points, stepsS, block.StepsS) +
      Combine(basis + block.Points + block.StepsS, stepsR, block.StepsR) + record[1] * a;
    const Vector c = Combine(ofEdge, edge, block.EdgePoints);
    const Vector dc = Combine(ofEdge + block.EdgePoints, edge, block.EdgePoints);
    for (int k = 0; k < 3; ++k)
    {
      const double l = RibbonNodes[k];
      sums.Add(record[0] * RibbonWeights[k], center + (1.0 - l) * a + l * c, c - a, (1.0 - l) * da + l * dc);
    }
  }
}

void AddCap(const double* record, const Pack* net, MomentSums& sums)
{
  const Vector apex = GetPoint(net);
  const Vector from = GetPoint(net + 3 * Packs);
  const Vector to = GetPoint(net + 6 * Packs);
  const Vector first = from - apex;
  const Vector second = to - apex;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double t = RibbonNodes[i];
      const double l = RibbonNodes[k];
      sums.Add(record[0] * RibbonWeights[i] * RibbonWeights[k] * l,
        (1.0 - l) * apex + l * ((1.0 - t) * from + t * to), first, second);
    }
  }
}

/// `nets` has room for the nets of all lanes, `variables` for the variables.
void AddInLanes(const sm::PointsView& face, const double* c, std::size_t directions, std::size_t count,
  double* sums, double* carries, double* scratch)
{
  const int* const ofFace = face.Directions;
  const int others = face.DirectionCount;
  double* const numbers = scratch;
  for (int a = 0; a <= others; ++a)
  {
    for (int lane = 0; lane < Lanes; ++lane)
    {
      numbers[a * Lanes + lane] = a == 0 ? 1.0
        : static_cast<std::size_t>(lane) < count
        ? c[static_cast<std::size_t>(lane) * directions + static_cast<std::size_t>(ofFace[a - 1])]
        : 0.0;
    }
  }
  const Pack* const variables = reinterpret_cast<const Pack*>(scratch);
  Pack* const nets = reinterpret_cast<Pack*>(scratch) + static_cast<std::size_t>(Packs) * (others + 1);
  for (std::size_t i = 0; i < face.NetSize; ++i)
  {
    const double* row = face.Nets + i * (others + 1);
    Pack x = row[0] * variables[0];
    Pack y = row[0] * variables[1];
    for (int a = 1; a <= others; ++a)
    {
      x += row[a] * variables[Packs * a];
      y += row[a] * variables[Packs * a + 1];
    }
    nets[Packs * i] = x;
    nets[Packs * i + 1] = y;
  }
  for (int half = 0; half < Packs; ++half)
  {
    MomentSums part;
    part.Sums = sums;
    part.Carries = carries;
    part.Offset = half * PackSize;
    part.Clear();
    for (const sm::PointsBlock* block = face.Blocks; block != face.Blocks + face.BlockCount; ++block)
    {
      const double* record = face.Records + block->Record;
      const Pack* net = nets + Packs * block->Net + half;
      switch (block->Kind)
      {
        case sm::PointsKind::Panel:
          AddPanel(*block, record, net, part);
          break;
        case sm::PointsKind::Ribbon:
          AddRibbon(*block, record, net, nets + Packs * block->EdgeNet + half, part);
          break;
        case sm::PointsKind::Cap:
          AddCap(record, net, part);
          break;
      }
    }
    part.Flush();
  }
}
}

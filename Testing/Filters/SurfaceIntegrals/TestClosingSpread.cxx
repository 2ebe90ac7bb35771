// TestClosingSpread FOLDER [MOVES]: no closing of the stated set changes volume, moments or area by more than
// the spread, and aligned ones change the volume by at least half of it. The closings are triangles between
// points that this test finds on faces and edges; what they enclose is a sum of tetrahedra, and no formula of
// Bounds.md enters.
#include "smClosingSpread.h"
#include "smGappedSolids.h"
#include "smTestManifest.h"
#include "smTestPipeline.h"

#include <vtkNURBSDataSet.h>
#include <vtkPartitionedDataSetCollection.h>

#include <algorithm>
#include <cmath>

namespace
{
using namespace smtest;
using sm::Cross;
using sm::Dot;
using sm::Norm;
using sm::Subtract;
using sm::Vector3;

/// Planes across an edge with one piece, points on the section of a surface, and pieces of the way between
/// two of them.
constexpr int Planes = 40;
constexpr int Grid = 33;
constexpr int Pieces = 3;
/// Closings of bilinear pieces between planes differ from the smooth ones that they stand for.
constexpr double Discretization = 2e-3;

Vector3 Mix(double a, const Vector3& x, double b, const Vector3& y)
{
  return { a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2] };
}

/// The section of one face in one plane.
struct Cut
{
  /// Coordinates along the tangent of the section, relative to the boundary's point, of the first and the
  /// last point.
  double Low = 0.0;
  double High = 0.0;
  Vector3 Boundary;
  std::array<Vector3, Grid> Points;

  Vector3 Get(double x) const
  {
    if (x == 0.0 || this->High == this->Low)
    {
      return this->Boundary;
    }
    const double at = (x - this->Low) / (this->High - this->Low) * (Grid - 1);
    const int i = std::min(std::max(static_cast<int>(at), 0), Grid - 2);
    return Mix(1.0 - (at - i), this->Points[i], at - i, this->Points[i + 1]);
  }
};

struct Use
{
  const sm::Face* Face;
  const sm::Coedge* Coedge;
  double Sign;
  std::vector<Cut> Cuts;
};

/// Solves two equations in u and v for a point of a surface: in the plane, and with the coordinate x along
/// `axis` from `from`. Starts at `at`, and leaves the solution there.
Vector3 Solve(const sm::NURBSSurface& surface, const Vector3& center, const Vector3& normal,
  const Vector3& from, const Vector3& axis, double x, std::array<double, 2>& at)
{
  Vector3 point{};
  for (int i = 0; i < 10; ++i)
  {
    Vector3 du;
    Vector3 dv;
    surface.Evaluate(at[0], at[1], point.data(), du.data(), dv.data());
    const double f = Dot(Subtract(point, center), normal);
    const double g = Dot(Subtract(point, from), axis) - x;
    const double a = Dot(du, normal);
    const double b = Dot(dv, normal);
    const double c = Dot(du, axis);
    const double d = Dot(dv, axis);
    const double determinant = a * d - b * c;
    at[0] -= (d * f - b * g) / determinant;
    at[1] -= (a * g - c * f) / determinant;
    if (std::abs(f) + std::abs(g) < 1e-11)
    {
      break;
    }
  }
  return point;
}

/// Where the boundary of a face meets a plane.
bool FindBoundary(const Use& use, const Vector3& center, const Vector3& normal, double near, double& t)
{
  const auto measure = [&](double s)
  {
    const std::array<double, 2> at = use.Coedge->Curve.Evaluate(s);
    Vector3 point;
    use.Face->Surface.Evaluate(at[0], at[1], point.data());
    return Dot(Subtract(point, center), normal);
  };
  const double width = use.Coedge->Curve.GetEnd() - use.Coedge->Curve.GetStart();
  double low = std::max(near - 0.02 * width, use.Coedge->Curve.GetStart());
  double high = std::min(near + 0.02 * width, use.Coedge->Curve.GetEnd());
  double below = measure(low);
  double above = measure(high);
  if (below > 0.0 || above < 0.0)
  {
    return false;
  }
  // Regula falsi; the value of an end that stays is halved.
  for (int i = 0; i < 60 && high - low > 1e-15 * width; ++i)
  {
    t = low - below * (high - low) / (above - below);
    const double value = measure(t);
    if (std::abs(value) < 1e-13)
    {
      break;
    }
    (value < 0.0 ? low : high) = t;
    (value < 0.0 ? below : above) = value;
    (value < 0.0 ? above : below) *= 0.5;
  }
  return true;
}

/// An edge with its planes and sections.
struct Gap
{
  std::vector<Use> Uses;
  std::vector<Vector3> Points;
  std::vector<Vector3> Tangents;
  /// Index of the last plane.
  int Last = 0;

  /// Returns false if some boundary cannot be followed.
  bool Prepare(const sm::Edge& edge, double tolerance)
  {
    const double start = edge.Curve.GetStart();
    const double width = edge.Curve.GetEnd() - start;
    int pieces = edge.Curve.GetNumberOfPieces();
    for (const Use& use : this->Uses)
    {
      pieces = std::max(pieces, use.Coedge->Curve.GetNumberOfPieces());
    }
    this->Last = Planes + 16 * pieces;
    for (int j = 0; j <= this->Last; ++j)
    {
      // Not quite to the ends, whose planes the boundaries may miss; all curves are fixed there.
      const double t = start + width * (1e-4 + (1.0 - 2e-4) * j / this->Last);
      Vector3 tangent;
      this->Points.push_back(edge.Curve.Evaluate(t, &tangent));
      this->Tangents.push_back(sm::Normalized(tangent));
      for (Use& use : this->Uses)
      {
        use.Cuts.emplace_back();
        double s = t;
        if (!FindBoundary(use, this->Points[j], this->Tangents[j], t, s) ||
          !this->CutSurface(use, j, s, tolerance))
        {
          return false;
        }
      }
    }
    return true;
  }

  bool CutSurface(Use& use, int j, double s, double tolerance)
  {
    Cut& cut = use.Cuts.back();
    const std::array<double, 2> at = use.Coedge->Curve.Evaluate(s);
    Vector3 du;
    Vector3 dv;
    use.Face->Surface.Evaluate(at[0], at[1], cut.Boundary.data(), du.data(), dv.data());
    const Vector3 normal = sm::Normalized(Cross(du, dv));
    const Vector3 across = Cross(normal, this->Tangents[j]);
    if (Norm(across) < 0.6)
    {
      return false;
    }
    const Vector3 axis = sm::Normalized(across);
    const Vector3 gap = Subtract(cut.Boundary, this->Points[j]);
    const double range = std::max(Norm(gap), tolerance);
    cut.Low = -Dot(gap, axis) - range;
    cut.High = -Dot(gap, axis) + range;
    std::array<double, 2> near = at;
    for (int k = 0; k < Grid; ++k)
    {
      const double x = cut.Low + (cut.High - cut.Low) * k / (Grid - 1);
      cut.Points[k] =
        Solve(use.Face->Surface, this->Points[j], this->Tangents[j], cut.Boundary, axis, x, near);
    }
    return true;
  }
};

/// What a closing changes: volume, first and second moments about a point, and the area of the faces.
struct Change
{
  double Volume = 0.0;
  Vector3 First{};
  std::array<double, 6> Second{};
  double Area = 0.0;

  /// Adds the tetrahedron of a triangle and the point.
  void Add(double sign, const Vector3& center, const Vector3& p, const Vector3& q, const Vector3& r)
  {
    const Vector3 v[3] = { Subtract(p, center), Subtract(q, center), Subtract(r, center) };
    const double volume = sign * Dot(v[0], Cross(v[1], v[2])) / 6.0;
    const Vector3 sum = { v[0][0] + v[1][0] + v[2][0], v[0][1] + v[1][1] + v[2][1],
      v[0][2] + v[1][2] + v[2][2] };
    this->Volume += volume;
    const int pairs[6][2] = { { 0, 0 }, { 1, 1 }, { 2, 2 }, { 0, 1 }, { 1, 2 }, { 0, 2 } };
    for (int d = 0; d < 3; ++d)
    {
      this->First[d] += volume * sum[d] / 4.0;
    }
    for (int k = 0; k < 6; ++k)
    {
      const int a = pairs[k][0];
      const int b = pairs[k][1];
      const double squares = v[0][a] * v[0][b] + v[1][a] * v[1][b] + v[2][a] * v[2][b];
      this->Second[k] += volume * (squares + sum[a] * sum[b]) / 20.0;
    }
  }
  /// The bilinear surface between four points: its volume is the mean of those of both diagonals.
  void AddQuad(double sign, const Vector3& center, const Vector3& a, const Vector3& b, const Vector3& c,
    const Vector3& d)
  {
    this->Add(0.5 * sign, center, a, b, c);
    this->Add(0.5 * sign, center, a, c, d);
    this->Add(0.5 * sign, center, a, b, d);
    this->Add(0.5 * sign, center, b, c, d);
  }
};

/// A closing: in every plane the common curve's point, and x of every boundary.
struct Closing
{
  std::vector<Vector3> Points;
  std::vector<std::vector<double>> X;
};

/// Returns the way from a boundary along its surface to the boundary of the closing, and on to its common
/// curve.
std::array<Vector3, Pieces + 2> GetWay(const Use& use, int j, double x, const Vector3& point)
{
  std::array<Vector3, Pieces + 2> way;
  for (int k = 0; k <= Pieces; ++k)
  {
    way[k] = use.Cuts[j].Get(x * k / Pieces);
  }
  way[Pieces + 1] = point;
  return way;
}

Change Measure(const Gap& gap, const Closing& closing, const Vector3& center)
{
  Change change;
  for (std::size_t i = 0; i < gap.Uses.size(); ++i)
  {
    const Use& use = gap.Uses[i];
    auto last = GetWay(use, 0, closing.X[i][0], closing.Points[0]);
    for (int j = 1; j <= gap.Last; ++j)
    {
      const auto way = GetWay(use, j, closing.X[i][j], closing.Points[j]);
      for (int k = 0; k <= Pieces; ++k)
      {
        change.AddQuad(use.Sign, center, last[k], last[k + 1], way[k + 1], way[k]);
        if (k < Pieces)
        {
          const Vector3 one = Cross(Subtract(last[k + 1], last[k]), Subtract(way[k + 1], last[k]));
          const Vector3 two = Cross(Subtract(way[k + 1], last[k]), Subtract(way[k], last[k]));
          change.Area += 0.5 * (Norm(one) + Norm(two));
        }
      }
      // The closing of the model, less.
      change.AddQuad(-use.Sign, center, last[0], gap.Points[j - 1], gap.Points[j], way[0]);
      last = way;
    }
  }
  return change;
}

/// Twice the signed area in plane j between the model's closing and one whose common curve passes `point`.
double MeasureSection(const Gap& gap, int j, const Vector3& point, const std::vector<double>& x)
{
  double area = 0.0;
  for (std::size_t i = 0; i < gap.Uses.size(); ++i)
  {
    const auto way = GetWay(gap.Uses[i], j, x[i], point);
    for (int k = 0; k <= Pieces; ++k)
    {
      area += gap.Uses[i].Sign *
        Dot(gap.Tangents[j], Cross(Subtract(way[k], gap.Points[j]), Subtract(way[k + 1], gap.Points[j])));
    }
  }
  return area;
}

Closing MakeIdentity(const Gap& gap)
{
  return { gap.Points,
    std::vector<std::vector<double>>(gap.Uses.size(), std::vector<double>(gap.Last + 1, 0.0)) };
}

/// The closing that adds the largest volume, plane by plane, or removes it.
Closing FindWorst(const Gap& gap, double sign)
{
  Closing closing = MakeIdentity(gap);
  const std::size_t uses = gap.Uses.size();
  for (int j = 1; j < gap.Last; ++j)
  {
    double largest = 0.0;
    for (std::size_t corner = 0; corner <= uses; ++corner)
    {
      const Vector3 point = corner == 0 ? gap.Points[j] : gap.Uses[corner - 1].Cuts[j].Boundary;
      for (std::size_t choice = 0; choice < std::size_t(1) << uses; ++choice)
      {
        std::vector<double> x;
        for (std::size_t i = 0; i < uses; ++i)
        {
          const Cut& cut = gap.Uses[i].Cuts[j];
          x.push_back((choice >> i) & 1 ? cut.High : cut.Low);
        }
        const double area = sign * MeasureSection(gap, j, point, x);
        if (area > largest)
        {
          largest = area;
          closing.Points[j] = point;
          for (std::size_t i = 0; i < uses; ++i)
          {
            closing.X[i][j] = x[i];
          }
        }
      }
    }
  }
  return closing;
}

/// A function of the plane in [0,1]: smooth, a step, or constant, which often reaches 0 and 1.
std::vector<double> DrawFunction(int last, std::mt19937& random)
{
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  const double size = 2.0 * std::abs(draw(random));
  const double mean = draw(random);
  const double frequency = 4.0 * draw(random);
  const double phase = 3.0 * draw(random);
  const bool isStep = draw(random) > 0.5;
  std::vector<double> values;
  for (int j = 0; j <= last; ++j)
  {
    const double wave = mean + size * std::sin(3.14159265358979 * frequency * j / last + phase);
    values.push_back(std::min(std::max(isStep ? (wave > 0.0 ? 1.0 : 0.0) : 0.5 + 0.5 * wave, 0.0), 1.0));
  }
  return values;
}

Closing DrawClosing(const Gap& gap, std::mt19937& random)
{
  Closing closing = MakeIdentity(gap);
  std::vector<std::vector<double>> weights;
  for (std::size_t i = 0; i <= gap.Uses.size(); ++i)
  {
    weights.push_back(DrawFunction(gap.Last, random));
  }
  for (std::size_t i = 0; i < gap.Uses.size(); ++i)
  {
    const std::vector<double> where = DrawFunction(gap.Last, random);
    for (int j = 1; j < gap.Last; ++j)
    {
      const Cut& cut = gap.Uses[i].Cuts[j];
      closing.X[i][j] = cut.Low + where[j] * (cut.High - cut.Low);
    }
  }
  for (int j = 1; j < gap.Last; ++j)
  {
    double sum = weights.back()[j] + 1e-9;
    Vector3 point = Mix(sum, gap.Points[j], 0.0, gap.Points[j]);
    for (std::size_t i = 0; i < gap.Uses.size(); ++i)
    {
      point = Mix(1.0, point, weights[i][j], gap.Uses[i].Cuts[j].Boundary);
      sum += weights[i][j];
    }
    closing.Points[j] = Mix(1.0 / sum, point, 0.0, point);
  }
  return closing;
}

/// Largest part of the spreads that moves reached.
struct Reached
{
  double Volume = 0.0;
  double First = 0.0;
  double Second = 0.0;
  double Area = 0.0;

  void Add(const Change& change, const sm::SpreadSums& sums)
  {
    this->Volume = std::max(this->Volume, std::abs(change.Volume) / sums.Volume);
    this->Area = std::max(this->Area, change.Area / sums.Area);
    for (int d = 0; d < 3; ++d)
    {
      this->First = std::max(this->First, std::abs(change.First[d]) / sums.First[d]);
    }
    for (int k = 0; k < 6; ++k)
    {
      this->Second = std::max(this->Second, std::abs(change.Second[k]) / sums.Second[k]);
    }
  }
};

std::vector<Use> CollectUses(const vtkTrimmedNURBSModel& model, const sm::Edge* edge)
{
  std::vector<Use> uses;
  for (const sm::FacePointer& face : model.GetFaces())
  {
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        if (coedge.Use.get() == edge)
        {
          uses.push_back({ face.get(), &coedge, face->Reversed == coedge.Reversed ? 1.0 : -1.0, {} });
        }
      }
    }
  }
  return uses;
}

/// Returns the number of moves that were tried.
int CheckSolid(const std::string& name, vtkTrimmedNURBSModel* source, double tolerance, int moves)
{
  std::mt19937 random(static_cast<unsigned int>(std::hash<std::string>()(name)));
  const double* box = source->GetLocalBounds();
  const double size = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
  const double gap = 2e-5 * size;
  const auto model = OpenGaps(source, gap, tolerance * gap, random);
  sm::ClosingSpreads spreads;
  const auto spread = spreads.Measure(*model);
  const Vector3 center = { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]) };
  Reached reached;
  double worst[2] = { 0.0, 0.0 };
  double volume = 0.0;
  double left = 0.0;
  int tried = 0;
  int edges = 0;
  for (const sm::ClosingSpreadEntry& entry : *spread)
  {
    if (!entry.Source)
    {
      continue;
    }
    const sm::SpreadSums sums = sm::SumSpread({ entry }, {}, center);
    Gap edge;
    edge.Uses = CollectUses(*model, entry.Source);
    if (!edge.Prepare(*entry.Source, tolerance * gap))
    {
      left += sums.Volume;
      continue;
    }
    ++edges;
    for (int sign = 0; sign < 2; ++sign)
    {
      const Change change = Measure(edge, FindWorst(edge, sign == 0 ? 1.0 : -1.0), center);
      worst[sign] += std::abs(change.Volume);
      reached.Add(change, sums);
      ++tried;
    }
    for (int move = 0; move < moves; ++move)
    {
      reached.Add(Measure(edge, DrawClosing(edge, random), center), sums);
      ++tried;
    }
  }
  volume = sm::SumSpread(*spread, {}, center).Volume - left;
  const std::string what = name + ", tolerance " + std::to_string(tolerance).substr(0, 3) + " gaps, ";
  std::printf("--- %s%d edges, %d moves, spread %.3g of %.3g\n", what.c_str(), edges, tried, volume,
    source->GetVolumeScale());
  const double limit = 1.0 + Discretization;
  CheckTrue(what + "edges", edges > 0 && left < 0.5 * volume, std::to_string(left));
  CheckRange(what + "volume", 0.3, reached.Volume, limit, "of the spread of an edge");
  CheckRange(what + "first moments", 0.1, reached.First, limit);
  CheckRange(what + "second moments", 0.05, reached.Second, limit);
  CheckRange(what + "area", 0.3, reached.Area, limit);
  CheckRange(what + "aligned moves", 0.5, std::max(worst[0], worst[1]) / volume, limit);
  return tried;
}
}

int TestClosingSpread(int argc, char* argv[])
{
  RequireUsage(argc >= 2, "TestClosingSpread FOLDER [MOVES]");
  const int moves = argc > 2 ? std::atoi(argv[2]) : 260;
  const Manifest manifest(argv[1]);
  int tried = 0;
  int solids = 0;
  for (const Expected& expected : manifest.GetVariant("plain"))
  {
    // Its profile is one edge of hundreds of pieces.
    if (expected.Solid == "gear")
    {
      continue;
    }
    vtkNew<vtkSTEPReader> reader;
    UseCoarseMesh(reader);
    reader->SetFileName(expected.Path.c_str());
    reader->Update();
    auto* output = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
    auto* leaf = vtkNURBSDataSet::SafeDownCast(output->GetPartition(0, 0));
    ++solids;
    for (const double tolerance : { 0.0, 3.0 })
    {
      tried += CheckSolid(expected.Solid, leaf->GetModel(), tolerance, moves);
    }
  }
  CheckRange("solids", 20, solids, 100);
  CheckRange("moves", moves >= 260 ? 1e5 : 1, tried, 1e9);
  return Finish();
}

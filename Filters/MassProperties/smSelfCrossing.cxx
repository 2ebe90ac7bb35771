#include "Detail/smSelfCrossing.h"

#include "smBodyScales.h"
#include "smMassIntegrands.h"
#include "smMeshTriangles.h"
#include "smParallelFor.h"
#include "smVector.h"
#include "smWholeSphere.h"
#include "smWindingTree.h"

#include "vtkBoundingBox.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace sm
{
namespace
{
/// Smallest number of points of a body besides those of its faces, and number of triangles for each point of
/// a large mesh.
constexpr std::size_t MinSamples = 400;
constexpr std::size_t TrianglesPerSample = 8;

/// Distance from an integer above which a winding number indicates a hole in the mesh, or a point on another
/// part of it.
constexpr double WholeNumber = 0.25;

/// Fraction of undecided points above which the check is given up.
constexpr double MaxUndecided = 0.25;

/// Largest difference of area and vector area between mesh and face, relative to the area, and area of a
/// face, relative to the body's, below which its mesh does not matter.
constexpr double MaxMismatch = 0.25;
constexpr double NegligibleArea = 1e-5;

/// Distance, relative to the diagonal, that counts as rounding.
constexpr double SmallShare = 1e-9;

/// Distance from the boundary, relative to the diagonal, up to which a second point is sought, and number of
/// samples for which it is.
constexpr double MaxStep = 0.1;
constexpr std::size_t MaxConfirmations = 256;
/// Number of samples between two calls of `shouldContinue`.
constexpr std::size_t SamplesPerReport = 4096;

Vector3 Transform(const std::array<double, 16>& m, const Vector3& p)
{
  Vector3 q;
  for (int r = 0; r < 3; ++r)
  {
    q[r] = m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
  }
  return q;
}

/// Returns the point at a distance from another one.
Vector3 Move(const Vector3& p, double distance, const Vector3& direction)
{
  return { p[0] + distance * direction[0], p[1] + distance * direction[1], p[2] + distance * direction[2] };
}

Vector3 GetNormal(const std::array<Vector3, 3>& c)
{
  return Normalized(Cross(Subtract(c[1], c[0]), Subtract(c[2], c[0])));
}

bool IsWrong(double winding)
{
  const double whole = std::round(winding);
  return std::abs(winding - whole) <= WholeNumber && (whole < 0.0 || whole > 1.0);
}

/// Area, vector area and volume of one face, the latter as a length times an area.
struct FaceExtent
{
  std::size_t Part = 0;
  std::size_t Index = 0;
  double Area = 0.0;
  std::array<double, 4> Oriented{};
  std::size_t MaxTriangle = WindingTree::None;
  double MaxArea = 0.0;
};

/// A whole sphere (smWholeSphere.h) in coordinates of the part.
struct Ball
{
  std::size_t Face = 0;
  Vector3 Center{};
  double Radius = 0.0;
  double Error = 0.0;
  /// 1 if its normals leave it, -1 if it is a void: its winding number about the points in it.
  double Side = 1.0;

  bool Contains(const Vector3& p) const { return GetDistance(p, this->Center) < this->Radius; }
  bool IsFarFrom(const Vector3& p, double slack) const
  {
    return std::abs(GetDistance(p, this->Center) - this->Radius) > slack + this->Error;
  }
};

/// A point on the boundary: on a triangle, or on a sphere, of which the other index is WindingTree::None.
struct Sample
{
  std::size_t Triangle;
  std::size_t Ball;
  Vector3 Position;
  /// Leaves the body.
  Vector3 Normal;
  /// Largest distance of the point from the surface.
  double Deviation;
};

class Checker
{
public:
  explicit Checker(const std::vector<const BodyIntegrals*>& parts)
    : Parts(parts)
  {
    vtkBoundingBox box;
    for (const BodyIntegrals* part : parts)
    {
      AddPlacedBox(*part, box);
      // The uncertainty that a file states is not a part of it: gaps are measured, and a large one would
      // excuse whole parts of a body.
      this->Slack = std::max(this->Slack, std::isfinite(part->MaxGap) ? part->MaxGap : 0.0);
    }
    this->Diagonal = box.IsValid() ? box.GetDiagonalLength() : 0.0;
    this->Slack += SmallShare * this->Diagonal;
  }
  SelfCrossing Run(const std::function<bool()>& shouldContinue);

private:
  void CollectBalls(std::size_t part);
  void CollectTriangles(std::size_t part);
  std::string OrientBalls();
  std::string OrientTriangles();
  void TakeSamples();
  void TakeBallSamples(const WindingTree& tree);
  bool FindCrossingBalls(const WindingTree& tree);
  double SumBalls(const Vector3& p, std::size_t without) const;
  double GetWinding(const WindingTree& tree, const Sample& sample) const;
  bool IsSound(const WindingTree& tree, const Sample& sample) const;
  bool ConfirmAt(const WindingTree& tree, const Vector3& p, std::size_t face);
  bool Confirm(const WindingTree& tree, const Sample& sample, bool inside);

  const std::vector<const BodyIntegrals*>& Parts;
  double Diagonal = 0.0;
  /// Largest distance between mesh and surface besides the deviation of a triangle.
  double Slack = 0.0;
  std::vector<MeshTriangle> Triangles;
  /// The faces of all parts one after another, and the face of each triangle.
  std::vector<FaceExtent> Extents;
  std::vector<std::size_t> FaceOfTriangle;
  /// Of each triangle, if it is against a normal at its corners.
  std::vector<bool> IsFolded;
  /// Whole spheres, which have no triangles here; of each face, if it is one.
  std::vector<Ball> Balls;
  std::vector<bool> IsBall;
  /// Every side of a triangle is that of another one, so that winding numbers can be counted.
  bool AreTrianglesClosed = false;
  /// Pairs of spheres that cross.
  std::vector<std::pair<std::size_t, std::size_t>> CrossingBalls;
  std::vector<Sample> Samples;
  SelfCrossing Result;
};

/// Collects the whole spheres of a part. Its faces are the next ones of Extents.
void Checker::CollectBalls(std::size_t part)
{
  const vtkTrimmedNURBSModel& model = *this->Parts[part]->Model;
  const std::vector<WholeSphere> spheres = FindWholeSpheres(model.GetFaces());
  this->IsBall.resize(this->Extents.size() + model.GetFaces().size(), false);
  for (std::size_t f = 0; f < spheres.size(); ++f)
  {
    if (!spheres[f])
    {
      continue;
    }
    Ball ball;
    ball.Face = this->Extents.size() + f;
    for (int d = 0; d < 3; ++d)
    {
      ball.Center[d] = spheres[f].Center[d] + this->Parts[part]->Model->GetOrigin()[d];
    }
    ball.Radius = spheres[f].Radius;
    ball.Error = spheres[f].Error;
    this->Balls.push_back(ball);
    this->IsBall[ball.Face] = true;
  }
}

void Checker::CollectTriangles(std::size_t part)
{
  const BodyIntegrals& body = *this->Parts[part];
  const std::size_t triangles = this->Triangles.size() + CountTriangles(body.Mesh);
  this->Triangles.reserve(triangles);
  this->FaceOfTriangle.reserve(triangles);
  this->IsFolded.reserve(triangles);
  std::array<double, 16> inverse;
  vtkMatrix4x4::Invert(body.Placement.data(), inverse.data());
  std::array<double, 16> rotation = inverse;
  rotation[3] = rotation[7] = rotation[11] = 0.0;
  const Vector3 origin = { body.Model->GetOrigin()[0], body.Model->GetOrigin()[1],
    body.Model->GetOrigin()[2] };
  const std::size_t first = this->Extents.size();
  for (std::size_t f = 0; f < body.Faces->size(); ++f)
  {
    this->Extents.push_back({ part, f });
  }
  VisitTriangles(body.Mesh, body.Faces->size(),
    [&](std::size_t face, std::array<Vector3, 3> corners, std::array<Vector3, 3> normals)
    {
      if (this->IsBall[first + face])
      {
        return;
      }
      for (int i = 0; i < 3; ++i)
      {
        corners[i] = Transform(inverse, corners[i]);
        normals[i] = Transform(rotation, normals[i]);
      }
      const Vector3 twice = Cross(Subtract(corners[1], corners[0]), Subtract(corners[2], corners[0]));
      const double area = 0.5 * Norm(twice);
      FaceExtent& extent = this->Extents[first + face];
      if (area > extent.MaxArea)
      {
        extent.MaxArea = area;
        extent.MaxTriangle = this->Triangles.size();
      }
      extent.Area += area;
      for (int d = 0; d < 3; ++d)
      {
        extent.Oriented[d] += 0.5 * twice[d];
      }
      extent.Oriented[3] += Dot(Subtract(corners[0], origin), twice) / (6.0 * this->Diagonal);
      this->Triangles.push_back({ corners, EstimateDeviation(corners, normals) });
      this->FaceOfTriangle.push_back(first + face);
      this->IsFolded.push_back(!(area > 0.0) ||
        std::any_of(normals.begin(), normals.end(),
          [&twice](const Vector3& normal) { return Dot(twice, normal) < 0.0; }));
    });
}

/// Orients the spheres as their exact integrals are. Returns the reason if a face does not cover its sphere
/// once.
std::string Checker::OrientBalls()
{
  for (Ball& ball : this->Balls)
  {
    const FaceExtent& extent = this->Extents[ball.Face];
    const BodyIntegrals& body = *this->Parts[extent.Part];
    const FaceIntegrals& face = (*body.Faces)[extent.Index];
    const std::vector<double>& exact = face.Face;
    WholeSphere sphere;
    sphere.Radius = ball.Radius;
    const double bound = face.GetBound(MassArea);
    if (!Covers(sphere, exact[MassArea], std::isnan(bound) ? 0.0 : bound, exact[MassVolume]))
    {
      return "face #" + std::to_string(body.Model->GetFaces()[extent.Index]->FileId) +
        " does not cover its sphere once";
    }
    const double side = body.GetSide(extent.Index) * (body.InsideOut ? -1.0 : 1.0);
    ball.Side = side * exact[MassVolume] > 0.0 ? 1.0 : -1.0;
  }
  return {};
}

/// Orients the triangles of every face as its exact integrals are. Returns the reason if that is impossible.
std::string Checker::OrientTriangles()
{
  std::vector<bool> reversed(this->Extents.size());
  for (std::size_t f = 0; f < this->Extents.size(); ++f)
  {
    if (this->IsBall[f])
    {
      continue;
    }
    const FaceExtent& mesh = this->Extents[f];
    const BodyIntegrals& body = *this->Parts[mesh.Part];
    const std::vector<double>& exact = (*body.Faces)[mesh.Index].Face;
    const double side = body.GetSide(mesh.Index) * (body.InsideOut ? -1.0 : 1.0);
    std::array<double, 4> oriented;
    for (int d = 0; d < 3; ++d)
    {
      oriented[d] = side * exact[MassVectorArea + d];
    }
    oriented[3] = side * exact[MassVolume] / this->Diagonal;
    double product = 0.0;
    for (int d = 0; d < 4; ++d)
    {
      product += oriented[d] * mesh.Oriented[d];
    }
    reversed[f] = product < 0.0;
    double difference = std::abs(mesh.Area - exact[MassArea]);
    for (int d = 0; d < 3; ++d)
    {
      difference =
        std::max(difference, std::abs(oriented[d] - (reversed[f] ? -1.0 : 1.0) * mesh.Oriented[d]));
    }
    if (exact[MassArea] > NegligibleArea * body.Value[MassArea] && difference > MaxMismatch * exact[MassArea])
    {
      return "the display mesh of face #" + std::to_string(body.Model->GetFaces()[mesh.Index]->FileId) +
        (mesh.Area > 0.0 ? " does not cover it once" : " is missing");
    }
  }
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (reversed[this->FaceOfTriangle[t]])
    {
      std::swap(this->Triangles[t].Corners[1], this->Triangles[t].Corners[2]);
    }
  }
  return {};
}

void Checker::TakeSamples()
{
  double area = 0.0;
  for (const FaceExtent& extent : this->Extents)
  {
    area += extent.Area;
  }
  const auto place = [this](std::size_t t, double x, double y)
  {
    const std::array<Vector3, 3>& c = this->Triangles[t].Corners;
    Vector3 p;
    for (int d = 0; d < 3; ++d)
    {
      p[d] = c[0][d] + x * (c[1][d] - c[0][d]) + y * (c[2][d] - c[0][d]);
    }
    this->Samples.push_back({ t, WindingTree::None, p, {}, this->Triangles[t].Deviation });
  };
  for (const FaceExtent& extent : this->Extents)
  {
    if (extent.MaxTriangle != WindingTree::None)
    {
      place(extent.MaxTriangle, 1.0 / 3.0, 1.0 / 3.0);
    }
  }
  const double spacing =
    area / static_cast<double>(std::max(MinSamples, this->Triangles.size() / TrianglesPerSample));
  double covered = 0.5 * spacing;
  double x = 0.5;
  double y = 0.5;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const std::array<Vector3, 3>& c = this->Triangles[t].Corners;
    covered += 0.5 * Norm(Cross(Subtract(c[1], c[0]), Subtract(c[2], c[0])));
    for (; covered > spacing; covered -= spacing)
    {
      // Additive recurrence by the inverse powers of the plastic number, which fills the square evenly.
      x = std::fmod(x + 0.7548776662466927, 1.0);
      y = std::fmod(y + 0.5698402909980532, 1.0);
      place(t, x + y < 1.0 ? x : 1.0 - x, x + y < 1.0 ? y : 1.0 - y);
    }
  }
}

/// Takes points on every sphere: a few if it meets neither a triangle nor another sphere, so that the winding
/// number next to it is the same everywhere, else as many as on a small mesh.
void Checker::TakeBallSamples(const WindingTree& tree)
{
  constexpr std::size_t few = 8;
  std::vector<bool> isFree(this->Balls.size());
  for (std::size_t b = 0; b < this->Balls.size(); ++b)
  {
    const Ball& ball = this->Balls[b];
    isFree[b] = tree.IsFarFrom(ball.Center, ball.Radius + ball.Error + this->Slack);
  }
  for (const auto& [a, b] : this->CrossingBalls)
  {
    isFree[a] = isFree[b] = false;
  }
  for (std::size_t b = 0; b < this->Balls.size(); ++b)
  {
    const Ball& ball = this->Balls[b];
    const std::size_t count = isFree[b] ? few : MinSamples;
    for (std::size_t k = 0; k < count; ++k)
    {
      // A spiral of equal areas, by the golden angle.
      const double z = (2.0 * static_cast<double>(k) + 1.0) / static_cast<double>(count) - 1.0;
      const double angle = 2.399963229728653 * static_cast<double>(k);
      const double ring = std::sqrt(1.0 - z * z);
      const Vector3 normal{ ring * std::cos(angle), ring * std::sin(angle), z };
      this->Samples.push_back({ WindingTree::None, b, Move(ball.Center, ball.Radius, normal),
        Move({}, ball.Side, normal), ball.Error });
    }
  }
}

/// Returns the winding number of the spheres about a point off them.
double Checker::SumBalls(const Vector3& p, std::size_t without) const
{
  double sum = 0.0;
  for (std::size_t b = 0; b < this->Balls.size(); ++b)
  {
    sum += b != without && this->Balls[b].Contains(p) ? this->Balls[b].Side : 0.0;
  }
  return sum;
}

/// Returns the winding number about a sample of the boundary without its triangle or sphere.
double Checker::GetWinding(const WindingTree& tree, const Sample& sample) const
{
  // A sphere is replaced by half of its own: the mean of both sides.
  return tree.EvaluateWindingNumber(sample.Position, sample.Triangle) +
    this->SumBalls(sample.Position, sample.Ball) +
    (sample.Ball != WindingTree::None ? 0.5 * this->Balls[sample.Ball].Side : 0.0);
}

/// Returns true if the winding number just outside of a sample's triangle is certainly 0: in a closed mesh it
/// is counted along a ray. That of the mean, GetWinding(), takes some twenty times as long; it decides about
/// all other samples.
bool Checker::IsSound(const WindingTree& tree, const Sample& sample) const
{
  if (!this->AreTrianglesClosed || sample.Ball != WindingTree::None || this->IsFolded[sample.Triangle])
  {
    return false;
  }
  // A surface that is nearer is within the slack, and nothing is found there.
  const double step = SmallShare * this->Diagonal;
  const std::array<Vector3, 3>& c = this->Triangles[sample.Triangle].Corners;
  const Vector3 normal = GetNormal(c);
  const Vector3 p = Move(sample.Position, step, normal);
  int number = 0;
  return Dot(Subtract(p, c[0]), normal) > 0.5 * step && tree.CountCrossings(p, number) &&
    number + this->SumBalls(p, WindingTree::None) == 0.0;
}

/// Finds CrossingBalls, and takes a point that has a wrong winding number. There is one next to the circle
/// where two spheres cross: the four parts of space around it have winding numbers w, w + a, w + b and w + a
/// + b with a and b 1 or -1, of which one is neither 0 nor 1.
bool Checker::FindCrossingBalls(const WindingTree& tree)
{
  std::vector<std::size_t> order(this->Balls.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  const auto getStart = [this](std::size_t b) { return this->Balls[b].Center[0] - this->Balls[b].Radius; };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return std::make_pair(getStart(a), a) < std::make_pair(getStart(b), b); });
  bool isFound = false;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Ball& a = this->Balls[order[i]];
    for (std::size_t j = i + 1; j < order.size() && getStart(order[j]) < a.Center[0] + a.Radius; ++j)
    {
      const Ball& b = this->Balls[order[j]];
      const double distance = GetDistance(a.Center, b.Center);
      const double slack = this->Slack + a.Error + b.Error;
      if (distance >= a.Radius + b.Radius - slack || distance <= std::abs(a.Radius - b.Radius) + slack)
      {
        continue;
      }
      this->CrossingBalls.emplace_back(order[i], order[j]);
      // Along the line through both centres: in the first alone, in both, in the second alone.
      const double ends[4] = { -a.Radius, distance - b.Radius, a.Radius, distance + b.Radius };
      for (int part = 0; part < 3 && !isFound; ++part)
      {
        const double x = 0.5 * (ends[part] + ends[part + 1]) / distance;
        isFound = this->ConfirmAt(tree, Move(a.Center, x, Subtract(b.Center, a.Center)), a.Face);
      }
    }
  }
  return isFound;
}

/// Takes the point if it is far enough from the boundary, and the winding number of the exact boundary about
/// it is neither 0 nor 1.
bool Checker::ConfirmAt(const WindingTree& tree, const Vector3& p, std::size_t face)
{
  const double balls = this->SumBalls(p, WindingTree::None);
  if (!IsWrong(tree.EvaluateWindingNumber(p) + balls) || !tree.IsFarFrom(p, this->Slack) ||
    !std::all_of(this->Balls.begin(), this->Balls.end(),
      [&](const Ball& ball) { return ball.IsFarFrom(p, this->Slack); }))
  {
    return false;
  }
  const double winding = tree.EvaluateExactWindingNumber(p) + balls;
  if (!IsWrong(winding))
  {
    return false;
  }
  this->Result.Winding = static_cast<int>(std::round(winding));
  const FaceExtent& extent = this->Extents[face];
  this->Result.Face = this->Parts[extent.Part]->Model->GetFaces()[extent.Index]->FileId;
  this->Result.Point = p;
  return true;
}

/// Seeks a point next to the sample where the winding number of the exact boundary is neither 0 nor 1.
bool Checker::Confirm(const WindingTree& tree, const Sample& sample, bool inside)
{
  Vector3 normal = sample.Normal;
  std::size_t face;
  if (sample.Ball == WindingTree::None)
  {
    normal = GetNormal(this->Triangles[sample.Triangle].Corners);
    face = this->FaceOfTriangle[sample.Triangle];
  }
  else
  {
    face = this->Balls[sample.Ball].Face;
  }
  for (double step = 1.5 * (sample.Deviation + this->Slack); step < MaxStep * this->Diagonal; step *= 1.5)
  {
    if (this->ConfirmAt(tree, Move(sample.Position, inside ? -step : step, normal), face))
    {
      return true;
    }
  }
  return false;
}

SelfCrossing Checker::Run(const std::function<bool()>& shouldContinue)
{
  for (std::size_t part = 0; part < this->Parts.size(); ++part)
  {
    this->CollectBalls(part);
    this->CollectTriangles(part);
  }
  this->Result.Unchecked =
    this->Triangles.empty() && this->Balls.empty() ? "it has no display mesh" : this->OrientBalls();
  this->Result.Unchecked = this->Result.Unchecked.empty() ? this->OrientTriangles() : this->Result.Unchecked;
  if (!this->Result.Unchecked.empty())
  {
    return this->Result;
  }
  if (!this->Triangles.empty())
  {
    this->TakeSamples();
  }
  const WindingTree tree(this->Triangles);
  this->AreTrianglesClosed = IsClosed(this->Triangles);
  if (this->FindCrossingBalls(tree))
  {
    return this->Result;
  }
  this->TakeBallSamples(tree);
  this->Result.Samples = this->Samples.size();
  // On a surface the winding number of its other parts is the mean of those on both sides: 1/2 next to a
  // sound boundary.
  std::vector<double> winding(this->Samples.size());
  for (std::size_t first = 0; first < winding.size(); first += SamplesPerReport)
  {
    if (first > 0 && shouldContinue && !shouldContinue())
    {
      this->Result.Unchecked = SelfCrossing::Stopped;
      return this->Result;
    }
    ParallelFor(std::min(SamplesPerReport, winding.size() - first), 64,
      [&](std::size_t begin, std::size_t end)
      {
        for (std::size_t i = first + begin; i < first + end; ++i)
        {
          const Sample& sample = this->Samples[i];
          winding[i] = this->IsSound(tree, sample) ? 0.5 : this->GetWinding(tree, sample);
        }
      });
  }
  std::vector<std::size_t> wrong;
  for (std::size_t i = 0; i < winding.size(); ++i)
  {
    const double outside = std::round(winding[i] - 0.5);
    const bool isDecided = std::abs(winding[i] - 0.5 - outside) <= WholeNumber;
    this->Result.Undecided += isDecided ? 0 : 1;
    if (isDecided && outside != 0.0)
    {
      wrong.push_back(i);
    }
  }
  if (wrong.empty() &&
    MaxUndecided * static_cast<double>(winding.size()) < static_cast<double>(this->Result.Undecided))
  {
    this->Result.Unchecked = "its display mesh is not closed";
  }
  const std::size_t count = std::min(wrong.size(), MaxConfirmations);
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::size_t i = wrong[k * wrong.size() / count];
    if (this->Confirm(tree, this->Samples[i], winding[i] > 1.0))
    {
      break;
    }
  }
  return this->Result;
}
}

SelfCrossing FindSelfCrossing(
  const std::vector<const BodyIntegrals*>& parts, const std::function<bool()>& shouldContinue)
{
  return Checker(parts).Run(shouldContinue);
}
}

#include "smEqualBodies.h"

#include "Loops/smDraftFace.h"
#include "smUnitRoundoff.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>

namespace sm
{
namespace
{
/// Largest deviation of a point from the translation, in roundings of the largest coordinate.
constexpr double MaxRoundings = 16.0;
/// A point rotated about an axis moves by at most the displacement of the point and twice that of the axis.
constexpr double RotationLever = 3.0;
/// The parameters at the ends of a curve on a face follow those of its edge, to this factor.
constexpr double TrimFactor = 2.0;

/// Which object of one body corresponds to which of the other.
template <class Key>
class Correspondence
{
public:
  /// Returns false if one of the two already corresponds to something else, or only one of them is null.
  bool Add(const Key* one, const Key* other)
  {
    return this->Forward.emplace(one, other).first->second == other &&
      this->Backward.emplace(other, one).first->second == one && !one == !other;
  }

private:
  std::unordered_map<const Key*, const Key*> Forward;
  std::unordered_map<const Key*, const Key*> Backward;
};

bool IsSame(const ParameterRange& a, const ParameterRange& b)
{
  return a.Low == b.Low && a.High == b.High;
}

bool IsSame(const SplineBasis& a, const SplineBasis& b)
{
  return a.Degree == b.Degree && a.Knots == b.Knots && a.Multiplicities == b.Multiplicities &&
    a.Periodic == b.Periodic;
}

bool IsSame(const GeometricCurve<2>& a, const GeometricCurve<2>& b)
{
  if (a.GetValue().index() != b.GetValue().index())
  {
    return false;
  }
  if (const auto* line = a.GetIf<LineCurve<2>>())
  {
    const auto* other = b.GetIf<LineCurve<2>>();
    return line->Origin == other->Origin && line->Direction == other->Direction;
  }
  if (const auto* conic = a.GetIf<ConicCurve<2>>())
  {
    const auto* other = b.GetIf<ConicCurve<2>>();
    return conic->Kind == other->Kind && conic->Center == other->Center && conic->X == other->X &&
      conic->Y == other->Y && std::equal(conic->Radii, conic->Radii + 2, other->Radii);
  }
  if (const auto* spline = a.GetIf<SplineCurve<2>>())
  {
    const auto* other = b.GetIf<SplineCurve<2>>();
    return IsSame(spline->Basis, other->Basis) && spline->Poles == other->Poles &&
      spline->Weights == other->Weights;
  }
  return false;
}

/// Returns true if the loops of two faces were completed alike, without a defect.
bool IsSame(const DraftFace& a, const DraftFace& b)
{
  const auto isSameLoop = [](const DraftLoop& one, const DraftLoop& other)
  {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
      [](const DraftCoedge& x, const DraftCoedge& y)
      {
        return x.Reversed == y.Reversed && x.Degenerate == y.Degenerate && x.Projected == y.Projected &&
          x.NeedsFeet == y.NeedsFeet && (x.EdgeIndex < 0) == (y.EdgeIndex < 0);
      });
  };
  return a.Reversed == b.Reversed && a.HasNaturalBoundary == b.HasNaturalBoundary &&
    a.HasReversedSphere == b.HasReversedSphere && a.IsPart == b.IsPart && a.IsEitherPart == b.IsEitherPart &&
    a.HasSeveralParts == b.HasSeveralParts && std::equal(a.EndsAtPole, a.EndsAtPole + 2, b.EndsAtPole) &&
    a.AddedEdges == b.AddedEdges && a.ReversedEdges == b.ReversedEdges && a.Defects == 0 && b.Defects == 0 &&
    a.Messages.empty() && b.Messages.empty() &&
    std::equal(a.Loops.begin(), a.Loops.end(), b.Loops.begin(), b.Loops.end(), isSameLoop);
}

/// Compares the shapes of two bodies from shells to points.
class BodyComparison
{
public:
  BodyShift Compare(const BodyShape& one, const BodyShape& other)
  {
    const auto isSameShell = [this](const ShellUse& a, const ShellUse& b)
    {
      return a.Reversed == b.Reversed && IsIdentity(a.Location) && IsIdentity(b.Location) &&
        a.Shell->Closed == b.Shell->Closed && a.Shell->OpenSolid == b.Shell->OpenSolid &&
        a.Shell->LostFaces == 0 && b.Shell->LostFaces == 0 && this->IsSame(a.Shell->Faces, b.Shell->Faces);
    };
    this->Result.IsEqual = one.IsSolid == other.IsSolid &&
      std::equal(
        one.Shells.begin(), one.Shells.end(), other.Shells.begin(), other.Shells.end(), isSameShell) &&
      this->IsSame(one.Faces, other.Faces) && this->HasPoint;
    if (this->HasRotation)
    {
      this->Result.Deviation.fill(RotationLever * Norm(this->Result.Deviation));
    }
    for (double& deviation : this->Result.Deviation)
    {
      deviation += this->Slide;
    }
    return this->Result;
  }

private:
  bool IsSame(const std::vector<FaceUse>& one, const std::vector<FaceUse>& other)
  {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
      [this](const FaceUse& a, const FaceUse& b)
      { return a.Reversed == b.Reversed && this->IsSame(*a.Face, *b.Face); });
  }

  bool IsSame(const FaceShape& a, const FaceShape& b)
  {
    if (a.Source || b.Source || a.Own.Surface || b.Own.Surface || !a.Surface || !b.Surface ||
      !a.Completed != !b.Completed)
    {
      return false;
    }
    return sm::IsSame(a.Range[0], b.Range[0]) && sm::IsSame(a.Range[1], b.Range[1]) &&
      IsIdentity(a.Location) && IsIdentity(b.Location) && a.Bounded == b.Bounded &&
      this->IsSame(*a.Surface, *b.Surface) &&
      std::equal(a.Wires.begin(), a.Wires.end(), b.Wires.begin(), b.Wires.end(),
        [this](const WireShape& x, const WireShape& y)
        {
          return x.Reversed == y.Reversed &&
            std::equal(x.Coedges.begin(), x.Coedges.end(), y.Coedges.begin(), y.Coedges.end(),
              [this](const CoedgeShape& p, const CoedgeShape& q) { return this->IsSame(p, q); });
        }) &&
      (!a.Completed || sm::IsSame(*a.Completed, *b.Completed));
  }

  bool IsSame(const CoedgeShape& a, const CoedgeShape& b)
  {
    if (a.Reversed != b.Reversed || !a.Trim != !b.Trim || (a.Trim && !sm::IsSame(*a.Trim, *b.Trim)) ||
      !this->Edges.Add(a.Edge.get(), b.Edge.get()))
    {
      return false;
    }
    const EdgeShape& edge = *a.Edge;
    const EdgeShape& other = *b.Edge;
    const double slack =
      TrimFactor * std::max(std::abs(edge.First - other.First), std::abs(edge.Last - other.Last));
    return std::abs(a.First - b.First) <= slack && std::abs(a.Last - b.Last) <= slack &&
      this->IsSame(edge, other);
  }

  bool IsSame(const EdgeShape& a, const EdgeShape& b)
  {
    if (a.Degenerate != b.Degenerate || a.Tolerance != b.Tolerance || !a.Curve != !b.Curve ||
      !IsIdentity(a.Location) || !IsIdentity(b.Location))
    {
      return false;
    }
    return this->IsSame(a.Start.get(), b.Start.get()) && this->IsSame(a.End.get(), b.End.get()) &&
      (!a.Curve || this->IsSame(*a.Curve, *b.Curve)) && this->IsSameEnd(a, a.First, b.First) &&
      this->IsSameEnd(a, a.Last, b.Last);
  }

  bool IsSame(const VertexShape* a, const VertexShape* b)
  {
    return this->Vertices.Add(a, b) &&
      (!a || (a->Tolerance == b->Tolerance && this->IsMoved(a->Point, b->Point)));
  }

  /// Compares the parameters at an end of an edge by the distance on its curve.
  bool IsSameEnd(const EdgeShape& edge, double a, double b)
  {
    if (a == b)
    {
      return true;
    }
    const auto* line = edge.Curve ? edge.Curve->GetIf<LineCurve<3>>() : nullptr;
    const auto* conic = edge.Curve ? edge.Curve->GetIf<ConicCurve<3>>() : nullptr;
    const bool isEllipse = conic && conic->Kind == ConicCurve<3>::Type::Ellipse;
    if (!line && !isEllipse)
    {
      return false;
    }
    const double distance = std::abs(a - b) * (line ? 1.0 : std::max(conic->Radii[0], conic->Radii[1]));
    this->Slide = std::max(this->Slide, distance);
    return distance <=
      MaxRoundings * UnitRoundoff * *std::max_element(this->Result.Reach.begin(), this->Result.Reach.end());
  }

  bool IsSame(const GeometricCurve<3>& a, const GeometricCurve<3>& b)
  {
    if (a.GetValue().index() != b.GetValue().index())
    {
      return false;
    }
    if (const auto* line = a.GetIf<LineCurve<3>>())
    {
      const auto* other = b.GetIf<LineCurve<3>>();
      return line->Direction == other->Direction && this->IsMoved(line->Origin, other->Origin);
    }
    if (const auto* conic = a.GetIf<ConicCurve<3>>())
    {
      const auto* other = b.GetIf<ConicCurve<3>>();
      return conic->Kind == other->Kind && conic->X == other->X && conic->Y == other->Y &&
        std::equal(conic->Radii, conic->Radii + 2, other->Radii) &&
        this->IsMoved(conic->Center, other->Center);
    }
    if (const auto* spline = a.GetIf<SplineCurve<3>>())
    {
      const auto* other = b.GetIf<SplineCurve<3>>();
      return sm::IsSame(spline->Basis, other->Basis) && spline->Weights == other->Weights &&
        this->AreMoved(spline->Poles, other->Poles);
    }
    return false;
  }

  bool IsSame(const GeometricSurface& a, const GeometricSurface& b)
  {
    if (a.GetValue().index() != b.GetValue().index())
    {
      return false;
    }
    if (const auto* elementary = a.GetIf<ElementarySurface>())
    {
      const auto* other = b.GetIf<ElementarySurface>();
      return elementary->Kind == other->Kind && elementary->Frame.Axes == other->Frame.Axes &&
        std::equal(elementary->Radii, elementary->Radii + 2, other->Radii) &&
        elementary->Angle == other->Angle && elementary->Selected == other->Selected &&
        this->IsMoved(elementary->Frame.Origin, other->Frame.Origin);
    }
    if (const auto* extruded = a.GetIf<ExtrudedSurface>())
    {
      const auto* other = b.GetIf<ExtrudedSurface>();
      return extruded->Direction == other->Direction && sm::IsSame(extruded->Range, other->Range) &&
        this->IsSame(*extruded->Profile, *other->Profile);
    }
    if (const auto* revolved = a.GetIf<RevolvedSurface>())
    {
      const auto* other = b.GetIf<RevolvedSurface>();
      this->HasRotation = true;
      return revolved->Axis == other->Axis && sm::IsSame(revolved->Range, other->Range) &&
        this->IsMoved(revolved->Origin, other->Origin) && this->IsSame(*revolved->Profile, *other->Profile);
    }
    if (const auto* spline = a.GetIf<SplineSurface>())
    {
      const auto* other = b.GetIf<SplineSurface>();
      return sm::IsSame(spline->Basis[0], other->Basis[0]) && sm::IsSame(spline->Basis[1], other->Basis[1]) &&
        spline->Weights == other->Weights && this->AreMoved(spline->Poles, other->Poles);
    }
    return false;
  }

  bool AreMoved(const std::vector<Vector3>& a, const std::vector<Vector3>& b)
  {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
      [this](const Vector3& p, const Vector3& q) { return this->IsMoved(p, q); });
  }

  /// Compares a point with that of the other body; the first one defines the translation.
  bool IsMoved(const Vector3& a, const Vector3& b)
  {
    if (!this->HasPoint)
    {
      this->Result.Shift = Subtract(b, a);
      this->HasPoint = true;
    }
    double largest = 0.0;
    double deviation = 0.0;
    for (int c = 0; c < 3; ++c)
    {
      const double reach = std::max(std::abs(a[c]), std::abs(b[c]));
      const double off = std::abs((b[c] - a[c]) - this->Result.Shift[c]);
      largest = std::max(largest, reach);
      deviation = std::max(deviation, off);
      this->Result.Reach[c] = std::max(this->Result.Reach[c], reach);
      this->Result.Deviation[c] = std::max(this->Result.Deviation[c], off);
    }
    return deviation <= MaxRoundings * UnitRoundoff * largest && std::isfinite(largest);
  }

  BodyShift Result;
  bool HasPoint = false;
  bool HasRotation = false;
  /// Largest distance by which the end of an edge lies elsewhere on its curve.
  double Slide = 0.0;
  Correspondence<EdgeShape> Edges;
  Correspondence<VertexShape> Vertices;
};

/// What a shape has in its file, by what its counterpart has there.
class DataOfCopies
{
public:
  DataOfCopies(const BodyShape& converted, const BodyShape& body)
  {
    std::vector<const FaceShape*> from;
    converted.VisitFaces([&from](const FaceUse& use) { from.push_back(use.Face.get()); });
    body.VisitFaces([this](const FaceUse& use) { this->Faces.push_back(use.Face.get()); });
    if (from.size() != this->Faces.size())
    {
      throw std::runtime_error("equal bodies have different numbers of faces");
    }
    for (std::size_t f = 0; f < from.size(); ++f)
    {
      this->FaceOf[from[f]] = this->Faces[f];
      for (std::size_t w = 0; w < from[f]->Wires.size(); ++w)
      {
        const std::vector<CoedgeShape>& coedges = from[f]->Wires[w].Coedges;
        for (std::size_t c = 0; c < coedges.size(); ++c)
        {
          const ShapeData& to = this->Faces[f]->Wires.at(w).Coedges.at(c).Edge->Data;
          const auto place = this->EdgeOf.emplace(coedges[c].Edge->Data.FileId, &to);
          if (coedges[c].Edge->Data.FileId != 0 && place.first->second->FileId != to.FileId)
          {
            throw std::runtime_error("parts of one edge are different edges");
          }
        }
      }
    }
  }

  const FaceShape& GetFace(const FaceShape* face) const { return *this->FaceOf.at(face); }

  /// Returns the copy of an edge, the same one for all its uses.
  const std::shared_ptr<const Edge>& GetEdge(const std::shared_ptr<const Edge>& edge)
  {
    std::shared_ptr<const Edge>& copy = this->Copies[edge.get()];
    if (!copy)
    {
      auto made = std::make_shared<Edge>(*edge);
      made->Id = NewId();
      const auto found = edge->FileId != 0 ? this->EdgeOf.find(edge->FileId) : this->EdgeOf.end();
      made->FileId = found != this->EdgeOf.end() ? found->second->FileId : 0;
      made->Name = found != this->EdgeOf.end() ? found->second->Name : std::string();
      copy = made;
    }
    return copy;
  }

private:
  std::vector<const FaceShape*> Faces;
  std::unordered_map<const FaceShape*, const FaceShape*> FaceOf;
  std::unordered_map<std::int64_t, const ShapeData*> EdgeOf;
  std::unordered_map<const Edge*, std::shared_ptr<const Edge>> Copies;
};

void Mix(std::size_t& hash, std::size_t value)
{
  hash ^= value + 0x9e3779b9 + (hash << 6) + (hash >> 2);
}
}

BodyShift CompareBodies(const BodyShape& one, const BodyShape& other)
{
  return BodyComparison().Compare(one, other);
}

std::size_t GetShapeHash(const BodyShape& body)
{
  std::size_t hash = body.Shells.size();
  body.VisitFaces(
    [&hash](const FaceUse& use)
    {
      const FaceShape& face = *use.Face;
      Mix(hash, face.Wires.size());
      for (const WireShape& wire : face.Wires)
      {
        Mix(hash, wire.Coedges.size());
      }
      if (face.Surface)
      {
        Mix(hash, face.Surface->GetValue().index());
        if (const auto* elementary = face.Surface->GetIf<ElementarySurface>())
        {
          Mix(hash, static_cast<std::size_t>(elementary->Kind));
          Mix(hash, std::hash<double>()(elementary->Radii[0]));
        }
      }
    });
  return hash;
}

ConvertedBody CopyConversion(
  const ConvertedBody& conversion, const BodyShape& converted, const BodyShape& body)
{
  DataOfCopies data(converted, body);
  ConvertedBody result = conversion;
  for (ConvertedFace& face : result.Faces)
  {
    const FaceShape& source = data.GetFace(face.Source);
    auto copy = std::make_shared<Face>(*face.Result);
    copy->Id = NewId();
    copy->FileId = source.Data.FileId;
    copy->Name = source.Data.Name;
    copy->Color = source.Data.Color;
    for (Loop& loop : copy->Loops)
    {
      for (Coedge& coedge : loop.Coedges)
      {
        coedge.Use = data.GetEdge(coedge.Use);
      }
    }
    face.Source = &source;
    face.Result = copy;
  }
  return result;
}
}

#include "smFaceBytes.h"

namespace sm
{
namespace
{
template <int Dimension>
void PutCurve(ByteWriter& to, const PolynomialCurve<Dimension>& curve)
{
  to.PutAll(curve.Breaks);
  to.PutAll(curve.Offsets);
  to.PutAll(curve.Coefficients);
  to.Put(curve.Residual);
  to.PutAll(curve.PieceResiduals);
}

template <int Dimension>
void GetCurve(ByteReader& from, PolynomialCurve<Dimension>& curve)
{
  curve.Breaks = from.GetAll<double>();
  curve.Offsets = from.GetAll<std::size_t>();
  curve.Coefficients = from.GetAll<typename PolynomialCurve<Dimension>::Point>();
  curve.Residual = from.Get<typename PolynomialCurve<Dimension>::Point>();
  curve.PieceResiduals = from.GetAll<typename PolynomialCurve<Dimension>::Point>();
}
}

void FaceWriter::Put(const Edge& edge)
{
  // A number that has not occurred before means that the edge's data follow.
  const auto [known, isNew] = this->Edges.emplace(&edge, static_cast<std::uint32_t>(this->Edges.size()));
  this->To.Put(known->second);
  if (!isNew)
  {
    return;
  }
  this->To.Put(edge.FileId);
  this->To.PutText(edge.Name);
  PutCurve(this->To, edge.Curve);
  this->To.Put(edge.StartVertex);
  this->To.Put(edge.EndVertex);
  this->To.Put(edge.Tolerance);
  this->To.Put(edge.Degenerate);
}

std::shared_ptr<const Edge> FaceReader::GetEdge()
{
  const auto number = this->From.Get<std::uint32_t>();
  if (!this->From.IsGood() || number > this->Edges.size())
  {
    return nullptr;
  }
  if (number == this->Edges.size())
  {
    auto edge = std::make_shared<Edge>();
    edge->Id = NewId();
    edge->FileId = this->From.Get<std::int64_t>();
    edge->Name = this->From.GetText();
    GetCurve(this->From, edge->Curve);
    edge->StartVertex = this->From.Get<std::array<double, 3>>();
    edge->EndVertex = this->From.Get<std::array<double, 3>>();
    edge->Tolerance = this->From.Get<double>();
    edge->Degenerate = this->From.Get<bool>();
    this->Edges.push_back(edge);
  }
  return this->Edges[number];
}

void FaceWriter::Put(const Face& face)
{
  const NURBSSurface& surface = face.Surface;
  this->To.Put(face.FileId);
  this->To.PutText(face.Name);
  this->To.Put(face.Reversed);
  this->To.Put(face.Color);
  this->To.PutTexts(face.Messages);
  for (int d = 0; d < 2; ++d)
  {
    this->To.Put(surface.Degree[d]);
    this->To.PutAll(surface.Knots[d]);
    this->To.Put(surface.NumberOfControlPoints[d]);
  }
  this->To.PutAll(surface.ControlPoints);
  this->To.Put(surface.Rational);
  this->To.Put(surface.Residual);
  this->To.Put(surface.Rounding);
  this->To.Put(static_cast<std::uint64_t>(face.Loops.size()));
  for (const Loop& loop : face.Loops)
  {
    this->To.Put(static_cast<std::uint64_t>(loop.Coedges.size()));
    for (const Coedge& coedge : loop.Coedges)
    {
      this->Put(*coedge.Use);
      this->To.Put(coedge.Reversed);
      PutCurve(this->To, coedge.Curve);
    }
  }
}

FacePointer FaceReader::Get()
{
  auto face = std::make_shared<Face>();
  face->Id = NewId();
  face->FileId = this->From.Get<std::int64_t>();
  face->Name = this->From.GetText();
  face->Reversed = this->From.Get<bool>();
  face->Color = this->From.Get<std::array<double, 3>>();
  face->Messages = this->From.GetTexts();
  NURBSSurface& surface = face->Surface;
  for (int d = 0; d < 2; ++d)
  {
    surface.Degree[d] = this->From.Get<int>();
    surface.Knots[d] = this->From.GetAll<double>();
    surface.NumberOfControlPoints[d] = this->From.Get<int>();
  }
  surface.ControlPoints = this->From.GetAll<std::array<double, 4>>();
  surface.Rational = this->From.Get<bool>();
  surface.Residual = this->From.Get<double>();
  surface.Rounding = this->From.Get<std::array<double, 3>>();
  face->Loops.resize(this->From.GetCount(sizeof(std::uint64_t)));
  for (Loop& loop : face->Loops)
  {
    loop.Coedges.resize(this->From.GetCount(sizeof(std::uint32_t)));
    for (Coedge& coedge : loop.Coedges)
    {
      coedge.Use = this->GetEdge();
      if (!coedge.Use)
      {
        return nullptr;
      }
      coedge.Reversed = this->From.Get<bool>();
      GetCurve(this->From, coedge.Curve);
    }
  }
  return this->From.IsGood() ? face : nullptr;
}
}

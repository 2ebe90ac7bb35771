#include "vtkTrimmedNURBSModel.h"

#include "smFormat.h"
#include "smWeights.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_set>
#include <utility>

vtkStandardNewMacro(vtkTrimmedNURBSModel);

namespace
{
std::string Count(vtkIdType count, const char* what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// The range of a curve's parameter.
template <int Dimension>
std::string FormatRange(const sm::PolynomialCurve<Dimension>& curve)
{
  return "[" + sm::FormatDigits(curve.GetStart(), 6) + ", " + sm::FormatDigits(curve.GetEnd(), 6) + "]";
}

/// All values of an array with this number of components; empty, with a sentence in `problem`, where it is
/// not such an array.
std::vector<double> GetValues(vtkDataArray* array, int components, const char* what, std::string& problem)
{
  std::vector<double> values;
  if (!array)
  {
    problem = std::string("the array of ") + what + " is missing";
    return values;
  }
  if (array->GetNumberOfComponents() != components)
  {
    problem = std::string(what) + " need " + Count(components, "component") + ", the array has " +
      std::to_string(array->GetNumberOfComponents());
    return values;
  }
  const vtkIdType tuples = array->GetNumberOfTuples();
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      values.push_back(array->GetComponent(i, c));
      if (!std::isfinite(values.back()))
      {
        problem = "tuple " + std::to_string(i) + " of the " + what + " is not finite";
        return {};
      }
    }
  }
  return values;
}

/// Fills a curve of which Breaks and Coefficients are empty; returns what is wrong, or an empty string.
template <int Dimension>
std::string MakeCurve(
  vtkDataArray* breaks, vtkDataArray* coefficients, double residual, sm::PolynomialCurve<Dimension>& curve)
{
  std::string problem;
  curve.Breaks = GetValues(breaks, 1, "breaks", problem);
  const std::vector<double> values =
    problem.empty() ? GetValues(coefficients, Dimension, "coefficients", problem) : std::vector<double>();
  if (!problem.empty())
  {
    return problem;
  }
  const auto pieces = static_cast<vtkIdType>(curve.Breaks.size()) - 1;
  const auto points = static_cast<vtkIdType>(values.size()) / Dimension;
  if (pieces < 1)
  {
    return "a curve needs two breaks or more, there " + std::string(pieces < 0 ? "is none" : "is one");
  }
  for (vtkIdType i = 0; i < pieces; ++i)
  {
    if (!(curve.Breaks[i] < curve.Breaks[i + 1]))
    {
      return "breaks have to increase, break " + std::to_string(i + 1) + " does not";
    }
  }
  const vtkIdType degree = (points - 1) / pieces;
  if (points < 1 || degree * pieces != points - 1 || (degree == 0 && pieces > 1))
  {
    return Count(points, "coefficient") + " do not fit " + Count(pieces, "piece") +
      " of one degree: a curve has pieces * degree + 1";
  }
  if (degree > sm::MaximumDegree)
  {
    return "the degree " + std::to_string(degree) + " is above " + std::to_string(sm::MaximumDegree);
  }
  if (!(residual >= 0.0) || !std::isfinite(residual))
  {
    return "the residual has to be finite and not negative";
  }
  std::vector<std::array<double, Dimension>> piece(degree + 1);
  const std::vector<double> ends(curve.Breaks.begin() + 1, curve.Breaks.end());
  curve.Breaks.resize(1);
  for (vtkIdType k = 0; k < pieces; ++k)
  {
    for (vtkIdType i = 0; i <= degree; ++i)
    {
      for (int d = 0; d < Dimension; ++d)
      {
        piece[i][d] = values[(k * degree + i) * Dimension + d];
      }
    }
    curve.AppendPiece(ends[k], piece.data(), static_cast<int>(degree));
  }
  curve.Residual.fill(residual);
  return {};
}
}

vtkTrimmedNURBSModel::vtkTrimmedNURBSModel()
  : FileVolume(std::numeric_limits<double>::quiet_NaN())
  , FileArea(std::numeric_limits<double>::quiet_NaN())
{
}

vtkTrimmedNURBSModel::~vtkTrimmedNURBSModel() = default;

void vtkTrimmedNURBSModel::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Name << "\n"
     << indent << "Body: " << (this->Body == SOLID ? "solid" : "shell") << "\n"
     << indent << "FileId: " << this->FileId << "\n"
     << indent << "LengthUnit: " << this->LengthUnit << "\n"
     << indent << "Faces: " << this->Faces.size() << "\n"
     << indent << "Shells: " << this->Shells.size() << "\n"
     << indent << "NumberOfMissingFaces: " << this->NumberOfMissingFaces << "\n"
     << indent << "NumberOfDefects: " << this->NumberOfDefects << "\n";
}

vtkIdType vtkTrimmedNURBSModel::GetNumberOfEdges() const
{
  std::unordered_set<const sm::Edge*> edges;
  for (const sm::FacePointer& face : this->Faces)
  {
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        edges.insert(coedge.Use.get());
      }
    }
  }
  return static_cast<vtkIdType>(edges.size());
}

void vtkTrimmedNURBSModel::SetDensity(double density)
{
  if (density != 0.0 && !sm::IsWeight(density))
  {
    vtkErrorMacro("SetDensity: " << sm::FormatDigits(density, 6) << " is not a density; give kg/m^3 from "
                                 << sm::WeightRange << ", for example 7850 for steel, or 0 for none.");
    return;
  }
  if (density != this->Density)
  {
    this->Density = density;
    this->Modified();
  }
}

void vtkTrimmedNURBSModel::ChangeFaces()
{
  this->ScaleMesh = nullptr;
  this->EqualFaces.clear();
  this->Modified();
}

void vtkTrimmedNURBSModel::SetFaces(std::vector<sm::FacePointer> faces)
{
  this->Faces = std::move(faces);
  this->ChangeFaces();
}

void vtkTrimmedNURBSModel::SetScaleMesh(vtkPolyData* mesh)
{
  if (this->ScaleMesh != mesh)
  {
    this->ScaleMesh = mesh;
    this->Modified();
  }
}

vtkPolyData* vtkTrimmedNURBSModel::GetScaleMesh() const
{
  return this->ScaleMesh;
}

void vtkTrimmedNURBSModel::SetFace(vtkIdType index, sm::FacePointer face)
{
  if (index < 0 || index >= this->GetNumberOfFaces() || !face)
  {
    vtkErrorMacro("SetFace: face " << index << " of " << this->GetNumberOfFaces()
                                   << " does not exist, or the new face is null.");
    return;
  }
  this->Faces[index] = std::move(face);
  this->ChangeFaces();
}

void vtkTrimmedNURBSModel::SetEqualFaces(std::vector<sm::FacePointer> faces)
{
  const bool hasNull = std::find(faces.begin(), faces.end(), nullptr) != faces.end();
  if (hasNull || (!faces.empty() && faces.size() != this->Faces.size()))
  {
    vtkErrorMacro("SetEqualFaces: there are "
      << faces.size() << (hasNull ? " faces, some of them null" : " faces") << ", and the model has "
      << this->Faces.size() << "; give one face for each, or none.");
    return;
  }
  if (faces != this->EqualFaces)
  {
    this->EqualFaces = std::move(faces);
    this->Modified();
  }
}

void vtkTrimmedNURBSModel::SetShells(std::vector<std::vector<int>> shells)
{
  this->Shells = std::move(shells);
  this->Modified();
}

void vtkTrimmedNURBSModel::SetMessages(std::vector<std::string> messages)
{
  this->Messages = std::move(messages);
  this->Modified();
}

int vtkTrimmedNURBSModel::AddEdge(vtkDataArray* breaks, vtkDataArray* coefficients, double residual)
{
  auto edge = std::make_shared<sm::Edge>();
  const std::string problem = MakeCurve(breaks, coefficients, residual, edge->Curve);
  if (!problem.empty())
  {
    vtkErrorMacro("AddEdge: " << problem << ".");
    return -1;
  }
  edge->Id = sm::NewId();
  edge->StartVertex = edge->Curve.GetStartPoint();
  edge->EndVertex = edge->Curve.GetEndPoint();
  edge->Degenerate = edge->Curve.Coefficients.size() == 1;
  this->AddedEdges.push_back(edge);
  return static_cast<int>(this->AddedEdges.size()) - 1;
}

int vtkTrimmedNURBSModel::AddFace(int degreeU, vtkDataArray* knotsU, int degreeV, vtkDataArray* knotsV,
  vtkDataArray* controlPoints, bool reversed)
{
  auto face = std::make_shared<sm::Face>();
  sm::NURBSSurface& surface = face->Surface;
  surface.Degree[0] = degreeU;
  surface.Degree[1] = degreeV;
  std::string problem;
  surface.Knots[0] = GetValues(knotsU, 1, "knots in u", problem);
  if (problem.empty())
  {
    surface.Knots[1] = GetValues(knotsV, 1, "knots in v", problem);
  }
  const int components = controlPoints && controlPoints->GetNumberOfComponents() == 3 ? 3 : 4;
  std::vector<double> values;
  if (problem.empty())
  {
    values = GetValues(controlPoints, components, "control points", problem);
  }
  for (std::size_t i = 0; i < values.size(); i += components)
  {
    surface.ControlPoints.push_back(
      { values[i], values[i + 1], values[i + 2], components == 4 ? values[i + 3] : 1.0 });
    surface.Rational = surface.Rational || surface.ControlPoints.back()[3] != surface.ControlPoints[0][3];
  }
  for (int d = 0; d < 2; ++d)
  {
    surface.NumberOfControlPoints[d] =
      static_cast<int>(surface.Knots[d].size()) - std::clamp(surface.Degree[d], 0, sm::MaximumDegree) - 1;
  }
  if (problem.empty())
  {
    problem = surface.Check();
  }
  if (!problem.empty())
  {
    vtkErrorMacro("AddFace: " << problem << ".");
    return -1;
  }
  face->Id = sm::NewId();
  face->Reversed = reversed;
  this->Faces.push_back(face);
  this->ChangeFaces();
  return static_cast<int>(this->Faces.size()) - 1;
}

bool vtkTrimmedNURBSModel::AddCoedge(int face, int loop, int edge, bool reversed, vtkDataArray* breaks,
  vtkDataArray* coefficients, double residual)
{
  std::string problem;
  sm::Coedge coedge;
  if (face < 0 || face >= this->GetNumberOfFaces())
  {
    problem = "face " + std::to_string(face) + " does not exist, there are " +
      std::to_string(this->GetNumberOfFaces());
  }
  else if (loop < 0 || loop > static_cast<int>(this->Faces[face]->Loops.size()))
  {
    problem = "loop " + std::to_string(loop) + " of face " + std::to_string(face) +
      " is neither one of its " + std::to_string(this->Faces[face]->Loops.size()) + " loops nor the next one";
  }
  else if (edge < 0 || edge >= static_cast<int>(this->AddedEdges.size()))
  {
    problem = "edge " + std::to_string(edge) + " does not exist, AddEdge() has added " +
      std::to_string(this->AddedEdges.size());
  }
  else
  {
    problem = MakeCurve(breaks, coefficients, residual, coedge.Curve);
  }
  if (problem.empty())
  {
    coedge.Use = this->AddedEdges[edge];
    const sm::EdgeCurve& curve = coedge.Use->Curve;
    if (coedge.Curve.GetStart() != curve.GetStart() || coedge.Curve.GetEnd() != curve.GetEnd())
    {
      problem = "the trim curve runs over " + FormatRange(coedge.Curve) + ", edge " + std::to_string(edge) +
        " over " + FormatRange(curve) + ": give both the same range";
    }
  }
  if (!problem.empty())
  {
    vtkErrorMacro("AddCoedge: " << problem << ".");
    return false;
  }
  coedge.Reversed = reversed;
  // Faces are immutable values, so one that others share is copied. To copy a face for each of its coedges
  // would take quadratic time.
  if (this->GrowingFace != this->Faces[face] || this->GrowingFace.use_count() > 2)
  {
    this->GrowingFace = std::make_shared<sm::Face>(*this->Faces[face]);
    this->Faces[face] = this->GrowingFace;
  }
  sm::Face& changed = *this->GrowingFace;
  changed.Id = sm::NewId();
  changed.Loops.resize(std::max(changed.Loops.size(), static_cast<std::size_t>(loop) + 1));
  changed.Loops[loop].Coedges.push_back(std::move(coedge));
  this->ChangeFaces();
  return true;
}

void vtkTrimmedNURBSModel::ShallowCopy(vtkTrimmedNURBSModel* source)
{
  if (!source || source == this)
  {
    return;
  }
  this->Body = source->Body;
  this->Name = source->Name;
  this->FileId = source->FileId;
  this->LengthUnit = source->LengthUnit;
  this->FileUnit = source->FileUnit;
  this->Material = source->Material;
  this->Density = source->Density;
  this->FileVolume = source->FileVolume;
  this->FileArea = source->FileArea;
  this->FileUncertainty = source->FileUncertainty;
  this->NumberOfMissingFaces = source->NumberOfMissingFaces;
  this->NumberOfDefects = source->NumberOfDefects;
  this->NumberOfOuterShells = source->NumberOfOuterShells;
  for (int i = 0; i < 3; ++i)
  {
    this->Origin[i] = source->Origin[i];
  }
  for (int i = 0; i < 6; ++i)
  {
    this->LocalBounds[i] = source->LocalBounds[i];
  }
  this->VolumeScale = source->VolumeScale;
  this->AreaScale = source->AreaScale;
  this->ScaleMesh = source->ScaleMesh;
  this->Faces = source->Faces;
  this->EqualFaces = source->EqualFaces;
  this->Shells = source->Shells;
  this->Messages = source->Messages;
  this->AddedEdges = source->AddedEdges;
  this->Modified();
}

unsigned long vtkTrimmedNURBSModel::GetActualMemorySize() const
{
  std::size_t bytes = sizeof(*this);
  std::unordered_set<const sm::Edge*> edges;
  for (const sm::FacePointer& face : this->Faces)
  {
    bytes += sm::GetMemorySize(*face);
    for (const sm::Loop& loop : face->Loops)
    {
      for (const sm::Coedge& coedge : loop.Coedges)
      {
        if (edges.insert(coedge.Use.get()).second)
        {
          bytes += sizeof(sm::Edge) + coedge.Use->Curve.Coefficients.size() * sizeof(sm::EdgeCurve::Point);
        }
      }
    }
  }
  const unsigned long mesh = this->ScaleMesh ? this->ScaleMesh->GetActualMemorySize() : 0;
  return static_cast<unsigned long>(bytes / 1024 + 1) + mesh;
}

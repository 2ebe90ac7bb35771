#include "smModelEdit.h"

#include "Detail/smNetChange.h"
#include "smFormat.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace sm
{
namespace
{
ModelEdit Fail(EditStatus status, const std::string& message)
{
  ModelEdit edit;
  edit.Status = status;
  edit.Message = message;
  return edit;
}

/// Returns Ok, or the reason why the face of the model cannot be edited.
ModelEdit CheckFace(vtkTrimmedNURBSModel* model, int face)
{
  if (!model)
  {
    return Fail(EditStatus::NoModel, "there is no model");
  }
  if (face < 0 || face >= model->GetNumberOfFaces())
  {
    return Fail(EditStatus::NoSuchFace,
      "there is no face " + std::to_string(face) + "; the model has " +
        std::to_string(model->GetNumberOfFaces()) + ", counted from 0");
  }
  return {};
}

ModelEdit CheckIndex(const NURBSSurface& surface, ControlPointIndex index)
{
  if (index.U < 0 || index.U >= surface.NumberOfControlPoints[0] || index.V < 0 ||
    index.V >= surface.NumberOfControlPoints[1])
  {
    return Fail(EditStatus::NoSuchControlPoint,
      "there is no control point (" + std::to_string(index.U) + ", " + std::to_string(index.V) +
        "); the face has " + std::to_string(surface.NumberOfControlPoints[0]) + " x " +
        std::to_string(surface.NumberOfControlPoints[1]) + ", counted from 0");
  }
  return {};
}

/// Returns Ok, or the reason why control points of an existing face cannot be moved.
ModelEdit CheckSurface(vtkTrimmedNURBSModel* model, int face)
{
  const std::string wrong = model->GetFaces()[face]->Surface.Check();
  return wrong.empty() ? ModelEdit()
                       : Fail(EditStatus::InvalidFace,
                           "the surface of face " + std::to_string(face) + " is not valid: " + wrong);
}

template <int Dimension>
bool IsEvaluable(const PolynomialCurve<Dimension>& curve)
{
  bool evaluable = curve.GetNumberOfPieces() > 0;
  for (int k = 0; k < curve.GetNumberOfPieces(); ++k)
  {
    evaluable = evaluable && curve.GetDegree(k) >= 0 && curve.GetDegree(k) <= MaximumDegree;
  }
  for (const auto& point : curve.Coefficients)
  {
    evaluable =
      evaluable && std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
  }
  return evaluable;
}

std::size_t GetEntry(const NURBSSurface& surface, ControlPointIndex index)
{
  return static_cast<std::size_t>(index.U) +
    static_cast<std::size_t>(index.V) * surface.NumberOfControlPoints[0];
}

ModelEdit CheckPoint(const std::array<double, 4>& point)
{
  if (!std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); }))
  {
    return Fail(EditStatus::NotFinite, "a control point is not finite");
  }
  if (!(point[3] > 0.0))
  {
    return Fail(EditStatus::WeightNotPositive,
      "the weight " + FormatDigits(point[3], 6) + " of a control point is not above 0");
  }
  return {};
}

/// Returns Ok, or the reason why the face cannot become a face of the model.
ModelEdit CheckReplacement(vtkTrimmedNURBSModel* model, int index, const FacePointer& face)
{
  if (!face || face->Id == 0)
  {
    return Fail(EditStatus::InvalidFace, "the new face is null or has no id; NewId() gives one");
  }
  const std::string wrong = face->Surface.Check();
  if (!wrong.empty())
  {
    return Fail(EditStatus::InvalidFace, "the new face's surface is not valid: " + wrong);
  }
  for (const Loop& loop : face->Loops)
  {
    for (const Coedge& coedge : loop.Coedges)
    {
      if (!coedge.Use || !IsEvaluable(coedge.Use->Curve) || !IsEvaluable(coedge.Curve))
      {
        return Fail(EditStatus::InvalidFace,
          "a coedge of the new face has no edge or no curve, or one of a degree above " +
            std::to_string(MaximumDegree) + " or that is not finite");
      }
    }
  }
  for (std::size_t f = 0; f < model->GetFaces().size(); ++f)
  {
    const FacePointer& other = model->GetFaces()[f];
    if (other->Id == face->Id && other != face)
    {
      return Fail(EditStatus::InvalidFace,
        "the new face " + std::to_string(index) + " has the id of face " + std::to_string(f) +
          "; NewId() gives another");
    }
  }
  return {};
}

bool HaveSameLayout(const NURBSSurface& a, const NURBSSurface& b)
{
  return a.Degree[0] == b.Degree[0] && a.Degree[1] == b.Degree[1] && a.Knots[0] == b.Knots[0] &&
    a.Knots[1] == b.Knots[1];
}
}

const char* GetName(EditStatus status)
{
  switch (status)
  {
    case EditStatus::Ok:
      return "ok";
    case EditStatus::NoModel:
      return "no-model";
    case EditStatus::NoSuchFace:
      return "no-such-face";
    case EditStatus::NoSuchControlPoint:
      return "no-such-control-point";
    case EditStatus::NotFinite:
      return "not-finite";
    case EditStatus::WeightNotPositive:
      return "weight-not-positive";
    case EditStatus::InvalidFace:
      return "invalid-face";
  }
  return "unknown";
}

bool GetControlPoint(
  vtkTrimmedNURBSModel* model, int face, ControlPointIndex index, std::array<double, 4>& point)
{
  if (CheckFace(model, face).Status != EditStatus::Ok ||
    CheckIndex(model->GetFaces()[face]->Surface, index).Status != EditStatus::Ok)
  {
    return false;
  }
  const NURBSSurface& surface = model->GetFaces()[face]->Surface;
  const std::size_t entry = GetEntry(surface, index);
  const bool exists = entry < surface.ControlPoints.size();
  point = exists ? surface.ControlPoints[entry] : point;
  return exists;
}

std::vector<std::vector<int>> FindTiedPoints(vtkTrimmedNURBSModel* model)
{
  return model ? NetChange(model, EditRule::MoveSharedBoundary).FindGroups()
               : std::vector<std::vector<int>>();
}

ModelEdit SetControlPoints(vtkTrimmedNURBSModel* model, int face,
  const std::vector<std::pair<ControlPointIndex, std::array<double, 4>>>& points, EditRule rule)
{
  ModelEdit edit = CheckFace(model, face);
  edit = edit.Status == EditStatus::Ok ? CheckSurface(model, face) : edit;
  for (std::size_t i = 0; i < points.size() && edit.Status == EditStatus::Ok; ++i)
  {
    edit = CheckIndex(model->GetFaces()[face]->Surface, points[i].first);
    edit = edit.Status == EditStatus::Ok ? CheckPoint(points[i].second) : edit;
  }
  if (edit.Status != EditStatus::Ok)
  {
    return edit;
  }
  NetChange change(model, rule);
  for (const auto& [index, point] : points)
  {
    change.SetPoint(face, GetEntry(model->GetFaces()[face]->Surface, index), point);
  }
  change.Finish(edit);
  return edit;
}

ModelEdit MoveControlPoints(vtkTrimmedNURBSModel* model, int face,
  const std::vector<ControlPointIndex>& indices, const std::array<double, 3>& displacement, EditRule rule)
{
  std::vector<std::pair<ControlPointIndex, std::array<double, 4>>> points;
  for (const ControlPointIndex& index : indices)
  {
    // SetControlPoints() reports control points that do not exist.
    std::array<double, 4> point{ 0.0, 0.0, 0.0, 1.0 };
    GetControlPoint(model, face, index, point);
    for (int c = 0; c < 3; ++c)
    {
      point[c] += displacement[c] * point[3];
    }
    points.emplace_back(index, point);
  }
  return SetControlPoints(model, face, points, rule);
}

ModelEdit SetWeights(vtkTrimmedNURBSModel* model, int face, const std::vector<ControlPointIndex>& indices,
  double weight, EditRule rule)
{
  std::vector<std::pair<ControlPointIndex, std::array<double, 4>>> points;
  for (const ControlPointIndex& index : indices)
  {
    std::array<double, 4> point{ 0.0, 0.0, 0.0, 1.0 };
    GetControlPoint(model, face, index, point);
    for (int c = 0; c < 3; ++c)
    {
      point[c] *= weight / point[3];
    }
    point[3] = weight;
    points.emplace_back(index, point);
  }
  return SetControlPoints(model, face, points, rule);
}

ModelEdit ReplaceFace(vtkTrimmedNURBSModel* model, int face, FacePointer replacement, EditRule rule)
{
  ModelEdit edit = CheckFace(model, face);
  edit = edit.Status == EditStatus::Ok ? CheckReplacement(model, face, replacement) : edit;
  if (edit.Status != EditStatus::Ok)
  {
    return edit;
  }
  const NURBSSurface& old = model->GetFaces()[face]->Surface;
  if (rule == EditRule::OneFace || !HaveSameLayout(old, replacement->Surface))
  {
    return ReplaceFaces(model, { { face, replacement } });
  }
  NetChange change(model, rule);
  change.SetTemplate(face, replacement);
  for (std::size_t i = 0; i < old.ControlPoints.size(); ++i)
  {
    if (old.ControlPoints[i] != replacement->Surface.ControlPoints[i])
    {
      change.SetPoint(face, i, replacement->Surface.ControlPoints[i]);
    }
  }
  change.Finish(edit);
  return edit;
}

ModelEdit ReplaceFaces(
  vtkTrimmedNURBSModel* model, const std::vector<std::pair<int, FacePointer>>& replacements)
{
  ModelEdit edit;
  std::vector<FacePointer> faces = model ? model->GetFaces() : std::vector<FacePointer>();
  for (const auto& [index, face] : replacements)
  {
    edit = CheckFace(model, index);
    edit = edit.Status == EditStatus::Ok ? CheckReplacement(model, index, face) : edit;
    if (edit.Status != EditStatus::Ok)
    {
      return edit;
    }
    faces[index] = face;
  }
  if (!model)
  {
    return CheckFace(model, 0);
  }
  std::map<std::uint64_t, std::size_t> owners;
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const std::size_t other = owners.emplace(faces[f]->Id, f).first->second;
    if (faces[f] != faces[other])
    {
      return Fail(EditStatus::InvalidFace,
        "the new faces " + std::to_string(other) + " and " + std::to_string(f) +
          " have one id; NewId() gives another");
    }
    if (faces[f] != model->GetFaces()[f])
    {
      edit.Replaced.emplace_back(static_cast<int>(f), model->GetFaces()[f]);
    }
  }
  edit.Model = vtkSmartPointer<vtkTrimmedNURBSModel>::New();
  edit.Model->ShallowCopy(model);
  edit.Model->SetFaces(std::move(faces));
  edit.Opened = FindOpenedEdges(model, edit.Model);
  return edit;
}

ModelEdit MapControlPoints(
  vtkTrimmedNURBSModel* model, const std::vector<int>& faces, const PointMap& map, EditRule rule)
{
  ModelEdit edit;
  if (!model)
  {
    return CheckFace(model, 0);
  }
  std::vector<bool> chosen(model->GetFaces().size(), faces.empty());
  for (const int face : faces)
  {
    edit = CheckFace(model, face);
    if (edit.Status != EditStatus::Ok)
    {
      return edit;
    }
    chosen[face] = true;
  }
  NetChange change(model, rule);
  change.SetMap(chosen, map);
  const double step = change.GetStep();
  for (std::size_t f = 0; f < chosen.size(); ++f)
  {
    edit = chosen[f] ? CheckSurface(model, static_cast<int>(f)) : edit;
    if (edit.Status != EditStatus::Ok)
    {
      return edit;
    }
    const NURBSSurface& surface = model->GetFaces()[f]->Surface;
    const bool hasErrors = surface.Residual > 0.0 || surface.Rounding != std::array<double, 3>{};
    const std::vector<std::array<double, 4>>& points = surface.ControlPoints;
    MapSlopes slopes;
    for (std::size_t i = 0; i < points.size() && chosen[f]; ++i)
    {
      const std::array<double, 4>& point = points[i];
      const std::array<double, 3> from{ point[0] / point[3], point[1] / point[3], point[2] / point[3] };
      const std::array<double, 3> to = map(from);
      // A point that the map does not move keeps its bits.
      const std::array<double, 4> mapped = to == from
        ? point
        : std::array<double, 4>{ to[0] * point[3], to[1] * point[3], to[2] * point[3], point[3] };
      edit = CheckPoint(mapped);
      if (edit.Status != EditStatus::Ok)
      {
        return edit;
      }
      if (mapped != point)
      {
        change.SetPoint(static_cast<int>(f), i, mapped);
        if (hasErrors)
        {
          slopes.Add(map, from, step);
        }
      }
    }
    change.RaiseErrors(static_cast<int>(f), slopes);
  }
  change.Finish(edit);
  return edit;
}
}

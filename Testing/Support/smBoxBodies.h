/**
 * @file smBoxBodies.h
 * @brief Solids made of boxes by hand: shells inside out, side by side, nested and crossing, without a CAD
 * kernel
 */
#ifndef smBoxBodies_h
#define smBoxBodies_h

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNURBSDataSet.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkTrimmedNURBSModel.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace smtest
{
/// Outward: its faces' normals leave the box. Sides: how many of its six faces are there.
struct BoxShell
{
  std::array<double, 3> Low;
  std::array<double, 3> High;
  bool Outward = true;
  int Faces = 6;

  double GetVolume() const
  {
    return (this->High[0] - this->Low[0]) * (this->High[1] - this->Low[1]) * (this->High[2] - this->Low[2]);
  }
};

/// Collects planar faces with shared straight edges, and two triangles for each.
class BoxBody
{
public:
  void Add(const BoxShell& box)
  {
    this->Edges.clear();
    std::vector<int> shell;
    // Corner c has High where bit d of c is set; every face is counter-clockwise seen from outside.
    const int corners[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
      { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
    for (int f = 0; f < box.Faces; ++f)
    {
      shell.push_back(static_cast<int>(this->Faces.size()));
      this->AddFace(box, corners[f]);
    }
    this->Shells.push_back(shell);
  }

  vtkSmartPointer<vtkNURBSDataSet> Make(bool solid = true, bool withMesh = true, bool oneShell = false)
  {
    vtkNew<vtkTrimmedNURBSModel> model;
    model->SetName("boxes");
    model->SetBody(solid ? vtkTrimmedNURBSModel::SOLID : vtkTrimmedNURBSModel::SHELL);
    model->SetFaces(this->Faces);
    if (oneShell)
    {
      for (std::size_t s = 1; s < this->Shells.size(); ++s)
      {
        this->Shells[0].insert(this->Shells[0].end(), this->Shells[s].begin(), this->Shells[s].end());
      }
      this->Shells.resize(1);
    }
    model->SetShells(this->Shells);
    double bounds[6];
    this->Points->GetBounds(bounds);
    model->SetLocalBounds(bounds);
    auto leaf = vtkSmartPointer<vtkNURBSDataSet>::New();
    leaf->SetPoints(this->Points);
    if (withMesh)
    {
      leaf->SetPolys(this->Triangles);
      this->CellFace->SetName(vtkNURBSDataSet::FaceIndexArrayName());
      leaf->GetCellData()->AddArray(this->CellFace);
    }
    leaf->SetModel(model);
    return leaf;
  }

private:
  using Point = std::array<double, 3>;

  void AddFace(const BoxShell& box, const int corners[4])
  {
    auto face = std::make_shared<sm::Face>();
    face->Id = sm::NewId();
    face->FileId = 100 + static_cast<int>(this->Faces.size());
    face->Reversed = !box.Outward;
    Point p[4];
    vtkIdType ids[4];
    for (int i = 0; i < 4; ++i)
    {
      for (int d = 0; d < 3; ++d)
      {
        p[i][d] = (corners[i] >> d) & 1 ? box.High[d] : box.Low[d];
      }
      ids[i] = this->Points->InsertNextPoint(p[i].data());
    }
    face->Surface.Knots[0] = face->Surface.Knots[1] = { 0.0, 0.0, 1.0, 1.0 };
    face->Surface.NumberOfControlPoints[0] = face->Surface.NumberOfControlPoints[1] = 2;
    for (const int i : { 0, 1, 3, 2 })
    {
      face->Surface.ControlPoints.push_back({ p[i][0], p[i][1], p[i][2], 1.0 });
    }
    const std::array<double, 2> uv[4] = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
    sm::Loop loop;
    for (int i = 0; i < 4; ++i)
    {
      const int next = (i + 1) % 4;
      sm::Coedge coedge;
      coedge.Use = this->GetEdge(corners[i], corners[next], p[i], p[next]);
      coedge.Reversed = corners[i] > corners[next];
      const std::array<double, 2> ends[2] = { uv[coedge.Reversed ? next : i],
        uv[coedge.Reversed ? i : next] };
      coedge.Curve.Breaks = { 0.0 };
      coedge.Curve.AppendPiece(1.0, ends, 1);
      loop.Coedges.push_back(coedge);
    }
    face->Loops.push_back(loop);
    for (int half = 0; half < 2; ++half)
    {
      const vtkIdType triangle[3] = { ids[0], ids[half + 1], ids[half + 2] };
      this->Triangles->InsertNextCell(3, triangle);
      this->CellFace->InsertNextValue(static_cast<int>(this->Faces.size()));
    }
    this->Faces.push_back(face);
  }

  std::shared_ptr<const sm::Edge> GetEdge(int a, int b, const Point& from, const Point& to)
  {
    std::shared_ptr<const sm::Edge>& known = this->Edges[{ std::min(a, b), std::max(a, b) }];
    if (!known)
    {
      auto edge = std::make_shared<sm::Edge>();
      edge->Id = sm::NewId();
      edge->FileId = 1000 + this->NumberOfEdges++;
      edge->StartVertex = a < b ? from : to;
      edge->EndVertex = a < b ? to : from;
      const Point line[2] = { edge->StartVertex, edge->EndVertex };
      edge->Curve.Breaks = { 0.0 };
      edge->Curve.AppendPiece(1.0, line, 1);
      known = edge;
    }
    return known;
  }

  std::vector<sm::FacePointer> Faces;
  std::vector<std::vector<int>> Shells;
  std::map<std::pair<int, int>, std::shared_ptr<const sm::Edge>> Edges;
  int NumberOfEdges = 0;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Triangles;
  vtkNew<vtkIntArray> CellFace;
};
}

#endif

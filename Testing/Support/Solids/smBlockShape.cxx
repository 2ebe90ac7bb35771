#include "smBlockShape.h"

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Builder.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>

#include <stdexcept>

namespace smtest
{
namespace
{
/// OCCT's default; the file states it.
constexpr double EdgeTolerance = 1e-7;

TColStd_Array1OfReal BezierKnots()
{
  TColStd_Array1OfReal knots(1, 2);
  knots.SetValue(1, 0.0);
  knots.SetValue(2, 1.0);
  return knots;
}

TColStd_Array1OfInteger BezierMultiplicities(int degree)
{
  TColStd_Array1OfInteger multiplicities(1, 2);
  multiplicities.Init(degree + 1);
  return multiplicities;
}

std::size_t GetPoleIndex(const RationalBlock& block, const std::array<int, 3>& lattice)
{
  return block.GetIndex(lattice[0], lattice[1], lattice[2]);
}

gp_Pnt GetPole(const RationalBlock& block, std::size_t index)
{
  return gp_Pnt(block.Poles[index][0], block.Poles[index][1], block.Poles[index][2]);
}

/// Parameter `axis` runs, the next is `b`, the one after it `c` (0 or 1).
Handle(Geom_BSplineCurve) MakeEdgeCurve(const RationalBlock& block, int axis, int b, int c)
{
  const int degree = block.Degree[axis];
  TColgp_Array1OfPnt poles(1, degree + 1);
  TColStd_Array1OfReal weights(1, degree + 1);
  for (int i = 0; i <= degree; ++i)
  {
    std::array<int, 3> lattice{};
    lattice[axis] = i;
    lattice[(axis + 1) % 3] = b * block.Degree[(axis + 1) % 3];
    lattice[(axis + 2) % 3] = c * block.Degree[(axis + 2) % 3];
    const std::size_t index = GetPoleIndex(block, lattice);
    poles.SetValue(i + 1, GetPole(block, index));
    weights.SetValue(i + 1, block.IsRational() ? block.Weights[index] : 1.0);
  }
  // OpenCASCADE makes the curve polynomial itself when all weights are equal.
  return new Geom_BSplineCurve(poles, weights, BezierKnots(), BezierMultiplicities(degree), degree);
}

struct Frame
{
  /// Corners by the bits 0, 1 and 2 of the index: the ends of u, v and w.
  TopoDS_Vertex Vertices[8];
  /// By axis, next and after-next parameter.
  TopoDS_Edge Edges[3][2][2];
};

Frame MakeFrame(const RationalBlock& block)
{
  BRep_Builder builder;
  Frame frame;
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<int, 3> lattice{};
    for (int d = 0; d < 3; ++d)
    {
      lattice[d] = (corner >> d & 1) * block.Degree[d];
    }
    builder.MakeVertex(frame.Vertices[corner], GetPole(block, GetPoleIndex(block, lattice)), EdgeTolerance);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int b = 0; b < 2; ++b)
    {
      for (int c = 0; c < 2; ++c)
      {
        TopoDS_Edge& edge = frame.Edges[axis][b][c];
        builder.MakeEdge(edge, MakeEdgeCurve(block, axis, b, c), EdgeTolerance);
        const int start = b << (axis + 1) % 3 | c << (axis + 2) % 3;
        builder.Add(edge, frame.Vertices[start].Oriented(TopAbs_FORWARD));
        builder.Add(edge, frame.Vertices[start | 1 << axis].Oriented(TopAbs_REVERSED));
        builder.Range(edge, 0.0, 1.0);
      }
    }
  }
  return frame;
}

TopoDS_Face MakeFace(Frame& frame, const Handle(Geom_Surface) & surface, int axis, int side)
{
  BRep_Builder builder;
  TopoDS_Face face;
  builder.MakeFace(face, surface, EdgeTolerance);
  TopoDS_Wire wire;
  builder.MakeWire(wire);
  // The face's u is the parameter a, its v is b: counter-clockwise around the unit square.
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  struct Use
  {
    TopoDS_Edge& Edge;
    gp_Pnt2d Start;
    gp_Dir2d Direction;
    TopAbs_Orientation Orientation;
  };
  // Edges along a are indexed by (b, axis), those along b by (axis, a).
  const Use uses[4] = {
    { frame.Edges[a][0][side], gp_Pnt2d(0, 0), gp_Dir2d(1, 0), TopAbs_FORWARD },
    { frame.Edges[b][side][1], gp_Pnt2d(1, 0), gp_Dir2d(0, 1), TopAbs_FORWARD },
    { frame.Edges[a][1][side], gp_Pnt2d(0, 1), gp_Dir2d(1, 0), TopAbs_REVERSED },
    { frame.Edges[b][side][0], gp_Pnt2d(0, 0), gp_Dir2d(0, 1), TopAbs_REVERSED },
  };
  for (const Use& use : uses)
  {
    builder.UpdateEdge(
      use.Edge, new Geom2d_Line(use.Start, use.Direction), surface, TopLoc_Location(), EdgeTolerance);
    builder.Range(use.Edge, surface, TopLoc_Location(), 0.0, 1.0);
    builder.Add(wire, use.Edge.Oriented(use.Orientation));
  }
  wire.Closed(true);
  builder.Add(face, wire);
  return face;
}
}

Handle(Geom_BSplineSurface) MakeBlockPatch(const RationalBlock& block, int axis, int side)
{
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  const int p = block.Degree[a];
  const int q = block.Degree[b];
  TColgp_Array2OfPnt poles(1, p + 1, 1, q + 1);
  TColStd_Array2OfReal weights(1, p + 1, 1, q + 1);
  for (int i = 0; i <= p; ++i)
  {
    for (int j = 0; j <= q; ++j)
    {
      std::array<int, 3> lattice{};
      lattice[axis] = side * block.Degree[axis];
      lattice[a] = i;
      lattice[b] = j;
      const std::size_t index = GetPoleIndex(block, lattice);
      poles.SetValue(i + 1, j + 1, GetPole(block, index));
      weights.SetValue(i + 1, j + 1, block.IsRational() ? block.Weights[index] : 1.0);
    }
  }
  return new Geom_BSplineSurface(
    poles, weights, BezierKnots(), BezierKnots(), BezierMultiplicities(p), BezierMultiplicities(q), p, q);
}

TopoDS_Shape MakeBlockShape(const RationalBlock& block, const std::array<Handle(Geom_Surface), 6>& replaced)
{
  BRep_Builder builder;
  Frame frame = MakeFrame(block);
  TopoDS_Shell shell;
  builder.MakeShell(shell);
  const int handedness = GetHandedness(block);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const Handle(Geom_Surface) given = replaced[2 * axis + side];
      const Handle(Geom_Surface) surface =
        given.IsNull() ? Handle(Geom_Surface)(MakeBlockPatch(block, axis, side)) : given;
      const TopoDS_Face face = MakeFace(frame, surface, axis, side);
      const bool outward = (side == 1) == (handedness > 0);
      builder.Add(shell, face.Oriented(outward ? TopAbs_FORWARD : TopAbs_REVERSED));
    }
  }
  shell.Closed(true);
  TopoDS_Solid solid;
  builder.MakeSolid(solid);
  builder.Add(solid, shell);
  for (auto& byAxis : frame.Edges)
  {
    for (auto& row : byAxis)
    {
      for (TopoDS_Edge& edge : row)
      {
        builder.SameRange(edge, true);
        builder.SameParameter(edge, true);
      }
    }
  }
  if (!BRepCheck_Analyzer(solid).IsValid())
  {
    throw std::runtime_error("OCCT finds fault with the shape of a block");
  }
  return solid;
}
}

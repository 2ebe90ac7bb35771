#include "smOCCTOrientVoids.h"

#include "smOCCTFailure.h"

#include <BRepBndLib.hxx>
#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRepGProp_Domain.hxx>
#include <BRepGProp_Face.hxx>
#include <BRepGProp_Vinert.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sm
{
namespace
{
/// Error of the volume between a face and a point by OpenCASCADE's rule of fixed order, relative to this
/// volume.
constexpr double QuadratureError = 1e-2;

/// Number of a void's vertices that are located.
constexpr int LocatedVertices = 8;

/// A closed shell, and the volume that it encloses, negative if its normals point inwards.
struct MeasuredShell
{
  Bnd_Box Box;
  double Volume = 0.0;
  double Error = 0.0;
  TopTools_IndexedMapOfShape Vertices;

  bool IsCertain() const { return std::abs(this->Volume) > this->Error; }
};

/// Returns the signed volume between a point and a face.
double GetCone(const TopoDS_Face& face, const gp_Pnt& apex)
{
  BRepGProp_Face integrand(face);
  BRepGProp_Vinert volume;
  volume.SetLocation(apex);
  if (TopExp_Explorer(face, TopAbs_WIRE).More())
  {
    BRepGProp_Domain wires(face);
    volume.Perform(integrand, wires);
  }
  else
  {
    volume.Perform(integrand);
  }
  return volume.Mass();
}

MeasuredShell Measure(const TopoDS_Shell& shell)
{
  MeasuredShell result;
  BRepBndLib::Add(shell, result.Box);
  const gp_Pnt low = result.Box.CornerMin();
  const gp_Pnt center((low.XYZ() + result.Box.CornerMax().XYZ()) / 2.0);
  for (TopoDS_Iterator face(shell); face.More(); face.Next())
  {
    const double cone = GetCone(TopoDS::Face(face.Value()), center);
    result.Volume += cone;
    result.Error += QuadratureError * std::abs(cone);
  }
  double tolerance = Precision::Confusion();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shell, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i)
  {
    tolerance = std::max(tolerance, BRep_Tool::Tolerance(TopoDS::Edge(edges(i))));
  }
  GProp_GProps area;
  BRepGProp::SurfaceProperties(shell, area);
  result.Error += tolerance * area.Mass();
  TopExp::MapShapes(shell, TopAbs_VERTEX, result.Vertices);
  return result;
}

bool IsInside(const Bnd_Box& inner, const Bnd_Box& outer)
{
  return !outer.IsOut(inner.CornerMin()) && !outer.IsOut(inner.CornerMax());
}

/// Locates points relative to a shell in either orientation.
class ShellLocator
{
public:
  explicit ShellLocator(const TopoDS_Shell& shell)
  {
    const BRep_Builder builder;
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    this->Classifier.Load(solid);
    this->Classifier.PerformInfinitePoint(Precision::Confusion());
    this->Infinity = this->Classifier.State();
  }

  /// Returns true if the orientation that rays find agrees with the sign of the volume.
  bool HasSign(double volume) const { return this->Infinity == (volume > 0.0 ? TopAbs_OUT : TopAbs_IN); }

  /// Returns true if the vertices of another shell are all inside, or all outside of this one.
  bool HasAll(const MeasuredShell& other, bool inside)
  {
    const int count = other.Vertices.Extent();
    const int step = std::max(1, count / LocatedVertices);
    for (int i = 1; i <= count; i += step)
    {
      this->Classifier.Perform(BRep_Tool::Pnt(TopoDS::Vertex(other.Vertices(i))), Precision::Confusion());
      const TopAbs_State state = this->Classifier.State();
      if ((state != TopAbs_IN && state != TopAbs_OUT) || (state != this->Infinity) != inside)
      {
        return false;
      }
    }
    return count > 0;
  }

private:
  BRepClass3d_SolidClassifier Classifier;
  TopAbs_State Infinity = TopAbs_UNKNOWN;
};

TopoDS_Shell Reverse(const TopoDS_Shell& shell)
{
  const BRep_Builder builder;
  TopoDS_Shell reversed;
  builder.MakeShell(reversed);
  for (TopoDS_Iterator face(shell); face.More(); face.Next())
  {
    builder.Add(reversed, face.Value().Reversed());
  }
  reversed.Closed(true);
  return reversed;
}

/// Returns true if the shell is certain to be a void of the first one with its orientation.
bool IsWrongVoid(
  const std::vector<TopoDS_Shell>& shells, const std::vector<MeasuredShell>& measured, std::size_t index)
{
  const MeasuredShell& candidate = measured[index];
  ShellLocator outer(shells[0]);
  if (!outer.HasSign(measured[0].Volume) || !ShellLocator(shells[index]).HasSign(candidate.Volume) ||
    !outer.HasAll(candidate, true))
  {
    return false;
  }
  for (std::size_t i = 1; i < shells.size(); ++i)
  {
    if (i != index && IsInside(candidate.Box, measured[i].Box) &&
      !ShellLocator(shells[i]).HasAll(candidate, false))
    {
      return false;
    }
  }
  return true;
}

/// Reverses what is to be reversed. Returns the number of shells that may be wrong and remain as they are.
int ReverseWrongVoids(std::vector<TopoDS_Shell>& shells)
{
  std::vector<MeasuredShell> measured;
  for (const TopoDS_Shell& shell : shells)
  {
    measured.push_back(Measure(shell));
  }
  const MeasuredShell& outer = measured[0];
  if (!outer.IsCertain())
  {
    return static_cast<int>(shells.size());
  }
  const bool isOuter = std::all_of(measured.begin(), measured.end(),
    [&outer](const MeasuredShell& shell) { return IsInside(shell.Box, outer.Box); });
  std::vector<std::size_t> wrong;
  int unknown = 0;
  for (std::size_t i = 1; i < shells.size(); ++i)
  {
    if (measured[i].IsCertain() && measured[i].Volume * outer.Volume < 0.0)
    {
      continue;
    }
    if (isOuter && measured[i].IsCertain() && IsWrongVoid(shells, measured, i))
    {
      wrong.push_back(i);
      continue;
    }
    ++unknown;
  }
  for (const std::size_t i : wrong)
  {
    shells[i] = Reverse(shells[i]);
  }
  return unknown;
}
}

std::string OrientVoids(std::vector<TopoDS_Shell>& shells)
{
  int unknown = 0;
  const std::string failure = CatchKernelFailure([&] { unknown = ReverseWrongVoids(shells); });
  if (!failure.empty())
  {
    unknown = static_cast<int>(shells.size());
  }
  return unknown == 0 ? std::string()
                      : "It is not certain that " + std::to_string(unknown) + " of the " +
      std::to_string(shells.size()) + " shells of the solid are oriented as outer shell and voids" +
      (failure.empty() ? "" : " (" + failure + ")") + ". They are saved as they are.";
}
}

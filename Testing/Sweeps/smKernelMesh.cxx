#include "smKernelMesh.h"

#include "smOCCTMakeShape.h"
#include "smVector.h"

#include "vtkMath.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace smtest
{
using sm::ConvertedFace;
using sm::NURBSSurface;
using sm::ParameterMap;

namespace
{
/// Native parameter of a mesh node to ours; a node beyond the domain comes back by whole periods.
double MapParameter(const ConvertedFace& face, int direction, double native)
{
  const ParameterMap& map = face.Map[direction];
  const NURBSSurface& surface = face.Result->Surface;
  const bool bent = map.Type != ParameterMap::Kind::Identity;
  const double low = bent ? map.Start : surface.GetDomainStart(direction);
  const double high = bent ? map.GetBorder(map.Count) : surface.GetDomainEnd(direction);
  const double period = face.Period[direction];
  if (period > 0.0)
  {
    const double slack = 1e-6 * period;
    if (native < low - slack)
    {
      native += period *
        std::max(0.0,
          std::min(std::ceil((low - slack - native) / period), std::floor((high + slack - native) / period)));
    }
    else if (native > high + slack)
    {
      native -= period *
        std::max(0.0,
          std::min(std::ceil((native - high - slack) / period), std::floor((native - low + slack) / period)));
    }
  }
  return map.Evaluate(native);
}

}

KernelBody MakeKernelBody(const sm::BodyShape& body)
{
  KernelBody result;
  std::string reason;
  try
  {
    sm::MadeShapes made;
    result.Shape = sm::MakeKernelShape(body, made, result.Faces);
    return result;
  }
  catch (const Standard_Failure& failure)
  {
    reason = failure.GetMessageString();
  }
  catch (const std::runtime_error& error)
  {
    reason = error.what();
  }
  std::printf("    OpenCASCADE has no such shape: %s\n", reason.c_str());
  return {};
}

bool MeshByKernel(const TopoDS_Shape& shape, double deflection, double angle)
{
  if (shape.IsNull())
  {
    return false;
  }
  try
  {
    BRepTools::Clean(shape);
    IMeshTools_Parameters parameters;
    parameters.Deflection = deflection;
    parameters.Angle = angle;
    parameters.Relative = false;
    parameters.InParallel = false;
    parameters.MinSize = std::max(0.01 * deflection, Precision::Confusion());
    BRepMesh_IncrementalMesh(shape, parameters);
    return true;
  }
  catch (const Standard_Failure&)
  {
    return false;
  }
}

std::vector<sm::FaceMesh> GetKernelMeshes(
  const sm::ConvertedBody& body, const KernelBody& kernel, const double origin[3], double deflection)
{
  std::vector<sm::FaceMesh> meshes(body.Faces.size());
  for (std::size_t f = 0; f < body.Faces.size(); ++f)
  {
    const ConvertedFace& face = body.Faces[f];
    meshes[f].Deviation = deflection;
    meshes[f].NormalTurn = vtkMath::Pi();
    const auto made = kernel.Faces.find(face.Source);
    if (made == kernel.Faces.end())
    {
      continue;
    }
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles =
      BRep_Tool::Triangulation(TopoDS::Face(made->second), location);
    if (triangles.IsNull() || !triangles->HasUVNodes())
    {
      continue;
    }
    const sm::AffineMap map = sm::AffineMap::Make(location.Transformation(), 1.0, origin);
    for (int i = 1; i <= triangles->NbNodes(); ++i)
    {
      const gp_Pnt2d uv = triangles->UVNode(i);
      meshes[f].Points.push_back(map.MapPoint(triangles->Node(i).XYZ()));
      meshes[f].Parameters.push_back({ MapParameter(face, 0, uv.X()), MapParameter(face, 1, uv.Y()) });
    }
    for (int i = 1; i <= triangles->NbTriangles(); ++i)
    {
      std::array<int, 3> t;
      triangles->Triangle(i).Get(t[0], t[1], t[2]);
      if (face.Result->Reversed)
      {
        std::swap(t[1], t[2]);
      }
      meshes[f].Triangles.push_back({ t[0] - 1, t[1] - 1, t[2] - 1 });
    }
  }
  return meshes;
}
}

/**
 * @file smOCCTBody.h
 * @brief One solid or shell of OpenCASCADE as faces, coedges and edges of a trimmed NURBS model
 */
#ifndef smOCCTBody_h
#define smOCCTBody_h

#include "smFace.h"
#include "smOCCTFileSurface.h"
#include "smOCCTLoop.h"
#include "smProgressCallback.h"
#include "smReadersSTEPModule.h"

#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace sm
{
/// Data of the file about a shape other than its geometry; the key of a ShapeTable is the shape's TShape.
struct ShapeInfo
{
  /// Keeps the shape: another one that got its address would get its data.
  Handle(TopoDS_TShape) Owner;
  int FileId = 0;
  std::string Name;
  Vector3 Color{ -1.0, -1.0, -1.0 };
  /// True for a shell that the file declares as a solid; OpenCASCADE makes no solid of a shell that is not
  /// closed.
  bool OpenSolid = false;
  /// True if the shape is a face for which the file has bounds.
  bool Bounded = false;
  /// The completed loops (smOCCTCompleteLoops.h) of a face that OpenCASCADE has not repaired; null for other
  /// shapes.
  std::shared_ptr<const DraftFace> AsInFile;
  /// The surface of a face in the file, if OpenCASCADE changed it.
  FileSurface OwnSurface;
  /// Number of faces that a shell has in the file but not in OpenCASCADE's shape.
  int LostFaces = 0;
};
using ShapeTable = std::unordered_map<const TopoDS_TShape*, ShapeInfo>;

/// Returns the data of a shape; empty ones are added if it has none.
inline ShapeInfo& AddShapeInfo(ShapeTable& table, const TopoDS_Shape& shape)
{
  ShapeInfo& info = table[shape.TShape().get()];
  info.Owner = shape.TShape();
  return info;
}

/// Returns true if OpenCASCADE has not repaired a solid or shell, or only some of its faces.
SMREADERSSTEP_EXPORT bool IsAsInFile(const TopoDS_Shape& shape, const ShapeTable& table);

struct ConvertedFace
{
  FacePointer Result;
  /// The OpenCASCADE face, with forward orientation, and the maps from its parameters to ours.
  TopoDS_Face Source;
  /// The OpenCASCADE edge of each coedge, with its orientation in the loop; null for an added pole or seam.
  std::vector<std::vector<TopoDS_Edge>> SourceEdges;
  ParameterMap Map[2];
  double Period[2] = { 0.0, 0.0 };
  /// Number of defects of this face, see vtkTrimmedNURBSModel::SetNumberOfDefects().
  int Defects = 0;
  /// Numbers of coedges whose 2D curve was parametrised differently from the edge's 3D curve: corrected ones,
  /// and uncorrected ones (smCommonParameter.h).
  int RestoredCoedges = 0;
  int LaggingCoedges = 0;
};

struct ConvertedBody
{
  std::vector<ConvertedFace> Faces;
  /// Lists of indices into Faces.
  std::vector<std::vector<int>> Shells;
  std::vector<std::string> Messages;
  /// Number of faces that were left out; Messages names them.
  int MissingFaces = 0;
  /// See vtkTrimmedNURBSModel::SetNumberOfDefects(); Messages names the places.
  int Defects = 0;
  /// True if `progress` stopped the conversion; all other members are empty then.
  bool Aborted = false;
};

/**
 * Converts all faces of `shape` (its own location included). `trsf` and then `unit` apply before `origin` is
 * subtracted. A face whose conversion fails is reported and left out; all others are kept. Edges and faces
 * are converted in parallel by vtkSMPTools. `progress`, if not empty, gets a fraction in [0,1] on the calling
 * thread, and returns false to stop. `roundings`: number of roundings of a coordinate in OpenCASCADE's
 * conversion of the file's length unit to mm.
 */
SMREADERSSTEP_EXPORT ConvertedBody ConvertBody(const TopoDS_Shape& shape, const gp_Trsf& trsf, double unit,
  const double origin[3], const ShapeTable& table, const ProgressCallback& progress = {}, int roundings = 0);
}

#endif

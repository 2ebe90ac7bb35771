/**
 * @file smOCCTBody.h
 * @brief One solid or shell of OpenCASCADE as faces, coedges and edges of a trimmed NURBS model
 */
#ifndef smOCCTBody_h
#define smOCCTBody_h

#include "smFace.h"
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
/// Data of the file about a shape besides its geometry; a ShapeTable is keyed by the shape's TShape.
struct ShapeInfo
{
  int FileId = 0;
  std::string Name;
  Vector3 Color{ -1.0, -1.0, -1.0 };
  /// A shell that the file calls a solid; OpenCASCADE makes no solid of one that is not closed.
  bool OpenSolid = false;
  /// The shape is a face that the file bounds by edges.
  bool Bounded = false;
  /// The shape is a face that OpenCASCADE has not repaired: its loops are those of the file, and here they are complete
  /// (smOCCTCompleteLoops.h).
  std::shared_ptr<const DraftFace> AsInFile;
  /// Faces that a shell has in the file but not in OpenCASCADE's shape.
  int LostFaces = 0;
  /// The shape is a solid or shell of which an instance lost its scale or its mirror.
  bool Misplaced = false;
};
using ShapeTable = std::unordered_map<const TopoDS_TShape*, ShapeInfo>;

/// OpenCASCADE has not repaired the faces of a solid or shell.
SMREADERSSTEP_EXPORT bool IsAsInFile(const TopoDS_Shape& shape, const ShapeTable& table);

struct ConvertedFace
{
  FacePointer Result;
  /// The face it was made from, forward, and how its native parameters become ours.
  TopoDS_Face Source;
  /// The edge behind each coedge, as the loop uses it; null where the file has none.
  std::vector<std::vector<TopoDS_Edge>> SourceEdges;
  ParameterMap Map[2];
  double Period[2] = { 0.0, 0.0 };
  /// As vtkTrimmedNURBSModel::GetNumberOfDefects, of this face.
  int Defects = 0;
  /// Coedges whose 2D curve was parametrised differently from the edge's 3D curve: corrected, and not corrected (smCommonParameter.h).
  int RestoredCoedges = 0;
  int LaggingCoedges = 0;
};

struct ConvertedBody
{
  std::vector<ConvertedFace> Faces;
  /// Lists of indices into Faces.
  std::vector<std::vector<int>> Shells;
  std::vector<std::string> Messages;
  /// Faces left out; Messages names them.
  int MissingFaces = 0;
  /// As vtkTrimmedNURBSModel::GetNumberOfDefects; Messages names them.
  int Defects = 0;
  /// `progress` said to stop; the rest is empty.
  bool Aborted = false;
};

/**
 * Converts all faces of `shape` (its own location included). `trsf` and then `unit` apply before `origin` is
 * subtracted. A face that fails is reported and left out; nothing else is lost. Edges and faces are converted
 * by vtkSMPTools with whatever backend the application chose. `progress`, where there is one, gets a fraction in
 * [0,1] now and then, on the calling thread, and answers false to stop. `roundings`: how often the kernel rounded a coordinate when it
 * converted the file's length unit to mm.
 */
SMREADERSSTEP_EXPORT ConvertedBody ConvertBody(const TopoDS_Shape& shape, const gp_Trsf& trsf, double unit,
  const double origin[3], const ShapeTable& table, const ProgressCallback& progress = {}, int roundings = 0);
}

#endif

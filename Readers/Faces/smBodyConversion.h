/**
 * @file smBodyConversion.h
 * @brief One solid or shell of a file as faces, coedges and edges of a trimmed NURBS model
 */
#ifndef smBodyConversion_h
#define smBodyConversion_h

#include "Loops/smDraftFace.h"
#include "smFace.h"
#include "smProgressCallback.h"

#include <string>
#include <vector>

namespace sm
{
/// Returns true if a body was not repaired, or only some of its faces.
SMREADERSFACES_EXPORT bool IsAsInFile(const BodyShape& body);

struct ConvertedFace
{
  FacePointer Result;
  /// The face of the file, and the maps from its parameters to ours.
  const FaceShape* Source = nullptr;
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
 * Converts all faces of a body. `scale` and then `unit` apply before `origin` is subtracted. A face whose
 * conversion fails is reported and left out; all others are kept. Edges and faces are converted in parallel
 * by vtkSMPTools. `progress`, if not empty, gets a fraction in [0,1] on the calling thread, and returns false
 * to stop. `roundings`: number of roundings of a coordinate in the conversion of the file's length unit to
 * mm. `moved`: what NURBSSurface::Rounding has in addition, in model units.
 */
SMREADERSFACES_EXPORT ConvertedBody ConvertBody(const BodyShape& body, const Placement& scale, double unit,
  const double origin[3], const ProgressCallback& progress = {}, int roundings = 0,
  const Vector3& moved = {});
}

#endif

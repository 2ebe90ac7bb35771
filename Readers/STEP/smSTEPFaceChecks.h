/**
 * @file smSTEPFaceChecks.h
 * @brief Checks the faces of a converted body against the statements of its file
 */
#ifndef smSTEPFaceChecks_h
#define smSTEPFaceChecks_h

#include "smBodyCheck.h"
#include "smBodyConversion.h"

#include <vector>

namespace sm
{
/// What is known of a body besides its faces.
struct CheckedBody
{
  StatementPlace Place;
  bool IsSolid = true;
  /// Its volume in the unit of the model by a mesh, below 0 if its normals point inwards, 0 if that is not
  /// certain; NaN if there is no mesh.
  double Volume = 0.0;
  /// Area of the mesh of each face in the unit of the model; empty if there is no mesh.
  std::vector<double> Areas;
};

/// Adds a defect and a message for each face that contradicts its statement (smFaceCheck.h), and for
/// contradictions between faces (smBodyCheck.h). Faces of the body with one number are parts of one face of
/// the file. Faces are checked in parallel.
void CheckFaces(const FaceStatements& statements, const CheckedBody& checked, ConvertedBody& body);
}

#endif

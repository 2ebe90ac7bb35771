/**
 * @file smSTEPFaceChecks.h
 * @brief Checks the faces of a converted body against the statements of its file
 */
#ifndef smSTEPFaceChecks_h
#define smSTEPFaceChecks_h

#include "smFaceCheck.h"
#include "smOCCTBody.h"

namespace sm
{
/// Adds a defect and a message for each face that contradicts its statement (smFaceCheck.h). Faces of the
/// body with one number are parts of one face of the file. Faces are checked in parallel.
void CheckFaces(const FaceStatements& statements, const StatementPlace& place, ConvertedBody& body);
}

#endif

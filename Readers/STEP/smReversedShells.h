/**
 * @file smReversedShells.h
 * @brief Solids and shells that are inside out in a STEP file and that were reversed
 */
#ifndef smReversedShells_h
#define smReversedShells_h

#include "smDocument.h"
#include "smRepair.h"

namespace sm
{
/**
 * Adds a message about solids that were inside out as a whole: they are the same solids with all normals
 * outwards. If a repair reversed some shells of a solid and left others, and the file has them as parts of
 * one shell, for example a box within a box whose normals both point outwards, nothing says which is meant:
 * that is a defect of the document. Shells that the file has as such it calls outer ones or voids, and a
 * message is enough. Faces of one shell that disagree are a reason for the repair, which its message names.
 */
void ReportReversedShells(const RepairLog& log, Document& document);
}

#endif

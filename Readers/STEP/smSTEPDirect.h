/**
 * @file smSTEPDirect.h
 * @brief Reads a STEP file without OpenCASCADE's STEP reader: from its entities to the document
 */
#ifndef smSTEPDirect_h
#define smSTEPDirect_h

#include "smOCCTDocument.h"
#include "smOCCTRepair.h"
#include "smPart21File.h"
#include "smSTEPCensus.h"

#include <string>

namespace sm
{
/**
 * Fills in units, bodies, instances and products of a document, and the table of its shapes, from the
 * entities of a file. Returns the reason why that is not possible, and then leaves the document as it was: an
 * entity that is not converted, or a structure that is not read yet. Sound bodies are not repaired
 * (RepairOnNeed); the others are, by OpenCASCADE. Hold a KernelSession, with the objects that filter its
 * repairs. `isAborted` is set if `progress` returned false.
 */
std::string ReadSTEPDirectly(const Part21File& file, const STEPCensus& census, RepairMode repair,
  const ProgressCallback& progress, Document& document, RepairLog& log, bool& isAborted);
}

#endif

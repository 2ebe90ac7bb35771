/**
 * @file smSTEPDirect.h
 * @brief Reads a STEP file: from its entities to the document
 */
#ifndef smSTEPDirect_h
#define smSTEPDirect_h

#include "smDocument.h"
#include "smPart21File.h"
#include "smRepair.h"
#include "smSTEPCensus.h"

#include <string>

namespace sm
{
/**
 * Fills in units, bodies, instances and products of a document from the entities of a file. Faces and
 * instances that are not converted are left out and reported. Sound bodies are not repaired unless `repair`
 * is Always; the others are, by OpenCASCADE (smKernel.h). `hidden` bodies are read and marked in any mode.
 * What contradicts itself becomes a problem of the census. Returns false if `progress` returned false.
 */
bool ReadSTEPDirectly(const Part21File& file, STEPCensus& census, RepairMode repair, HiddenMode hidden,
  const ProgressCallback& progress, Document& document, RepairLog& log);
}

#endif

/**
 * @file smSTEPReconciliation.h
 * @brief Compares the shapes that were made of a STEP file with the census of the file
 */
#ifndef smSTEPReconciliation_h
#define smSTEPReconciliation_h

#include "smDocument.h"
#include "smSTEPCensus.h"

namespace sm
{
/**
 * Accounts for every solid of the census with its faces and instances: a missing face is added to
 * PartBody::LostFaces, and a missing body or instance becomes a defect of the document. Contradictions that
 * the census found become defects of the document, and a missing unit a message. The bodies and instances of
 * the document must be complete.
 */
void Reconcile(const STEPCensus& census, Document& document);

/// Returns the number of nodes of the expanded product tree: instances of bodies with faces, and of the
/// products and representations above them.
CensusCount CountDeclaredInstances(const STEPCensus& census);
}

#endif

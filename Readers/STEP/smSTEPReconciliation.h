/**
 * @file smSTEPReconciliation.h
 * @brief Compares what OpenCASCADE made of a STEP file with what the file declares
 */
#ifndef smSTEPReconciliation_h
#define smSTEPReconciliation_h

#include "smOCCTDocument.h"
#include "smSTEPCensus.h"

namespace sm
{
/**
 * Accounts for every solid of the census and its faces and instances: what the document lacks becomes a lost face of the body
 * (PartBody::LostFaces) or, where there is no body, a defect of the document. Contradictions that the census found become defects of
 * the document, and a unit that is not stated a message. The document has its bodies and instances.
 */
void Reconcile(const STEPCensus& census, Document& document);

/// Number of nodes of the expanded product tree: instances of bodies with faces, and of the products and representations above them.
CensusCount CountDeclaredInstances(const STEPCensus& census);
}

#endif

/**
 * @file smOCCTProducts.h
 * @brief The tree of products of an XCAF document, with their bodies and placements
 */
#ifndef smOCCTProducts_h
#define smOCCTProducts_h

#include "smOCCTDocument.h"

#include <TDocStd_Document.hxx>

namespace sm
{
/// Adds the products of `xde` to the root of the document. The table of the document must have the data of
/// the shapes. Faces outside of solids become bodies only if the file has no solids; else they are counted.
SMREADERSSTEP_EXPORT void AddProducts(const Handle(TDocStd_Document) & xde, Document& document);
}

#endif

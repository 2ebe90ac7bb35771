/**
 * @file smOCCTProducts.h
 * @brief The tree of products of an XCAF document, with their bodies and where these are placed
 */
#ifndef smOCCTProducts_h
#define smOCCTProducts_h

#include "smOCCTDocument.h"

#include <TDocStd_Document.hxx>

namespace sm
{
/// Adds the products of `xde` to the root of the document, whose table has what the file says of their shapes. Faces that no solid has are
/// bodies only where the file has no solids; else they are counted.
SMREADERSSTEP_EXPORT void AddProducts(const Handle(TDocStd_Document) & xde, Document& document);
}

#endif

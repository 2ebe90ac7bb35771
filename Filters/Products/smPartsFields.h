/**
 * @file smPartsFields.h
 * @brief The members of a parts list; not installed
 */
#ifndef smPartsFields_h
#define smPartsFields_h

#include "smFields.h"
#include "smFiltersProductsModule.h"
#include "smPartsList.h"

namespace sm
{
/// Visits an entry with its children.
SMFILTERSPRODUCTS_EXPORT void VisitPart(Fields& fields, PartsListEntry& part);
}

#endif

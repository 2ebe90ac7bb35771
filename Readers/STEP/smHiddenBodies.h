/**
 * @file smHiddenBodies.h
 * @brief Bodies that a STEP file hides (INVISIBILITY), counted or left out
 */
#ifndef smHiddenBodies_h
#define smHiddenBodies_h

#include "smDocument.h"

namespace sm
{
/**
 * Removes instances from a complete document: those that are hidden, or with HiddenMode::Only the others, the
 * bodies that have no instance then, and the products that have none. A message has the number and the names.
 * If nothing is left, the document is empty, and Problem has the reason.
 */
void LeaveOutHidden(HiddenMode mode, Document& document);
}

#endif

/**
 * @file smInputBounds.h
 * @brief The bounds of a new filter's input, for defaults that depend on them
 */
#ifndef smInputBounds_h
#define smInputBounds_h

#include "vtkBoundingBox.h"

class vtkSMProxy;

namespace sm
{
/// Returns the bounds of the input. Updates the input first, so that a script gets the same defaults as the
/// window, where the input is up to date. The result is not valid without input or data.
vtkBoundingBox ComputeInputBounds(vtkSMProxy* filter);
}

#endif

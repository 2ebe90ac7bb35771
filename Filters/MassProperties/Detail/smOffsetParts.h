/**
 * @file smOffsetParts.h
 * @brief The measurements that smOffsetGeometry.h consists of
 */
#ifndef smOffsetParts_h
#define smOffsetParts_h

#include "Detail/smOffsetGeometry.h"

namespace sm
{
/// Measures the curvatures of a face, whose outward normal is that of the face alone.
OffsetFace MeasureOffsetFace(const Face& source);
}

#endif

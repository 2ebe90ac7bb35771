/**
 * @file smConvertedSurface.h
 * @brief A native surface as a rational B-spline, with the map between their parameters
 */
#ifndef smConvertedSurface_h
#define smConvertedSurface_h

#include "smNURBSSurface.h"
#include "smParameterMap.h"

namespace sm
{
struct ConvertedSurface
{
  NURBSSurface Surface;
  ParameterMap Map[2];
};

/// Range of native parameters that the trim curves of a face cover.
struct NativeBox
{
  double Low[2] = { 0.0, 0.0 };
  double High[2] = { 0.0, 0.0 };
};
}

#endif

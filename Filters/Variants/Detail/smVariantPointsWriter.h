/**
 * @file smVariantPointsWriter.h
 * @brief Writes the samples of a face for the CPU
 */
#ifndef smVariantPointsWriter_h
#define smVariantPointsWriter_h

#include "smVariantChain.h"
#include "smVariantPoints.h"

namespace sm
{
/// Returns the samples of a face and the nets that they refer to.
PointsFace WritePoints(const VariantFaceChain& chain);
}

#endif

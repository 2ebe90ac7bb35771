/**
 * @file smIntegralBytes.h
 * @brief Bitwise conversion of the integrals of a face to bytes and back
 */
#ifndef smIntegralBytes_h
#define smIntegralBytes_h

#include "Engine/smFaceIntegrals.h"
#include "smBytes.h"
#include "smFiltersSurfaceIntegralsModule.h"

namespace sm
{
SMFILTERSSURFACEINTEGRALS_EXPORT void PutIntegrals(ByteWriter& to, const FaceIntegrals& integrals);
SMFILTERSSURFACEINTEGRALS_EXPORT FaceIntegrals GetIntegrals(ByteReader& from);
}

#endif

/**
 * @file smOCCTModel.h
 * @brief Reads data of a STEP file's entities that OpenCASCADE's transfer loses: units, scales, reflections,
 * faces without a product
 */
#ifndef smOCCTModel_h
#define smOCCTModel_h

#include "smOCCTEntities.h"
#include "smReadersSTEPModule.h"
#include "smSTEPCensus.h"

#include <STEPControl_Reader.hxx>

#include <string>
#include <vector>

namespace sm
{
/// Returns the length unit of the file in its spelling ("millimetre", "INCH"); empty if it states none.
std::string ReadLengthUnit(
  STEPControl_Reader& reader, const ModelEntities& entities, std::vector<std::string>& messages);

/// Compares the units of contexts with those that OpenCASCADE takes for them, after the transfer. Each
/// difference is a defect.
SMREADERSSTEP_EXPORT void CompareUnits(const ModelEntities& entities,
  const std::vector<CensusContext>& contexts, std::vector<std::string>& defects);

/**
 * Checks the transformation operators (CARTESIAN_TRANSFORMATION_OPERATOR_3D). OpenCASCADE 7.6 ignores their
 * scale and their reflection, which is reported in `messages`. A missing local origin is set to the origin.
 * Returns the operators whose scale or reflection is lost. Call before the transfer.
 */
std::vector<Handle(Standard_Transient)> CheckOperators(
  const ModelEntities& entities, std::vector<std::string>& messages);

/**
 * Clears the flag of closed splines whose last control points or weights are not their first ones.
 * OpenCASCADE makes a curve with this flag periodic if its ends are the same point, and replaces the last
 * control points and weights by the first ones. The flag is for information only (ISO 10303-42). Call before
 * the transfer.
 */
void ClearClosedFlags(const ModelEntities& entities);

/// Returns true if the file has faces, including faces of which the transfer makes no shape.
bool HasGeometry(const ModelEntities& entities);
}

#endif

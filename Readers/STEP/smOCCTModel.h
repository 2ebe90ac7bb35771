/**
 * @file smOCCTModel.h
 * @brief Data of a STEP file's entities that OpenCASCADE's transfer loses: length unit, scales, mirrors, faces without a product
 */
#ifndef smOCCTModel_h
#define smOCCTModel_h

#include <STEPControl_Reader.hxx>
#include <StepData_StepModel.hxx>

#include <string>
#include <vector>

namespace sm
{
/// The file's own length unit as it spells it ("millimetre", "INCH"); empty when it gives none.
std::string ReadLengthUnit(
  STEPControl_Reader& reader, const Handle(StepData_StepModel) & model, std::vector<std::string>& messages);

/**
 * Transformation operators (CARTESIAN_TRANSFORMATION_OPERATOR_3D): OpenCASCADE 7.6 ignores their scale and their
 * reflection, which is reported in `messages`, and crashes on one without a local origin, which gets the
 * origin here. Returns the operators whose scale or reflection is lost. Call before the transfer.
 */
std::vector<Handle(Standard_Transient)> CheckOperators(
  const Handle(StepData_StepModel) & model, std::vector<std::string>& messages);

/// True when the file holds faces, whether or not the transfer makes a shape of them.
bool HasGeometry(const Handle(StepData_StepModel) & model);
}

#endif

/**
 * @file smOCCTModel.h
 * @brief Questions to the entities of a STEP file that OpenCASCADE's transfer answers wrongly or not at all
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
 * Transformation operators (CARTESIAN_TRANSFORMATION_OPERATOR_3D): OpenCASCADE 7.6 drops their scale and their
 * reflection without a word, which a message says here, and crashes on one without a local origin, which gets the
 * origin here. Returns those that lose something. Call before the transfer.
 */
std::vector<Handle(Standard_Transient)> CheckOperators(
  const Handle(StepData_StepModel) & model, std::vector<std::string>& messages);

/// True when the file holds faces, whether or not the transfer makes a shape of them.
bool HasGeometry(const Handle(StepData_StepModel) & model);
}

#endif

/**
 * @file smSTEPEntities.h
 * @brief Completes the STEP entities that OpenCASCADE makes: names and numbers, stated accuracy, header
 */
#ifndef smSTEPEntities_h
#define smSTEPEntities_h

#include "smExportTree.h"
#include "smOCCTExport.h"
#include "smOCCTExportParts.h"

#include <StepData_StepModel.hxx>
#include <Transfer_FinderProcess.hxx>

#include <vector>

namespace sm
{
/**
 * Bodies, faces and edges get the names and numbers that they had in the file from which they were read,
 * unless another one has the number already; all other entities get free numbers. Every part states its
 * accuracy (UNCERTAINTY_MEASURE_WITH_UNIT): the largest measured tolerance of its edges, at least 1e-7, but
 * no more than a tenth of its shortest edge.
 *
 * When OpenCASCADE reads the file, it uses the accuracy as the tolerance of all edges: trim curves farther
 * from their edge are replaced by approximations, and shorter edges are removed. Therefore there are two
 * limits.
 */
void CompleteEntities(const Handle(Transfer_FinderProcess) & process,
  const Handle(StepData_StepModel) & model, const ExportTree& tree, const std::vector<BuiltPart>& parts);

void FillHeader(const Handle(StepData_StepModel) & model, const ExportOptions& options);
}

#endif

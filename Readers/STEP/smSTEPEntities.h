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
 * Bodies, faces and edges get the names and numbers that they had in their own file, where no other took a number first; all
 * other entities get numbers that are free. Every part states its accuracy (UNCERTAINTY_MEASURE_WITH_UNIT): the largest
 * measured tolerance of its edges, at least 1e-7, but no more than a tenth of its shortest edge.
 *
 * OpenCASCADE, reading, takes the accuracy for the tolerance of all edges: it replaces trim curves that lie farther off their
 * edge by approximations of its own, and drops edges that are shorter. Hence both limits.
 */
void CompleteEntities(const Handle(Transfer_FinderProcess) & process,
  const Handle(StepData_StepModel) & model, const ExportTree& tree, const std::vector<BuiltPart>& parts);

void FillHeader(const Handle(StepData_StepModel) & model, const ExportOptions& options);
}

#endif

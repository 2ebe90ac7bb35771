/**
 * @file smPlaneCut.h
 * @brief Runs filters that cut the solids by planes
 */
#ifndef smPlaneCut_h
#define smPlaneCut_h

#include "smFileJob.h"
#include "smFilterSetUp.h"
#include "smResults.h"

#include "vtkCADReader.h"
#include "vtkPlaneCutBase.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

namespace sm
{
/// Runs the filter and calls `write` with the row and the results of the file and of each solid. If the file
/// was ok, it gets the status of the filter.
template <typename Result, typename Write>
void RunPlaneCut(const AnalysisRun& run, vtkPlaneCutBase* filter, const Write& write)
{
  SetUpFilter(filter, run.Options);
  filter->SetInputConnection(run.Reader->GetOutputPort());
  run.Update(filter);
  write(filter->GetOutput()->GetFieldData(), 0, *run.File.Analyses.Find<Result>());
  vtkFieldData* columns = vtkTable::SafeDownCast(filter->GetOutputDataObject(1))->GetRowData();
  vtkIdType row = 0;
  for (SolidResult& solid : run.File.Solids)
  {
    write(columns, row, *solid.Analyses.Find<Result>());
    ++row;
  }
  AddEffort(filter, run.File, run.Messages);
}
}

#endif

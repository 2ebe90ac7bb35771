/**
 * @file smAbortFlag.h
 * @brief Lets the abort flag of an algorithm stop one run only
 */
#ifndef smAbortFlag_h
#define smAbortFlag_h

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkNew.h>

namespace sm
{
/// Clears the abort flag of an algorithm when a run begins; call it in the constructor. VTK 9.2 leaves the
/// flag set, and an observer may set it in the executive's report of progress after a run: the next one would
/// stop at once. A flag that is set in the report before the run stops the run.
inline void ClearAbortAtStart(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> clear;
  clear->SetCallback(
    [](vtkObject* started, unsigned long, void*, void*)
    {
      // The setter calls Modified(), which within a run does not make the output outdated.
      auto* running = static_cast<vtkAlgorithm*>(started);
      if (running->GetAbortExecute())
      {
        running->SetAbortExecute(0);
      }
    });
  algorithm->AddObserver(vtkCommand::StartEvent, clear);
}
}

#endif

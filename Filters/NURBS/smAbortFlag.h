/**
 * @file smAbortFlag.h
 * @brief Ends the abort flag of an algorithm with the run that it stopped
 */
#ifndef smAbortFlag_h
#define smAbortFlag_h

#include <vtkAlgorithm.h>

namespace sm
{
/// Clears the abort flag of an algorithm at the begin and at the end of a run, which lasts as long as this object. VTK 9.2 leaves the flag
/// set, and the next run would stop at once. At the begin, because an observer may set the flag in the executive's report of progress after
/// the run.
class AbortFlag
{
public:
  explicit AbortFlag(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
    this->Clear();
  }
  ~AbortFlag() { this->Clear(); }
  AbortFlag(const AbortFlag&) = delete;
  void operator=(const AbortFlag&) = delete;

private:
  void Clear()
  {
    // The setter calls Modified(), which within a run does not make the output outdated.
    if (this->Algorithm->GetAbortExecute())
    {
      this->Algorithm->SetAbortExecute(0);
    }
  }

  vtkAlgorithm* Algorithm;
};
}

#endif

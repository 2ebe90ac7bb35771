/**
 * @file smLeaves.h
 * @brief Copies the leaves of a dataset for filters that change them; composites keep structure, names and
 * assembly
 */
#ifndef smLeaves_h
#define smLeaves_h

#include <functional>

class vtkDataObject;
class vtkPointSet;

namespace sm
{
/// `output` becomes a shallow copy of `input`, leaf by leaf; `change` is called for every copy that is a
/// point set, with its source, in order, and returns false to stop. Returns false if it was stopped, or if
/// `output` has another type than `input`. `report` gets the share of leaves that are done, from 0 to 1 and
/// never less than before, and returns false to stop, too.
bool CopyLeaves(vtkDataObject* input, vtkDataObject* output,
  const std::function<bool(vtkPointSet* source, vtkPointSet* copy)>& change,
  const std::function<bool(double share)>& report);
}

#endif

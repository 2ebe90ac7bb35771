/**
 * @file smLeaves.h
 * @brief Filters that give every leaf of their input a copy: composites keep structure, names and assembly
 */
#ifndef smLeaves_h
#define smLeaves_h

#include <functional>

class vtkDataObject;
class vtkPointSet;

namespace sm
{
/// `output` becomes a shallow copy of `input`, leaf by leaf; `change` gets every copy that is a point set and what it is a copy
/// of, in order, and returns false to stop. False when it did, or when the types do not fit. `report` gets the share of leaves that are
/// done, from 0 to 1 and never less than before, and returns false to stop, too.
bool CopyLeaves(vtkDataObject* input, vtkDataObject* output,
  const std::function<bool(vtkPointSet* source, vtkPointSet* copy)>& change,
  const std::function<bool(double share)>& report);
}

#endif

/**
 * @file smEmptyRanges.h
 * @brief Ranges of vectors and matrices of which no value is known
 */
#ifndef smEmptyRanges_h
#define smEmptyRanges_h

class vtkDataObject;

namespace sm
{
/// Marks the range of lengths of each array of several components that holds NaN alone as empty. The VTK
/// of ParaView 5.11 computes NaN for it, and a server that sends the array warns of that in the client's
/// window. Blocks of collections are left as they are: they share arrays with the input.
void MarkEmptyRanges(vtkDataObject* data);
}

#endif

/**
 * @file smTimeSteps.h
 * @brief Time steps of an edit: how much of it is applied at which time
 */
#ifndef smTimeSteps_h
#define smTimeSteps_h

class vtkInformation;

namespace sm
{
/** Declares `steps` times from 0 to 1 for an output, at equal distances; fewer than 2: leaves the times of the input. */
void DeclareTimeSteps(int steps, vtkInformation* outputInformation);

/**
 * Returns the share of the edit, from 0 to 1, at the time that is asked for, and marks the data with that time. 1 with fewer than 2 steps, and
 * where no time is asked for.
 */
double TakeTimeShare(int steps, vtkInformation* outputInformation);
}

#endif

/**
 * @file smTimeSteps.h
 * @brief Time steps of an edit, which is applied in proportion to the time
 */
#ifndef smTimeSteps_h
#define smTimeSteps_h

class vtkInformation;

namespace sm
{
/** Declares `steps` times from 0 to 1 for an output, at equal distances; fewer than 2: leaves the times of
 * the input. */
void DeclareTimeSteps(int steps, vtkInformation* outputInformation);

/**
 * Returns the fraction of the edit, from 0 to 1, at the requested time, and sets DATA_TIME_STEP of the
 * output. Returns 1 with fewer than 2 steps, or if no time is requested.
 */
double TakeTimeShare(int steps, vtkInformation* outputInformation);
}

#endif

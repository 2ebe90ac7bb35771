/**
 * @file smWrongSamples.h
 * @brief Samples that every shader multiplies by a factor, for the life of an object
 */
#ifndef smWrongSamples_h
#define smWrongSamples_h

#include "smShaderFault.h"

#include <vtkAlgorithm.h>

namespace smtest
{
class WrongSamples
{
public:
  /// `filter` runs with the factor, and after the life of the object without it.
  WrongSamples(vtkAlgorithm* filter, double factor)
    : Filter(filter)
  {
    sm::GetSampleFactor() = factor;
    this->Filter->Modified();
  }
  ~WrongSamples()
  {
    sm::GetSampleFactor() = 1.0;
    this->Filter->Modified();
  }
  WrongSamples(const WrongSamples&) = delete;
  WrongSamples& operator=(const WrongSamples&) = delete;

private:
  vtkAlgorithm* Filter;
};
}

#endif

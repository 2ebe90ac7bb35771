/**
 * @file smProcessorTime.h
 * @brief A stopwatch of the process's processor time, which other work on the machine hardly changes
 */
#ifndef smProcessorTime_h
#define smProcessorTime_h

#include <ctime>

namespace smtest
{
class ProcessorTime
{
public:
  double GetSeconds() const { return static_cast<double>(std::clock() - this->Start) / CLOCKS_PER_SEC; }

private:
  std::clock_t Start = std::clock();
};
}

#endif

/**
 * @file smRepairNotice.h
 * @brief Says when OpenCASCADE repairs a body
 */
#ifndef smRepairNotice_h
#define smRepairNotice_h

#include "smReadersSTEPModule.h"

#include <functional>

namespace sm
{
/// Sets a function that is called when a repair begins and when it has ended, so that another process knows
/// what this one was doing if it crashes. Not thread safe; empty: none.
SMREADERSSTEP_EXPORT void SetRepairObserver(std::function<void(bool isBeginning)> observer);

/// Calls the observer.
class RepairNotice
{
public:
  RepairNotice();
  ~RepairNotice();
  RepairNotice(const RepairNotice&) = delete;
  void operator=(const RepairNotice&) = delete;
};
}

#endif

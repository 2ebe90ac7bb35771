#include "smStatus.h"

#include "smIntegralNames.h"

namespace sm
{
const char* GetText(Status status)
{
  switch (status)
  {
    case Status::None:
      return "";
    case Status::Ok:
      return names::StatusOk;
    case Status::ToleranceNotMet:
      return names::StatusToleranceNotMet;
    case Status::Suspect:
      return names::StatusSuspect;
    case Status::Open:
      return names::StatusOpen;
    case Status::NotComputed:
      return names::StatusNotComputed;
    case Status::Empty:
      return names::StatusEmpty;
    case Status::Unreadable:
      return names::StatusUnreadable;
  }
  return "";
}
}

/**
 * @file smTestRanks.h
 * @brief Several ranks in a test: the controller of all, a watchdog, and the end of the program
 */
#ifndef smTestRanks_h
#define smTestRanks_h

#include "smTesting.h"

#include <vtkMPIController.h>
#include <vtkNew.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <unistd.h>

namespace smtest
{
inline vtkMultiProcessController* controller = nullptr;
inline int rank = 0;
inline int ranks = 1;

/// Ends the process, and mpirun all others, if a run takes so long that its rank must be waiting for another
/// one.
class Watchdog
{
public:
  explicit Watchdog(const std::string& what)
  {
    std::snprintf(Text, sizeof(Text), "rank %d waits for ever: %s\n", rank, what.c_str());
    std::signal(SIGALRM, OnAlarm);
    alarm(60);
  }
  ~Watchdog() { alarm(0); }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

private:
  static void OnAlarm(int)
  {
    const ssize_t written = write(STDERR_FILENO, Text, std::strlen(Text));
    _exit(written > 0 ? 1 : 2);
  }
  static inline char Text[200];
};

/// Runs the checks on all ranks, with the global controller of MPI, and returns the exit status.
template <typename Checks>
int RunOnRanks(int& argc, char**& argv, const Checks& checks)
{
  vtkNew<vtkMPIController> mpi;
  mpi->Initialize(&argc, &argv);
  controller = mpi;
  vtkMultiProcessController::SetGlobalController(mpi);
  rank = mpi->GetLocalProcessId();
  ranks = mpi->GetNumberOfProcesses();
  CheckTrue("there are other ranks", ranks > 1, std::to_string(ranks));
  checks();
  vtkMultiProcessController::SetGlobalController(nullptr);
  const int status = Finish();
  mpi->Finalize();
  return status;
}
}

#endif

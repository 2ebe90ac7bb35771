// TestRankFailures FILE, under mpirun: all ranks run together, and an allocation fails on one of them, in
// every run another one. The run ends on all ranks, with a status. If the rank that fails is not the one that
// has the bodies, the others compute its share. The next run has the bits of an undisturbed one.
#include "smShortFilter.h"
#include "smTestRanks.h"

#include <vtkSMPTools.h>

#include <cstdio>

namespace
{
using namespace smtest;
namespace names = sm::names;

template <class Filter>
struct Subject
{
  vtkNew<vtkSTEPReader> Reader;
  vtkNew<ShortFilter<Filter>> Probe;
  MessageTrap Trap{ Probe };
  std::vector<double> Undisturbed;
  std::string Status;
  /// Number of ranks that integrate faces.
  int Sharing = 0;

  explicit Subject(const std::string& path)
  {
    this->Reader->SetFileName(path.c_str());
    UseCoarseMesh(this->Reader);
    this->Probe->SetInputConnection(this->Reader->GetOutputPort());
    this->Probe->SetBackend(vtkSurfaceIntegralBase::CPU);
    this->Probe->SetController(controller);
    SetUp(this->Probe);
    this->Run("the first run", 0);
    this->Undisturbed = this->GetNumbers();
    this->Sharing = this->Probe->GetNumberOfRanks();
    this->Status = this->Probe->GetStatus();
    CheckTrue("it has values", rank != 0 || this->Undisturbed.size() > 2, this->Status);
  }
  void Run(const std::string& what, long failing)
  {
    const Watchdog watchdog(what);
    this->Probe->Memory.Failing = failing;
    this->Probe->Modified();
    this->Probe->UpdatePiece(rank, ranks, 0);
    CheckTrue(what + ": no exception leaves it", !this->Probe->Memory.HasEscaped);
    controller->Barrier();
  }
  /// All values, apart from the number of ranks that integrated faces.
  std::vector<double> GetNumbers() const
  {
    vtkNew<vtkFieldData> fields;
    fields->ShallowCopy(this->Probe->GetOutput()->GetFieldData());
    fields->RemoveArray(names::Ranks);
    return GetFieldNumbers(fields);
  }
  bool IsWhole() const
  {
    const std::vector<double> numbers = this->GetNumbers();
    return this->Probe->GetStatus() == this->Status && numbers.size() == this->Undisturbed.size() &&
      (numbers.empty() ||
        std::memcmp(numbers.data(), this->Undisturbed.data(), numbers.size() * sizeof(double)) == 0);
  }
  /// A run of all in which the rank `who` is short of memory, and one in which none is. Returns true if some
  /// rank reported it.
  bool CheckShortage(const std::string& what, int who, long allocation)
  {
    this->Probe->ReleaseMemory();
    this->Run(what, rank == who ? allocation : 0);
    const bool isWhole = this->IsWhole();
    const std::string status = this->Probe->GetStatus();
    const bool mayFail = rank == who;
    CheckTrue(what + ": values and status", isWhole || (mayFail && status == names::StatusNotComputed),
      status + ", " + GetMessages(this->Probe));
    CheckTrue(what + ": it says why", isWhole || Says(this->Probe, "memory"), GetMessages(this->Probe));
    int told = Says(this->Probe, "memory") ? 1 : 0;
    int toldAnywhere = 0;
    controller->AllReduce(&told, &toldAnywhere, 1, vtkCommunicator::MAX_OP);
    this->Run(what + ", then again", 0);
    CheckTrue(what + ": then the bits of an undisturbed run, by as many ranks",
      this->IsWhole() && this->Probe->GetNumberOfRanks() == this->Sharing,
      this->Probe->GetStatus() + ", " + GetMessages(this->Probe));
    return toldAnywhere != 0;
  }
};

template <class Filter>
void CheckFailures(const std::string& name, const std::string& path, long ends, long between)
{
  Subject<Filter> subject(path);
  for (const int who : { 0, ranks - 1 })
  {
    subject.Probe->ReleaseMemory();
    subject.Run(name, 0);
    long count = subject.Probe->Memory.Allocations;
    controller->Broadcast(&count, 1, who);
    int told = 0;
    const std::set<long> chosen = ChooseAllocations(count, ends, between);
    for (const long allocation : chosen)
    {
      char what[120];
      std::snprintf(
        what, sizeof(what), "%s, rank %d: allocation %ld of %ld fails", name.c_str(), who, allocation, count);
      told += subject.CheckShortage(what, who, allocation) ? 1 : 0;
    }
    CheckRange(name + ", rank " + std::to_string(who) + ": runs that were disturbed",
      static_cast<double>(chosen.size()) / 2.0, told, static_cast<double>(chosen.size()));
  }
}
}

int main(int argc, char* argv[])
{
  const auto checks = [&]()
  {
    const std::string path = argc > 1 ? argv[1] : "";
    // Exceptions of other threads end the process.
    vtkSMPTools::SetBackend("Sequential");
    CheckFailures<vtkMassPropertiesGPU>("mass properties", path, 20, 20);
    CheckFailures<vtkSurfaceIntegralGPU>("integrals", path, 5, 15);
#ifdef HAS_BUOYANCY
    CheckFailures<vtkBuoyancy>("buoyancy", path, 5, 5);
#endif
  };
  return RunOnRanks(argc, argv, checks);
}

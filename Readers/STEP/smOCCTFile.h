/**
 * @file smOCCTFile.h
 * @brief Bytes of a file and checks before OpenCASCADE reads them; OpenCASCADE's global settings and its progress
 */
#ifndef smOCCTFile_h
#define smOCCTFile_h

#include "smProgressCallback.h"
#include "smReadersSTEPModule.h"

#include <Message_ProgressIndicator.hxx>
#include <Message_SequenceOfPrinters.hxx>
#include <TDocStd_Document.hxx>

#include <atomic>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>

namespace sm
{
/// Reads all bytes of a file, or the problem with its remedy when it cannot be opened or is empty. `progress` is asked now and then; false
/// when it answers false.
bool LoadFile(
  const std::string& name, const std::function<bool()>& progress, std::string& bytes, std::string& problem);

/// Result of a look at the first and last bytes of a STEP file.
struct FileCheck
{
  bool Readable = false;
  /// Why it is not readable, and what to do about it.
  std::string Problem;
  /// Bytes before "ISO-10303-21;" that are neither blanks nor comments.
  std::size_t JunkBytes = 0;
  /// The file does not end with END-ISO-10303-21.
  bool Truncated = false;
};
SMREADERSSTEP_EXPORT FileCheck CheckText(std::string_view text);

/// The first 64 KiB of a file, in which the header of its format stands; fewer where there are no more.
SMREADERSSTEP_EXPORT std::string LoadHead(const std::string& name);

/// True when the file begins like a STEP file; cheap.
bool LooksLikeSTEP(const std::string& name);

/// Sets parameters of OpenCASCADE, which belong to the process, and puts them back when it goes. One that this version does not know
/// is left out.
class SMREADERSSTEP_EXPORT KernelSettings
{
public:
  KernelSettings() = default;
  ~KernelSettings();
  KernelSettings(const KernelSettings&) = delete;
  void operator=(const KernelSettings&) = delete;

  void Set(const char* name, const char* value);

private:
  std::map<std::string, std::string> Before;
};

/**
 * A lock on OpenCASCADE, whose parameters and messenger are global. While a session exists, its messenger prints nothing and
 * lengths arrive in mm, and tessellations are not read. The session of another thread waits; a session inside one of the same thread
 * changes nothing.
 */
class SMREADERSSTEP_EXPORT KernelSession
{
public:
  KernelSession();
  ~KernelSession();
  KernelSession(const KernelSession&) = delete;
  void operator=(const KernelSession&) = delete;

  /// This thread has a session: an observer of a reader's progress asks another one to read.
  static bool IsHeldHere();

private:
  std::unique_lock<std::mutex> Lock;
  Message_SequenceOfPrinters Printers;
  KernelSettings Settings;
};

/// Lengths of the document are in mm; OpenCASCADE looks at the process's settings only where a document has no unit.
SMREADERSSTEP_EXPORT void SetMillimetres(const Handle(TDocStd_Document) & document);

/// CPU time of this thread in seconds. A limit in CPU time does not depend on the load of the machine, so that a file gives the same
/// bits on a busy one.
double GetThreadSeconds();

/// OpenCASCADE's progress as a call of `progress` with a fraction in [0,1]; progress answers false to stop. It also
/// stops after so many seconds of this thread's; 0: never.
class SMREADERSSTEP_EXPORT KernelProgress : public Message_ProgressIndicator
{
  DEFINE_STANDARD_RTTI_INLINE(KernelProgress, Message_ProgressIndicator)
public:
  explicit KernelProgress(ProgressCallback progress, double seconds = 0.0);

  bool IsTimedOut() const { return this->TimedOut; }

  /// Throws what `progress` threw: OpenCASCADE reports from destructors, which no exception may leave, and is stopped instead. Call
  /// when it has returned.
  void Rethrow() const;

protected:
  Standard_Boolean UserBreak() override;
  void Show(const Message_ProgressScope& scope, const Standard_Boolean force) override;

private:
  ProgressCallback Report;
  double Last = -1.0;
  bool Limited;
  double Deadline;
  std::atomic<bool> Stopped{ false };
  std::atomic<bool> TimedOut{ false };
  std::exception_ptr Thrown;
};
}

#endif

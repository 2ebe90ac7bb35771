/**
 * @file smOCCTFile.h
 * @brief Loads files and checks them before OpenCASCADE reads them; OpenCASCADE's global settings and its
 * progress
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
/// Reads all bytes of a file. Sets `problem`, with a remedy, if it cannot be opened or is empty. Returns
/// false if `progress`, which is called repeatedly, returned false.
bool LoadFile(
  const std::string& name, const std::function<bool()>& progress, std::string& bytes, std::string& problem);

/// Result of the check of the first and last bytes of a STEP file.
struct FileCheck
{
  bool Readable = false;
  /// The reason why it is not readable, with a remedy; empty if it may be.
  std::string Problem;
  /// Bytes before "ISO-10303-21;" that are neither blanks nor comments.
  std::size_t JunkBytes = 0;
  /// True if the file does not end with END-ISO-10303-21.
  bool Truncated = false;
};
SMREADERSSTEP_EXPORT FileCheck CheckText(std::string_view text);

/// Returns the first 64 KiB of a file, or fewer if it is shorter, in which the header of its format is.
SMREADERSSTEP_EXPORT std::string LoadHead(const std::string& name);

/// Returns true if the file begins like a STEP file; reads only its beginning.
bool LooksLikeSTEP(const std::string& name);

/// Sets parameters of OpenCASCADE, which are global in the process, and restores them in the destructor.
/// Parameters that this version does not know are ignored.
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
 * A lock on OpenCASCADE, whose parameters and messenger are global. During a session OpenCASCADE prints
 * nothing, lengths are converted to mm, and tessellations are not read. The session of another thread waits;
 * a nested session of the same thread has no effect.
 */
class SMREADERSSTEP_EXPORT KernelSession
{
public:
  KernelSession();
  ~KernelSession();
  KernelSession(const KernelSession&) = delete;
  void operator=(const KernelSession&) = delete;

  /// Returns true if this thread has a session, for example if an observer of a reader's progress updates
  /// another reader.
  static bool IsHeldHere();

private:
  std::unique_lock<std::mutex> Lock;
  Message_SequenceOfPrinters Printers;
  KernelSettings Settings;
};

/// States that the lengths of a document are in mm. OpenCASCADE uses the settings of the process only for a
/// document without a unit.
SMREADERSSTEP_EXPORT void SetMillimetres(const Handle(TDocStd_Document) & document);

/// Returns the CPU time of this thread in seconds. A limit in CPU time does not depend on the load of the
/// machine, so that results are the same on a busy one.
double GetThreadSeconds();

/// Forwards OpenCASCADE's progress to `progress`, as a fraction in [0,1]; if that returns false, OpenCASCADE
/// is asked to stop. It is also asked to stop after `seconds` of CPU time of this thread; 0: no limit.
class SMREADERSSTEP_EXPORT KernelProgress : public Message_ProgressIndicator
{
  DEFINE_STANDARD_RTTI_INLINE(KernelProgress, Message_ProgressIndicator)
public:
  explicit KernelProgress(ProgressCallback progress, double seconds = 0.0);

  bool IsTimedOut() const { return this->TimedOut; }

  /// Rethrows an exception of `progress`. OpenCASCADE reports progress from destructors, which must not
  /// throw, so the exception is stored and OpenCASCADE is asked to stop. Call this after OpenCASCADE has
  /// returned.
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

/**
 * @file smOCCTFile.h
 * @brief OpenCASCADE's global settings and its progress
 */
#ifndef smOCCTFile_h
#define smOCCTFile_h

#include "smProgressCallback.h"
#include "smReadersKernelModule.h"

#include <Message_ProgressIndicator.hxx>
#include <Message_SequenceOfPrinters.hxx>
#include <TDocStd_Document.hxx>

#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <string>

namespace sm
{
/// Sets parameters of OpenCASCADE, which are global in the process, and restores them in the destructor.
/// Parameters that this version does not know are ignored.
class SMREADERSKERNEL_EXPORT KernelSettings
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
 * nothing, and lengths are converted to mm. The session of another thread waits;
 * a nested session of the same thread has no effect.
 */
class SMREADERSKERNEL_EXPORT KernelSession
{
public:
  KernelSession();
  ~KernelSession();
  KernelSession(const KernelSession&) = delete;
  void operator=(const KernelSession&) = delete;

  /// Returns true if this thread has a session.
  static bool IsHeldHere();

private:
  std::unique_lock<std::mutex> Lock;
  Message_SequenceOfPrinters Printers;
  KernelSettings Settings;
};

/// States that the lengths of a document are in mm. OpenCASCADE uses the settings of the process only for a
/// document without a unit.
void SetMillimetres(const Handle(TDocStd_Document) & document);

/// Forwards OpenCASCADE's progress to `progress`, as a fraction in [0,1]; if that returns false, OpenCASCADE
/// is asked to stop.
class KernelProgress : public Message_ProgressIndicator
{
  DEFINE_STANDARD_RTTI_INLINE(KernelProgress, Message_ProgressIndicator)
public:
  explicit KernelProgress(ProgressCallback progress);

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
  std::atomic<bool> Stopped{ false };
  std::exception_ptr Thrown;
};
}

#endif

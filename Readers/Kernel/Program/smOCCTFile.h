/**
 * @file smOCCTFile.h
 * @brief OpenCASCADE's global settings and its progress
 */
#ifndef smOCCTFile_h
#define smOCCTFile_h

#include "smProgressCallback.h"

#include <Message_ProgressIndicator.hxx>
#include <TDocStd_Document.hxx>

#include <atomic>
#include <exception>

namespace sm
{
/// Sets a parameter of OpenCASCADE, which is global in the process. One that this version does not know is
/// ignored.
void SetKernelParameter(const char* name, const char* value);

/// Sets OpenCASCADE up for the process: it prints nothing, and lengths are converted to mm.
void SetUpKernel();

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

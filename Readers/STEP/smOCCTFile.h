/**
 * @file smOCCTFile.h
 * @brief What must be known of a STEP file before OpenCASCADE sees it, and how to keep OpenCASCADE quiet
 */
#ifndef smOCCTFile_h
#define smOCCTFile_h

#include <Message_ProgressIndicator.hxx>
#include <Message_SequenceOfPrinters.hxx>
#include <TCollection_AsciiString.hxx>

#include <atomic>
#include <functional>
#include <string>

namespace sm
{
/// Result of a look at the first and last bytes.
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
FileCheck CheckFile(const std::string& name);

/// True when the file begins like a STEP file; cheap.
bool LooksLikeSTEP(const std::string& name);

/// While it lives, OpenCASCADE's process-wide messenger prints nothing and lengths arrive in mm.
class QuietKernel
{
public:
  QuietKernel();
  ~QuietKernel();
  QuietKernel(const QuietKernel&) = delete;
  void operator=(const QuietKernel&) = delete;

private:
  Message_SequenceOfPrinters Printers;
  TCollection_AsciiString Unit;
};

/// OpenCASCADE's progress as a call of `report` with a fraction in [0,1]; report answers false to stop.
class KernelProgress : public Message_ProgressIndicator
{
  DEFINE_STANDARD_RTTI_INLINE(KernelProgress, Message_ProgressIndicator)
public:
  explicit KernelProgress(std::function<bool(double)> report);

protected:
  Standard_Boolean UserBreak() override { return this->Stopped; }
  void Show(const Message_ProgressScope& scope, const Standard_Boolean force) override;

private:
  std::function<bool(double)> Report;
  double Last = -1.0;
  std::atomic<bool> Stopped{ false };
};
}

#endif

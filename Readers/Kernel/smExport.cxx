#include "smExport.h"

#include "smExportBytes.h"
#include "smKernelMessages.h"
#include "smKernelProcess.h"

#include <ostream>

namespace sm
{
ExportResult WriteExport(ExportFormat format, const ExportTree& tree, const ExportOptions& options,
  std::ostream& stream, const ProgressCallback& progress)
{
  ByteWriter to;
  PutExport(tree, options, to);
  bool isWritten = true;
  const KernelAnswer answer =
    AskKernel(format == ExportFormat::STEP ? kernel::WriteSTEP : kernel::WriteBREP, to.GetBytes(), progress,
      [&](const Bytes& content)
      {
        isWritten = !stream.write(content.data(), static_cast<std::streamsize>(content.size())).fail();
        return isWritten;
      });
  ExportResult result;
  if (!isWritten)
  {
    return result;
  }
  result.Aborted = answer.IsStopped;
  if (answer.IsStopped || !answer.Problem.empty())
  {
    result.Problem = "OpenCASCADE could not write it (" + answer.Problem + ")";
    return result;
  }
  ByteReader from(answer.Result);
  if (!GetExportResult(from, result))
  {
    result.Problem = "the process of OpenCASCADE sent what is not understood here";
  }
  return result;
}
}

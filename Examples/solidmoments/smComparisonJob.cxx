#include "smComparisonJob.h"

#include "smExtras.h"
#include "smFileReader.h"
#include "smMassPropertyNames.h"
#include "smResults.h"

#include "vtkCADReader.h"

namespace sm
{
void DrawComparison(const JobOptions& options, const JobListener& send)
{
  const std::string& name = options.GetSource();
  const vtkSmartPointer<vtkCADReader> before = MakeReader(options.ComparedName);
  const vtkSmartPointer<vtkCADReader> after = MakeReader(name);
  send(JobMessage::OfProgress(stages::Read));
  SetUpReader(before, options.ComparedName, options);
  before->Update();
  SetUpReader(after, name, options);
  after->Update();
  FileResult file(options);
  const bool areRead = before->GetStatus() == vtkCADReader::OK && after->GetStatus() == vtkCADReader::OK;
  file.Status = areRead ? names::StatusOk : names::StatusNotComputed;
  send(JobMessage::OfResult(file, true));
  send(JobMessage::OfProgress(stages::Draw));
  send(JobMessage::OfOutput(JobMessage::Picture,
    areRead ? CallExtra(&ExtraFunctions::WriteComparison, before.Get(), after.Get(), options)
            : std::string("the files could not be read again")));
}
}

/**
 * @file smRunReport.h
 * @brief Report of a run of a filter over surface integrals: status, messages, device and effort
 */
#ifndef smRunReport_h
#define smRunReport_h

#include "Items/smBackendCost.h"
#include "smBodyIntegrals.h"
#include "smFileState.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smIntegralNames.h"
#include "smStatus.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
namespace columns
{
class Writer;
}
/// Report of a run, with the values of the getters and of the field data.
struct SMFILTERSSURFACEINTEGRALS_EXPORT RunReport
{
  sm::Status Status = sm::Status::None;
  /// Status of the file as a whole; the status of the run is this one or a worse one.
  sm::Status FileStatus = sm::Status::None;
  std::vector<std::string> Messages;
  /// The message that gives the reason why the run stopped or had nothing to compute; empty otherwise.
  std::string Reason;
  /// A message about all bodies together, which follows the messages about single bodies.
  std::string Note;
  std::string Backend = names::BackendNone;
  std::string Renderer;
  /// Why BackendChoice::Automatic took this backend; empty where the user chose it.
  std::string BackendReason;
  BackendCost Estimate;
  /// Reason why the CPU was used although OpenGL is preferred; empty otherwise.
  std::string FallbackReason;
  std::int64_t Evaluations = 0;
  std::int64_t Dispatches = 0;
  /// True if some bound is estimated and not proved.
  bool Estimated = false;
  int Solids = 0;
  int Faces = 0;
  int Ranks = 0;
  double StartSeconds = 0.0;
  double PrepareSeconds = 0.0;
  double CutSeconds = 0.0;
  double PlanSeconds = 0.0;
  double IntegrateSeconds = 0.0;
  double AnalyseSeconds = 0.0;

  /// What the reader notes about a file that is not in doubt.
  std::vector<std::string> FileNotes;

  /// Adds a message; the first one of a run becomes its Reason.
  void SetReason(const std::string& message);
  /// Reports the status of the file, and why there is nothing to integrate. `hasBodies`: the input has some;
  /// `isChosen`: some of them are to be integrated.
  void AddFile(const FileState& file, bool hasBodies, bool isChosen);
  /// Counts the bodies with their faces. Where there are bodies, meshes without exact geometry are missing
  /// from the result: they make it suspect, and a message has their names.
  void AddBodies(const std::vector<BodyIntegrals>& bodies, const RejectedInput& rejected);
  /// Reports an input that has meshes only, without exact geometry; `isWithheld`: it had some, but its points
  /// were changed.
  void RejectInput(bool isWithheld);
  /// Adds the statuses of the bodies after their analysis.
  void AddStatuses(const std::vector<BodyIntegrals>& bodies);
  /// Adds the messages of the bodies, and the note.
  void AddMessages(const std::vector<BodyIntegrals>& bodies);
  /// Returns the messages of the run, of its bodies and of the file.
  std::vector<std::string> ListNotes(const std::vector<BodyIntegrals>& bodies) const;
  /// Returns a sentence with the reason for the status; empty if none is known.
  std::string FindReason(const std::vector<BodyIntegrals>& bodies) const;
  /// Adds the arrays Status, Backend, Renderer, BackendReason, Evaluations, Dispatches, Faces, Ranks,
  /// BoundsEstimated.
  void FillFieldData(columns::Writer data) const;
};

/// Returns the first lines of a summary: the status, its reason in lines of at most 64 characters, and, where
/// the model is suspect or open, that bounds do not include its defects.
SMFILTERSSURFACEINTEGRALS_EXPORT std::string FormatStatus(
  const std::string& status, const std::string& reason);

/// Returns the last lines of a summary: the first few messages that do not repeat the reason, each as a note,
/// and the number of the others.
SMFILTERSSURFACEINTEGRALS_EXPORT std::string FormatNotes(
  const std::string& reason, const std::vector<std::string>& messages);
}

#endif

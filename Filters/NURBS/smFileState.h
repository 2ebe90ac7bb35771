/**
 * @file smFileState.h
 * @brief A reader's findings about a file as a whole; they travel with the reader's output as field data
 */
#ifndef smFileState_h
#define smFileState_h

#include "smFiltersNURBSModule.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
struct FileState
{
  /// "ok", "empty", "unreadable", "aborted" or "failed"; empty for data that no reader made.
  std::string Status;
  /// Why the status is not "ok": a sentence with the file's name.
  std::string Problem;
  /// Reasons why every result of the file is suspect, one sentence each: solids, faces or instances that the
  /// file declares and that are not in the output, and contradictions that belong to no single body.
  std::vector<std::string> Defects;
  /// What a user has to know although no result is in doubt, such as a unit that was assumed: sentences.
  std::vector<std::string> Notes;
};

/// Names of the string arrays in the field data of the output, with one value, one value, one for each defect
/// and one for each note.
constexpr const char* FileStatusArrayName = "FileStatus";
constexpr const char* FileProblemArrayName = "FileProblem";
constexpr const char* FileDefectsArrayName = "FileDefects";
constexpr const char* FileNotesArrayName = "FileNotes";

SMFILTERSNURBS_EXPORT void SetFileState(vtkDataObject* data, const FileState& state);
SMFILTERSNURBS_EXPORT FileState GetFileState(vtkDataObject* data);
/// Removes these arrays, and those of the drawing's tolerances (smDrawingTolerances.h). The pipeline copies
/// the field data of a filter's input to its outputs, also to those that are not the file's data.
SMFILTERSNURBS_EXPORT void RemoveFileState(vtkDataObject* data);
}

#endif

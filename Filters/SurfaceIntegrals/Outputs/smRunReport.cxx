#include "smRunReport.h"

#include "smColumns.h"
#include "smFormat.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace sm
{
namespace
{
/// Number of messages that a summary lists at most.
constexpr std::size_t MaxNotes = 5;

/// Returns true for the note of a body about its widest gap, without a consequence behind it.
bool IsGapNote(const std::string& message)
{
  const std::size_t at = message.find("the widest gap between a face and its edge is ");
  return at != std::string::npos && message.find(": ", at) == std::string::npos;
}

/// Lines of at most 64 characters, in which every line of the text begins a new one.
std::string WrapLines(const std::string& text)
{
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    result += WrapText(line, 64);
  }
  return result;
}
}

std::string FormatStatus(const std::string& status, const std::string& reason)
{
  const std::string text = "Status: " + status + "\n" + WrapLines(reason);
  return status == GetText(Status::Suspect) || status == GetText(Status::Open)
    ? text + "Bounds are those of the computation: the model is in doubt.\n"
    : text;
}

std::string FormatNotes(const std::string& reason, const std::vector<std::string>& messages)
{
  std::string text;
  std::set<std::string> known;
  std::size_t listed = 0;
  bool hasGapNote = false;
  for (const std::string& message : messages)
  {
    if (reason.find(message) != std::string::npos || !known.insert(message).second)
    {
      continue;
    }
    // One note of gaps is enough: those of an assembly would fill half of a view.
    const bool isAnotherGap = hasGapNote && IsGapNote(message);
    hasGapNote = hasGapNote || IsGapNote(message);
    if (listed < MaxNotes && !isAnotherGap)
    {
      ++listed;
      text += WrapLines("Note: " + message);
    }
  }
  const std::size_t left = known.size() - listed;
  return left > 0 ? text + "and " + FormatCount(left, "more note\n", "more notes\n") : text;
}

namespace
{
/// Largest number of meshes that a message names.
constexpr std::size_t MaxMeshes = 5;

std::string DescribeMeshes(const RejectedInput& rejected)
{
  std::string names;
  for (std::size_t i = 0; i < std::min(rejected.Meshes.size(), MaxMeshes); ++i)
  {
    const std::string& name = rejected.Meshes[i].second;
    names += (names.empty() ? "" : ", ") + (name.empty() ? std::string("a mesh without a name") : name);
  }
  names += rejected.Meshes.size() > MaxMeshes
    ? " and " + std::to_string(rejected.Meshes.size() - MaxMeshes) + " more"
    : "";
  return FormatCount(rejected.Meshes.size(), "part of the input has", "parts of the input have") +
    " no exact geometry, or lost it when points were changed, and " +
    (rejected.Meshes.size() == 1 ? "is" : "are") + " left out: " + names;
}
}

void RunReport::SetReason(const std::string& message)
{
  this->Messages.push_back(message);
  this->Reason = this->Reason.empty() ? message : this->Reason;
}

void RunReport::FillFieldData(columns::Writer data) const
{
  data.SetString(names::Status, GetText(this->Status));
  data.SetString(names::Backend, this->Backend);
  data.SetString(names::Renderer, this->Renderer);
  data.SetString(names::BackendReason, this->BackendReason);
  data.SetInteger(names::Evaluations, this->Evaluations);
  data.SetInteger(names::Dispatches, this->Dispatches);
  data.SetInteger(names::Faces, this->Faces);
  data.SetInteger(names::Ranks, this->Ranks);
  data.SetInteger(names::BoundsEstimated, this->Estimated ? 1 : 0);
}

void RunReport::AddFile(const FileState& file, bool hasBodies, bool isChosen)
{
  this->FileStatus = this->Reason.empty() ? Status::Ok : Status::Suspect;
  this->FileNotes = file.Notes;
  for (const std::string& defect : file.Defects)
  {
    this->FileStatus = Status::Suspect;
    this->SetReason(defect);
  }
  if (!isChosen)
  {
    this->FileStatus = file.Status == names::StatusUnreadable ? Status::Unreadable
      : file.Status == "aborted" || file.Status == "failed"   ? Status::NotComputed
                                                              : Status::Empty;
    this->SetReason(hasBodies   ? "no solid is chosen"
        : !file.Problem.empty() ? file.Problem
                                : "the input holds no solid and no surface");
  }
}

void RunReport::AddBodies(const std::vector<BodyIntegrals>& bodies, const RejectedInput& rejected)
{
  if (!bodies.empty() && !rejected.Meshes.empty())
  {
    this->SetReason(DescribeMeshes(rejected));
  }
  this->Solids = static_cast<int>(bodies.size());
  for (const BodyIntegrals& body : bodies)
  {
    this->Faces += static_cast<int>(body.Model->GetNumberOfFaces());
  }
}

void RunReport::RejectInput(bool isWithheld)
{
  this->Status = Status::Empty;
  this->Messages.push_back(isWithheld ? "the points of the input were changed after it was read, "
                                        "so its exact geometry no longer describes it"
                                      : "the input is a mesh without exact geometry");
}

void RunReport::AddStatuses(const std::vector<BodyIntegrals>& bodies)
{
  for (const BodyIntegrals& body : bodies)
  {
    this->Status = std::max(this->Status, body.Status);
    this->Estimated = this->Estimated || body.IsEstimated();
  }
}

void RunReport::AddMessages(const std::vector<BodyIntegrals>& bodies)
{
  for (const BodyIntegrals& body : bodies)
  {
    for (const std::string& message : body.Messages)
    {
      this->Messages.push_back((body.Name.empty() ? "" : body.Name + ": ") + message);
    }
  }
  if (!this->Note.empty())
  {
    this->Messages.push_back(this->Note);
  }
  // Notes about materials, for example, come behind the reason for the status.
  const auto reason = this->Status == sm::Status::Ok
    ? this->Messages.end()
    : std::find(this->Messages.begin(), this->Messages.end(), this->FindReason(bodies));
  if (reason != this->Messages.end())
  {
    std::rotate(this->Messages.begin(), reason, reason + 1);
  }
}

std::vector<std::string> RunReport::ListNotes(const std::vector<BodyIntegrals>& bodies) const
{
  RunReport all = *this;
  all.AddMessages(bodies);
  all.Messages.insert(all.Messages.end(), this->FileNotes.begin(), this->FileNotes.end());
  return all.Messages;
}

std::string RunReport::FindReason(const std::vector<BodyIntegrals>& bodies) const
{
  const auto worst = std::find_if(bodies.begin(), bodies.end(),
    [this](const BodyIntegrals& body) { return body.Status == this->Status && !body.Reason.empty(); });
  return !this->Reason.empty() ? this->Reason
    : worst == bodies.end()    ? this->Note
                               : (worst->Name.empty() ? "" : worst->Name + ": ") + worst->Reason;
}
}

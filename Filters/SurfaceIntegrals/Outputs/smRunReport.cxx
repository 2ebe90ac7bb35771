#include "smRunReport.h"

#include "smColumns.h"
#include "smFormat.h"

#include "vtkTrimmedNURBSModel.h"

#include <algorithm>
#include <sstream>

namespace sm
{
namespace
{
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

std::string FormatStatus(
  const std::string& status, const std::string& reason, const std::vector<std::string>& messages)
{
  // Messages with the status ok are notes, such as a unit that was assumed.
  const bool isNote = status == names::StatusOk;
  if (isNote && messages.empty())
  {
    return "";
  }
  const std::string& first = isNote ? messages.front() : reason;
  const auto others = std::count_if(messages.begin(), messages.end(),
    [&first](const std::string& message) { return first.find(message) == std::string::npos; });
  std::string text = isNote ? WrapLines("Note: " + first) : "Status: " + status + "\n" + WrapLines(first);
  if (others > 0)
  {
    text += "and " + FormatCount(others, "more message\n", "more messages\n");
  }
  return status == GetText(Status::Suspect) || status == GetText(Status::Open)
    ? text + "Bounds are those of the computation: the model is in doubt.\n"
    : text;
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
  this->FileStatus = Status::Ok;
  for (const std::string& defect : file.Defects)
  {
    this->FileStatus = Status::Suspect;
    this->SetReason(defect);
  }
  if (!isChosen)
  {
    this->FileStatus = file.Status == names::StatusUnreadable ? Status::Unreadable
      : file.Status == "aborted"                              ? Status::NotComputed
                                                              : Status::Empty;
    this->SetReason(hasBodies   ? "no solid is chosen"
        : !file.Problem.empty() ? file.Problem
                                : "the input holds no solid and no surface");
  }
}

void RunReport::AddBodies(const std::vector<BodyIntegrals>& bodies, const RejectedInput& rejected)
{
  const int meshes = rejected.Plain + rejected.Withheld;
  if (meshes > 0)
  {
    this->Messages.push_back(FormatCount(
      meshes, "mesh without exact geometry was left out", "meshes without exact geometry were left out"));
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

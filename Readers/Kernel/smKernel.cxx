#include "smKernel.h"

#include "smKernelMessages.h"
#include "smKernelProcess.h"

#include <algorithm>
#include <utility>

namespace sm
{
namespace
{
constexpr const char* BadAnswer = "its process sent what is not understood here";

/// Sends a request and reads the failure in its answer. `read` gets what follows if there is none.
template <class Read>
std::string Ask(char kind, const Bytes& request, const RepairWatch& watch, const Read& read)
{
  const KernelAnswer answer = AskKernel(kind, request, [&watch](double) { return watch(); });
  if (answer.IsStopped || !answer.Problem.empty())
  {
    return answer.IsStopped ? "it was stopped" : answer.Problem;
  }
  ByteReader from(answer.Result);
  const std::string failure = from.GetText();
  return !from.IsGood() ? BadAnswer : !failure.empty() ? failure : read(from) ? std::string() : BadAnswer;
}

std::vector<FaceShapePointer> GetFaces(const BodyShape& body)
{
  std::vector<FaceShapePointer> faces;
  body.VisitFaces([&faces](const FaceUse& use) { faces.push_back(use.Face); });
  return faces;
}
}

std::string RepairBody(const BodyShape& body, const ShapeData& data, const RepairLimits& limits,
  const RepairWatch& watch, ShapeGroup& result)
{
  ByteWriter to;
  ShapeTable table;
  to.Put(limits);
  ShapeWriter(to, table).Put(body);
  std::string failure = Ask(kernel::RepairBody, to.GetBytes(), watch,
    [&](ByteReader& from) { return ShapeReader(from, table).Get(result); });
  if (!failure.empty() || result.IsEmpty())
  {
    return failure.empty() ? "it left nothing" : failure;
  }
  for (const SolidUse& solid : result.Solids)
  {
    solid.Solid->Data = data;
  }
  for (const ShellUse& shell : result.Shells)
  {
    shell.Shell->OpenSolid = body.IsSolid && result.Solids.empty();
    if (shell.Shell->Data.FileId == 0 || shell.Shell->OpenSolid)
    {
      shell.Shell->Data = body.IsSolid ? data : body.Shells.front().Shell->Data;
    }
  }
  return {};
}

BodyShape RepairFaces(const BodyShape& body, const std::vector<const FaceShape*>& faces,
  const RepairLimits& limits, const RepairWatch& watch, std::vector<const FaceShape*>& repaired)
{
  ByteWriter to;
  ShapeTable table;
  to.Put(limits);
  ShapeWriter writer(to, table);
  writer.Put(body);
  std::vector<FaceShapePointer> chosen = GetFaces(body);
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                 [&faces](const FaceShapePointer& face)
                 { return std::find(faces.begin(), faces.end(), face.get()) == faces.end(); }),
    chosen.end());
  writer.Put(chosen);
  BodyShape result;
  std::vector<FaceShapePointer> fixed;
  const std::string failure = Ask(kernel::RepairFaces, to.GetBytes(), watch,
    [&](ByteReader& from)
    {
      ShapeReader reader(from, table);
      return reader.Get(result) && reader.Get(fixed);
    });
  if (!failure.empty())
  {
    return body;
  }
  for (const FaceShapePointer& face : fixed)
  {
    repaired.push_back(face.get());
  }
  return result;
}

BREPContent ReadBREPShapes(std::string_view bytes, const ProgressCallback& progress)
{
  BREPContent content;
  const KernelAnswer answer = AskKernel(kernel::ReadBREP, Bytes(bytes.begin(), bytes.end()), progress);
  content.IsStopped = answer.IsStopped;
  if (answer.IsStopped || !answer.Problem.empty())
  {
    content.Problem = "OpenCASCADE could not read it (" + answer.Problem + ")";
    content.HasFailed = !answer.IsCrash;
    return content;
  }
  ByteReader from(answer.Result);
  ShapeTable table;
  ShapeReader reader(from, table);
  content.Problem = from.GetText();
  content.Defects = from.GetTexts();
  if (!reader.Get(content.Shapes) || !reader.Get(content.Root))
  {
    content.Problem = std::string("OpenCASCADE could not read it (") + BadAnswer + ")";
    content.HasFailed = true;
  }
  return content;
}
}

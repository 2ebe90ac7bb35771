/**
 * @file solidmoments_kernel.cxx
 * @brief solidmoments-kernel: the only program that links OpenCASCADE; takes requests (smKernelMessages.h)
 *
 * It ends with its standard input, and so with the process that started it.
 */
#include "smExportBytes.h"
#include "smHelperProcess.h"
#include "smKernel.h"
#include "smKernelMessages.h"
#include "smOCCTExport.h"
#include "smOCCTFailure.h"
#include "smOCCTFile.h"
#include "smOCCTFixShape.h"
#include "smOCCTImport.h"
#include "smOCCTMakeShape.h"
#include "smOCCTReadBREP.h"

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <ostream>
#include <streambuf>
#include <unistd.h>
#include <unordered_map>
#include <unordered_set>

namespace
{
using ShapesOfFaces = std::unordered_map<const sm::FaceShape*, TopoDS_Shape>;

/// Sends a file in parts.
class SendingBuffer : public std::streambuf
{
public:
  explicit SendingBuffer(int messages)
    : Messages(messages)
  {
    this->setp(this->Part, this->Part + sizeof(this->Part));
  }

protected:
  int_type overflow(int_type character) override
  {
    if (this->sync() != 0)
    {
      return traits_type::eof();
    }
    if (!traits_type::eq_int_type(character, traits_type::eof()))
    {
      *this->pptr() = traits_type::to_char_type(character);
      this->pbump(1);
    }
    return traits_type::not_eof(character);
  }
  int sync() override
  {
    const auto size = static_cast<std::size_t>(this->pptr() - this->pbase());
    this->setp(this->Part, this->Part + sizeof(this->Part));
    return size == 0 || sm::SendMessage(this->Messages, sm::kernel::Content, this->Part, size) ? 0 : -1;
  }

private:
  int Messages;
  char Part[1 << 16];
};

sm::ProgressCallback MakeProgress(int messages)
{
  return [messages](double fraction)
  { return sm::SendMessage(messages, sm::kernel::Fraction, &fraction, sizeof(fraction)); };
}

/// Returns the answer to a request that is not valid.
void Refuse(sm::ByteWriter& to)
{
  to = sm::ByteWriter();
  to.PutText("the request is not valid");
}

void RepairBody(sm::ByteReader& from, sm::ByteWriter& to)
{
  const auto limits = from.Get<sm::RepairLimits>();
  sm::ShapeTable table;
  sm::BodyShape body;
  if (!sm::ShapeReader(from, table).Get(body))
  {
    Refuse(to);
    return;
  }
  sm::ShapeGroup result;
  const std::string failure = sm::CatchKernelFailure(
    [&]
    {
      sm::MadeShapes made;
      ShapesOfFaces faces;
      const TopoDS_Shape shape = sm::MakeKernelShape(body, made, faces);
      sm::ShapeImport import(&made);
      const TopoDS_Shape repaired = sm::FixShape(shape, limits.Precision, limits.Maximum,
        [&import](const TopoDS_Shape& before, const TopoDS_Shape& after)
        { import.AddReplacement(before, after); });
      result = import.MakeGroup(repaired);
    });
  to.PutText(failure);
  sm::ShapeWriter(to, table).Put(failure.empty() ? result : sm::ShapeGroup());
}

/// Repairs faces of a body, whose shape is returned; `fixed` gets what became of them.
sm::BodyShape RepairFaces(const sm::BodyShape& body, const std::vector<sm::FaceShapePointer>& faces,
  const sm::RepairLimits& limits, std::vector<sm::FaceShapePointer>& fixed)
{
  sm::MadeShapes made;
  ShapesOfFaces known;
  const std::unordered_set<sm::FaceShapePointer> chosen(faces.begin(), faces.end());
  const TopoDS_Shape shape = sm::MakeKernelShape(body, made, known);
  std::vector<TopoDS_Shape> damaged;
  body.VisitFaces(
    [&](const sm::FaceUse& use)
    {
      if (chosen.count(use.Face) > 0)
      {
        damaged.push_back(known.at(use.Face.get()).Oriented(use.Reversed ? TopAbs_REVERSED : TopAbs_FORWARD));
      }
    });
  sm::ShapeImport import(&made);
  std::vector<TopoDS_Shape> repaired;
  const TopoDS_Shape whole = sm::FixFaces(
    shape, damaged, limits.Precision, limits.Maximum,
    [&import](const TopoDS_Shape& before, const TopoDS_Shape& after)
    { import.AddReplacement(before, after); },
    repaired);
  import.KeepFacesExcept(repaired);
  const sm::ShapeGroup group = import.MakeGroup(whole);
  if (group.Solids.size() != (body.IsSolid ? 1u : 0u) || group.Shells.size() != (body.IsSolid ? 0u : 1u))
  {
    return body;
  }
  for (const TopoDS_Shape& face : repaired)
  {
    fixed.push_back(import.Find(face.Oriented(TopAbs_FORWARD)));
  }
  return body.IsSolid ? sm::MakeBody(group.Solids.front()) : sm::MakeBody(group.Shells.front());
}

void RepairFaces(sm::ByteReader& from, sm::ByteWriter& to)
{
  const auto limits = from.Get<sm::RepairLimits>();
  sm::ShapeTable table;
  sm::ShapeReader reader(from, table);
  sm::BodyShape body;
  std::vector<sm::FaceShapePointer> faces;
  if (!reader.Get(body) || !reader.Get(faces))
  {
    Refuse(to);
    return;
  }
  sm::BodyShape result = body;
  std::vector<sm::FaceShapePointer> fixed;
  const std::string failure =
    sm::CatchKernelFailure([&] { result = RepairFaces(body, faces, limits, fixed); });
  to.PutText(failure);
  sm::ShapeWriter writer(to, table);
  writer.Put(result);
  writer.Put(fixed);
}

void ReadBREP(const sm::Bytes& request, int messages, sm::ByteWriter& to)
{
  const sm::BREPContent content =
    sm::ReadKernelBREP({ request.data(), request.size() }, MakeProgress(messages));
  to.PutText(content.Problem);
  to.PutTexts(content.Defects);
  sm::ShapeTable table;
  sm::ShapeWriter writer(to, table);
  writer.Put(content.Shapes);
  writer.Put(content.Root);
}

void Write(char kind, sm::ByteReader& from, int messages, sm::ByteWriter& to)
{
  sm::ExportTree tree;
  sm::ExportOptions options;
  sm::ExportResult result;
  if (!sm::GetExport(from, tree, options))
  {
    result.Problem = "the request is not valid";
  }
  else
  {
    SendingBuffer buffer(messages);
    std::ostream stream(&buffer);
    result = kind == sm::kernel::WriteSTEP ? sm::WriteSTEP(tree, options, stream, MakeProgress(messages))
                                           : sm::WriteBREP(tree, options, stream, MakeProgress(messages));
    stream.flush();
  }
  sm::PutExportResult(result, to);
}

/// Answers one request; returns false if the other process has ended.
bool Answer(char kind, const sm::Bytes& request, int messages)
{
  sm::ByteReader from(request);
  sm::ByteWriter to;
  switch (kind)
  {
    case sm::kernel::RepairBody:
      RepairBody(from, to);
      break;
    case sm::kernel::RepairFaces:
      RepairFaces(from, to);
      break;
    case sm::kernel::ReadBREP:
      ReadBREP(request, messages, to);
      break;
    case sm::kernel::WriteSTEP:
    case sm::kernel::WriteBREP:
      Write(kind, from, messages, to);
      break;
    default:
      Refuse(to);
  }
  return sm::SendMessage(messages, sm::kernel::Result, to.GetBytes().data(), to.GetBytes().size());
}

void Serve()
{
  // An interrupt of the program that started this one does not end a server that it may still need.
  std::signal(SIGINT, SIG_IGN);
  sm::EndWithInput();
  const int messages = sm::OpenMessages();
  const std::string version = SOLIDMOMENTS_VERSION;
  sm::SetUpKernel();
  bool isConnected = sm::SendMessage(messages, sm::kernel::Version, version.data(), version.size());
  char kind = 0;
  sm::Bytes request;
  while (isConnected && sm::ReceiveMessage(STDIN_FILENO, kind, request))
  {
    try
    {
      isConnected = Answer(kind, request, messages);
    }
    catch (const std::bad_alloc&)
    {
      isConnected = sm::SendMessage(messages, sm::kernel::OutOfMemory, nullptr, 0);
    }
  }
}
}

int main(int argc, char**)
{
  if (argc != 1 || isatty(STDIN_FILENO) != 0)
  {
    std::cerr << "solidmoments-kernel: this program is started by the readers and writers, which repair "
                 "bodies and exchange files by OpenCASCADE in it; the command line is solidmoments.\n";
    return 1;
  }
  try
  {
    Serve();
  }
  catch (const std::exception&)
  {
    std::_Exit(1); // out of memory
  }
  // _Exit() skips the destructors of static objects in third-party libraries, which might fail.
  std::_Exit(0);
}

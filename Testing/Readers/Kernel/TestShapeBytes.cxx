// TestShapeBytes SOLIDS FILE: shapes of STEP files keep every number and every shared object as bytes; what
// the other side refers to becomes the same object; bytes that are missing or wrong are refused.
#include "smBodyCapture.h"
#include "smShapeBytes.h"
#include "smTesting.h"

#include <algorithm>
#include <filesystem>
#include <random>
#include <set>
#include <utility>

namespace
{
using namespace smtest;

sm::Bytes Pack(const sm::BodyShape& body)
{
  sm::ByteWriter to;
  sm::ShapeTable table;
  sm::ShapeWriter(to, table).Put(body);
  return to.GetBytes();
}

bool Unpack(const sm::Bytes& bytes, sm::BodyShape& body)
{
  sm::ByteReader from(bytes);
  sm::ShapeTable table;
  return sm::ShapeReader(from, table).Get(body);
}

struct Objects
{
  std::set<const void*> Edges;
  std::set<const void*> Curves;
  std::set<const void*> Surfaces;
  std::size_t Faces = 0;
  /// Sum of values of curves and surfaces.
  double Sum = 0.0;
};

Objects Collect(const sm::BodyShape& body)
{
  Objects found;
  body.VisitFaces(
    [&](const sm::FaceUse& use)
    {
      const sm::FaceShape& face = *use.Face;
      ++found.Faces;
      found.Surfaces.insert(face.Surface.get());
      found.Sum += face.Surface->Evaluate(0.3, 0.2)[0];
      for (const sm::WireShape& wire : face.Wires)
      {
        for (const sm::CoedgeShape& coedge : wire.Coedges)
        {
          found.Edges.insert(coedge.Edge.get());
          found.Curves.insert(coedge.Edge->Curve.get());
          found.Sum += coedge.Edge->HasCurve() ? coedge.Edge->EvaluateAt(0.4)[1] : 0.0;
          found.Sum += coedge.Trim ? coedge.Trim->Evaluate(coedge.First)[0] : 0.0;
        }
      }
    });
  return found;
}

void CheckSame(const std::string& what, const sm::BodyShape& body)
{
  const sm::Bytes bytes = Pack(body);
  sm::BodyShape copy;
  CheckTrue(what + ": read", Unpack(bytes, copy));
  CheckTrue(what + ": the same bytes again", Pack(copy) == bytes);
  const Objects a = Collect(body);
  const Objects b = Collect(copy);
  CheckEqual(what + ": faces", a.Faces, b.Faces);
  CheckEqual(what + ": edges", a.Edges.size(), b.Edges.size());
  CheckEqual(what + ": curves", a.Curves.size(), b.Curves.size());
  CheckEqual(what + ": surfaces", a.Surfaces.size(), b.Surfaces.size());
  CheckEqual(what + ": values", a.Sum, b.Sum);
}

/// A reply that refers to objects of the request has the very same ones.
void CheckReply(const sm::BodyShape& body)
{
  sm::ByteWriter request;
  sm::ShapeTable here;
  sm::ShapeWriter(request, here).Put(body);
  sm::ByteReader fromRequest(request.GetBytes());
  sm::ShapeTable there;
  sm::BodyShape copy;
  CheckTrue("request", sm::ShapeReader(fromRequest, there).Get(copy));
  const auto added = std::make_shared<sm::FaceShape>(*copy.Shells[0].Shell->Faces[0].Face);
  added->Data.Name = "new";
  added->Source = copy.Shells[0].Shell->Faces[1].Face;
  sm::ShapeGroup group;
  group.Faces = { copy.Shells[0].Shell->Faces[2], { added, true } };
  sm::ByteWriter reply;
  sm::ShapeWriter(reply, there).Put(group);
  sm::ByteReader fromReply(reply.GetBytes());
  sm::ShapeGroup result;
  CheckTrue("reply", sm::ShapeReader(fromReply, here).Get(result));
  const auto& faces = body.Shells[0].Shell->Faces;
  CheckTrue("a known face", result.Faces[0].Face == faces[2].Face);
  CheckTrue("a new face", result.Faces[1].Face != faces[0].Face && result.Faces[1].Reversed);
  CheckEqual("its name", "new", result.Faces[1].Face->Data.Name);
  CheckTrue("its source", result.Faces[1].Face->Source == faces[1].Face);
  CheckTrue("its surface", result.Faces[1].Face->Surface == faces[0].Face->Surface);
  CheckTrue(
    "its edges", result.Faces[1].Face->Wires[0].Coedges[0].Edge == faces[0].Face->Wires[0].Coedges[0].Edge);
}

/// Every shorter message is refused; of those with another byte each is read or refused.
void CheckDamage(const sm::BodyShape& body)
{
  const sm::Bytes bytes = Pack(body);
  int read = 0;
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 500)
  {
    sm::BodyShape part;
    read += Unpack(sm::Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)), part) ? 1 : 0;
  }
  CheckEqual("parts of a message that are read", 0, read);
  std::mt19937 random(3);
  int refused = 0;
  for (int i = 0; i < 2000; ++i)
  {
    sm::Bytes damaged = bytes;
    damaged[random() % damaged.size()] = static_cast<char>(random());
    sm::BodyShape other;
    refused += Unpack(damaged, other) ? 0 : 1;
  }
  std::printf("%d of 2000 messages with a wrong byte are refused\n", refused);
  CheckTrue("some are refused", refused > 0 && refused < 2000);
}

/// Offsets of offsets: deeper nesting than the limit is refused, not followed.
void CheckDepth()
{
  std::string problem;
  sm::CurvePointer<3> curve =
    sm::GeometricCurve<3>::Make(sm::LineCurve<3>{ { 0, 0, 0 }, { 1, 0, 0 } }, problem);
  sm::BodyShape body;
  const auto nest = [&](int levels)
  {
    sm::CurvePointer<3> nested = curve;
    for (int i = 0; i < levels; ++i)
    {
      nested = sm::GeometricCurve<3>::Make(sm::CompositeCurve<3>{ { { nested, 0.0, 1.0, 1.0 } } }, problem);
    }
    const auto face = std::make_shared<sm::FaceShape>();
    const auto edge = std::make_shared<sm::EdgeShape>();
    edge->Curve = nested;
    face->Wires.resize(1);
    face->Wires[0].Coedges.push_back({ edge, false, nullptr, 0.0, 0.0 });
    body.Faces = { { face, false } };
    sm::BodyShape copy;
    return Unpack(Pack(body), copy);
  };
  CheckTrue("100 levels", nest(100));
  CheckTrue("more levels than the limit", !nest(sm::MaxShapeDepth));
  sm::ShapeNode node;
  for (int i = 0; i < 2 * sm::MaxShapeDepth; ++i)
  {
    sm::ShapeNode parent;
    parent.Children.push_back(std::move(node));
    node = std::move(parent);
  }
  sm::ByteWriter to;
  sm::ShapeTable table;
  sm::ShapeWriter(to, table).Put(node);
  sm::ByteReader from(to.GetBytes());
  sm::ShapeNode copy;
  CheckTrue("a tree with more levels", !sm::ShapeReader(from, table).Get(copy));
}

/// Uses of nothing are refused.
void CheckNull()
{
  sm::ShapeGroup groups[3];
  groups[0].Solids.resize(1);
  groups[1].Shells.resize(1);
  groups[2].Faces.resize(1);
  for (const sm::ShapeGroup& group : groups)
  {
    sm::ByteWriter to;
    sm::ShapeTable table;
    sm::ShapeWriter(to, table).Put(group);
    sm::ByteReader from(to.GetBytes());
    sm::ShapeGroup copy;
    CheckTrue("a null pointer", !sm::ShapeReader(from, table).Get(copy));
  }
}
}

int TestShapeBytes(int argc, char* argv[])
{
  if (argc < 3)
  {
    return 1;
  }
  std::vector<std::string> files{ argv[2] };
  for (const auto& entry : std::filesystem::directory_iterator(argv[1]))
  {
    const std::string name = entry.path().filename().string();
    const bool isPlain = name.find("-plain.step") != std::string::npos || name == "two_solids.step";
    if (isPlain)
    {
      files.push_back(entry.path().string());
    }
  }
  CheckTrue("there are solids", files.size() > 10);
  std::sort(files.begin(), files.end());
  for (const std::string& file : files)
  {
    for (const sm::BodyShape& body : CaptureBodies(file))
    {
      CheckSame(file, body);
    }
  }
  const sm::BodyShape part = CaptureBodies(argv[2]).at(0);
  CheckReply(part);
  CheckDamage(part);
  CheckDepth();
  CheckNull();
  return Finish();
}

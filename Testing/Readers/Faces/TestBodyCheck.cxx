// Contradictions between faces: each kind that the table of smBodyCheck.h names is found, and what is sound
// is not.
#include "smBodyCheck.h"
#include "smTesting.h"

#include <string>

namespace
{
using Type = sm::BodyContradiction::Type;

struct TestBody
{
  std::vector<sm::FaceStatement> Statements;
  std::vector<sm::CheckedFace> Faces;

  explicit TestBody(std::size_t count)
    : Statements(count)
    , Faces(count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Statements[i].Id = 10 * (i + 1);
      this->Faces[i].Statement = &this->Statements[i];
      this->Faces[i].Finding.Verdict = sm::FaceVerdict::Agrees;
    }
  }
  void Use(std::size_t face, std::uint64_t edge, bool isForward, bool isArc = false)
  {
    this->Statements[face].Uses.push_back({ edge, isForward, isArc });
    this->Statements[face].EdgeLoops = 1;
  }
  void Turn(std::size_t face) { this->Faces[face].Finding.Verdict = sm::FaceVerdict::Turned; }
};

void CheckFound(const std::string& what, const TestBody& body, bool isInsideOut, std::size_t count,
  Type kind = Type::Turned, std::size_t face = 0)
{
  const std::vector<sm::BodyContradiction> found = sm::FindContradictions(body.Faces, isInsideOut);
  smtest::CheckEqual(what, static_cast<long long>(count), static_cast<long long>(found.size()));
  if (count > 0 && !found.empty())
  {
    smtest::CheckEqual("  its kind", static_cast<long long>(kind), static_cast<long long>(found[0].Kind));
    smtest::CheckEqual("  its face", static_cast<long long>(face), static_cast<long long>(found[0].Face));
  }
}

/// A cap of a sphere, face 0, and a disc: the edge 1 forwards and backwards.
TestBody MakeCap(bool isCapForward, bool isDiscForward)
{
  TestBody body(2);
  body.Faces[0].IsClosed = true;
  body.Use(0, 1, isCapForward);
  body.Use(1, 1, isDiscForward);
  return body;
}

void TestCaps()
{
  CheckFound("a sound cap", MakeCap(true, false), false, 0);
  TestBody turned = MakeCap(false, false);
  turned.Turn(0);
  CheckFound("a turned cap", turned, false, 1, Type::Turned);
  CheckFound("a cap by the letter", MakeCap(false, false), false, 1, Type::SameDirection);
  TestBody plane = MakeCap(true, true);
  plane.Turn(1);
  CheckFound("a turned plane beside a cap", plane, false, 0);
  CheckFound("a rest that is inside out", MakeCap(true, false), true, 1, Type::InsideOut);
  TestBody box(2);
  box.Use(0, 1, true);
  box.Use(1, 1, false);
  CheckFound("planes that are inside out", box, true, 0);
  TestBody planes(2);
  planes.Use(0, 1, true);
  planes.Use(1, 1, true);
  CheckFound("planes that disagree", planes, false, 0);
  TestBody torus(1);
  torus.Faces[0].IsClosed = true;
  torus.Use(0, 1, true);
  torus.Use(0, 1, false);
  CheckFound("a whole torus that is inside out", torus, true, 0);
}

/// A segment of a disc, and another one beside it at the same arc. The arc is a sixth of the circle, or five
/// sixths.
TestBody MakeSegments(double stated, double whole)
{
  TestBody body(2);
  for (std::size_t i = 0; i < 2; ++i)
  {
    body.Use(i, 1, i == 0, true);
    body.Use(i, 2 + i, true);
    const double sign = i == 0 ? 1.0 : -1.0;
    body.Turn(i);
    body.Faces[i].Finding.Stated = { 0.0, 0.0, sign * stated };
    body.Faces[i].Finding.Read = { 0.0, 0.0, -sign * stated };
    body.Statements[i].OtherArcs = { 0.0, 0.0, -sign * whole };
  }
  return body;
}

void TestArcs()
{
  // The circle has the area 12.6, the part at the long arc 12.2 of it.
  CheckFound("arcs that run backwards", MakeSegments(12.2, 12.6), false, 2, Type::Backwards);
  TestBody half = MakeSegments(12.2, 12.6);
  half.Faces[1].Finding.Verdict = sm::FaceVerdict::Agrees;
  CheckFound("one of two faces is turned", half, false, 0);
  CheckFound("rounded corners", MakeSegments(100.0, 12.6), false, 0);
  // Both halves of a circle are the same circle when they are exchanged.
  CheckFound("a disc in two halves", MakeSegments(12.6, 25.2), false, 0);
}
}

int TestBodyCheck(int, char*[])
{
  TestCaps();
  TestArcs();
  return smtest::Finish();
}

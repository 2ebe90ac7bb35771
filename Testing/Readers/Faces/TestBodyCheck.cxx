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
  void Turn(std::size_t face) { this->Faces[face].Finding.Verdict = sm::FaceVerdict::Reversed; }
};

void CheckFound(const std::string& what, const TestBody& body, bool isInsideOut, std::size_t count,
  Type kind = Type::Reversed, std::size_t face = 0)
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
  TestBody reversed = MakeCap(false, false);
  reversed.Turn(0);
  CheckFound("a reversed cap", reversed, false, 1, Type::Reversed);
  // The seam is within the cap, whatever the direction of its bound; that of its neighbour decides which of
  // both is reversed.
  for (const bool isDiscForward : { false, true })
  {
    TestBody seamed = MakeCap(false, isDiscForward);
    seamed.Use(0, 2, true);
    seamed.Use(0, 2, false);
    seamed.Turn(0);
    CheckFound("a reversed cap with a seam", seamed, false, isDiscForward ? 1 : 0, Type::SameDirection);
  }
  // A ring whose section is a lens: seams and circles of both parts contradict each other, and no other face
  // says which are right.
  TestBody ring(2);
  for (std::size_t face = 0; face < 2; ++face)
  {
    ring.Faces[face].IsClosed = true;
    ring.Turn(face);
    ring.Use(face, 1, face == 0);
    ring.Use(face, 2, face == 1);
    ring.Use(face, 3 + face, true);
    ring.Use(face, 3 + face, false);
  }
  CheckFound("a ring of two parts", ring, false, 2, Type::Reversed);
  CheckFound("a cap by the letter", MakeCap(false, false), false, 1, Type::SameDirection);
  // A surface that is closed, which the file does not say.
  TestBody egg = MakeCap(false, false);
  egg.Faces[0].IsClosed = false;
  CheckFound("a cap of an unknown surface", egg, false, 0);
  int calls = 0;
  const std::vector<sm::BodyContradiction> found = sm::FindContradictions(egg.Faces, false,
    [&calls](std::size_t i)
    {
      ++calls;
      return i == 0;
    });
  smtest::CheckEqual("a cap of an egg by the letter", 1LL, static_cast<long long>(found.size()));
  smtest::CheckEqual("  both faces are asked for once", 2LL, static_cast<long long>(calls));
  TestBody plane = MakeCap(true, true);
  plane.Turn(1);
  CheckFound("a reversed plane next to a cap", plane, false, 0);
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

void TestExtents()
{
  TestBody caps = MakeCap(true, false);
  caps.Faces[0].Pieces = 2;
  CheckFound("two caps as one face", caps, false, 1, Type::InPieces);
  TestBody plane = MakeCap(true, false);
  plane.Faces[1].Pieces = 2;
  CheckFound("two pieces of a plane", plane, false, 0);
  TestBody torus = MakeCap(true, false);
  torus.Faces[0].IsOnBothParts = true;
  CheckFound("both parts of a torus", torus, false, 1, Type::CrossesItself);
  TestBody sphere = MakeCap(true, false);
  sphere.Statements[0].WholeArea = 12.57;
  sphere.Faces[0].Area = 12.5;
  CheckFound("less than the whole sphere", sphere, false, 0);
  sphere.Faces[0].Area = 20.0;
  CheckFound("more than the whole sphere", sphere, false, 1, Type::TooLarge);
  sphere.Statements[0].WholeVolume = 1e-4 * 12.57;
  sphere.Statements[0].Boundary.AddSegment({ 0, 0, 0 }, { 1, 0, 0 });
  CheckFound("a tube that is thinner than its triangles", sphere, false, 0);
  TestBody meshed = MakeCap(true, false);
  meshed.Statements[1].Boundary.AddSegment({ 0, 0, 0 }, { 1, 0, 0 });
  meshed.Statements[1].Boundary.AddSegment({ 1, 0, 0 }, { 0, 1, 0 });
  meshed.Statements[1].Boundary.AddSegment({ 0, 1, 0 }, { 0, 0, 0 });
  meshed.Faces[1].Area = 0.49;
  CheckFound("a face with triangles", meshed, false, 0);
  meshed.Faces[1].Area = 0.0;
  CheckFound("a face without triangles", meshed, false, 1, Type::NotInMesh, 1);
  TestBody sliver = MakeCap(true, false);
  sliver.Statements[1].Boundary.AddSegment({ 0, 0, 0 }, { 1, 0, 0 });
  sliver.Statements[1].Boundary.AddSegment({ 1, 0, 0 }, { 0.5, 1e-5, 0 });
  sliver.Statements[1].Boundary.AddSegment({ 0.5, 1e-5, 0 }, { 0, 0, 0 });
  sliver.Faces[1].Area = 0.0;
  CheckFound("a sliver without triangles", sliver, false, 0);
}

/// A segment of a disc, and another one next to it at the same arc. The arc is a sixth of the circle, or five
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
  CheckFound("one of two faces is reversed", half, false, 0);
  CheckFound("rounded corners", MakeSegments(100.0, 12.6), false, 0);
  // Both halves of a circle are the same circle when they are exchanged.
  CheckFound("a disc in two halves", MakeSegments(12.6, 25.2), false, 0);
}
}

int TestBodyCheck(int, char*[])
{
  TestCaps();
  TestExtents();
  TestArcs();
  return smtest::Finish();
}

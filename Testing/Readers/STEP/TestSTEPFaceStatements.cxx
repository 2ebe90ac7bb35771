// TestSTEPFaceStatements FILE...: what files say about their faces in space. Solids are closed: the vector
// areas of their faces cancel, and so do the uses of each edge.
#include "smPart21File.h"
#include "smSTEPCensus.h"
#include "smSTEPFaceStatements.h"
#include "smTesting.h"

#include <cmath>
#include <map>
#include <string>

namespace
{
/// Checks a file with one solid, or with parts that are closed each.
void CheckClosedSolids(const std::string& path)
{
  std::printf("%s\n", path.c_str());
  sm::Part21File file;
  smtest::CheckTrue("  it is read", file.Read(path));
  const sm::STEPCensus census = sm::TakeSTEPCensus(file);
  const sm::FaceStatements statements = sm::ReadFaceStatements(file, census);
  std::size_t faces = 0;
  for (const sm::CensusFace& face : census.Faces)
  {
    faces += statements.count(face.Id);
  }
  smtest::CheckTrue("  it has faces", faces > 0);
  smtest::CheckEqual(
    "  a statement for each", static_cast<long long>(census.Faces.size()), static_cast<long long>(faces));
  sm::Vector3 sum{};
  double perimeters = 0.0;
  int unknown = 0;
  std::map<std::uint64_t, int> uses;
  for (const auto& [id, statement] : statements)
  {
    unknown += statement.IsKnown && statement.Id == id ? 0 : 1;
    const sm::Vector3 area = statement.Boundary.GetVectorArea();
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += area[c];
    }
    perimeters += statement.Boundary.Length * statement.Boundary.Length;
    for (const sm::EdgeUseStatement& use : statement.Uses)
    {
      uses[use.Edge] += use.IsForward ? 1 : -1;
    }
  }
  int open = 0;
  for (const auto& [edge, count] : uses)
  {
    open += count != 0 ? 1 : 0;
  }
  smtest::CheckEqual("  faces that are not known", 0LL, static_cast<long long>(unknown));
  smtest::CheckEqual("  edges whose uses do not cancel", 0LL, static_cast<long long>(open));
  smtest::CheckRange(
    "  sum of the vector areas", 0.0, sm::Norm(sum) / perimeters, 1e-12, "the same edges in both directions");
}
}

int TestSTEPFaceStatements(int argc, char* argv[])
{
  for (int i = 1; i < argc; ++i)
  {
    CheckClosedSolids(argv[i]);
  }
  return smtest::Finish();
}

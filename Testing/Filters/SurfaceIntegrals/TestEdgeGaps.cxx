// The gaps of coedges add up by edge; the widest comes first, what is not known last, and is named when it
// matters.
#include "smBoxBodies.h"
#include "smEdgeGaps.h"
#include "smTesting.h"

#include <cmath>
#include <limits>

namespace
{
using smtest::Check;
using smtest::CheckEqual;
using smtest::CheckTrue;

/// Coedge (loop 0, i) of face f has the gap 1e-4 (10 f + i + 1), squared gap and area that are known
/// multiples.
std::vector<sm::FaceIntegrals> MakeResults(std::size_t faces)
{
  std::vector<sm::FaceIntegrals> results(faces);
  for (std::size_t f = 0; f < faces; ++f)
  {
    // In an order of their own: a coedge is named, not counted.
    for (int i = 3; i >= 0; --i)
    {
      const double gap = 1e-4 * static_cast<double>(10 * f + i + 1);
      results[f].Gaps.push_back({ 0, i, 3.0 * gap, 2.0 * gap, gap });
    }
  }
  return results;
}

/// The same by looking for the edge in every face.
sm::EdgeGap AddUp(const vtkTrimmedNURBSModel& model, const sm::Edge* edge)
{
  sm::EdgeGap sum;
  for (std::size_t f = 0; f < model.GetFaces().size(); ++f)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      if (model.GetFaces()[f]->Loops[0].Coedges[i].Use.get() == edge)
      {
        const double gap = 1e-4 * static_cast<double>(10 * f + i + 1);
        ++sum.Uses;
        sum.GapSquared += 3.0 * gap;
        sum.GapArea += 2.0 * gap;
        sum.MaxGap = std::max(sum.MaxGap, gap);
      }
    }
  }
  return sum;
}
}

int TestEdgeGaps(int, char*[])
{
  smtest::BoxBody body;
  body.Add({ { 0, 0, 0 }, { 1, 2, 3 }, true, 5 });
  const auto leaf = body.Make();
  vtkTrimmedNURBSModel* model = leaf->GetModel();
  std::vector<sm::FaceIntegrals> results = MakeResults(5);

  std::vector<sm::EdgeGap> edges = sm::CollectEdgeGaps(*model, &results);
  CheckEqual("edges of a box", 12, static_cast<long long>(edges.size()));
  int open = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const sm::EdgeGap expected = AddUp(*model, edges[i].Source);
    const std::string name = "edge " + std::to_string(i);
    CheckEqual(name + ": uses", expected.Uses, edges[i].Uses);
    Check(name + ": squared", expected.GapSquared, edges[i].GapSquared, 1e-18, "a sum of two");
    Check(name + ": area", expected.GapArea, edges[i].GapArea, 1e-18, "a sum of two");
    Check(name + ": widest", expected.MaxGap, edges[i].MaxGap, 0.0);
    CheckTrue(name + ": in order", i == 0 || edges[i - 1].MaxGap >= edges[i].MaxGap);
    CheckTrue(name + ": open", edges[i].IsOpen() == (edges[i].Uses == 1));
    open += edges[i].IsOpen() ? 1 : 0;
  }
  CheckEqual("a box without a lid is open", 4, open);
  Check("the widest of all", 44e-4, edges[0].MaxGap, 1e-18);

  // The widest is named above the file's tolerance, or above 1e-5 of the size, and otherwise not.
  const std::string id = "#" + std::to_string(edges[0].Source->FileId);
  const std::string said = sm::DescribeWorstEdge(edges, 3.7, "mm");
  CheckTrue(
    "it is named", said.find("0.0044 mm, at edge " + id + ", whose tolerance") != std::string::npos, said);
  sm::Edge tolerant = *edges[0].Source;
  tolerant.Tolerance = 1.0;
  tolerant.Name = "rim";
  edges[0].Source = &tolerant;
  CheckEqual("within the tolerance of a large body", "", sm::DescribeWorstEdge(edges, 1e4, "mm"));
  CheckEqual("within the tolerance of a small one",
    "the widest gap between a face and its edge is 0.0044 mm, at edge " + id + " \"rim\"",
    sm::DescribeWorstEdge(edges, 100.0, "mm"));
  edges[0].MaxGap = 1e-15;
  tolerant.Tolerance = 0.0;
  CheckEqual("rounding is not a gap", "", sm::DescribeWorstEdge(edges, 3.7, "mm"));
  CheckEqual("no edges", "", sm::DescribeWorstEdge({}, 3.7, "mm"));

  // A coedge without a row has a gap of rounding; a face that was not integrated leaves its edges unknown,
  // and last; poles are not edges.
  results[0].Gaps.clear();
  edges = sm::CollectEdgeGaps(*model, &results);
  for (const sm::EdgeGap& edge : edges)
  {
    CheckTrue("every gap is known", std::isfinite(edge.MaxGap) && std::isfinite(edge.GapArea));
  }
  results[0].Error = "a test";
  results[1].Gaps.push_back({ 7, 0, 1.0, 1.0, 1.0 });
  results[1].Gaps.push_back({ 0, -1, 1.0, 1.0, 1.0 });
  edges = sm::CollectEdgeGaps(*model, &results);
  int unknown = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    unknown += std::isnan(edges[i].MaxGap) ? 1 : 0;
    CheckTrue("unknown edges come last", std::isnan(edges[i].MaxGap) == (i >= 8));
  }
  CheckEqual("edges of the face", 4, unknown);
  results[0].Error.clear();
  results[0].Skipped = true;
  CheckTrue("the same for a skipped face", std::isnan(sm::CollectEdgeGaps(*model, &results).back().MaxGap));
  results = MakeResults(5);
  results[2].Gaps[0].MaxGap = std::numeric_limits<double>::quiet_NaN();
  edges = sm::CollectEdgeGaps(*model, &results);
  CheckTrue("a gap that is not a number is not lost", std::isnan(edges.back().MaxGap));
  results = MakeResults(5);
  results[0].Gaps[0].MaxGap = std::numeric_limits<double>::quiet_NaN();
  edges = sm::CollectEdgeGaps(*model, &results);
  CheckTrue("nor by a number that comes later", std::isnan(edges.back().MaxGap));
  edges = sm::CollectEdgeGaps(*model, nullptr);
  CheckTrue("without results nothing is known",
    edges.size() == 12 && std::isnan(edges[0].MaxGap) && sm::DescribeWorstEdge(edges, 3.7, "mm").empty());

  auto pole = std::make_shared<sm::Face>(*model->GetFaces()[0]);
  auto point = std::make_shared<sm::Edge>(*pole->Loops[0].Coedges[0].Use);
  point->Degenerate = true;
  pole->Loops[0].Coedges[0].Use = point;
  model->SetFace(0, pole);
  CheckEqual(
    "a pole is not an edge", 12, static_cast<long long>(sm::CollectEdgeGaps(*model, nullptr).size()));
  CheckTrue("the edge it replaces is open", sm::CollectEdgeGaps(*model, nullptr)[0].Source != point.get());
  return smtest::Finish();
}

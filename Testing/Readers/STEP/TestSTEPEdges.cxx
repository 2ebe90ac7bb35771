// TestSTEPEdges: edges of a file on their curves, by the definition of edge_curve. TestSTEPEdges models
// FILE... compares the edges of real files with those of the reader, which are OpenCASCADE's.
#include "Geometry/smCurveFoot.h"
#include "smReaderTesting.h"
#include "smSTEPCensus.h"
#include "smSTEPEdges.h"

#include "vtkCompositeDataIterator.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>

namespace
{
using namespace smtest;
using sm::Vector3;

constexpr double QuarterTurn = 1.5707963267948966;
constexpr double EdgeRounding = 1e-12;

double GetAway(const Vector3& a, const Vector3& b)
{
  return sm::Norm(sm::Subtract(a, b));
}

/// Vertices #11 (2,0,0), #12 (0,2,0), #13 (-2,0,0), #14 (0,0,0) and #15 (3,0,0), on curves about the origin.
class EdgeSample
{
public:
  explicit EdgeSample(const std::string& entities)
  {
    this->File.Parse(
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n"
      "#1=CARTESIAN_POINT('',(2.,0.,0.));\n#2=CARTESIAN_POINT('',(0.,2.,0.));\n#3=CARTESIAN_POINT('',(-2.,0.,"
      "0.));\n"
      "#4=CARTESIAN_POINT('',(0.,0.,0.));\n#5=CARTESIAN_POINT('',(3.,0.,0.));\n#6=DIRECTION('',(1.,0.,0.));\n"
      "#7=VECTOR('',#6,2.);\n#8=AXIS2_PLACEMENT_3D('',#4,$,#6);\n"
      "#11=VERTEX_POINT('',#1);\n#12=VERTEX_POINT('',#2);\n#13=VERTEX_POINT('',#3);\n#14=VERTEX_POINT('',#4);"
      "\n"
      "#15=VERTEX_POINT('',#5);\n"
      "#21=LINE('',#4,#7);\n#22=CIRCLE('',#8,2.);\n#23=PARABOLA('',#8,0.5);\n#24=POLYLINE('',(#1,#2,#3,#1));"
      "\n"
      "#25=TRIMMED_CURVE('',#22,(PARAMETER_VALUE(3.)),(PARAMETER_VALUE(1.)),.F.,.PARAMETER.);\n"
      "#26=POLYLINE('',(#1,#2,#3));\n" +
      entities + "ENDSEC;\nEND-ISO-10303-21;\n");
    this->Entities = std::make_unique<sm::STEPAttributes>(this->File);
    this->Geometry = std::make_unique<sm::STEPGeometry>(*this->Entities, sm::STEPUnitSizes(), this->Ledger);
    this->Edges =
      std::make_unique<sm::STEPEdges>(*this->Entities, sm::STEPUnitSizes(), *this->Geometry, this->Ledger);
  }

  const sm::STEPEdge* Get(std::uint64_t id) { return this->Edges->GetEdge(this->File.Find(id)); }

  sm::Part21File File;
  std::unique_ptr<sm::STEPAttributes> Entities;
  sm::STEPLedger Ledger;
  std::unique_ptr<sm::STEPGeometry> Geometry;
  std::unique_ptr<sm::STEPEdges> Edges;
};

void CheckPart(const std::string& name, const sm::STEPEdge* edge, double width, const Vector3& middle,
  bool isForward, bool isTurned = false)
{
  CheckTrue(name, edge != nullptr);
  if (edge)
  {
    Check(name + ": width of its range", width, edge->Last - edge->First, EdgeRounding);
    Check(name + ": middle", 0.0, GetAway(edge->Curve->Evaluate(0.5 * (edge->First + edge->Last)), middle),
      EdgeRounding, "rounding");
    CheckTrue(name + ": sense", edge->IsForward == isForward && edge->IsTurned == isTurned);
    Check(name + ": gap", 0.0, edge->Gap, EdgeRounding);
  }
}

void TestParts()
{
  EdgeSample s("#31=EDGE_CURVE('e',#14,#11,#21,.T.);\n#32=EDGE_CURVE('',#11,#14,#21,.F.);\n"
               "#33=EDGE_CURVE('',#11,#14,#21,.T.);\n#34=EDGE_CURVE('',#11,#12,#22,.T.);\n"
               "#35=EDGE_CURVE('',#11,#12,#22,.F.);\n#36=EDGE_CURVE('',#12,#12,#22,.T.);\n"
               "#37=EDGE_CURVE('',#14,#14,#21,.T.);\n#38=EDGE_CURVE('',#11,#13,#24,.T.);\n"
               "#39=EDGE_CURVE('',#13,#12,#24,.T.);\n#40=EDGE_CURVE('',#11,#11,#24,.T.);\n"
               "#41=EDGE_CURVE('',#12,#12,#24,.T.);\n#42=EDGE_CURVE('',#12,#11,#25,.T.);\n"
               "#43=EDGE_CURVE('',#13,#11,#26,.T.);\n#44=EDGE_CURVE('',#14,#15,#99,.T.);\n"
               "#45=EDGE_CURVE('',#14,#15,#22,.T.);\n");
  const double root = std::sqrt(2.0);
  CheckPart("line", s.Get(31), 2.0, { 1.0, 0.0, 0.0 }, true);
  CheckEqual("its name", "e", s.Get(31) ? s.Get(31)->Name : "");
  CheckPart("line against its curve", s.Get(32), 2.0, { 1.0, 0.0, 0.0 }, false);
  CheckPart("line whose sense contradicts it", s.Get(33), 2.0, { 1.0, 0.0, 0.0 }, false, true);
  CheckPart("quarter of a circle", s.Get(34), QuarterTurn, { root, root, 0.0 }, true);
  CheckPart("the other three quarters", s.Get(35), 3.0 * QuarterTurn, { -root, -root, 0.0 }, false);
  CheckPart("whole circle", s.Get(36), 4.0 * QuarterTurn, { 0.0, -2.0, 0.0 }, true);
  CheckTrue("a line between equal vertices", !s.Get(37));
  CheckTrue("has a row",
    s.Ledger.Rows.size() == 1 && s.Ledger.Rows[0].Id == 37 &&
      s.Ledger.Rows[0].Reason.find("not closed") != std::string::npos);
  CheckPart("two of three sides", s.Get(38), 2.0, { 0.0, 2.0, 0.0 }, true);
  CheckPart("two sides over the seam", s.Get(39), 2.0, { 2.0, 0.0, 0.0 }, true);
  CheckPart("a whole closed polyline", s.Get(40), 3.0, { -1.0, 1.0, 0.0 }, true);
  CheckPart("from a vertex within", s.Get(41), 3.0, { 0.0, 0.0, 0.0 }, true);
  CheckPart("a trimmed circle against its basis", s.Get(42), QuarterTurn, { root, root, 0.0 }, false);
  CheckPart("an open polyline whose sense contradicts it", s.Get(43), 2.0, { 0.0, 2.0, 0.0 }, false, true);
  CheckTrue("a curve that is missing", !s.Get(44) && s.Ledger.Rows.back().Id == 44);
  Check("vertices off the circle: gap", 2.0, s.Get(45) ? s.Get(45)->Gap : 0.0, EdgeRounding);
  CheckTrue("no edge", !s.Get(21) && s.Ledger.Rows.back().Id == 21);
  CheckEqual("edges that are left out", 3, static_cast<long long>(s.Ledger.Rows.size()));
}

/// Numbers of compared edges by what was found.
struct EdgeTally
{
  long long Compared = 0;
  long long Refused = 0;
  long long Different = 0;
  std::map<std::string, long long> Reasons;
};

/// Returns how far an edge of the reader lies from ours: the ends in either direction, and points between
/// from the curve. Repaired edges have other parameters.
double GetDifference(const sm::STEPEdge& own, const sm::Edge& edge, const double origin[3])
{
  const auto getPoint = [&](double x)
  {
    Vector3 p = edge.Curve.Evaluate((1.0 - x) * edge.Curve.GetStart() + x * edge.Curve.GetEnd());
    for (int c = 0; c < 3; ++c)
    {
      p[c] += origin[c];
    }
    return p;
  };
  const Vector3 ends[2] = { own.Curve->Evaluate(own.First), own.Curve->Evaluate(own.Last) };
  const double along = std::max(GetAway(getPoint(0.0), ends[0]), GetAway(getPoint(1.0), ends[1]));
  const double against = std::max(GetAway(getPoint(0.0), ends[1]), GetAway(getPoint(1.0), ends[0]));
  double difference = std::min(along, against);
  for (const double x : { 0.23, 0.5, 0.81 })
  {
    const Vector3 p = getPoint(x);
    const double y = along <= against ? x : 1.0 - x;
    const double direct = GetAway(p, own.Curve->Evaluate((1.0 - y) * own.First + y * own.Last));
    const double foot = sm::FindCurveParameter<3>(*own.Curve, p);
    difference = std::max(difference, std::min(direct, GetAway(p, own.Curve->Evaluate(foot))));
  }
  return difference;
}

double GetLargest(const sm::STEPEdge& own)
{
  double largest = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    largest = std::max({ largest, std::abs(own.Start[c]), std::abs(own.End[c]) });
  }
  return largest;
}

void CompareEdges(const std::string& path, EdgeTally& tally)
{
  vtkNew<vtkSTEPReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  sm::Part21File file;
  file.Read(path);
  const sm::STEPAttributes entities(file);
  sm::STEPUnitSizes units;
  for (const sm::CensusContext& context : sm::TakeSTEPCensus(file).Contexts)
  {
    units.Length = context.Used && context.Length.Factor > 0.0 ? context.Length.Factor : units.Length;
    units.Angle = context.Used && context.Angle.Factor > 0.0 ? context.Angle.Factor : units.Angle;
  }
  sm::STEPLedger ledger;
  sm::STEPGeometry geometry(entities, units, ledger);
  sm::STEPEdges edges(entities, units, geometry, ledger);
  std::set<const sm::Edge*> seen;
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(reader->GetOutput()->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto* leaf = vtkNURBSDataSet::SafeDownCast(it->GetCurrentDataObject());
    for (const sm::FacePointer& face : leaf ? leaf->GetModel()->GetFaces() : std::vector<sm::FacePointer>())
    {
      for (const sm::Loop& loop : face->Loops)
      {
        for (const sm::Coedge& coedge : loop.Coedges)
        {
          const sm::Edge& edge = *coedge.Use;
          if (edge.FileId == 0 || edge.Degenerate || !seen.insert(&edge).second)
          {
            continue;
          }
          const sm::STEPEdge* own = edges.GetEdge(file.Find(edge.FileId));
          if (!own)
          {
            ++tally.Refused;
            continue;
          }
          ++tally.Compared;
          const double difference = GetDifference(*own, edge, leaf->GetModel()->GetOrigin());
          // Ends may be as far from the vertices as the gaps of either side; feet are rounded.
          const double gap = std::max(GetAway(edge.Curve.GetStartPoint(), edge.StartVertex),
            GetAway(edge.Curve.GetEndPoint(), edge.EndVertex));
          if (gap > 1e-6 + 2.0 * own->Gap)
          {
            std::printf("%s #%lld: the reader's edge ends %g from its vertex, ours %g\n", path.c_str(),
              static_cast<long long>(edge.FileId), gap, own->Gap);
          }
          if (!(difference <= 1e-6 + 2.0 * (own->Gap + gap) + 1e-12 * GetLargest(*own)))
          {
            ++tally.Different;
            std::printf("%s #%lld: %g, gap %g\n", path.c_str(), static_cast<long long>(edge.FileId),
              difference, own->Gap);
          }
        }
      }
    }
  }
  for (const sm::LedgerRow& row : ledger.Rows)
  {
    ++tally.Reasons[row.Type + ": " + row.Reason];
  }
}
}

int TestSTEPEdges(int argc, char* argv[])
{
  if (argc > 2 && !std::strcmp(argv[1], "models"))
  {
    EdgeTally tally;
    for (int i = 2; i < argc; ++i)
    {
      CompareEdges(argv[i], tally);
    }
    for (const auto& [reason, count] : tally.Reasons)
    {
      std::printf("%lld in the ledger: %s\n", count, reason.c_str());
    }
    CheckRange("edges compared", 1.0, static_cast<double>(tally.Compared), 1e9);
    CheckEqual("edges of the reader that are refused", 0, tally.Refused);
    CheckEqual("edges that lie elsewhere", 0, tally.Different);
    return Finish();
  }
  TestParts();
  return Finish();
}

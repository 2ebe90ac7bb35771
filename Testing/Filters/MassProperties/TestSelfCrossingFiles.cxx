// TestSelfCrossingFiles FOLDER: polyhedra from hand-written STEP that cross themselves are suspect, with the
// face and what it means for the volume; the same ones that only touch themselves are ok.
#include "smStepText.h"
#include "smTestPipeline.h"

#include <fstream>
#include <iterator>
#include <regex>

namespace
{
using namespace smtest;
namespace names = sm::names;
using Point = StepText::Point;

std::string Folder;

/// The file is suspect, and it is said; or ok, without a message of the filter, and the reader says `read`.
void CheckFile(const std::string& name, double volume, const std::string& said,
  const std::string& read = std::string(), bool repairAll = false)
{
  std::printf("--- %s%s\n", name.c_str(), repairAll ? ", all repaired" : "");
  Pipeline pipeline(Folder + "/crossing_" + name + ".step");
  pipeline.Reader->SetRepair(repairAll ? vtkSTEPReader::ALWAYS : vtkSTEPReader::ON_NEED);
  MessageTrap reader(pipeline.Reader);
  MessageTrap filter(pipeline.Mass);
  pipeline.Mass->Update();
  CheckEqual(
    "status", said.empty() ? names::StatusOk : names::StatusSuspect, std::string(pipeline.Mass->GetStatus()));
  CheckTrue("messages", said.empty() ? pipeline.Mass->GetNumberOfMessages() == 0 : Says(pipeline.Mass, said),
    GetMessages(pipeline.Mass));
  Check("oriented volume", volume, pipeline.Mass->GetVolume(), 1e-12 * 300.0, "planes: rounding");
  std::string messages;
  for (int i = 0; i < pipeline.Reader->GetNumberOfMessages(); ++i)
  {
    messages += pipeline.Reader->GetMessage(i) + "\n";
  }
  CheckTrue("read", messages.find(read) != std::string::npos, messages);
}

/// A prism over a polygon that is 3 high.
void WritePrism(const std::string& name, const std::vector<std::array<double, 2>>& corners)
{
  StepPrism::Polygon polygon{ {}, true };
  for (const auto& [x, y] : corners)
  {
    polygon.Corners.push_back({ x, y, static_cast<int>(polygon.Corners.size()) });
  }
  StepPrism().Write(Folder + "/crossing_" + name + ".step", { polygon }, 3.0);
}

/// Planar faces whose straight edges are shared; a face is a list of loops of points, the first one outer,
/// counter-clockwise from outside.
class Polyhedron
{
public:
  void AddFace(const std::vector<std::vector<Point>>& loops)
  {
    std::vector<std::string> bounds;
    for (const std::vector<Point>& loop : loops)
    {
      std::vector<std::string> oriented;
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        oriented.push_back(this->GetEdge(loop[i], loop[(i + 1) % loop.size()]));
      }
      bounds.push_back(this->Text.AddBound(this->Text.AddEdgeLoop(oriented), bounds.empty()));
    }
    const Point a = Along(loops[0][0], loops[0][1]);
    const Point b = Along(loops[0][0], loops[0][2]);
    const Point normal = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
    this->Faces.push_back(this->Text.AddFace(
      bounds, this->Text.Add("PLANE(''," + this->Text.AddFrame(loops[0][0], normal, a) + ")")));
  }
  void Write(const std::string& name, const std::string& uncertainty = "1.E-07")
  {
    this->Text.Write(Folder + "/crossing_" + name + ".step", this->Faces, uncertainty);
  }

private:
  static Point Along(const Point& from, const Point& to)
  {
    return { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
  }
  std::string GetVertex(const Point& p)
  {
    std::string& vertex = this->Vertices[p];
    vertex = vertex.empty() ? this->Text.AddVertex(p) : vertex;
    return vertex;
  }
  std::string GetEdge(const Point& from, const Point& to)
  {
    const Point& low = std::min(from, to);
    const Point& high = std::max(from, to);
    std::string& edge = this->Edges[{ low, high }];
    if (edge.empty())
    {
      edge = this->Text.AddLine(this->GetVertex(low), this->GetVertex(high), low, high);
    }
    return this->Text.AddOriented(edge, from < to);
  }

  StepText Text;
  std::vector<std::string> Faces;
  std::map<Point, std::string> Vertices;
  std::map<std::pair<Point, Point>, std::string> Edges;
};

/// The corners of a box, counter-clockwise seen from above, at the height z.
std::vector<Point> MakeRing(const Point& low, const Point& high, double z)
{
  return { { low[0], low[1], z }, { high[0], low[1], z }, { high[0], high[1], z }, { low[0], high[1], z } };
}

/// The four sides of a box between two of its rings, seen from outside.
void AddSides(Polyhedron& solid, const std::vector<Point>& bottom, const std::vector<Point>& top)
{
  for (int i = 0; i < 4; ++i)
  {
    const int next = (i + 1) % 4;
    solid.AddFace({ { bottom[i], bottom[next], top[next], top[i] } });
  }
}

std::vector<Point> Reversed(const std::vector<Point>& points)
{
  return { points.rbegin(), points.rend() };
}

/// A prism, 3 high, between two cubic curves in the plane that lead from (0,0) to (10,0), and back with the
/// inner control points p and q.
void WriteLens(const std::string& name, const Point& p, const Point& q)
{
  StepText text;
  const std::vector<Point> curves[2] = { { { 0, 0, 0 }, { 3, -4, 0 }, { 7, -4, 0 }, { 10, 0, 0 } },
    { { 10, 0, 0 }, p, q, { 0, 0, 0 } } };
  const Point axis{ 0, 0, 1 };
  std::string vertices[2][2];
  std::string uprights[2];
  for (int end = 0; end < 2; ++end)
  {
    const Point low = curves[end][0];
    const Point high{ low[0], low[1], 3.0 };
    vertices[end][0] = text.AddVertex(low);
    vertices[end][1] = text.AddVertex(high);
    uprights[end] = text.AddLine(vertices[end][0], vertices[end][1], low, high);
  }
  std::vector<std::string> faces;
  std::string edges[2][2];
  for (int c = 0; c < 2; ++c)
  {
    std::string curve[2];
    for (int side = 0; side < 2; ++side)
    {
      std::vector<std::string> points;
      for (const Point& point : curves[c])
      {
        points.push_back(text.AddPoint({ point[0], point[1], 3.0 * side }));
      }
      curve[side] = text.Add("B_SPLINE_CURVE_WITH_KNOTS('',3," + StepText::List(points) +
        ",.UNSPECIFIED.,.F.,.F.,(4,4),(0.,1.),.UNSPECIFIED.)");
      edges[c][side] = text.Add(
        "EDGE_CURVE(''," + vertices[c][side] + "," + vertices[1 - c][side] + "," + curve[side] + ",.T.)");
    }
    const std::string vector = text.Add("VECTOR(''," + text.AddDirection(axis) + ",1.)");
    const std::string loop =
      text.AddEdgeLoop({ text.AddOriented(edges[c][0], true), text.AddOriented(uprights[1 - c], true),
        text.AddOriented(edges[c][1], false), text.AddOriented(uprights[c], false) });
    faces.push_back(text.AddFace({ text.AddBound(loop, true) },
      text.Add("SURFACE_OF_LINEAR_EXTRUSION(''," + curve[0] + "," + vector + ")")));
  }
  for (int side = 0; side < 2; ++side)
  {
    const int first = 1 - side;
    const std::string loop = text.AddEdgeLoop(
      { text.AddOriented(edges[first][side], side == 1), text.AddOriented(edges[side][side], side == 1) });
    const std::string frame =
      text.AddFrame({ 0, 0, 3.0 * side }, { 0, 0, side == 0 ? -1.0 : 1.0 }, { 1, 0, 0 });
    faces.push_back(text.AddFace({ text.AddBound(loop, true) }, text.Add("PLANE(''," + frame + ")")));
  }
  text.Write(Folder + "/crossing_" + name + ".step", faces);
}

/// Boxes in one shell.
void WriteBoxes(const std::string& name, const std::vector<std::array<Point, 2>>& boxes)
{
  Polyhedron solid;
  for (const auto& [low, high] : boxes)
  {
    const std::vector<Point> bottom = MakeRing(low, high, low[2]);
    const std::vector<Point> top = MakeRing(low, high, high[2]);
    solid.AddFace({ Reversed(bottom) });
    solid.AddFace({ top });
    AddSides(solid, bottom, top);
  }
  solid.Write(name);
}

/// Boxes in one shell; those that are said to be have all normals inwards.
void WriteSides(
  const std::string& name, const std::vector<std::array<Point, 2>>& boxes, const std::vector<bool>& inwards)
{
  Polyhedron solid;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    const std::vector<Point> bottom = MakeRing(boxes[i][0], boxes[i][1], boxes[i][0][2]);
    const std::vector<Point> top = MakeRing(boxes[i][0], boxes[i][1], boxes[i][1][2]);
    solid.AddFace({ inwards[i] ? bottom : Reversed(bottom) });
    solid.AddFace({ inwards[i] ? Reversed(top) : top });
    AddSides(solid, inwards[i] ? Reversed(bottom) : bottom, inwards[i] ? Reversed(top) : top);
  }
  solid.Write(name);
}

/// The file says which shell is a void: it is one whatever its normals are, and if they are wrong that is
/// said.
void CheckDeclaredVoids(const std::array<Point, 2>& outer, const std::array<Point, 2>& inner)
{
  for (const bool isInsideOut : { false, true })
  {
    // ORIENTED_CLOSED_SHELL turns the shell of the void.
    WriteSides("declared_void", { outer, inner }, { false, isInsideOut });
    const std::string path = Folder + "/crossing_declared_void.step";
    std::ifstream file(path);
    std::string text((std::istreambuf_iterator<char>(file)), {});
    const std::regex shell(R"((#\d+)=CLOSED_SHELL\('',\(((?:#\d+,){5}#\d+),([#\d,]+)\)\);)");
    text = std::regex_replace(text, shell,
      "$1=CLOSED_SHELL('',($2));\n#9001=CLOSED_SHELL('',($3));\n#9002=ORIENTED_CLOSED_SHELL('',*,#9001,.F.)"
      ";");
    text = std::regex_replace(
      text, std::regex(R"(MANIFOLD_SOLID_BREP\('solid',(#\d+)\))"), "BREP_WITH_VOIDS('solid',$1,(#9002))");
    std::ofstream(path) << text;
    for (const bool repairAll : { false, true })
    {
      std::printf("--- a declared void, inside out: %d, all repaired: %d\n", isInsideOut, repairAll);
      Pipeline pipeline(path);
      pipeline.Reader->SetRepair(repairAll ? vtkSTEPReader::ALWAYS : vtkSTEPReader::ON_NEED);
      pipeline.Mass->Update();
      std::string messages = GetMessages(pipeline.Mass);
      for (int i = 0; i < pipeline.Reader->GetNumberOfMessages(); ++i)
      {
        messages += std::string("\n") + pipeline.Reader->GetMessage(i);
      }
      CheckEqual("status", names::StatusOk, std::string(pipeline.Mass->GetStatus()));
      Check("volume", 994.0, pipeline.Mass->GetVolume(), 1e-12 * 1000.0, "planes: rounding");
      CheckTrue("it is said of a void that is inside out",
        (messages.find("inside out") != std::string::npos) == isInsideOut, messages);
    }
  }
}

/// A plate of 10 x 10 with rectangular holes through it, wherever they lie.
void WritePlate(const std::string& name, const std::vector<std::array<Point, 2>>& holes, double height,
  const std::string& uncertainty = "1.E-07")
{
  const Point zero{ 0.0, 0.0, 0.0 };
  const Point ten{ 10.0, 10.0, 10.0 };
  Polyhedron plate;
  std::vector<std::vector<Point>> top = { MakeRing(zero, ten, height) };
  std::vector<std::vector<Point>> bottom = { Reversed(MakeRing(zero, ten, 0.0)) };
  AddSides(plate, MakeRing(zero, ten, 0.0), top[0]);
  for (const auto& [low, high] : holes)
  {
    top.push_back(Reversed(MakeRing(low, high, height)));
    bottom.push_back(MakeRing(low, high, 0.0));
    AddSides(plate, Reversed(bottom.back()), top.back());
  }
  plate.AddFace(top);
  plate.AddFace(bottom);
  plate.Write(name, uncertainty);
}

/// A box of 1 x 2 x 3 with two faces more: twice its top, or twice a diagonal wall, with opposite sides.
void WriteMembrane(const std::string& name, const std::vector<Point>& wall)
{
  const Point low{ 0.0, 0.0, 0.0 };
  const Point high{ 1.0, 2.0, 3.0 };
  Polyhedron box;
  box.AddFace({ Reversed(MakeRing(low, high, 0.0)) });
  box.AddFace({ MakeRing(low, high, 3.0) });
  AddSides(box, MakeRing(low, high, 0.0), MakeRing(low, high, 3.0));
  box.AddFace({ wall });
  box.AddFace({ Reversed(wall) });
  box.Write(name);
}

/// A block of 10 x 10 x 10 with a pocket of 4 x 4 from its top down to z = bottom.
void WritePocket(const std::string& name, double bottom)
{
  const Point zero{ 0.0, 0.0, 0.0 };
  const Point ten{ 10.0, 10.0, 10.0 };
  const Point low{ 3.0, 3.0, 0.0 };
  const Point high{ 7.0, 7.0, 0.0 };
  const std::vector<Point> mouth = Reversed(MakeRing(low, high, 10.0));
  const std::vector<Point> floor = MakeRing(low, high, bottom);
  Polyhedron block;
  block.AddFace({ Reversed(MakeRing(zero, ten, 0.0)) });
  block.AddFace({ MakeRing(zero, ten, 10.0), mouth });
  block.AddFace({ floor });
  AddSides(block, MakeRing(zero, ten, 0.0), MakeRing(zero, ten, 10.0));
  AddSides(block, Reversed(floor), mouth);
  block.Write(name);
}
}

int TestSelfCrossingFiles(int argc, char* argv[])
{
  RequireUsage(argc == 2, "TestSelfCrossingFiles FOLDER");
  Folder = argv[1];
  const std::string loops = "a loop covers part of the surface more than once or from outside";
  // In the second one a curve leaves (10,0) below the other one, and crosses it. Areas: the integral of x dy
  // over the cubics.
  WriteLens("lens", { 7, 4, 0 }, { 3, 4, 0 });
  CheckFile("lens", 122.4, "");
  WriteLens("figure_of_eight", { 9, -4, 0 }, { 3, 12, 0 });
  CheckFile("figure_of_eight", 133.2, loops);
  WritePrism("touching", { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 2, 0.001 }, { 0, 4 } });
  CheckFile("touching", 3.0 * (8.0 + 0.002), "");
  // One loop of straight edges in each of two faces: the larger part less the smaller one.
  WritePrism("bow_tie", { { 0, 0 }, { 6, 0 }, { 0, 4 }, { 3, 3 } });
  CheckFile("bow_tie", 3.0 * 6.0, loops);
  WritePrism("bow_tie_of_equal_parts", { { 0, 0 }, { 6, 0 }, { 0, 4 }, { 6, 4 } });
  CheckFile("bow_tie_of_equal_parts", 0.0, loops);

  const std::string crosses = "its boundary crosses itself: near face #";
  const std::string subtracted = "its winding number is -1: the volume there is subtracted";
  WritePocket("pocket", 2.0);
  CheckFile("pocket", 1000.0 - 16.0 * 8.0, "");
  WritePocket("pocket_with_a_thin_floor", 1e-4);
  CheckFile("pocket_with_a_thin_floor", 1000.0 - 16.0 * (10.0 - 1e-4), "");
  WritePocket("pocket_through_the_floor", -3.0);
  CheckFile("pocket_through_the_floor", 1000.0 - 16.0 * 13.0, crosses);
  CheckFile("pocket_through_the_floor", 1000.0 - 16.0 * 13.0, subtracted);
  WritePocket("pocket_slightly_through_the_floor", -0.01);
  CheckFile("pocket_slightly_through_the_floor", 1000.0 - 16.0 * 10.01, subtracted);

  // OpenCASCADE makes a solid of each box.
  const std::string twice = "its winding number is 2: the volume there counts 2 times";
  WriteBoxes("boxes_that_overlap",
    { { Point{ 0, 0, 0 }, Point{ 1, 1, 1 } }, { Point{ 0.5, 0.2, 0.1 }, Point{ 2, 2, 2 } } });
  CheckFile("boxes_that_overlap", 1.0 + 1.5 * 1.8 * 1.9, twice);
  WriteBoxes(
    "boxes_apart", { { Point{ 0, 0, 0 }, Point{ 1, 1, 1 } }, { Point{ 1.5, 0.2, 0.1 }, Point{ 2, 2, 2 } } });
  CheckFile("boxes_apart", 1.0 + 0.5 * 1.8 * 1.9, "");
  WriteBoxes("boxes_side_by_side",
    { { Point{ 0, 0, 0 }, Point{ 1, 1, 1 } }, { Point{ 1, 0.2, 0.1 }, Point{ 2, 2, 2 } } });
  CheckFile("boxes_side_by_side", 1.0 + 1.0 * 1.8 * 1.9, "");

  // Loops that cross none, in plates too thin for the samples of the mesh, and where the file states a large
  // uncertainty.
  const std::array<Point, 2> hole{ Point{ 1, 1, 0 }, Point{ 6, 6, 0 } };
  const std::array<Point, 2> inHole{ Point{ 2, 2, 0 }, Point{ 3, 3, 0 } };
  const std::array<Point, 2> outside{ Point{ 20, 1, 0 }, Point{ 22, 3, 0 } };
  for (const double height : { 0.1, 1.0 })
  {
    for (const char* uncertainty : { "1.E-07", "1." })
    {
      WritePlate("plate", { hole }, height, uncertainty);
      CheckFile("plate", 75.0 * height, "");
      WritePlate("hole_in_hole", { hole, inHole }, height, uncertainty);
      CheckFile("hole_in_hole", 74.0 * height, loops);
      WritePlate("hole_outside", { outside }, height, uncertainty);
      CheckFile("hole_outside", 96.0 * height, loops);
    }
  }

  const std::string onEachOther =
    "lie on each other with opposite sides: both areas count, and no volume; edge #";
  WriteMembrane("top_three_times", MakeRing({ 0, 0, 0 }, { 1, 2, 3 }, 3.0));
  CheckFile("top_three_times", 6.0, onEachOther);
  CheckFile("top_three_times", 6.0, "is used 4 times");
  WriteMembrane("wall", { { 0, 0, 0 }, { 1, 2, 0 }, { 1, 2, 3 }, { 0, 0, 3 } });
  CheckFile("wall", 6.0, onEachOther);

  const std::array<Point, 2> outer{ Point{ 0, 0, 0 }, Point{ 10, 10, 10 } };
  const std::array<Point, 2> inner{ Point{ 1, 1, 1 }, Point{ 2, 3, 4 } };
  const std::array<Point, 2> beside{ Point{ 12, 0, 0 }, Point{ 13, 1, 1 } };
  const std::string turned = "OpenCASCADE reversed it, against what the file states";
  const std::string insideOut = "1 solid is inside out in the file, and reversed: #";
  WriteSides("void", { outer, inner }, { false, true });
  WriteSides("void_that_is_solid", { outer, inner }, { false, false });
  WriteSides("void_in_a_turned_box", { outer, inner }, { true, true });
  WriteSides("turned_with_its_void", { outer, inner }, { true, false });
  WriteSides("turned_box", { inner }, { true });
  WriteSides("turned_box_beside_another", { outer, beside }, { false, true });
  for (const bool repairAll : { false, true })
  {
    CheckFile("void", 994.0, "", "", repairAll);
    CheckFile("void_that_is_solid", 994.0, turned, "", repairAll);
    CheckFile("void_in_a_turned_box", 994.0, turned, "", repairAll);
    CheckFile("turned_with_its_void", 994.0, "", insideOut, repairAll);
    CheckFile("turned_box", 6.0, "", insideOut, repairAll);
    CheckFile("turned_box_beside_another", 1001.0, "", insideOut, repairAll);
  }
  CheckDeclaredVoids(outer, inner);
  return Finish();
}

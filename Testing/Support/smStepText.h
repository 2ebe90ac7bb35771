/**
 * @file smStepText.h
 * @brief Small STEP files written by hand: loops as no modelling kernel writes them
 */
#ifndef smStepText_h
#define smStepText_h

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace smtest
{
/// Entities of one solid in mm; every method answers the reference "#n" of what it added.
class StepText
{
public:
  using Point = std::array<double, 3>;

  std::string Add(const std::string& entity)
  {
    this->Entities += "#" + std::to_string(this->Next) + "=" + entity + ";\n";
    return "#" + std::to_string(this->Next++);
  }
  static std::string List(const std::vector<std::string>& items)
  {
    std::string text;
    for (const std::string& item : items)
    {
      text += (text.empty() ? "" : ",") + item;
    }
    return "(" + text + ")";
  }
  std::string AddPoint(const Point& p) { return this->Add("CARTESIAN_POINT(''," + Triple(p) + ")"); }
  std::string AddDirection(const Point& p) { return this->Add("DIRECTION(''," + Triple(p) + ")"); }
  std::string AddVertex(const Point& p) { return this->Add("VERTEX_POINT(''," + this->AddPoint(p) + ")"); }
  std::string AddFrame(const Point& origin, const Point& axis, const Point& x)
  {
    return this->Add("AXIS2_PLACEMENT_3D(''," + this->AddPoint(origin) + "," + this->AddDirection(axis) +
      "," + this->AddDirection(x) + ")");
  }
  std::string AddLine(const std::string& from, const std::string& to, const Point& a, const Point& b)
  {
    const Point along = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    const std::string vector = this->Add("VECTOR(''," + this->AddDirection(along) + ",1.)");
    const std::string line = this->Add("LINE(''," + this->AddPoint(a) + "," + vector + ")");
    return this->Add("EDGE_CURVE(''," + from + "," + to + "," + line + ",.T.)");
  }
  std::string AddOriented(const std::string& edge, bool forward)
  {
    return this->Add("ORIENTED_EDGE('',*,*," + edge + (forward ? ",.T.)" : ",.F.)"));
  }
  std::string AddEdgeLoop(const std::vector<std::string>& oriented)
  {
    return this->Add("EDGE_LOOP(''," + List(oriented) + ")");
  }
  std::string AddVertexLoop(const std::string& vertex) { return this->Add("VERTEX_LOOP(''," + vertex + ")"); }
  std::string AddBound(const std::string& loop, bool outer)
  {
    return this->Add(std::string(outer ? "FACE_OUTER_BOUND" : "FACE_BOUND") + "(''," + loop + ",.T.)");
  }
  std::string AddFace(const std::vector<std::string>& bounds, const std::string& surface)
  {
    return this->Add("ADVANCED_FACE(''," + List(bounds) + "," + surface + ",.T.)");
  }

  /// A closed solid of these faces, as a whole file that states this uncertainty of lengths.
  void Write(
    const std::string& path, const std::vector<std::string>& faces, const std::string& uncertainty = "1.E-07")
  {
    const std::string shell = this->Add("CLOSED_SHELL(''," + List(faces) + ")");
    const std::string solid = this->Add("MANIFOLD_SOLID_BREP('solid'," + shell + ")");
    const std::string length = this->Add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const std::string angle = this->Add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const std::string solidAngle = this->Add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const std::string accuracy = this->Add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(" + uncertainty +
      ")," + length + ",'distance_accuracy_value','')");
    const std::string context =
      this->Add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((" + accuracy +
        "))GLOBAL_UNIT_ASSIGNED_CONTEXT((" + length + "," + angle + "," + solidAngle +
        "))REPRESENTATION_CONTEXT('',''))");
    const std::string shape = this->Add("ADVANCED_BREP_SHAPE_REPRESENTATION(''," +
      List({ this->AddFrame({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }), solid }) + "," + context + ")");
    const std::string application = this->Add("APPLICATION_CONTEXT('')");
    const std::string productContext = this->Add("PRODUCT_CONTEXT(''," + application + ",'mechanical')");
    const std::string product = this->Add("PRODUCT('solid','solid','',(" + productContext + "))");
    const std::string formation = this->Add("PRODUCT_DEFINITION_FORMATION('',''," + product + ")");
    const std::string designContext =
      this->Add("PRODUCT_DEFINITION_CONTEXT(''," + application + ",'design')");
    const std::string definition =
      this->Add("PRODUCT_DEFINITION('',''," + formation + "," + designContext + ")");
    const std::string definitionShape = this->Add("PRODUCT_DEFINITION_SHAPE('',''," + definition + ")");
    this->Add("SHAPE_DEFINITION_REPRESENTATION(" + definitionShape + "," + shape + ")");
    std::ofstream(path) << "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n"
                           "FILE_NAME('','2024-01-01T00:00:00',(''),(''),'','','');\n"
                           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n"
                        << this->Entities << "ENDSEC;\nEND-ISO-10303-21;\n";
  }

private:
  static std::string Triple(const Point& p)
  {
    char text[120];
    std::snprintf(text, sizeof(text), "(%.16E,%.16E,%.16E)", p[0], p[1], p[2]);
    return text;
  }

  std::string Entities;
  int Next = 1;
};

/// A prism over a region bounded by polygons: outer ones counter-clockwise, holes clockwise. Corners at one
/// place with the same number share a vertex, and an upright edge.
class StepPrism
{
public:
  struct Corner
  {
    double X;
    double Y;
    int Number;
  };
  struct Polygon
  {
    std::vector<Corner> Corners;
    bool Outer;
  };

  /// Extra bounds of the bottom face, besides the polygons.
  std::vector<std::string> BottomBounds;
  StepText Text;

  void Write(const std::string& path, const std::vector<Polygon>& polygons, double height)
  {
    const double z[2] = { 0.0, height };
    std::vector<std::string> faces;
    std::vector<std::string> bounds[2];
    for (const Polygon& polygon : polygons)
    {
      const std::size_t n = polygon.Corners.size();
      std::vector<std::string> across[2];
      for (std::size_t i = 0; i < n; ++i)
      {
        const Corner& a = polygon.Corners[i];
        const Corner& b = polygon.Corners[(i + 1) % n];
        for (int side = 0; side < 2; ++side)
        {
          across[side].push_back(this->Text.AddLine(this->GetVertex(a, side, z[side]),
            this->GetVertex(b, side, z[side]), { a.X, a.Y, z[side] }, { b.X, b.Y, z[side] }));
        }
        const std::string loop = this->Text.AddEdgeLoop({ this->Text.AddOriented(across[0].back(), true),
          this->Text.AddOriented(this->GetUpright(b, z), true),
          this->Text.AddOriented(across[1].back(), false),
          this->Text.AddOriented(this->GetUpright(a, z), false) });
        const std::string frame = this->Text.AddFrame(
          { a.X, a.Y, 0.0 }, { b.Y - a.Y, a.X - b.X, 0.0 }, { b.X - a.X, b.Y - a.Y, 0.0 });
        faces.push_back(
          this->Text.AddFace({ this->Text.AddBound(loop, true) }, this->Text.Add("PLANE(''," + frame + ")")));
      }
      for (int side = 0; side < 2; ++side)
      {
        std::vector<std::string> oriented;
        for (std::size_t i = 0; i < n; ++i)
        {
          oriented.push_back(this->Text.AddOriented(across[side][side == 0 ? n - 1 - i : i], side == 1));
        }
        bounds[side].push_back(this->Text.AddBound(this->Text.AddEdgeLoop(oriented), polygon.Outer));
      }
    }
    bounds[0].insert(bounds[0].end(), this->BottomBounds.begin(), this->BottomBounds.end());
    for (int side = 0; side < 2; ++side)
    {
      const std::string frame =
        this->Text.AddFrame({ 0, 0, z[side] }, { 0, 0, side == 0 ? -1.0 : 1.0 }, { 1, 0, 0 });
      faces.push_back(this->Text.AddFace(bounds[side], this->Text.Add("PLANE(''," + frame + ")")));
    }
    this->Text.Write(path, faces);
  }

private:
  std::string GetVertex(const Corner& corner, int side, double z)
  {
    std::string& vertex = this->Vertices[{ corner.Number, side }];
    vertex = vertex.empty() ? this->Text.AddVertex({ corner.X, corner.Y, z }) : vertex;
    return vertex;
  }
  std::string GetUpright(const Corner& corner, const double z[2])
  {
    std::string& edge = this->Uprights[corner.Number];
    if (edge.empty())
    {
      edge = this->Text.AddLine(this->GetVertex(corner, 0, z[0]), this->GetVertex(corner, 1, z[1]),
        { corner.X, corner.Y, z[0] }, { corner.X, corner.Y, z[1] });
    }
    return edge;
  }

  std::map<std::pair<int, int>, std::string> Vertices;
  std::map<int, std::string> Uprights;
};
}

#endif

#include "smScaleModels.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace smtest
{
namespace
{
using Vector = std::array<double, 3>;

const double Pi = std::acos(-1.0);
const Vector Axes[3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };

Vector Opposite(const Vector& v)
{
  return { -v[0], -v[1], -v[2] };
}

/// The same positive number below 1 for the same index; numbers of different indices are spread evenly.
double Spread(int index)
{
  const double golden = 0.6180339887498949;
  return std::fmod((index + 1) * golden, 1.0);
}

std::string List(const std::vector<int>& ids)
{
  std::string text = "(";
  for (const int id : ids)
  {
    text += (text.size() > 1 ? ",#" : "#") + std::to_string(id);
  }
  return text + ")";
}

/// Instances of a Part 21 file; functions that add one return its number.
class Writer
{
public:
  explicit Writer(std::string& text)
    : Text(text)
  {
    this->Text =
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n";
  }
  void Finish() { this->Text += "ENDSEC;\nEND-ISO-10303-21;\n"; }

  int Add(const std::string& record)
  {
    this->Text += "#" + std::to_string(++this->Last) + "=" + record + ";\n";
    return this->Last;
  }
  __attribute__((format(printf, 2, 3))) int Format(const char* format, ...)
  {
    char record[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(record, sizeof(record), format, arguments);
    va_end(arguments);
    return this->Add(record);
  }

  int AddPoint(const Vector& p)
  {
    return this->Format("CARTESIAN_POINT('',(%#.17g,%#.17g,%#.17g))", p[0], p[1], p[2]);
  }
  int AddDirection(const Vector& d)
  {
    return this->Format("DIRECTION('',(%#.17g,%#.17g,%#.17g))", d[0], d[1], d[2]);
  }
  int AddPlacement(const Vector& origin, const Vector& axis, const Vector& reference)
  {
    const int point = this->AddPoint(origin);
    const int z = this->AddDirection(axis);
    const int x = this->AddDirection(reference);
    return this->Format("AXIS2_PLACEMENT_3D('',#%d,#%d,#%d)", point, z, x);
  }
  int AddVertex(const Vector& p) { return this->Format("VERTEX_POINT('',#%d)", this->AddPoint(p)); }

  /// Adds a straight edge between two vertices, given by their numbers and by their points `from` and `to`.
  int AddLine(int start, int end, const Vector& from, const Vector& to)
  {
    Vector direction = { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    for (double& d : direction)
    {
      d /= length;
    }
    const int point = this->AddPoint(from);
    const int vector = this->Format("VECTOR('',#%d,1.)", this->AddDirection(direction));
    const int line = this->Format("LINE('',#%d,#%d)", point, vector);
    return this->Format("EDGE_CURVE('',#%d,#%d,#%d,.T.)", start, end, line);
  }
  /// A circle that begins and ends at `vertex`, in the direction of `reference` from its centre.
  int AddCircle(int vertex, const Vector& center, const Vector& axis, const Vector& reference, double radius)
  {
    const int placement = this->AddPlacement(center, axis, reference);
    const int circle = this->Format("CIRCLE('',#%d,%#.17g)", placement, radius);
    return this->Format("EDGE_CURVE('',#%d,#%d,#%d,.T.)", vertex, vertex, circle);
  }
  /// A bound of edges, each with its orientation.
  int AddBound(const std::vector<std::pair<int, bool>>& edges, bool isOuter)
  {
    std::vector<int> oriented;
    for (const auto& [edge, isForward] : edges)
    {
      oriented.push_back(this->Format("ORIENTED_EDGE('',*,*,#%d,.%c.)", edge, isForward ? 'T' : 'F'));
    }
    const int loop = this->Add("EDGE_LOOP(''," + List(oriented) + ")");
    return this->Format("%s('',#%d,.T.)", isOuter ? "FACE_OUTER_BOUND" : "FACE_BOUND", loop);
  }
  int AddFace(const std::vector<int>& bounds, int surface, bool isSame)
  {
    return this->Add(
      "ADVANCED_FACE(''," + List(bounds) + ",#" + std::to_string(surface) + (isSame ? ",.T.)" : ",.F.)"));
  }
  int AddPlane(const Vector& origin, const Vector& axis, const Vector& reference)
  {
    return this->Format("PLANE('',#%d)", this->AddPlacement(origin, axis, reference));
  }

private:
  std::string& Text;
  int Last = 0;
};

/// The entities that all shapes of a file refer to.
struct Context
{
  int Application, Product, Definition, Geometry;

  explicit Context(Writer& writer)
  {
    this->Application = writer.Add("APPLICATION_CONTEXT('automotive design')");
    writer.Format("APPLICATION_PROTOCOL_DEFINITION('','automotive_design',2000,#%d)", this->Application);
    this->Product = writer.Format("PRODUCT_CONTEXT('',#%d,'mechanical')", this->Application);
    this->Definition =
      writer.Format("PRODUCT_DEFINITION_CONTEXT('part definition',#%d,'design')", this->Application);
    const int length = writer.Add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
    const int angle = writer.Add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
    const int solid = writer.Add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
    const int accuracy = writer.Format(
      "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),#%d,'distance_accuracy_value','')", length);
    this->Geometry =
      writer.Format("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#%d))"
                    "GLOBAL_UNIT_ASSIGNED_CONTEXT((#%d,#%d,#%d))REPRESENTATION_CONTEXT('',''))",
        accuracy, length, angle, solid);
  }
};

/// A product definition, and the shape of this product.
struct Product
{
  int Definition, Shape;

  Product(Writer& writer, const Context& context, const char* name)
  {
    const int product = writer.Format("PRODUCT('%s','%s','',(#%d))", name, name, context.Product);
    const int formation = writer.Format("PRODUCT_DEFINITION_FORMATION('','',#%d)", product);
    this->Definition = writer.Format("PRODUCT_DEFINITION('','',#%d,#%d)", formation, context.Definition);
    this->Shape = writer.Format("PRODUCT_DEFINITION_SHAPE('','',#%d)", this->Definition);
  }
  /// Gives the product a representation of a kind with these items, and returns the representation.
  int Represent(Writer& writer, const Context& context, const char* kind, const std::vector<int>& items) const
  {
    const int representation =
      writer.Add(std::string(kind) + "(''," + List(items) + ",#" + std::to_string(context.Geometry) + ")");
    writer.Format("SHAPE_DEFINITION_REPRESENTATION(#%d,#%d)", this->Shape, representation);
    return representation;
  }
};

int AddSolid(Writer& writer, const std::vector<int>& faces)
{
  const int shell = writer.Add("CLOSED_SHELL(''," + List(faces) + ")");
  return writer.Format("MANIFOLD_SOLID_BREP('solid',#%d)", shell);
}

/// A block with its faces open for further bounds, so that holes or struts begin there.
struct Block
{
  Vector Low, High;
  /// Bounds of the faces, 2 * axis + (1 for the upper one).
  std::vector<int> Bounds[6];

  Block(Writer& writer, const Vector& low, const Vector& high)
    : Low(low)
    , High(high)
  {
    int vertices[8];
    for (int corner = 0; corner < 8; ++corner)
    {
      vertices[corner] = writer.AddVertex(this->GetCorner(corner));
    }
    // Edges by their lower corner and their axis.
    std::map<std::pair<int, int>, int> edges;
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        const int end = corner | 1 << axis;
        if (end != corner)
        {
          edges[{ corner, axis }] =
            writer.AddLine(vertices[corner], vertices[end], this->GetCorner(corner), this->GetCorner(end));
        }
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const int first = 1 << (axis + 1) % 3;
      const int second = 1 << (axis + 2) % 3;
      for (int upper = 0; upper < 2; ++upper)
      {
        // Counterclockwise seen from outside.
        const int base = upper << axis;
        std::vector<std::pair<int, bool>> loop = { { edges[{ base, (axis + 1) % 3 }], true },
          { edges[{ base | first, (axis + 2) % 3 }], true },
          { edges[{ base | second, (axis + 1) % 3 }], false }, { edges[{ base, (axis + 2) % 3 }], false } };
        if (upper == 0)
        {
          loop = { { loop[3].first, true }, { loop[2].first, true }, { loop[1].first, false },
            { loop[0].first, false } };
        }
        this->Bounds[2 * axis + upper] = { writer.AddBound(loop, true) };
      }
    }
  }
  Vector GetCorner(int corner) const
  {
    Vector point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = (corner >> axis & 1) != 0 ? this->High[axis] : this->Low[axis];
    }
    return point;
  }
  void AddFaces(Writer& writer, std::vector<int>& faces) const
  {
    for (int face = 0; face < 6; ++face)
    {
      const int axis = face / 2;
      const bool isUpper = face % 2 == 1;
      const Vector normal = isUpper ? Axes[axis] : Opposite(Axes[axis]);
      const int plane = writer.AddPlane(isUpper ? this->High : this->Low, normal, Axes[(axis + 1) % 3]);
      faces.push_back(writer.AddFace(this->Bounds[face], plane, true));
    }
  }
  double GetVolume() const
  {
    return (this->High[0] - this->Low[0]) * (this->High[1] - this->Low[1]) * (this->High[2] - this->Low[2]);
  }
  Vector GetCenter() const
  {
    return { 0.5 * (this->Low[0] + this->High[0]), 0.5 * (this->Low[1] + this->High[1]),
      0.5 * (this->Low[2] + this->High[2]) };
  }
};

/// A surface of revolution between two blocks, or through one, along an axis: its two circles, seam and face.
struct Tube
{
  /// Circles at the lower and the upper end, counterclockwise about the axis.
  int Circle[2];
  int Face;

  /// `isHole`: the material is outside.
  Tube(
    Writer& writer, int axis, const Vector& center, const double ends[2], const double radii[2], bool isHole)
  {
    const Vector& reference = Axes[(axis + 1) % 3];
    int vertices[2];
    Vector points[2];
    for (int end = 0; end < 2; ++end)
    {
      Vector middle = center;
      middle[axis] = ends[end];
      points[end] = middle;
      points[end][(axis + 1) % 3] += radii[end];
      vertices[end] = writer.AddVertex(points[end]);
      this->Circle[end] = writer.AddCircle(vertices[end], middle, Axes[axis], reference, radii[end]);
    }
    const int seam = writer.AddLine(vertices[0], vertices[1], points[0], points[1]);
    Vector base = center;
    base[axis] = ends[0];
    const int placement = writer.AddPlacement(base, Axes[axis], reference);
    const int surface = radii[0] == radii[1]
      ? writer.Format("CYLINDRICAL_SURFACE('',#%d,%#.17g)", placement, radii[0])
      : writer.Format("CONICAL_SURFACE('',#%d,%#.17g,%#.17g)", placement, radii[0],
          std::atan2(radii[1] - radii[0], ends[1] - ends[0]));
    const int bound =
      writer.AddBound(isHole ? std::vector<std::pair<int, bool>>{ { this->Circle[0], false }, { seam, true },
                                 { this->Circle[1], true }, { seam, false } }
                             : std::vector<std::pair<int, bool>>{ { this->Circle[0], true }, { seam, true },
                                 { this->Circle[1], false }, { seam, false } },
        true);
    this->Face = writer.AddFace({ bound }, surface, !isHole);
  }
};

/// Adds a body to the volume of the model; its centre is a sum, weighted by volumes, until the model is
/// finished.
void AddBody(double volume, const Vector& center, ScaleModel& model)
{
  model.Volume += volume;
  for (int d = 0; d < 3; ++d)
  {
    model.Center[d] += volume * center[d];
  }
}

void Finish(Writer& writer, ScaleModel& model)
{
  for (double& c : model.Center)
  {
    c /= model.Volume;
  }
  writer.Finish();
}

/// Adds a plate of side x side holes to the file, and its volume and faces to the model. Returns the solid.
int AddPlate(Writer& writer, int side, ScaleModel& model)
{
  const double pitch = 10.0;
  const double thickness = 6.0;
  Block block(writer, { 0.0, 0.0, 0.0 }, { pitch * side, pitch * side, thickness });
  AddBody(block.GetVolume(), block.GetCenter(), model);
  std::vector<int> faces;
  for (int i = 0; i < side * side; ++i)
  {
    const double radius = 2.0 + 2.0 * Spread(i);
    const double ends[2] = { 0.0, thickness };
    const double radii[2] = { radius, radius };
    const Vector center = { pitch * (i % side + 0.5), pitch * (i / side + 0.5), 0.5 * thickness };
    const Tube hole(writer, 2, center, ends, radii, true);
    block.Bounds[4].push_back(writer.AddBound({ { hole.Circle[0], true } }, false));
    block.Bounds[5].push_back(writer.AddBound({ { hole.Circle[1], false } }, false));
    faces.push_back(hole.Face);
    AddBody(-Pi * radius * radius * thickness, center, model);
  }
  block.AddFaces(writer, faces);
  model.Faces += static_cast<long long>(faces.size());
  return AddSolid(writer, faces);
}

/// Writes the product of a single part.
void AddPart(Writer& writer, const Context& context, int solid, const char* name)
{
  const int origin = writer.AddPlacement({ 0.0, 0.0, 0.0 }, Axes[2], Axes[0]);
  Product(writer, context, name)
    .Represent(writer, context, "ADVANCED_BREP_SHAPE_REPRESENTATION", { origin, solid });
}
}

ScaleModel MakeBalls(int balls)
{
  const double radius = 0.3;
  const double pitch = 0.8;
  const auto side = static_cast<int>(std::lround(std::sqrt(balls)));
  ScaleModel model;
  Writer writer(model.Text);
  const Context context(writer);
  const Product product(writer, context, "balls");
  std::vector<int> items;
  for (int i = 0; i < side * side; ++i)
  {
    const Vector center = { pitch * (i % side), pitch * (i / side), radius };
    const int vertex = writer.AddVertex({ center[0], center[1], center[2] - radius });
    const int bound = writer.Format("FACE_BOUND('',#%d,.T.)", writer.Format("VERTEX_LOOP('',#%d)", vertex));
    const int sphere = writer.Format(
      "SPHERICAL_SURFACE('',#%d,%#.17g)", writer.AddPlacement(center, Axes[2], Axes[0]), radius);
    items.push_back(AddSolid(writer, { writer.AddFace({ bound }, sphere, true) }));
  }
  product.Represent(writer, context, "ADVANCED_BREP_SHAPE_REPRESENTATION", items);
  writer.Finish();
  model.Faces = model.Instances = side * side;
  model.Volume = side * side * 4.0 / 3.0 * Pi * radius * radius * radius;
  model.Center = { 0.5 * pitch * (side - 1), 0.5 * pitch * (side - 1), radius };
  return model;
}

ScaleModel MakePlate(int holes)
{
  ScaleModel model;
  Writer writer(model.Text);
  const Context context(writer);
  const int solid = AddPlate(writer, static_cast<int>(std::lround(std::sqrt(holes))), model);
  AddPart(writer, context, solid, "plate");
  Finish(writer, model);
  return model;
}

ScaleModel MakeLattice(int side)
{
  const double pitch = 10.0;
  ScaleModel model;
  Writer writer(model.Text);
  const Context context(writer);
  std::vector<Block> blocks;
  for (int i = 0; i < side * side * side; ++i)
  {
    const Vector middle = { pitch * (i % side), pitch * (i / side % side), pitch * (i / side / side) };
    const double half = 2.0 + Spread(i);
    blocks.emplace_back(writer, Vector{ middle[0] - half, middle[1] - half, middle[2] - half },
      Vector{ middle[0] + half, middle[1] + half, middle[2] + half });
    AddBody(blocks.back().GetVolume(), middle, model);
  }
  std::vector<int> faces;
  const int strides[3] = { 1, side, side * side };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < side * side * side; ++i)
    {
      if (i / strides[axis] % side == side - 1)
      {
        continue;
      }
      Block& low = blocks[i];
      Block& high = blocks[i + strides[axis]];
      const double ends[2] = { low.High[axis], high.Low[axis] };
      const double first = 0.7 + 0.6 * Spread(3 * i + axis);
      const double radii[2] = { first, axis == 0 ? first : first + 0.4 };
      Vector center = low.GetCenter();
      const Tube strut(writer, axis, center, ends, radii, false);
      low.Bounds[2 * axis + 1].push_back(writer.AddBound({ { strut.Circle[0], false } }, false));
      high.Bounds[2 * axis].push_back(writer.AddBound({ { strut.Circle[1], true } }, false));
      faces.push_back(strut.Face);
      const double length = ends[1] - ends[0];
      const double squares = radii[0] * radii[0] + radii[0] * radii[1] + radii[1] * radii[1];
      center[axis] =
        ends[0] + 0.25 * length * (squares + radii[0] * radii[1] + 2.0 * radii[1] * radii[1]) / squares;
      AddBody(Pi / 3.0 * length * squares, center, model);
    }
  }
  for (const Block& block : blocks)
  {
    block.AddFaces(writer, faces);
  }
  model.Faces = static_cast<long long>(faces.size());
  AddPart(writer, context, AddSolid(writer, faces), "lattice");
  Finish(writer, model);
  return model;
}

ScaleModel MakeAssembly(int instances, Placing placing)
{
  ScaleModel model;
  Writer writer(model.Text);
  const Context context(writer);
  const int solid = AddPlate(writer, 2, model);
  const double volume = model.Volume;
  const Vector moments = model.Center;
  model.Instances = instances;
  const Product part(writer, context, "plate");
  const int origin = writer.AddPlacement({ 0.0, 0.0, 0.0 }, Axes[2], Axes[0]);
  const int shape = part.Represent(writer, context, "ADVANCED_BREP_SHAPE_REPRESENTATION", { origin, solid });
  std::vector<int> items = { origin };
  std::vector<int> placements;
  model.Volume = 0.0;
  model.Center = {};
  const int side = static_cast<int>(std::ceil(std::sqrt(instances)));
  for (int i = 0; i < instances; ++i)
  {
    const bool isSecond = placing == Placing::Alternating && i % 2 == 1;
    const int k = isSecond ? i - 1 : i;
    const double angle = 2.0 * Pi * Spread(k);
    const Vector x = { std::cos(angle), std::sin(angle), 0.0 };
    const Vector at = { 40.0 * (k % side), 40.0 * (k / side), 10.0 * Spread(2 * k) };
    placements.push_back(isSecond ? placements.back() : writer.AddPlacement(at, Axes[2], x));
    if (!isSecond)
    {
      items.push_back(placements.back());
    }
    AddBody(volume,
      { at[0] + (x[0] * moments[0] - x[1] * moments[1]) / volume,
        at[1] + (x[1] * moments[0] + x[0] * moments[1]) / volume, at[2] + moments[2] / volume },
      model);
  }
  const Product assembly(writer, context, "assembly");
  const int whole = assembly.Represent(writer, context, "SHAPE_REPRESENTATION", items);
  for (int i = 0; i < instances; ++i)
  {
    const bool isSwapped = placing == Placing::Swapped || (placing == Placing::Alternating && i % 2 == 1);
    const int transformation = writer.Format("ITEM_DEFINED_TRANSFORMATION('','',#%d,#%d)",
      isSwapped ? placements[i] : origin, isSwapped ? origin : placements[i]);
    const int relation = writer.Format(
      "(REPRESENTATION_RELATIONSHIP('','',#%d,#%d)"
      "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#%d)SHAPE_REPRESENTATION_RELATIONSHIP())",
      shape, whole, transformation);
    const int use = writer.Format("NEXT_ASSEMBLY_USAGE_OCCURRENCE('%d','plate %d','',#%d,#%d,$)", i + 1,
      i + 1, assembly.Definition, part.Definition);
    const int placed = writer.Format("PRODUCT_DEFINITION_SHAPE('','',#%d)", use);
    writer.Format("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#%d,#%d)", relation, placed);
  }
  Finish(writer, model);
  return model;
}
}

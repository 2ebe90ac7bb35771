#include "smShapeBytes.h"

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>

namespace sm
{
namespace
{
/// Stand for an object whose content follows, and for a null pointer.
constexpr std::uint64_t NewObject = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t NoObject = NewObject - 1;

template <class Object>
struct ObjectTable
{
  std::vector<std::shared_ptr<Object>> Objects;
  std::unordered_map<const Object*, std::uint64_t> Numbers;

  void Add(const std::shared_ptr<Object>& object)
  {
    this->Numbers.emplace(object.get(), this->Objects.size());
    this->Objects.push_back(object);
  }
};
}

struct ShapeTable::Content
{
  std::tuple<ObjectTable<VertexShape>, ObjectTable<EdgeShape>, ObjectTable<FaceShape>,
    ObjectTable<ShellShape>, ObjectTable<SolidShape>, ObjectTable<const GeometricCurve<2>>,
    ObjectTable<const GeometricCurve<3>>, ObjectTable<const GeometricSurface>>
    Tables;

  template <class Object>
  ObjectTable<Object>& Get()
  {
    return std::get<ObjectTable<Object>>(this->Tables);
  }
};

ShapeTable::ShapeTable()
  : Objects(new Content)
{
}

ShapeTable::~ShapeTable() = default;

namespace
{
/// Writes values; Visit() passes it the members of each type.
class Packing
{
public:
  Packing(ByteWriter& to, ShapeTable& table)
    : To(to)
    , Table(table.GetContent())
  {
  }

  template <class Type>
  void operator()(const Type& value);
  void operator()(const std::string& text) { this->To.PutText(text); }
  template <class Type>
  void operator()(const std::vector<Type>& values);
  template <class Object>
  void operator()(const std::shared_ptr<Object>& object);
  template <class... Types>
  void operator()(const std::variant<Types...>& value)
  {
    this->To.Put(static_cast<std::uint64_t>(value.index()));
    std::visit([this](const auto& alternative) { (*this)(alternative); }, value);
  }

  template <class Object>
  void Require(const std::shared_ptr<Object>& object)
  {
    (*this)(object);
  }

private:
  ByteWriter& To;
  ShapeTable::Content& Table;
};

/// Reads values; sets the members that Visit() passes.
class Unpacking
{
public:
  Unpacking(ByteReader& from, ShapeTable& table)
    : From(from)
    , Table(table.GetContent())
  {
  }

  bool IsGood() const { return this->Good && this->From.IsGood(); }

  template <class Type>
  void operator()(Type& value);
  void operator()(std::string& text) { text = this->From.GetText(); }
  template <class Type>
  void operator()(std::vector<Type>& values);
  template <class Object>
  void operator()(std::shared_ptr<Object>& object);
  template <class... Types>
  void operator()(std::variant<Types...>& value)
  {
    this->ReadAlternative(value, this->From.Get<std::uint64_t>(), std::index_sequence_for<Types...>());
  }

  /// Refuses a null pointer.
  template <class Object>
  void Require(std::shared_ptr<Object>& object)
  {
    (*this)(object);
    this->Good = object && this->Good;
  }

private:
  template <class Variant, std::size_t... Index>
  void ReadAlternative(Variant& value, std::uint64_t index, std::index_sequence<Index...>)
  {
    this->Good = index < sizeof...(Index) && this->Good;
    const auto read = [&](auto number)
    {
      if (index == number && this->IsGood())
      {
        (*this)(value.template emplace<number>());
      }
    };
    (read(std::integral_constant<std::size_t, Index>()), ...);
  }
  template <class Object>
  void ReadObject(std::shared_ptr<Object>& object);

  ByteReader& From;
  ShapeTable::Content& Table;
  int Depth = 0;
  bool Good = true;
};

///@{
/// Call `visit` with each member. `Type` is const for a writer.
template <class Visit>
void VisitMembers(Visit& visit, SplineBasis& basis)
{
  visit(basis.Degree);
  visit(basis.Knots);
  visit(basis.Multiplicities);
  visit(basis.Periodic);
}

template <class Visit, int Dimension>
void VisitMembers(Visit& visit, ConicCurve<Dimension>& curve)
{
  visit(curve.Kind);
  visit(curve.Center);
  visit(curve.X);
  visit(curve.Y);
  visit(curve.Radii[0]);
  visit(curve.Radii[1]);
}

template <class Visit, int Dimension>
void VisitMembers(Visit& visit, SplineCurve<Dimension>& curve)
{
  visit(curve.Basis);
  visit(curve.Poles);
  visit(curve.Weights);
}

template <class Visit, int Dimension>
void VisitMembers(Visit& visit, OffsetCurve<Dimension>& curve)
{
  visit.Require(curve.Basis);
  visit(curve.Distance);
  visit(curve.Reference);
}

template <class Visit, int Dimension>
void VisitMembers(Visit& visit, CurveSegment<Dimension>& segment)
{
  visit.Require(segment.Curve);
  visit(segment.First);
  visit(segment.Last);
  visit(segment.Length);
}

template <class Visit, int Dimension>
void VisitMembers(Visit& visit, CompositeCurve<Dimension>& curve)
{
  visit(curve.Segments);
}

template <class Visit>
void VisitMembers(Visit& visit, CurveOnSurface& curve)
{
  visit.Require(curve.Surface);
  visit.Require(curve.Curve);
}

template <class Visit>
void VisitMembers(Visit& visit, ElementarySurface& surface)
{
  visit(surface.Kind);
  visit(surface.Frame);
  visit(surface.Radii[0]);
  visit(surface.Radii[1]);
  visit(surface.Angle);
  visit(surface.Selected);
}

template <class Visit>
void VisitMembers(Visit& visit, ExtrudedSurface& surface)
{
  visit.Require(surface.Profile);
  visit(surface.Range);
  visit(surface.Direction);
}

template <class Visit>
void VisitMembers(Visit& visit, RevolvedSurface& surface)
{
  visit.Require(surface.Profile);
  visit(surface.Range);
  visit(surface.Origin);
  visit(surface.Axis);
}

template <class Visit>
void VisitMembers(Visit& visit, SplineSurface& surface)
{
  visit(surface.Basis[0]);
  visit(surface.Basis[1]);
  visit(surface.Poles);
  visit(surface.Weights);
}

template <class Visit>
void VisitMembers(Visit& visit, OffsetSurface& surface)
{
  visit.Require(surface.Basis);
  visit(surface.Distance);
}

template <class Visit>
void VisitMembers(Visit& visit, FileSurface& surface)
{
  visit(surface.Surface);
  visit(surface.Distance);
}

template <class Visit>
void VisitMembers(Visit& visit, ShapeData& data)
{
  visit(data.FileId);
  visit(data.Name);
  visit(data.Color);
}

template <class Visit>
void VisitMembers(Visit& visit, EdgeShape& edge)
{
  visit(edge.Data);
  visit(edge.Curve);
  visit(edge.First);
  visit(edge.Last);
  visit(edge.Location);
  visit(edge.Start);
  visit(edge.End);
  visit(edge.Tolerance);
  visit(edge.Degenerate);
}

template <class Visit>
void VisitMembers(Visit& visit, CoedgeShape& coedge)
{
  visit.Require(coedge.Edge);
  visit(coedge.Reversed);
  visit(coedge.Trim);
  visit(coedge.First);
  visit(coedge.Last);
}

template <class Visit>
void VisitMembers(Visit& visit, WireShape& wire)
{
  visit(wire.Coedges);
  visit(wire.Reversed);
}

template <class Visit>
void VisitMembers(Visit& visit, FaceShape& face)
{
  visit(face.Data);
  visit(face.Surface);
  visit(face.Range[0]);
  visit(face.Range[1]);
  visit(face.Location);
  visit(face.Wires);
  visit(face.Bounded);
  visit(face.Own);
  visit(face.Source);
}

template <class Visit>
void VisitMembers(Visit& visit, FaceUse& use)
{
  visit.Require(use.Face);
  visit(use.Reversed);
}

template <class Visit>
void VisitMembers(Visit& visit, ShellShape& shell)
{
  visit(shell.Data);
  visit(shell.Faces);
  visit(shell.LostFaces);
  visit(shell.OpenSolid);
  visit(shell.Closed);
}

template <class Visit>
void VisitMembers(Visit& visit, ShellUse& use)
{
  visit.Require(use.Shell);
  visit(use.Reversed);
  visit(use.Location);
}

template <class Visit>
void VisitMembers(Visit& visit, SolidShape& solid)
{
  visit(solid.Data);
  visit(solid.Shells);
}

template <class Visit>
void VisitMembers(Visit& visit, SolidUse& use)
{
  visit.Require(use.Solid);
  visit(use.Reversed);
  visit(use.Location);
}

template <class Visit>
void VisitMembers(Visit& visit, ShapeGroup& group)
{
  visit(group.Solids);
  visit(group.Shells);
  visit(group.Faces);
}

template <class Visit>
void VisitMembers(Visit& visit, BodyShape& body)
{
  visit(body.IsSolid);
  visit(body.Shells);
  visit(body.Faces);
}

template <class Visit>
void VisitMembers(Visit& visit, ShapeNode& node)
{
  visit(node.Shapes);
  visit(node.Place);
  visit(node.Children);
}
///@}

/// Values that have no bytes between their members, and are written as they are.
template <class Type>
constexpr bool IsPlain = std::is_arithmetic_v<Type> || std::is_enum_v<Type>;
template <std::size_t Dimension>
constexpr bool IsPlain<std::array<double, Dimension>> = true;
template <int Dimension>
constexpr bool IsPlain<LineCurve<Dimension>> = true;
template <>
constexpr bool IsPlain<ParameterRange> = true;
template <>
constexpr bool IsPlain<GeometricFrame> = true;
template <>
constexpr bool IsPlain<VertexShape> = true;
template <>
constexpr bool IsPlain<Placement> = true;

/// The last enumerator.
template <class Type>
constexpr Type LastOf = Type();
template <>
constexpr ConicCurve<2>::Type LastOf<ConicCurve<2>::Type> = ConicCurve<2>::Type::Hyperbola;
template <>
constexpr ConicCurve<3>::Type LastOf<ConicCurve<3>::Type> = ConicCurve<3>::Type::Hyperbola;
template <>
constexpr ElementarySurface::Type LastOf<ElementarySurface::Type> = ElementarySurface::Type::Torus;
template <>
constexpr ElementarySurface::Part LastOf<ElementarySurface::Part> = ElementarySurface::Part::Inner;

template <class Object>
constexpr bool IsGeometry = std::is_const_v<Object>;

template <class Type>
void Packing::operator()(const Type& value)
{
  if constexpr (IsPlain<Type>)
  {
    this->To.Put(value);
  }
  else
  {
    // A writer changes nothing.
    VisitMembers(*this, const_cast<Type&>(value));
  }
}

template <class Type>
void Packing::operator()(const std::vector<Type>& values)
{
  if constexpr (IsPlain<Type>)
  {
    this->To.PutAll(values);
  }
  else
  {
    this->To.Put(static_cast<std::uint64_t>(values.size()));
    for (const Type& value : values)
    {
      (*this)(value);
    }
  }
}

template <class Object>
void Packing::operator()(const std::shared_ptr<Object>& object)
{
  ObjectTable<Object>& table = this->Table.Get<Object>();
  const auto known = object ? table.Numbers.find(object.get()) : table.Numbers.end();
  if (!object || known != table.Numbers.end())
  {
    this->To.Put(object ? known->second : NoObject);
    return;
  }
  this->To.Put(NewObject);
  if constexpr (IsGeometry<Object>)
  {
    (*this)(object->GetValue());
  }
  else
  {
    (*this)(*object);
  }
  table.Add(object);
}

template <class Type>
void Unpacking::operator()(Type& value)
{
  if constexpr (std::is_same_v<Type, bool>)
  {
    value = this->From.Get<unsigned char>() != 0;
  }
  else if constexpr (std::is_enum_v<Type>)
  {
    const auto number = this->From.Get<std::underlying_type_t<Type>>();
    this->Good = number <= static_cast<std::underlying_type_t<Type>>(LastOf<Type>) && this->Good;
    value = this->IsGood() ? static_cast<Type>(number) : Type();
  }
  else if constexpr (IsPlain<Type>)
  {
    value = this->From.Get<Type>();
  }
  else
  {
    VisitMembers(*this, value);
  }
}

template <class Type>
void Unpacking::operator()(std::vector<Type>& values)
{
  if constexpr (IsPlain<Type>)
  {
    values = this->From.GetAll<Type>();
  }
  else
  {
    // An element begins with a count or the number of an object.
    values.resize(this->Depth < MaxShapeDepth ? this->From.GetCount(sizeof(std::uint64_t)) : 0);
    this->Good = this->Depth < MaxShapeDepth && this->Good;
    ++this->Depth;
    for (std::size_t i = 0; i < values.size() && this->IsGood(); ++i)
    {
      (*this)(values[i]);
    }
    --this->Depth;
  }
}

template <class Object>
void Unpacking::operator()(std::shared_ptr<Object>& object)
{
  const ObjectTable<Object>& table = this->Table.Get<Object>();
  const auto number = this->From.Get<std::uint64_t>();
  if (number == NewObject && this->IsGood() && this->Depth < MaxShapeDepth)
  {
    ++this->Depth;
    this->ReadObject(object);
    --this->Depth;
  }
  else if (number < table.Objects.size())
  {
    object = table.Objects[number];
  }
  else
  {
    this->Good = number == NoObject && this->Good;
  }
}

template <class Object>
void Unpacking::ReadObject(std::shared_ptr<Object>& object)
{
  if constexpr (IsGeometry<Object>)
  {
    typename Object::Variant value;
    std::string problem;
    (*this)(value);
    object = this->IsGood() ? Object::Make(std::move(value), problem) : nullptr;
    this->Good = object && this->Good;
  }
  else
  {
    object = std::make_shared<Object>();
    (*this)(*object);
  }
  this->Table.Get<Object>().Add(object);
}

template <class Value>
bool Unpack(ByteReader& from, ShapeTable& table, Value& value)
{
  Unpacking unpack(from, table);
  unpack(value);
  return unpack.IsGood();
}
}

void ShapeWriter::Put(const BodyShape& body)
{
  Packing(this->To, this->Table)(body);
}

void ShapeWriter::Put(const ShapeGroup& group)
{
  Packing(this->To, this->Table)(group);
}

void ShapeWriter::Put(const ShapeNode& node)
{
  Packing(this->To, this->Table)(node);
}

void ShapeWriter::Put(const std::vector<FaceShapePointer>& faces)
{
  Packing(this->To, this->Table)(faces);
}

bool ShapeReader::Get(BodyShape& body)
{
  return Unpack(this->From, this->Table, body);
}

bool ShapeReader::Get(ShapeGroup& group)
{
  return Unpack(this->From, this->Table, group);
}

bool ShapeReader::Get(ShapeNode& node)
{
  return Unpack(this->From, this->Table, node);
}

bool ShapeReader::Get(std::vector<FaceShapePointer>& faces)
{
  return Unpack(this->From, this->Table, faces);
}
}

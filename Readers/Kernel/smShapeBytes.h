/**
 * @file smShapeBytes.h
 * @brief Shapes on their native geometry as bytes, for messages between processes on machines of one kind
 *
 * A vertex, edge, face, shell, solid, curve or surface is written once, and then by its number. The table of
 * numbers may outlive the message: what a reply refers to and the request had becomes the same object again.
 * Doubles keep their bits. The completed loops of a face are not written.
 */
#ifndef smShapeBytes_h
#define smShapeBytes_h

#include "Shapes/smShape.h"
#include "smBytes.h"
#include "smReadersKernelModule.h"

#include <memory>
#include <vector>

namespace sm
{
/// Largest depth of pointers and lists in shapes, curves, surfaces and nodes.
constexpr int MaxShapeDepth = 4000;

/// A part of a file without product structure, or an assembly of such nodes.
struct ShapeNode
{
  /// The shapes of a part; empty for an assembly.
  ShapeGroup Shapes;
  /// Of the part, in the coordinates of the file.
  Placement Place;
  std::vector<ShapeNode> Children;
};

/// The objects that both sides know, with their numbers.
class SMREADERSKERNEL_EXPORT ShapeTable
{
public:
  ShapeTable();
  ~ShapeTable();
  ShapeTable(const ShapeTable&) = delete;
  void operator=(const ShapeTable&) = delete;

  struct Content;
  Content& GetContent() { return *this->Objects; }

private:
  std::unique_ptr<Content> Objects;
};

class SMREADERSKERNEL_EXPORT ShapeWriter
{
public:
  ShapeWriter(ByteWriter& to, ShapeTable& table)
    : To(to)
    , Table(table)
  {
  }
  void Put(const BodyShape& body);
  void Put(const ShapeGroup& group);
  void Put(const ShapeNode& node);
  void Put(const std::vector<FaceShapePointer>& faces);

private:
  ByteWriter& To;
  ShapeTable& Table;
};

/// Get() returns false if the bytes are not valid; the value has then what was read before.
class SMREADERSKERNEL_EXPORT ShapeReader
{
public:
  ShapeReader(ByteReader& from, ShapeTable& table)
    : From(from)
    , Table(table)
  {
  }
  bool Get(BodyShape& body);
  bool Get(ShapeGroup& group);
  bool Get(ShapeNode& node);
  bool Get(std::vector<FaceShapePointer>& faces);

private:
  ByteReader& From;
  ShapeTable& Table;
};
}

#endif

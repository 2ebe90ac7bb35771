/**
 * @file smFaceBytes.h
 * @brief Bitwise conversion of faces to bytes and back
 */
#ifndef smFaceBytes_h
#define smFaceBytes_h

#include "smBytes.h"
#include "smFace.h"
#include "smFiltersNURBSModule.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace sm
{
/// Writes faces into one message; an edge shared by several of them is written once.
class SMFILTERSNURBS_EXPORT FaceWriter
{
public:
  explicit FaceWriter(ByteWriter& to)
    : To(to)
  {
  }
  /// Writes all of the face but its id and the previous positions of edited edges.
  void Put(const Face& face);

private:
  void Put(const Edge& edge);

  ByteWriter& To;
  std::map<const Edge*, std::uint32_t> Edges;
};

/// Reads the faces of a FaceWriter, in the same order.
class SMFILTERSNURBS_EXPORT FaceReader
{
public:
  explicit FaceReader(ByteReader& from)
    : From(from)
  {
  }
  /// Returns a face with a new id, whose edges have new ids too; null if the message is invalid.
  FacePointer Get();

private:
  std::shared_ptr<const Edge> GetEdge();

  ByteReader& From;
  std::vector<std::shared_ptr<const Edge>> Edges;
};
}

#endif

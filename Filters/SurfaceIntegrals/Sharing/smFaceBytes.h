/**
 * @file smFaceBytes.h
 * @brief Faces and their integrals as bytes, bit for bit
 */
#ifndef smFaceBytes_h
#define smFaceBytes_h

#include "smBytes.h"
#include "smFace.h"
#include "smFiltersSurfaceIntegralsModule.h"
#include "smSurfaceIntegrator.h"

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace sm
{
/// Writes faces into one message; an edge that several of them share is written once.
class SMFILTERSSURFACEINTEGRALS_EXPORT FaceWriter
{
public:
  explicit FaceWriter(ByteWriter& to)
    : To(to)
  {
  }
  /// Everything that integrals depend on, and what messages name. Not the colour, the reader's messages, and where an edit
  /// moved an edge from.
  void Put(const Face& face);

private:
  void Put(const Edge& edge);

  ByteWriter& To;
  std::map<const Edge*, std::uint32_t> Edges;
};

/// Reads them, in the same order.
class SMFILTERSSURFACEINTEGRALS_EXPORT FaceReader
{
public:
  explicit FaceReader(ByteReader& from)
    : From(from)
  {
  }
  /// A face with a new id, its edges too; null when the message makes no sense.
  FacePointer Get();

private:
  std::shared_ptr<const Edge> GetEdge();

  ByteReader& From;
  std::vector<std::shared_ptr<const Edge>> Edges;
};

SMFILTERSSURFACEINTEGRALS_EXPORT void PutIntegrals(ByteWriter& to, const FaceIntegrals& integrals);
SMFILTERSSURFACEINTEGRALS_EXPORT FaceIntegrals GetIntegrals(ByteReader& from);
}

#endif

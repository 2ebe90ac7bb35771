#include "smGLBFile.h"

#include "smJson.h"
#include "smLengthUnits.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <vector>

namespace sm
{
namespace
{
/// Numbers of the glTF 2.0 specification.
constexpr int Float = 5126;
constexpr int UnsignedInt = 5125;
constexpr int ArrayBuffer = 34962;
constexpr int ElementArrayBuffer = 34963;
constexpr std::uint32_t Magic = 0x46546C67;
constexpr std::uint32_t JsonChunk = 0x4E4F534A;
constexpr std::uint32_t BinaryChunk = 0x004E4942;

using Rgb = std::array<unsigned char, 3>;
/// The colour of faces without a colour in the file.
constexpr Rgb Grey{ 204, 204, 204 };

/// Converts an sRGB component to the linear one that glTF requires.
double GetLinear(unsigned char component)
{
  const double x = component / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

void AppendNumber(std::uint32_t x, std::string& bytes)
{
  for (int shift = 0; shift < 32; shift += 8)
  {
    bytes.push_back(static_cast<char>(x >> shift & 255));
  }
}

/// Appends a chunk, padded to a multiple of four bytes.
void AppendChunk(std::uint32_t type, std::string content, char filler, std::string& bytes)
{
  content.append((4 - content.size() % 4) % 4, filler);
  AppendNumber(static_cast<std::uint32_t>(content.size()), bytes);
  AppendNumber(type, bytes);
  bytes += content;
}

class Scene
{
public:
  explicit Scene(const std::string& unit)
  {
    const double metres = GetMetres(unit);
    const double turn = std::sqrt(0.5);
    this->Root = { { "asset", { { "version", "2.0" }, { "generator", "SolidMoments" } } }, { "scene", 0 },
      { "scenes", { { { "nodes", { 0 } } } } },
      { "nodes",
        { { { "name", "lengths in " + unit }, { "rotation", { -turn, 0.0, 0.0, turn } },
          { "scale", { metres, metres, metres } }, { "children", Json::array() } } } } };
  }

  void AddBody(vtkPolyData* body, const std::string& name)
  {
    Json primitives = Json::array();
    const std::map<Rgb, std::vector<std::uint32_t>> parts = GetParts(body);
    if (parts.empty())
    {
      return;
    }
    double center[3];
    body->GetCenter(center);
    Json attributes{ { "POSITION", this->AddVectors(body->GetPoints()->GetData(), center) } };
    if (vtkDataArray* normals = body->GetPointData()->GetNormals())
    {
      const double zero[3] = { 0.0, 0.0, 0.0 };
      attributes["NORMAL"] = this->AddVectors(normals, zero);
    }
    for (const auto& [color, corners] : parts)
    {
      const int view = this->AddView(corners.data(), 4 * corners.size(), ElementArrayBuffer);
      this->Root["accessors"].push_back({ { "bufferView", view }, { "componentType", UnsignedInt },
        { "count", corners.size() }, { "type", "SCALAR" } });
      primitives.push_back({ { "attributes", attributes }, { "indices", this->Root["accessors"].size() - 1 },
        { "material", this->GetMaterial(color) } });
    }
    this->Root["meshes"].push_back({ { "name", name }, { "primitives", primitives } });
    Json& nodes = this->Root["nodes"];
    nodes[0]["children"].push_back(nodes.size());
    nodes.push_back({ { "name", name }, { "mesh", this->Root["meshes"].size() - 1 },
      { "translation", { center[0], center[1], center[2] } } });
  }

  std::string Write()
  {
    if (this->Binary.empty())
    {
      return {};
    }
    this->Root["buffers"] = { { { "byteLength", this->Binary.size() } } };
    std::string chunks;
    AppendChunk(JsonChunk, Dump(this->Root), ' ', chunks);
    AppendChunk(BinaryChunk, std::move(this->Binary), '\0', chunks);
    std::string bytes;
    AppendNumber(Magic, bytes);
    AppendNumber(2, bytes);
    AppendNumber(static_cast<std::uint32_t>(chunks.size() + 12), bytes);
    return bytes + chunks;
  }

private:
  /// Returns the corners of the triangles, by colour.
  static std::map<Rgb, std::vector<std::uint32_t>> GetParts(vtkPolyData* body)
  {
    std::map<Rgb, std::vector<std::uint32_t>> parts;
    vtkDataArray* colors = body->GetCellData()->GetArray("Color");
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < body->GetNumberOfPolys(); ++i)
    {
      Rgb color = Grey;
      for (int c = 0; colors && c < 3; ++c)
      {
        color[c] = static_cast<unsigned char>(colors->GetComponent(i, c));
      }
      body->GetPolys()->GetCellAtId(i, corners);
      for (const vtkIdType corner : { corners->GetId(0), corners->GetId(1), corners->GetId(2) })
      {
        parts[color].push_back(static_cast<std::uint32_t>(corner));
      }
    }
    return parts;
  }

  int AddView(const void* data, std::size_t size, int target)
  {
    this->Root["bufferViews"].push_back({ { "buffer", 0 }, { "byteOffset", this->Binary.size() },
      { "byteLength", size }, { "target", target } });
    this->Binary.append(static_cast<const char*>(data), size);
    return static_cast<int>(this->Root["bufferViews"].size()) - 1;
  }

  int AddVectors(vtkDataArray* from, const double origin[3])
  {
    std::vector<std::array<float, 3>> vectors(static_cast<std::size_t>(from->GetNumberOfTuples()));
    std::array<float, 3> low;
    std::array<float, 3> high;
    low.fill(HUGE_VALF);
    high.fill(-HUGE_VALF);
    for (std::size_t i = 0; i < vectors.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        vectors[i][c] = static_cast<float>(from->GetComponent(static_cast<vtkIdType>(i), c) - origin[c]);
        low[c] = std::min(low[c], vectors[i][c]);
        high[c] = std::max(high[c], vectors[i][c]);
      }
    }
    const int view = this->AddView(vectors.data(), vectors.size() * sizeof(vectors[0]), ArrayBuffer);
    this->Root["accessors"].push_back({ { "bufferView", view }, { "componentType", Float },
      { "count", vectors.size() }, { "type", "VEC3" }, { "min", low }, { "max", high } });
    return static_cast<int>(this->Root["accessors"].size()) - 1;
  }

  int GetMaterial(const Rgb& color)
  {
    const auto entry = this->Materials.emplace(color, static_cast<int>(this->Materials.size()));
    if (entry.second)
    {
      this->Root["materials"].push_back(
        { { "pbrMetallicRoughness",
            { { "baseColorFactor", { GetLinear(color[0]), GetLinear(color[1]), GetLinear(color[2]), 1.0 } },
              { "metallicFactor", 0.0 }, { "roughnessFactor", 0.6 } } },
          { "doubleSided", true } });
    }
    return entry.first->second;
  }

  Json Root;
  std::string Binary;
  std::map<Rgb, int> Materials;
};
}

std::string MakeGLB(vtkPartitionedDataSetCollection* bodies, const std::string& unit)
{
  Scene scene(unit);
  for (unsigned int i = 0; i < bodies->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkInformation* info = bodies->HasMetaData(i) ? bodies->GetMetaData(i) : nullptr;
    const char* name = info ? info->Get(vtkCompositeDataSet::NAME()) : nullptr;
    for (unsigned int k = 0; k < bodies->GetNumberOfPartitions(i); ++k)
    {
      if (auto* body = vtkPolyData::SafeDownCast(bodies->GetPartitionAsDataObject(i, k)))
      {
        scene.AddBody(body, name ? name : "");
      }
    }
  }
  return scene.Write();
}
}

/**
 * @file smOCCTDocument.h
 * @brief A STEP or BREP file as parts and instances with their attributes
 */
#ifndef smOCCTDocument_h
#define smOCCTDocument_h

#include "smOCCTBody.h"
#include "smProgressCallback.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace sm
{
/// One solid or free shell, in the coordinates of its part: its own location is taken off.
struct PartBody
{
  TopoDS_Shape Shape;
  /// Applied to the shape before anything else: a scale that an instance asks for, else the identity.
  gp_Trsf Scale;
  bool Solid = true;
  int FileId = 0;
  std::string Name;
  std::string Material;
  double Density = 0.0;
  /// mm^3 and mm^2; NaN when the file has none.
  double FileVolume = std::numeric_limits<double>::quiet_NaN();
  double FileArea = std::numeric_limits<double>::quiet_NaN();
  Vector3 Color{ -1.0, -1.0, -1.0 };
  /// An instance of it lost its scale or mirror.
  bool Misplaced = false;
  /// Accuracy of coordinates that the file states for it, mm; 0: none.
  double Uncertainty = 0.0;
  /// Faces that the file declares and that Shape does not have; Messages names them.
  int LostFaces = 0;
  std::vector<std::string> Messages;
};

/// One occurrence of a body. The placement is rigid or mirrored, in mm.
struct BodyInstance
{
  int Body = 0;
  gp_Trsf Placement;
  std::string Name;
  /// Colour of the instance, which overrides that of its part; negative: none.
  Vector3 Color{ -1.0, -1.0, -1.0 };
};

struct ProductNode
{
  std::string Name;
  std::string Layer;
  std::vector<int> Instances;
  std::vector<ProductNode> Children;
};

enum class ReadStatus
{
  Ok,
  Empty,
  Unreadable,
  Aborted
};

struct Document
{
  ReadStatus Status = ReadStatus::Unreadable;
  /// Why Status is not Ok: a sentence without the file's name.
  std::string Problem;
  std::vector<std::string> Messages;
  /// Solids, faces and instances that the file declares and the document lacks, and contradictions that belong to no single body; a sentence each.
  std::vector<std::string> Defects;
  /// The file's own length unit as it spells it ("millimetre"), and in mm; empty and 1 when it gives none.
  std::string FileUnit;
  double FileUnitInMillimetres = 1.0;
  /// Unit of the lengths of this document, also where mm is said above, in mm.
  double UnitInMillimetres = 1.0;
  std::vector<PartBody> Bodies;
  std::vector<BodyInstance> Instances;
  ProductNode Root;
  int FreeFaces = 0;
  ShapeTable Table;
  /// Wall-clock seconds until the entities are in memory, and those of the inspection of faces, which seeks missing trim curves. The
  /// rest of the reading makes shapes of entities.
  double ParseSeconds = 0.0;
  double TrimSeconds = 0.0;
};

/// Instances of bodies and sub-assemblies that are read; each becomes a node of the tree, a body's a leaf with points of its own.
constexpr std::uint64_t MostInstances = 100000;

/// Which shapes OpenCASCADE repairs before they are converted.
enum class RepairMode
{
  Always,
  /// Those that are not sound as the file has them (smOCCTRepair.h).
  OnNeed
};

/**
 * Reads the bytes of a STEP file. `progress` gets a fraction in [0,1] and answers false to stop. Holds a KernelSession, so that one
 * thread of the process reads at a time. Throws std::bad_alloc, and nothing else.
 */
Document ReadSTEP(std::string content, RepairMode repair, const ProgressCallback& progress);
}

#endif

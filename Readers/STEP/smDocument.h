/**
 * @file smDocument.h
 * @brief A STEP or BREP file as parts and instances with their attributes
 */
#ifndef smDocument_h
#define smDocument_h

#include "Shapes/smShape.h"
#include "smDrawingTolerances.h"
#include "smFaceStatement.h"
#include "smProgressCallback.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace sm
{
/// One solid or free shell, in the coordinates of its part, without its own location.
struct PartBody
{
  BodyShape Shape;
  /// Transform that is applied to the shape first: the scale of an instance, else the identity.
  Placement Scale;
  bool Solid = true;
  std::int64_t FileId = 0;
  std::string Name;
  std::string Material;
  double Density = 0.0;
  /// Volume in mm^3 and area in mm^2 that the file states; NaN if it states none.
  double FileVolume = std::numeric_limits<double>::quiet_NaN();
  double FileArea = std::numeric_limits<double>::quiet_NaN();
  Vector3 Color{ -1.0, -1.0, -1.0 };
  /// Accuracy of coordinates in mm that the file states for it; 0: none.
  double Uncertainty = 0.0;
  /// Number of faces that the file declares and that Shape does not have; Messages names them.
  int LostFaces = 0;
  std::vector<std::string> Messages;
};

/// One occurrence of a body. The placement is rigid or mirrored, in mm.
struct BodyInstance
{
  int Body = 0;
  Placement Place;
  std::string Name;
  /// Colour of the instance, which overrides that of its part; negative: none.
  Vector3 Color{ -1.0, -1.0, -1.0 };
  /// True if the file hides it: its body, an occurrence above it, or a representation or layer with one of
  /// these (INVISIBILITY).
  bool IsHidden = false;
};

struct ProductNode
{
  std::string Name;
  std::string Layer;
  /// From the coordinates of the product to those of the world, in mm; none where it is not known.
  std::optional<Placement> Place;
  std::vector<int> Instances;
  std::vector<ProductNode> Children;
};

enum class ReadStatus
{
  Ok,
  Empty,
  Unreadable,
  Aborted,
  /// Not read for a reason that may not be in the file: solidmoments-kernel is missing, was ended, or took
  /// too long.
  Failed
};

struct Document
{
  ReadStatus Status = ReadStatus::Unreadable;
  /// The reason why Status is not Ok: a sentence without the file's name.
  std::string Problem;
  std::vector<std::string> Messages;
  /// Solids, faces and instances that the file declares and the document lacks, and contradictions that
  /// belong to no single body; a sentence each.
  std::vector<std::string> Defects;
  /// The length unit of the file, in its spelling ("millimetre"), and its size in mm; empty and 1 if it
  /// states none.
  std::string FileUnit;
  double FileUnitInMillimetres = 1.0;
  /// Size in mm of the unit of all lengths in this document, also of those that are said to be in mm above.
  double UnitInMillimetres = 1.0;
  std::vector<PartBody> Bodies;
  std::vector<BodyInstance> Instances;
  ProductNode Root;
  int FreeFaces = 0;
  /// What a STEP file states about its faces in space.
  FaceStatements Statements;
  /// Tolerances of the drawing in a STEP file, in mm.
  std::vector<DrawingTolerance> Tolerances;
  /// Numbers of the faces whose surface was read with the opposite normal, because one of its parameters runs
  /// backwards in the file.
  std::vector<std::uint64_t> ReversedFaces;
  /// Wall-clock seconds until the entities are in memory, and those of the inspection of faces, which finds
  /// missing trim curves. The rest of the time of reading is the transfer of entities to shapes.
  double ParseSeconds = 0.0;
  double TrimSeconds = 0.0;
};

/// Largest number of levels of assemblies, and of geometric entities that refer to one another, that are
/// read: each needs a part of the stack.
constexpr std::size_t MaxLevels = 1000;

/// The bodies that OpenCASCADE repairs before they are converted.
enum class RepairMode
{
  Always,
  /// Only bodies with defects (smRepair.h).
  OnNeed,
  /// None: a body with defects has those of its faces that are sound, and is a defect of the document.
  Never
};

/// The bodies that are read of those that a file hides, and of the others.
enum class HiddenMode
{
  /// All, with a message about those that are hidden.
  Count,
  /// Those that are not hidden.
  Skip,
  /// Those that are hidden.
  Only
};

/**
 * Reads the bytes of a STEP file. `progress` gets a fraction in [0,1] and returns false to stop. Throws only
 * std::bad_alloc.
 */
Document ReadSTEP(
  std::string content, RepairMode repair, HiddenMode hidden, const ProgressCallback& progress);
}

#endif

/**
 * @file smExportTree.h
 * @brief A dataset with exact geometry as parts, instances and assemblies: what a file of solids holds
 */
#ifndef smExportTree_h
#define smExportTree_h

#include "vtkSmartPointer.h"
#include "vtkTrimmedNURBSModel.h"

#include <array>
#include <string>
#include <vector>

class vtkDataObject;

namespace sm
{
/// Row-major, the first three rows of a 4x4.
using Placement = std::array<double, 12>;
using Color = std::array<double, 3>;

/// A body of a part: the model, mapped by `Own` (the identity, unless the part has several bodies, or is mirrored).
struct ExportBody
{
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  Placement Own{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
  /// sRGB in [0,1]; negative: none. Of the body, and of each face that has one of its own.
  Color BodyColor{ -1.0, -1.0, -1.0 };
  std::vector<Color> FaceColors;
};

struct ExportPart
{
  std::string Name;
  std::string Layer;
  std::vector<ExportBody> Bodies;
};

/// A part (Part >= 0) or an assembly, as it stands in its parent. Assemblies stand where their parents do.
struct ExportNode
{
  std::string Name;
  std::string Layer;
  int Part = -1;
  /// Rigid, in the lengths of the models.
  Placement Place{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
  /// Colour of the instance, which overrides that of its part; negative: none.
  Color InstanceColor{ -1.0, -1.0, -1.0 };
  std::vector<ExportNode> Children;
};

struct ExportTree
{
  std::vector<ExportPart> Parts;
  /// Nameless; its children are the roots of the file.
  ExportNode Root;
  /// Length unit of the models; all bodies of a tree have the same.
  std::string LengthUnit;
  /// The unit that the file of the first body was written in; empty when it is not known.
  std::string FileUnit;
  /// Worth knowing, and worth a warning; one sentence each.
  std::vector<std::string> Notes;
  std::vector<std::string> Warnings;
};

extern const Placement IdentityPlacement;

/**
 * Leaves of one model are instances of one part. The assembly of a partitioned dataset collection gives structure, names and
 * layers; leaves that it does not name, and those of other datasets, stand at the root under the names of their blocks. A
 * node's leaves are the bodies of one part.
 *
 * A mirrored placement becomes a rigid one of a part of its own, whose x is the negative of the part's, exactly; a
 * placement that is not rigid is taken into the geometry. The roots of the tree are parts in their own coordinates, or
 * assemblies: where one is placed otherwise, or twice, all roots get an assembly above them.
 *
 * Colours come from the cell array Color (per face) where there is one, else from the faces.
 *
 * Leaves without exact geometry are left out and named in Warnings. A tree without parts has nothing to save.
 */
ExportTree MakeExportTree(vtkDataObject* data);
}

#endif

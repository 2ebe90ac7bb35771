/**
 * @file smExportTree.h
 * @brief Converts a dataset with exact geometry to the parts, instances and assemblies of a CAD file
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
/// The first three rows of a 4x4 matrix, row-major.
using MatrixRows = std::array<double, 12>;
using Color = std::array<double, 3>;

constexpr MatrixRows IdentityPlacement{ 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };

/// A body of a part: the model, mapped by `Own` (the identity, unless the part has several bodies, or is
/// mirrored).
struct ExportBody
{
  vtkSmartPointer<vtkTrimmedNURBSModel> Model;
  MatrixRows Own = IdentityPlacement;
  /// Colour of the body, and of each face that has one of its own; sRGB in [0,1], negative: none.
  Color BodyColor{ -1.0, -1.0, -1.0 };
  std::vector<Color> FaceColors;
};

struct ExportPart
{
  std::string Name;
  std::string Layer;
  std::vector<ExportBody> Bodies;
};

/// A part (Part >= 0) or an assembly. Place is relative to the parent; assemblies have the identity.
struct ExportNode
{
  std::string Name;
  std::string Layer;
  int Part = -1;
  /// Rigid placement; the translation is in the unit of the models.
  MatrixRows Place = IdentityPlacement;
  /// Colour of the instance, which overrides that of its part; negative: none.
  Color InstanceColor{ -1.0, -1.0, -1.0 };
  std::vector<ExportNode> Children;
};

struct ExportTree
{
  std::vector<ExportPart> Parts;
  /// A node without a name, whose children are the roots of the file.
  ExportNode Root;
  /// Length unit of the models; all bodies of a tree have the same.
  std::string LengthUnit;
  /// Length unit of the file from which the first body was read; empty if not known.
  std::string FileUnit;
  /// Information for the user, and warnings; one sentence each.
  std::vector<std::string> Notes;
  std::vector<std::string> Warnings;
};

/**
 * Makes the tree of a dataset. Leaves of one model are instances of one part. The assembly of a partitioned
 * dataset collection gives structure, names and layers; leaves that it does not name, and those of other
 * datasets, are children of the root with the names of their blocks. A node's leaves are the bodies of one
 * part.
 *
 * A mirrored placement becomes a rigid one of a separate part, whose x coordinates are exactly negated; a
 * placement that is not rigid is applied to the geometry. The roots of the tree are parts in their own
 * coordinates, or assemblies: if one of them has another placement, or occurs twice, all roots are put into
 * an additional assembly.
 *
 * Colours come from the cell array Color (per face) where there is one, else from the faces.
 *
 * Leaves without exact geometry are left out and named in Warnings. A tree without parts has nothing to save.
 */
ExportTree MakeExportTree(vtkDataObject* data);
}

#endif

/**
 * @file smScaleModels.h
 * @brief STEP files of any number of faces or instances, whose volumes have closed forms
 */
#ifndef smScaleModels_h
#define smScaleModels_h

#include <array>
#include <string>

namespace smtest
{
/// A STEP file, as text, and what it declares.
struct ScaleModel
{
  std::string Text;
  /// Volume of all instances together, in mm^3.
  double Volume = 0.0;
  /// Their centre of mass, in mm.
  std::array<double, 3> Center{};
  /// Faces that the file has, those of a part counted once.
  long long Faces = 0;
  long long Instances = 1;
};

/// A plate with `holes` (a square number) round holes of different radii: two of its faces have as many
/// loops.
ScaleModel MakePlate(int holes);

/// A cubic lattice of side^3 blocks and the struts between them, cylinders along x and cones along y and z,
/// as one solid. All blocks and struts differ in size; a face of a block has a loop round its strut. About 9
/// side^3 faces.
ScaleModel MakeLattice(int side);

/// A square grid of `balls` (a square number) balls of one radius, each a solid of one face, as the solder
/// under a chip.
ScaleModel MakeBalls(int balls);

/// The order of the two placements that an instance names: first that of the part, as the format asks; first
/// that of the assembly, an error of some CAD systems that OpenCASCADE corrects; or by turns, two instances
/// in one place with the same placements.
enum class Placing
{
  InOrder,
  Swapped,
  Alternating
};

/// `instances` copies of a plate with four holes in one assembly.
ScaleModel MakeAssembly(int instances, Placing placing);
}

#endif

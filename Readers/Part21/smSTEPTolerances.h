/**
 * @file smSTEPTolerances.h
 * @brief Tolerances of the drawing in a STEP file (AP242), as ranges of offsets of faces
 */
#ifndef smSTEPTolerances_h
#define smSTEPTolerances_h

#include "smPart21File.h"
#include "smReadersPart21Module.h"

#include <cstdint>
#include <string>
#include <vector>

namespace sm
{
struct STEPTolerance
{
  /// Number of the entity.
  std::uint64_t Id = 0;
  /// "surface profile", "diameter", "thickness", or the name of the entity in small letters.
  std::string Kind;
  /// Numbers of the faces that the file links to it; none with IsForAll, if it links the shape of the
  /// product.
  std::vector<std::uint64_t> Faces;
  bool IsForAll = false;
  /// Range of offsets of these faces along their outward normals, in mm.
  double Lower = 0.0;
  double Upper = 0.0;
  /// The reason why the range is not known, or does not say where the face is; empty otherwise.
  std::string Problem;
};

/**
 * Returns all tolerances of a file: PLUS_MINUS_TOLERANCE and the subtypes of GEOMETRIC_TOLERANCE, in the
 * order of the text. Understood are
 *
 * - surface profiles with a datum: half of the value to each side. Unequally disposed with a displacement d
 *   and a value w: from d - w to d + w/2, which holds if d is what may be added (ASME), and if
 *   it is the offset of the zone's middle (ISO). Without a datum they control the form alone, and do not say
 *   where the face is;
 * - plus-minus tolerances of a diameter or radius whose faces are cylinders, outside or inside: half of the
 *   limits of a diameter;
 * - plus-minus tolerances of a linear distance between two planes whose outward normals are opposite: a
 *   thickness, or a width. Half of the limits belongs to each plane.
 *
 * The links are GEOMETRIC_ITEM_SPECIFIC_USAGE of the toleranced SHAPE_ASPECT or of parts of it
 * (SHAPE_ASPECT_RELATIONSHIP), as the recommended practices of the CAx-IF have them. Outward normals follow
 * from same_sense of the face, as those of solids do.
 */
SMREADERSPART21_EXPORT std::vector<STEPTolerance> ReadSTEPTolerances(const Part21File& file);
}

#endif

/**
 * @file smExportColors.h
 * @brief Colours of bodies, faces and instances from what the display mesh shows
 */
#ifndef smExportColors_h
#define smExportColors_h

#include "smExportTree.h"

class vtkNURBSDataSet;

namespace sm
{
/**
 * Reads the colours of the faces and of the body from the leaf's cell array Color and from the faces. A
 * face's own colour, in full precision, is used if it agrees with the array to 1/255. If the array has a
 * single colour, and a face has a different one of its own, the single colour is that of the instance, and
 * the body has none.
 */
void ReadColors(vtkNURBSDataSet* leaf, ExportBody& body, Color& instance);

/// Returns the single colour of all faces of `other` if the colours of `part` differ from it; negative if
/// they are equal, or if there is more than one colour.
Color GetDifference(const std::vector<ExportBody>& part, const std::vector<ExportBody>& other);
}

#endif

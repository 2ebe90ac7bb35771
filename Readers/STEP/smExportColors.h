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
 * Colours of the faces and of the body, from the leaf's cell array Color and the faces' own colours: one that the array
 * shows to 1/255 is kept to all its digits. Where the array shows one colour and a face has another of its own,
 * that one colour is the instance's, and the body gets none.
 */
void ReadColors(vtkNURBSDataSet* leaf, ExportBody& body, Color& instance);

/// The one colour of all faces of `other` when that is not what `part` has; negative: the same, or more than one.
Color GetDifference(const std::vector<ExportBody>& part, const std::vector<ExportBody>& other);
}

#endif

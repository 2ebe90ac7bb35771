/**
 * @file smSchemeJob.h
 * @brief Mass properties by the schemes of the paper: the filter, its part of the JSON, its trim textures as PNG files
 */
#ifndef smSchemeJob_h
#define smSchemeJob_h

#include "smFileJob.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>

class vtkFieldData;
class vtkMassPropertiesBase;

namespace sm
{
/// Makes a filter for the scheme of the options, which must be "midpoint", "gauss2" or "gauss3".
vtkSmartPointer<vtkMassPropertiesBase> MakeSchemeFilter(const JobOptions& options);

/// Returns the scheme of such a filter; null for any other filter.
Json GetSchemeOptions(vtkMassPropertiesBase* filter);

/// Returns the paper's estimates of the error and the number of sub-patches in a row of field data or of a table; null if they are missing.
Json GetSchemeQuantities(vtkFieldData* data, vtkIdType row);

/// Writes the textures that the last run kept, v upwards, white inside the face, as PREFIX-NAME.png. NAME is the texture's name with a
/// dash for all but letters, digits and points; equal names get -2, -3, ... Returns an error message, empty when all are written.
std::string WriteTrimPictures(vtkMassPropertiesBase* filter, const std::string& prefix);
}

#endif

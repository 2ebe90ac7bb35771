/**
 * @file smTrimPictures.h
 * @brief The trim textures of a run as PNG files
 */
#ifndef smTrimPictures_h
#define smTrimPictures_h

#include <string>

class vtkMassPropertiesGPU;

namespace sm
{
/// Writes the textures that the last run kept, v upwards, white inside the face, as PREFIX-NAME.png. NAME is the texture's name with a
/// dash for all but letters, digits and points; equal names get -2, -3, ... Returns an error message, empty when all are written.
std::string WriteTrimPictures(const vtkMassPropertiesGPU* filter, const std::string& prefix);
}

#endif

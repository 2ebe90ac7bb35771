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
/// Writes the textures that the last run kept, v upwards, white in the face: PREFIX-NAME.png, NAME the texture's with everything but
/// letters, digits and points as dashes; -2, -3 … where names are equal. Returns why it could not, empty when it could.
std::string WriteTrimPictures(const vtkMassPropertiesGPU* filter, const std::string& prefix);
}

#endif

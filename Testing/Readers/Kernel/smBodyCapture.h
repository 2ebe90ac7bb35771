/**
 * @file smBodyCapture.h
 * @brief The bodies of a STEP file as the reader has them before they are converted
 */
#ifndef smBodyCapture_h
#define smBodyCapture_h

#include "Shapes/smShape.h"

#include <string>
#include <vector>

namespace smtest
{
/// A failure to read the file is a failure of the test.
std::vector<sm::BodyShape> CaptureBodies(const std::string& path);
}

#endif

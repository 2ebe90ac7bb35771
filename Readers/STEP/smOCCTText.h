/**
 * @file smOCCTText.h
 * @brief Numbers in messages
 */
#ifndef smOCCTText_h
#define smOCCTText_h

#include <cstdio>
#include <string>

namespace sm
{
/// Three digits: 1.23e-05.
inline std::string FormatShort(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}
}

#endif

/**
 * @file smOCCTText.h
 * @brief Numbers in messages
 */
#ifndef smOCCTText_h
#define smOCCTText_h

#include <cmath>
#include <cstdio>
#include <string>

namespace sm
{
/// Three digits: 1.23e-05; words for what is no number.
inline std::string FormatShort(double value)
{
  if (!std::isfinite(value))
  {
    return "an unknown distance";
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", value);
  return text;
}
}

#endif

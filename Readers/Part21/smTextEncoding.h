/**
 * @file smTextEncoding.h
 * @brief Converts the bytes of a STEP file to UTF-8
 */
#ifndef smTextEncoding_h
#define smTextEncoding_h

#include "smReadersPart21Module.h"

#include <string>
#include <string_view>

namespace sm
{
/**
 * Part 21 writes letters beyond ASCII with escapes (\X2\00E4\X0\) and leaves other bytes undefined. Files in
 * the wild have them in UTF-8 or ISO 8859-1. Valid UTF-8 sequences are kept; every other byte above 127
 * becomes the character of ISO 8859-1. Text without such bytes is returned unchanged, in a time that is small
 * compared with that of reading it.
 */
SMREADERSPART21_EXPORT std::string ToUTF8(std::string text);

/// Returns the text of a string of Part 21 (ISO 10303-21, 6.4.3) without its escapes: '', \\, \X\, \X2\,
/// \X4\, and \S\ for ISO 8859-1; without \N\, \F\ and line breaks, which count only where the file is
/// printed. Incomplete escapes are kept as they are.
SMREADERSPART21_EXPORT std::string DecodePart21Text(std::string_view given);
}

#endif

/**
 * @file smTextEncoding.h
 * @brief The bytes of a STEP file as UTF-8
 */
#ifndef smTextEncoding_h
#define smTextEncoding_h

#include "smReadersPart21Module.h"

#include <string>

namespace sm
{
/**
 * Part 21 writes letters beyond ASCII with escapes (\X2\00E4\X0\) and leaves other bytes undefined. Files in the wild have them in UTF-8 or
 * ISO 8859-1. Sequences of UTF-8 are kept, every other byte from 128 on becomes the letter that ISO 8859-1 has there. Text without such
 * bytes is returned as it is, in a time that is small beside that of reading it.
 */
SMREADERSPART21_EXPORT std::string ToUTF8(std::string text);
}

#endif

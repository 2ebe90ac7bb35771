/**
 * @file smReference.h
 * @brief The reference of the documents that the program writes, from the results themselves
 */
#ifndef smReference_h
#define smReference_h

#include <string>

namespace sm
{
/// Returns tables in Markdown of all keys of the JSON and all columns of the CSV, with the units and meanings
/// that Visit() and AddColumns() of the results give them.
std::string FormatReference();
}

#endif

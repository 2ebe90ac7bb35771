/**
 * @file smArgumentOptions.h
 * @brief The options of the command line with their help
 */
#ifndef smArgumentOptions_h
#define smArgumentOptions_h

#include "smArguments.h"

namespace sm
{
/// Declares all options, whose values are stored in `arguments`.
void DeclareOptions(CLI::App& app, Arguments& arguments);
}

#endif

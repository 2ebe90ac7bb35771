/**
 * @file smArgumentOptions.h
 * @brief The options of the command line with their help
 */
#ifndef smArgumentOptions_h
#define smArgumentOptions_h

#include "smArguments.h"

namespace sm
{
/// Declares all options; values that they are given go to `arguments`.
void DeclareOptions(CLI::App& app, Arguments& arguments);
}

#endif

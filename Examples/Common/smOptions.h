/**
 * @file smOptions.h
 * @brief Exit statuses and options that the example programs share, for CLI11
 */
#ifndef smOptions_h
#define smOptions_h

#include "smText.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace sm
{
/// Exit statuses. If several of them apply, the smallest one above 0 is used.
enum ExitStatus
{
  AllOk = 0,
  UsageOrOutput = 1,
  Unreadable = 2,
  Flagged = 3,
  Different = 4
};

/// Returns an error message if the value of an option that names a file looks like another option; empty
/// otherwise. "-" is a file name.
inline std::string CheckFileName(const std::string& name)
{
  return name.size() > 1 && name[0] == '-' ? "a file name is missing: " + name +
      " looks like an option (write ./" + name + " for a file of that name)"
                                           : "";
}

/// Adds an option that names a file or a folder.
inline CLI::Option* AddFileOption(
  CLI::App& app, const std::string& option, std::string& name, const std::string& help)
{
  return app.add_option(option, name, help)->type_name("FILE")->check(CheckFileName);
}

/// Adds an option that takes a number. CLI11 itself reads numbers with the decimal sign of the locale. A
/// check must refuse NaN.
inline CLI::Option* AddNumberOption(
  CLI::App& app, const std::string& option, double& number, const std::string& help)
{
  return app
    .add_option_function<std::string>(
      option, [&number](const std::string& text) { number = ParseNumber(text); }, help)
    ->type_name("NUMBER");
}

/// Adds an option that may be given several times; `use` gets each value.
inline CLI::Option* AddRepeatedOption(CLI::App& app, const std::string& option, const std::string& help,
  const std::function<void(const std::string&)>& use)
{
  return app
    .add_option_function<std::vector<std::string>>(
      option,
      [use](const std::vector<std::string>& texts)
      {
        for (const std::string& text : texts)
        {
          use(text);
        }
      },
      help)
    ->take_all()
    ->allow_extra_args(false);
}
}

#endif

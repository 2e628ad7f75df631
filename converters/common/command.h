// SPDX-License-Identifier: Apache-2.0
// What every program shares: one table of options that feeds the parser, --help, the check of the
// man page and the history in the output; exit codes and messages.
//
// A program is a settings struct, a function that describes it as a Command, and a run that reads
// like its SYNOPSIS:
//
//     int main(int argc, char** argv) {
//       Settings settings;
//       return run_command(argc, argv, describe(settings));
//     }
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "converters/common/session.h"

namespace libstyle {

// Wrong use of a program; ends it with exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Whether an option belongs into the history of a document: only what decides the result does.
enum class HistoryUse : std::uint8_t {
  kRecorded,  // name and value
  kFile,      // name, and the value without its folder
  kFilesOf,   // name, and the value WHAT=FILE:FILE without the folders of its files
  kLeftOut    // threads, progress, where files lie
};

// Where the value goes. What stands there at the start is the default, which --help shows.
using OptionTarget = std::variant<bool*, int*, double*, std::uint64_t*, std::string*,
                                  std::vector<std::string>*, std::optional<double>*>;

struct Option {
  std::string names;       // long name first, then a short one: "--output,-o"
  std::string value_name;  // "FILE", "N"; empty for a flag
  std::string help;        // one sentence, lower case, no full stop
  OptionTarget target;
  HistoryUse history = HistoryUse::kRecorded;
  std::vector<std::string> choices = {};  // the only values allowed, if any
};

// "--output" of "--output,-o".
std::string long_name(const Option& option);

// Options that mean the same in every program that has them.
Option keep_going_option(bool& keep_going);
Option threads_option(int& threads);

struct Command {
  std::string name;
  std::string summary;                // completes "name - ..."
  std::vector<std::string> synopsis;  // real command lines
  std::vector<Option> options;        // without --report, --quiet, --help and --version
  // Positional names; "-" stands for stdin when none are given. Null: the program takes none.
  std::vector<std::string>* inputs = nullptr;
  std::function<void(Session&)> run;  // throws Error or UsageError
  bool has_report = false;            // whether there is --report
  // Filled with the long names of the options that were given, if there.
  std::vector<std::string>* given = nullptr;
};

// Parses, runs, reports. Returns the exit code: 0 done, 1 bad data or a failed run, 2 wrong use.
// A closed pipe is a quiet success. The report is written unless the use was wrong.
int run_command(int argc, const char* const* argv, const Command& command);

}  // namespace libstyle

// SPDX-License-Identifier: Apache-2.0
// What a program says while it runs: warnings, errors, and a bar while it works.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "converters/common/report.h"
#include "libstyle/base/error.h"
#include "libstyle/base/progress.h"
#include "libstyle/base/warning.h"

namespace libstyle {

// Not for several threads at a time.
class Session {
 public:
  // What is said is noted in `report`, if there is one, --quiet or not.
  Session(std::string program, std::string history, bool quiet, Report* report = nullptr);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  // Prints "program: text" to stderr, --quiet or not.
  void message(std::string_view text) const;

  // Prints a warning in one line, unless --quiet, and counts it. Of one text in one file only the
  // first few are printed, and how many more there were when that file is done.
  void warn(const Warning& warning);
  WarningHandler warning_handler();
  std::size_t warning_count() const { return warnings_; }

  // Whether there is a report, and so a use for what goes into it.
  bool has_report() const { return report_ != nullptr; }
  // Notes something in a list of the report, if there is one.
  void note(std::string_view list, const JsonObject& item);

  // Prints an error in one line. The run may go on, and will end with exit code 1.
  void error(const Error& error);
  std::size_t error_count() const { return errors_; }

  // Draws a progress bar when stderr is a terminal and the work takes over a second.
  ProgressHandler progress_handler() const;

  // This command line as it belongs into the history of a document.
  const std::string& history() const { return history_; }

 private:
  void print(const Warning& warning);
  void print_repeated();

  std::string program_;
  std::string history_;
  bool quiet_;
  Report* report_;
  std::size_t warnings_ = 0;
  std::size_t errors_ = 0;
  std::string file_;                             // that the last warning was about
  std::map<std::string, std::size_t> repeated_;  // how often each text was said of it
};

}  // namespace libstyle

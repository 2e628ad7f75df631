// SPDX-License-Identifier: Apache-2.0
#include "converters/common/session.h"

#include <cstdio>
#include <utility>

#include "converters/common/progress_bar.h"

namespace libstyle {

Session::Session(std::string program, std::string history, bool quiet, Report* report)
    : program_(std::move(program)), history_(std::move(history)), quiet_(quiet), report_(report) {}

void Session::message(std::string_view text) const {
  const std::string line = program_ + ": " + std::string(text) + '\n';
  // Where messages cannot be written, nobody can be told so.
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

void Session::warn(const Warning& warning) {
  ++warnings_;
  if (report_) report_->add(Severity::kWarning, warning.place, warning.id, warning.message);
  if (quiet_) return;
  const std::string id = warning.id.empty() ? "" : "#" + warning.id + ": ";
  message(to_prefix(warning.place) + "warning: " + id + warning.message);
}

WarningHandler Session::warning_handler() {
  return [this](const Warning& warning) { warn(warning); };
}

void Session::error(const Error& error) {
  ++errors_;
  if (report_) report_->add(Severity::kError, error.place(), {}, error.message());
  message(error.what());
}

ProgressHandler Session::progress_handler() const {
  if (quiet_ || !stderr_is_terminal()) return {};
  return make_progress_bar(program_);
}

}  // namespace libstyle

// SPDX-License-Identifier: Apache-2.0
#include "converters/common/session.h"

#include <cstdio>
#include <utility>

#include "converters/common/progress_bar.h"

namespace libstyle {
namespace {

// Of one text in one file: enough to see what it is about.
constexpr std::size_t kMostPrinted = 5;

}  // namespace

Session::Session(std::string program, std::string history, bool quiet, Report* report)
    : program_(std::move(program)), history_(std::move(history)), quiet_(quiet), report_(report) {}

Session::~Session() { print_repeated(); }

void Session::message(std::string_view text) const {
  const std::string line = program_ + ": " + std::string(text) + '\n';
  // Where messages cannot be written, nobody can be told so.
  static_cast<void>(std::fwrite(line.data(), 1, line.size(), stderr));
}

void Session::warn(const Warning& warning) {
  ++warnings_;
  if (report_) report_->add(Severity::kWarning, warning.place, warning.id, warning.message);
  if (!quiet_) print(warning);
}

void Session::print(const Warning& warning) {
  if (warning.place.file != file_) {
    print_repeated();
    file_ = warning.place.file;
  }
  if (++repeated_[warning.message] > kMostPrinted) return;
  const std::string id = warning.id.empty() ? "" : "#" + warning.id + ": ";
  message(to_prefix(warning.place) + "warning: " + id + warning.message);
}

void Session::print_repeated() {
  for (const auto& [text, count] : std::exchange(repeated_, {})) {
    if (count <= kMostPrinted) continue;
    const std::string more = "and " + std::to_string(count - kMostPrinted) + " more: ";
    message(to_prefix({file_}) + "warning: " + more + text);
  }
}

WarningHandler Session::warning_handler() {
  return [this](const Warning& warning) { warn(warning); };
}

void Session::note(std::string_view list, const JsonObject& item) {
  if (report_) report_->add_to_list(list, item);
}

void Session::error(const Error& error) {
  ++errors_;
  if (report_) report_->add(Severity::kError, error.place(), {}, error.message());
  print_repeated();
  message(error.what());
}

ProgressHandler Session::progress_handler() const {
  if (quiet_ || !stderr_is_terminal()) return {};
  return make_progress_bar(program_);
}

}  // namespace libstyle

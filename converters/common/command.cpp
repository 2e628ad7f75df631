// SPDX-License-Identifier: Apache-2.0
#include "converters/common/command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>
#include <optional>

#include "converters/common/files.h"
#include "converters/common/help.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

enum ExitCode { kDone = 0, kFailed = 1, kWrongUse = 2 };

// The options of every program.
struct CommonSettings {
  std::string report;
  bool quiet = false;
  bool help = false;
  bool version = false;
};

std::vector<Option> all_options(const Command& command, CommonSettings& common) {
  std::vector<Option> options = command.options;
  if (command.has_report) {
    options.push_back({"--report", "FILE", "write all warnings and errors here as JSON",
                       &common.report, HistoryUse::kLeftOut});
  }
  options.push_back(
      {"--quiet,-q", "", "print no warnings and no progress", &common.quiet, HistoryUse::kLeftOut});
  options.push_back({"--help", "", "print this text and end", &common.help, HistoryUse::kLeftOut});
  options.push_back(
      {"--version", "", "print the version and end", &common.version, HistoryUse::kLeftOut});
  return options;
}

// CLI11 reads "-1" into an unsigned number and "nan" into a double.
std::string check_number(const std::string& text) {
  double value = 0;
  std::string_view rest = text;
  if (rest.starts_with('+')) rest.remove_prefix(1);
  return take_number(rest, value) && rest.empty() ? "" : "'" + text + "' is not a number";
}

std::string check_not_negative(const std::string& text) {
  return text.starts_with('-') ? "'" + text + "' is below zero" : check_number(text);
}

CLI::Option* declare(CLI::App& parser, const Option& option) {
  return std::visit(
      [&](auto* target) -> CLI::Option* {
        using Value = std::remove_reference_t<decltype(*target)>;
        if constexpr (std::is_same_v<Value, bool>) {
          return parser.add_flag(option.names, *target);
        } else {
          CLI::Option* declared = parser.add_option(option.names, *target);
          if (!option.choices.empty()) declared->check(CLI::IsMember(option.choices));
          if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
            declared->expected(1)->take_all()->allow_extra_args(false);
          } else if constexpr (std::is_integral_v<Value>) {
            declared->check(check_not_negative);  // there is nothing to count below zero
          } else if constexpr (!std::is_same_v<Value, std::string>) {
            declared->check(check_number);
          }
          return declared;
        }
      },
      option.target);
}

// A word as a shell would need it written.
std::string shell_quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,%@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string file_name(std::string_view path) {
  return std::filesystem::path(path).filename().string();
}

// "meadow=styles/plain.svg:styles/grass.svg" as "meadow=plain.svg:grass.svg".
std::string without_folders(std::string_view value) {
  const std::size_t files = value.find('=') + 1;
  std::string result(value.substr(0, files));
  value.remove_prefix(files);
  for (std::size_t colon; (colon = value.find(':')) != std::string_view::npos;) {
    result += file_name(value.substr(0, colon)) + ':';
    value.remove_prefix(colon + 1);
  }
  return result + file_name(value);
}

std::string history_of(const std::string& program, const std::vector<Option>& options,
                       const std::vector<CLI::Option*>& parsed) {
  std::string line = program;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i].history == HistoryUse::kLeftOut || parsed[i]->count() == 0) continue;
    const std::string name = long_name(options[i]);
    if (options[i].value_name.empty()) {
      line += ' ' + name;
      continue;
    }
    for (std::string value : parsed[i]->results()) {
      if (options[i].history == HistoryUse::kFile) value = file_name(value);
      if (options[i].history == HistoryUse::kFilesOf) value = without_folders(value);
      line += ' ' + name + ' ' + shell_quoted(value);
    }
  }
  return line;
}

int report_wrong_use(const std::string& program, const std::string& what) {
  Session(program, {}, false).message(what + "; see " + program + " --help");
  return kWrongUse;
}

void print(const std::string& text) {
  OutputFile output("-");
  output.write(text);
  output.commit();
}

// Runs what can throw and turns it into an exit code.
int guarded(const std::string& program, Session& session, const std::function<void()>& run) {
  try {
    run();
  } catch (const ClosedPipe&) {
  } catch (const UsageError& error) {
    return report_wrong_use(program, error.what());
  } catch (const Error& error) {
    session.error(error);
  } catch (const std::bad_alloc&) {
    session.error(Error("out of memory; give it more, or a smaller input"));
  } catch (const std::exception& error) {
    session.error(Error(std::string("internal error: ") + error.what()));
  }
  return session.error_count() > 0 ? kFailed : kDone;
}

bool writes_stdout(const Command& command) {
  return std::ranges::any_of(command.options, [](const Option& option) {
    if (!option.names.starts_with("--output")) return false;
    return *std::get<std::string*>(option.target) == "-";
  });
}

// Runs a command and writes its report, whose place is tried beforehand.
int run_with_report(const Command& command, const std::string& history,
                    const CommonSettings& common) {
  Report report;
  Session session(command.name, history, common.quiet, &report);
  std::optional<OutputFile> file;
  const int code = guarded(command.name, session, [&] {
    if (common.report == "-" && writes_stdout(command)) {
      throw UsageError("--report and --output cannot both be stdout");
    }
    file.emplace(common.report);
    command.run(session);
  });
  if (code == kWrongUse || !file) return code;
  return std::max(code, guarded(command.name, session, [&] {
                    file->write(report.to_json(command.name, code));
                    file->commit();
                  }));
}

}  // namespace

std::string long_name(const Option& option) {
  return option.names.substr(0, option.names.find(','));
}

Option keep_going_option(bool& keep_going) {
  return {"--keep-going", "", "report a document that is bad, and do the others", &keep_going,
          HistoryUse::kLeftOut};
}

Option threads_option(int& threads) {
  return {"--threads", "N", "how many threads work; 0: one a core", &threads, HistoryUse::kLeftOut};
}

int run_command(int argc, const char* const* argv, const Command& command) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error of write(), reported as ClosedPipe
  CommonSettings common;
  const std::vector<Option> options = all_options(command, common);
  CLI::App parser(command.summary, command.name);
  parser.set_help_flag();
  std::vector<CLI::Option*> parsed;
  // The help text shows the defaults, so it is made before parsing replaces them.
  const std::string help = help_text(command, options);
  for (const Option& option : options) parsed.push_back(declare(parser, option));
  if (command.inputs != nullptr) parser.add_option("inputs", *command.inputs);
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_wrong_use(command.name, error.what());
  }
  for (std::size_t i = 0; command.given != nullptr && i < options.size(); ++i) {
    if (parsed[i]->count() > 0) command.given->push_back(long_name(options[i]));
  }
  if (command.inputs != nullptr && command.inputs->empty()) command.inputs->push_back("-");
  Session session(command.name, history_of(command.name, options, parsed), common.quiet);
  if (common.help || common.version) {
    return guarded(command.name, session, [&] {
      print(common.help ? help : command.name + " (libstyle) " LIBSTYLE_VERSION "\n");
    });
  }
  if (!common.report.empty()) return run_with_report(command, session.history(), common);
  return guarded(command.name, session, [&] { command.run(session); });
}

}  // namespace libstyle

// SPDX-License-Identifier: Apache-2.0
#include "converters/common/command.h"

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>

#include "converters/common/files.h"
#include "converters/common/help.h"
#include "libstyle/base/number.h"

namespace libstyle {
namespace {

enum ExitCode { kDone = 0, kFailed = 1, kWrongUse = 2 };

// The options of every program.
struct CommonSettings {
  bool quiet = false;
  bool help = false;
  bool version = false;
};

std::vector<Option> all_options(const Command& command, CommonSettings& common) {
  std::vector<Option> options = command.options;
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
          } else if constexpr (std::is_same_v<Value, std::uint64_t>) {
            declared->check(check_not_negative);
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
    const std::string name = options[i].names.substr(0, options[i].names.find(','));
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
int guarded(const std::string& program, const std::function<void()>& run) {
  const Session session(program, {}, false);
  try {
    run();
    return kDone;
  } catch (const ClosedPipe&) {
    return kDone;
  } catch (const UsageError& error) {
    return report_wrong_use(program, error.what());
  } catch (const Error& error) {
    session.message(error.what());
  } catch (const std::bad_alloc&) {
    session.message("out of memory; give it more, or a smaller input");
  } catch (const std::exception& error) {
    session.message(std::string("internal error: ") + error.what());
  }
  return kFailed;
}

}  // namespace

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
  if (command.inputs != nullptr && command.inputs->empty()) command.inputs->push_back("-");
  return guarded(command.name, [&] {
    if (common.help) return print(help);
    if (common.version) return print(command.name + " (libstyle) " LIBSTYLE_VERSION "\n");
    Session session(command.name, history_of(command.name, options, parsed), common.quiet);
    command.run(session);
  });
}

}  // namespace libstyle

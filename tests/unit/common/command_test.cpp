// SPDX-License-Identifier: Apache-2.0
#include "converters/common/command.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "converters/common/files.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::internal::CaptureStderr;
using ::testing::internal::CaptureStdout;
using ::testing::internal::GetCapturedStderr;
using ::testing::internal::GetCapturedStdout;

// A small program with one option of each kind.
struct Sample {
  std::uint64_t seed = 1;
  std::string style;
  std::vector<std::string> examples, parts;
  std::string mode = "fast";
  bool strict = false;
  int threads = 0;
  std::optional<double> scale;
  std::vector<std::string> inputs;
  std::string history;

  Command describe(std::function<void(Session&)> run) {
    return {"sample",
            "shows every kind of option",
            {"sample FILE --seed 7"},
            {{"--seed,-s", "N", "the seed", &seed},
             {"--style", "FILE", "the style", &style, HistoryUse::kFile},
             {"--example", "FILE", "an example, may be given again", &examples},
             {"--part", "WHAT=FILES", "the style of a part", &parts, HistoryUse::kFilesOf},
             {"--mode", "MODE", "how", &mode, HistoryUse::kRecorded, {"fast", "slow"}},
             {"--strict", "", "be strict", &strict},
             {"--scale", "FACTOR", "the scale", &scale},
             {"--threads", "N", "how many threads", &threads, HistoryUse::kLeftOut}},
            &inputs,
            std::move(run)};
  }

  int call(const std::vector<const char*>& words) {
    std::vector<const char*> argv = {"sample"};
    argv.insert(argv.end(), words.begin(), words.end());
    return run_command(static_cast<int>(argv.size()), argv.data(),
                       describe([this](Session& session) { history = session.history(); }));
  }
};

TEST(Command, ReadsEveryKindOfOption) {
  Sample sample;
  EXPECT_EQ(sample.call({"a.svg", "--seed", "18446744073709551615", "--example", "x", "--example",
                         "y", "b.svg", "--mode=slow", "--strict", "--scale", "0.5"}),
            0);
  EXPECT_EQ(sample.seed, 18446744073709551615u);
  EXPECT_THAT(sample.examples, ElementsAre("x", "y"));
  EXPECT_THAT(sample.inputs, ElementsAre("a.svg", "b.svg"));
  EXPECT_EQ(sample.mode, "slow");
  EXPECT_TRUE(sample.strict);
  EXPECT_EQ(sample.scale, 0.5);
}

TEST(Command, ReadsStdinWhenNoInputIsNamed) {
  Sample sample;
  EXPECT_EQ(sample.call({"--strict"}), 0);
  EXPECT_THAT(sample.inputs, ElementsAre("-"));
}

TEST(Command, HistoryHoldsOnlyWhatDecidesTheResult) {
  Sample sample;
  sample.call({"--threads", "2", "--style", "some/where/my pen.svg", "--strict", "-s", "7", "-q"});
  EXPECT_EQ(sample.history, "sample --seed 7 --style 'my pen.svg' --strict");
}

TEST(Command, HistoryHoldsTheFilesOfPartsWithoutTheirFolders) {
  Sample sample;
  sample.call({"--part", "sea=a/b.svg", "--part", "layer:a/b=/c/d:e.svg:../f.svg@2"});
  EXPECT_EQ(sample.history, "sample --part sea=b.svg --part layer:a/b=d:e.svg:f.svg@2");
}

TEST(Command, WrongUseIsOneLineAndExitTwo) {
  for (const std::vector<const char*>& words :
       std::vector<std::vector<const char*>>{{"--nonsense"},
                                             {"--seed", "x"},
                                             {"--mode", "odd"},
                                             {"--seed"},
                                             {"--seed", "-1"},
                                             {"--threads", "-1"},
                                             {"--threads", "1.5"},
                                             {"--scale", "nan"},
                                             {"--scale", "1x"}}) {
    Sample sample;
    CaptureStderr();
    EXPECT_EQ(sample.call(words), 2);
    const std::string said = GetCapturedStderr();
    EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
    EXPECT_THAT(said, HasSubstr("sample: "));
    EXPECT_THAT(said, HasSubstr("see sample --help"));
  }
}

TEST(Command, HelpShowsEveryOptionItsDefaultAndItsChoices) {
  Sample sample;
  CaptureStdout();
  EXPECT_EQ(sample.call({"--help"}), 0);
  const std::string help = GetCapturedStdout();
  EXPECT_THAT(help, HasSubstr("-s, --seed N"));
  EXPECT_THAT(help, HasSubstr("the seed [1]"));
  EXPECT_THAT(help, HasSubstr("how: fast, slow [fast]"));
  EXPECT_THAT(help, HasSubstr("--quiet"));
  std::size_t start = 0;
  while (start < help.size()) {
    const std::size_t end = help.find('\n', start);
    EXPECT_LE(end - start, 80u) << help.substr(start, end - start);
    start = end + 1;
  }
}

int exit_code_of(std::function<void(Session&)> run) {
  const char* argv[] = {"sample"};
  Sample sample;
  return run_command(1, argv, sample.describe(std::move(run)));
}

TEST(Command, ExitCodeTellsTheKindOfFailure) {
  CaptureStderr();
  EXPECT_EQ(exit_code_of([](Session&) { throw Error({"a.curves", 3}, "is bad"); }), 1);
  EXPECT_EQ(GetCapturedStderr(), "sample: a.curves:3: is bad\n");
  CaptureStderr();
  EXPECT_EQ(exit_code_of([](Session&) { throw UsageError("name a file"); }), 2);
  EXPECT_EQ(exit_code_of([](Session&) { throw std::bad_alloc(); }), 1);
  GetCapturedStderr();
}

TEST(Command, ClosedPipeIsAQuietSuccess) {
  CaptureStderr();
  EXPECT_EQ(exit_code_of([](Session&) { throw ClosedPipe(); }), 0);
  EXPECT_EQ(GetCapturedStderr(), "");
}

TEST(Command, AnErrorThatDidNotEndTheRunMakesExitOne) {
  CaptureStderr();
  EXPECT_EQ(exit_code_of([](Session& session) { session.error(Error({"a.svg"}, "is bad")); }), 1);
  EXPECT_EQ(GetCapturedStderr(), "sample: a.svg: is bad\n");
}

TEST(Session, CountsWarningsAndNamesPlaceAndId) {
  Session session("sample", "", false);
  CaptureStderr();
  const Warning warning = {{"a.svg", 12}, "rock", "filters are not carried"};
  session.warning_handler()(warning);
  EXPECT_EQ(GetCapturedStderr(), "sample: a.svg:12: warning: #rock: filters are not carried\n");
  EXPECT_EQ(session.warning_count(), 1u);
}

}  // namespace
}  // namespace libstyle

// SPDX-License-Identifier: Apache-2.0
#include "converters/common/batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::internal::CaptureStderr;
using ::testing::internal::GetCapturedStderr;

// A batch over words, each of which says what becomes of it.
struct Words {
  std::vector<std::string> words;
  BatchSettings settings;

  std::vector<std::string> finished = {};
  std::string said = {};  // on stderr
  std::size_t errors = 0;
  std::string failure = {};  // what ended the run

  void run() {
    Session session("sample", "", false);
    std::size_t next = 0;
    CaptureStderr();
    try {
      run_batch<std::string>(settings, session,
                             {.read =
                                  [&](std::string& word) {
                                    if (next == words.size()) return false;
                                    word = words[next++];
                                    if (word == "unreadable") throw Error({word}, "unreadable");
                                    return true;
                                  },
                              .work =
                                  [&](std::string& word, const WarningHandler& warn) {
                                    warn({{word}, "", "odd"});
                                    if (word == "bad") throw Error({word, 7}, "bad");
                                  },
                              .finish =
                                  [&](std::string& word) {
                                    if (word == "undrawable") throw Error({word}, "undrawable");
                                    if (word == "full") throw OutputError({"out"}, "full");
                                    finished.push_back(word);
                                  }});
    } catch (const std::exception& exception) {
      failure = exception.what();
    }
    said = GetCapturedStderr();
    errors = session.error_count();
  }
};

TEST(Batch, WithoutKeepGoingTheFirstErrorEndsIt) {
  for (const int threads : {1, 2, 5}) {
    for (const std::string bad : {"unreadable", "bad", "undrawable"}) {
      Words batch{{"a", "b", bad, "bad", "c"}, {false, threads}};
      batch.run();
      EXPECT_THAT(batch.finished, ElementsAre("a", "b"));
      EXPECT_EQ(batch.failure, bad == "bad" ? "bad:7: bad" : bad + ": " + bad);
      EXPECT_EQ(batch.errors, 0u);
    }
  }
}

TEST(Batch, KeepsGoingOverEveryKindOfErrorAndSaysAllInOrder) {
  for (const int threads : {1, 2, 5}) {
    Words batch{{"a", "unreadable", "bad", "b", "undrawable", "c", "unreadable"}, {true, threads}};
    batch.run();
    EXPECT_THAT(batch.finished, ElementsAre("a", "b", "c"));
    EXPECT_EQ(batch.failure, "");
    EXPECT_EQ(batch.errors, 4u);
    EXPECT_EQ(batch.said,
              "sample: a: warning: odd\n"
              "sample: unreadable: unreadable\n"
              "sample: bad: warning: odd\n"
              "sample: bad:7: bad\n"
              "sample: b: warning: odd\n"
              "sample: undrawable: warning: odd\n"
              "sample: undrawable: undrawable\n"
              "sample: c: warning: odd\n"
              "sample: unreadable: unreadable\n");
  }
}

TEST(Batch, WarnsAboutTheDocumentThatEndsIt) {
  Words batch{{"a", "bad", "c"}, {false, 3}};
  batch.run();
  EXPECT_EQ(batch.said, "sample: a: warning: odd\nsample: bad: warning: odd\n");
}

TEST(Batch, AnOutputThatCannotBeWrittenEndsItAlways) {
  Words batch{{"a", "bad", "full", "b"}, {true, 2}};
  batch.run();
  EXPECT_THAT(batch.finished, ElementsAre("a"));
  EXPECT_EQ(batch.failure, "out: full");
  EXPECT_EQ(batch.errors, 1u);
}

}  // namespace
}  // namespace libstyle

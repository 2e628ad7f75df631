// SPDX-License-Identifier: Apache-2.0
#include "converters/common/files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "libstyle/base/error.h"

namespace libstyle {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class Files : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::path(::testing::TempDir()) / ("files_test." + std::to_string(getpid()));
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string content(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(path(name)).rdbuf();
    return text.str();
  }
  std::size_t file_count() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  std::filesystem::path folder_;
};

TEST_F(Files, OutputAppearsOnlyWhenCommitted) {
  {
    OutputFile output(path("a"));
    output.write("half");
    EXPECT_FALSE(std::filesystem::exists(path("a")));
  }
  EXPECT_EQ(file_count(), 0u);
  OutputFile output(path("a"));
  output.write("whole");
  output.commit();
  EXPECT_EQ(content("a"), "whole");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(Files, ReplacingKeepsTheModeAndTheLink) {
  std::ofstream(path("real")) << "old";
  chmod(path("real").c_str(), 0640);
  std::filesystem::create_symlink("real", path("link"));
  OutputFile output(path("link"));
  output.write("new");
  output.commit();
  EXPECT_EQ(content("real"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  struct stat status {};
  stat(path("real").c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(Files, NewFileFollowsTheUmask) {
  const mode_t before = umask(027);
  OutputFile output(path("a"));
  output.commit();
  umask(before);
  struct stat status {};
  stat(path("a").c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(Files, FullDiskIsAnErrorThatNamesTheFile) {
  OutputFile output("/dev/full");
  EXPECT_THAT([&] { output.write("text"); }, ThrowsMessage<OutputError>(HasSubstr("/dev/full")));
}

TEST_F(Files, UnwritablePlaceIsAnErrorThatNamesTheFile) {
  EXPECT_THAT([&] { OutputFile output(path("missing/a")); },
              ThrowsMessage<OutputError>(HasSubstr("missing/a: cannot be written")));
}

TEST_F(Files, InputReadsBackWhole) {
  const std::string text(1000000, 'x');
  std::ofstream(path("a")) << text;
  EXPECT_EQ(read_all(*open_input(path("a")), text.size(), "a"), text);
}

TEST_F(Files, InputOverTheLimitIsAnError) {
  std::ofstream(path("a")) << std::string(1000, 'x');
  const auto source = open_input(path("a"));
  EXPECT_THROW(read_all(*source, 999, "a"), Error);
}

TEST_F(Files, MissingInputAndFolderAreErrorsThatNameThem) {
  EXPECT_THAT([&] { open_input(path("none")); },
              ThrowsMessage<Error>(HasSubstr("none: cannot be opened")));
  EXPECT_THAT([&] { open_input(path(".")); }, ThrowsMessage<Error>(HasSubstr("is a folder")));
}

TEST(DocumentName, IsTheStemOfTheFile) {
  EXPECT_EQ(document_name("drawings/plan.v2.svg"), "plan.v2");
  EXPECT_EQ(document_name("-"), "stdin");
}

}  // namespace
}  // namespace libstyle

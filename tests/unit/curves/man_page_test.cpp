// SPDX-License-Identifier: Apache-2.0
// man/curves.5.scd and the code say the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "libstyle/curves/fields.h"
#include "libstyle/curves/reader.h"
#include "libstyle/curves/writer.h"

namespace libstyle {
namespace {

using ::testing::HasSubstr;

struct Page {
  std::map<std::string, std::string> sections;  // by heading
  std::vector<std::string> examples;            // the lines of one block that are JSON
};

Page read_page() {
  Page page;
  std::ifstream file(LIBSTYLE_CURVES_MAN_PAGE);
  std::string heading, example;
  bool in_block = false;
  for (std::string line; std::getline(file, line);) {
    if (line == "```") {
      in_block = !in_block;
      if (!example.empty()) page.examples.push_back(std::exchange(example, ""));
    } else if (in_block) {
      if (line.starts_with("{")) example += line + '\n';
    } else if (line.starts_with("# ")) {
      heading = line.substr(2);
    } else {
      page.sections[heading] += line + '\n';
    }
  }
  return page;
}

// The section of a type is its name in capitals.
std::string heading_of(std::string_view type) {
  std::string heading(type);
  std::ranges::transform(heading, heading.begin(),
                         [](char c) { return static_cast<char>(c - 'a' + 'A'); });
  return heading;
}

// Calls visit(pointer to R) for each kind R of record that the page describes.
template <typename Visit>
void for_each_kind(Visit visit) {
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (visit(static_cast<const std::variant_alternative_t<I, Record>*>(nullptr)), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Record> - 1>());
}

template <std::size_t N>
void expect_keys(const std::string& section, const std::array<std::string_view, N>& keys,
                 std::size_t first = 0) {
  for (std::size_t i = first; i < N; ++i) {
    EXPECT_THAT(section, HasSubstr("*" + std::string(keys[i]) + "*"));
  }
}

TEST(CurvesManPage, ShowsLinesAsTheyAreWritten) {
  const Page page = read_page();
  ASSERT_GT(page.examples.size(), 10u);
  for (const std::string& example : page.examples) {
    const bool whole = example.starts_with("{\"curves\":");
    const std::string stream = (whole ? "" : "{\"curves\":1}\n") + example;
    TextSource source(stream);
    Reader reader(source, "curves.5");
    TextSink sink;
    for (Document document; reader.read(document);) write_document(sink, document);
    EXPECT_EQ(sink.text, stream);
  }
}

TEST(CurvesManPage, HasAnExampleOfEveryRecord) {
  const Page page = read_page();
  for_each_kind([&]<typename R>(const R*) {
    const std::string begin = "{\"type\":\"" + std::string(R::kType) + '"';
    EXPECT_TRUE(std::ranges::any_of(page.examples, [&](const std::string& example) {
      return example.find(begin) != std::string::npos;
    })) << R::kType;
  });
}

TEST(CurvesManPage, NamesEveryKeyInTheSectionOfItsRecord) {
  Page page = read_page();
  expect_keys(page.sections["HEADER"], fields::kKeys<Header>);
  constexpr std::size_t kCommon = std::tuple_size_v<decltype(fields::kCommonFields)>;
  const std::string& common = page.sections["ALL RECORDS"];
  for (std::size_t i = 0; i < kCommon; ++i) {
    EXPECT_THAT(common, HasSubstr("*" + std::string(fields::kKeys<PathRecord>[i]) + "*"));
  }
  for_each_kind([&]<typename R>(const R*) {
    expect_keys(page.sections[heading_of(R::kType)], fields::kKeys<R>, kCommon);
  });
  expect_keys(page.sections["GRADIENT"], fields::kKeys<GradientStop>);
  expect_keys(page.sections["GRADIENT"], fields::kKeys<LinearGeometry>);
  expect_keys(page.sections["GRADIENT"], fields::kKeys<RadialGeometry>);
  expect_keys(page.sections["CLIP"], fields::kKeys<ClipPart>);
}

// The words of enumerations, and the members of "along" that have a meaning.
TEST(CurvesManPage, NamesEveryWord) {
  const std::string path = read_page().sections["PATH"];
  const auto expect_words = [&](const auto& field) {
    if constexpr (requires { field.form.words; }) {
      for (const std::string_view word : field.form.words) {
        EXPECT_THAT(path, HasSubstr("\"" + std::string(word) + "\"")) << field.key;
      }
    }
  };
  std::apply([&](const auto&... field) { (expect_words(field), ...); },
             fields::kFields<PathRecord>);
  for (const char* name : {"*width*", "*pressure*", "*t*", "*color*"}) {
    EXPECT_THAT(path, HasSubstr(name));
  }
}

}  // namespace
}  // namespace libstyle

// SPDX-License-Identifier: Apache-2.0
#include "libstyle/analogy/style_set.h"

#include <gmock/gmock.h>

#include "libstyle/analogy/fitting_scale.h"
#include "libstyle/base/error.h"
#include "tests/unit/analogy/wavy_drawing.h"

namespace libstyle {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// A meadow (hill, tree), and the sea.
Document bay() {
  Document document;
  document.header.line = 7;
  GroupRecord meadow;
  meadow.id = "meadow";
  PathRecord hill = path_record("hill", "M0 0 L300 0"), tree = path_record("tree", "M9 0 L9 -60");
  hill.parent = tree.parent = "meadow";
  PathRecord sea = path_record("", "M0 90 L900 90");
  sea.classes = "sea";
  document.records = {meadow, hill, tree, sea};
  return document;
}

StyleExample example(std::string name, double scale = 1) {
  StyleExample style{std::move(name), wavy_pairs(), {}, false};
  style.parameters.scale = scale;
  return style;
}

void add(StyleSet& styles, const std::string& what) {
  styles.add(RecordSelector(what, BareWord::kAnything), example(what));
}

// The names of what the hill, the tree and the sea are drawn in.
std::vector<std::string> styles_of_bay(StyleSet& styles) {
  const StylePlan plan = styles.plan(bay(), {});
  std::vector<std::string> names;
  for (std::size_t i = 1; i < 4; ++i) {
    const std::size_t style = plan.style_of_record[i];
    names.push_back(style == StylePlan::kNone ? "-" : plan.styles[style].name);
    if (style != StylePlan::kNone) {
      EXPECT_NE(plan.styles[style].analogy, nullptr);
    }
  }
  return names;
}

TEST(StyleSet, EachPartHasItsStyle) {
  StyleSet styles(std::nullopt);
  add(styles, "#tree");
  add(styles, "meadow");
  EXPECT_THAT(styles_of_bay(styles), ElementsAre("meadow", "#tree", "-"));
  add(styles, "sea");
  EXPECT_THAT(styles_of_bay(styles), ElementsAre("meadow", "#tree", "sea"));
}

TEST(StyleSet, TheRestHasTheStyleOfTheRest) {
  StyleSet styles(example("rest"));
  EXPECT_THAT(styles_of_bay(styles), ElementsAre("rest", "rest", "rest"));
  add(styles, "meadow");
  EXPECT_THAT(styles_of_bay(styles), ElementsAre("meadow", "meadow", "rest"));
}

TEST(StyleSet, WarnsOnceOfAStyleThatDrawsNoLine) {
  StyleSet styles(example("rest"));
  for (const char* what : {"meadow", "#hill,#tree", "wood", "sea"}) add(styles, what);
  std::vector<std::string> messages;
  std::vector<std::size_t> lines;
  styles.plan(bay(), [&](const Warning& warning) {
    messages.push_back(warning.message);
    lines.push_back(warning.place.line);
  });
  EXPECT_THAT(messages, ElementsAre(HasSubstr("meadow draws no line"), HasSubstr("wood draws")));
  EXPECT_THAT(lines, ElementsAre(7, 7));
}

TEST(StyleSet, ASizeThatFitsIsThatOfTheLinesOfTheStyle) {
  StyleSet styles(example("rest"));
  StyleExample fits = example("sea");
  fits.fits = true;
  styles.add(RecordSelector(".sea"), fits);
  const StylePlan plan = styles.plan(bay(), {});
  const Document document = bay();
  const Path* const sea[] = {&std::get<PathRecord>(document.records[3]).path};
  const double scale = fitting_scale(sea, wavy_pairs(), {});
  EXPECT_NE(scale, 1);
  EXPECT_NEAR(plan.styles[0].analogy->example().feature_size(),
              scale * plan.styles[1].analogy->example().feature_size(), 1e-6);
}

TEST(StyleSet, IsPreparedOnceForAllDrawings) {
  StyleSet styles(example("rest"));
  const CurveAnalogy* const first = styles.plan(bay(), {}).styles[0].analogy;
  EXPECT_EQ(styles.plan(bay(), {}).styles[0].analogy, first);
}

TEST(StyleSet, NamesTheStyleWhoseExampleCannotServe) {
  StyleSet styles(example("rest"));
  styles.add(RecordSelector(".sea"), {"--style .sea", {}, {}, false});
  try {
    styles.plan(bay(), {});
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("--style .sea: there is no example"));
  }
}

}  // namespace
}  // namespace libstyle

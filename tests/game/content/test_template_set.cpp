#include "game/content/template_set.h"

#include "content_helpers.h"

#include <gmock/gmock.h>

namespace brittle::content {
namespace {

TEST(TemplateSet, KeepsTheFirstOfANameAndNamesTheRest) {
  const TemplateSet set = readTemplates(dataFile("templates.xml"), "t.xml");
  ASSERT_NE(set.find("pane"), nullptr);
  EXPECT_EQ(set.find("pane")->line, 2);
  ASSERT_EQ(set.find("pane")->attributes.size(), 4u);
  EXPECT_EQ(set.find("pane")->attributes[0].line, 3);
  EXPECT_EQ(set.find("none"), nullptr);
  EXPECT_EQ(listed(set.problems),
            "t.xml:6: a template of this name exists already: the first counts, got 'pane'\nt.xml:7: <template> "
            "without a name\n");
}

TEST(TemplateSet, CutOrChangedAnywhereItIsStillSound) {
  forEachDamage(dataFile("templates.xml"), [](const std::string& text) {
    const TemplateSet set = readTemplates(text, "f.xml");
    for (const auto& [name, one] : set.templates) ASSERT_FALSE(name.empty());
  });
}

}  // namespace
}  // namespace brittle::content

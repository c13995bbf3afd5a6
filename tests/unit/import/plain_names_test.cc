// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/plain_names.h"

#include "models/support/plain_word.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

/// Names of a robot of links called as `names`, and of its joints, after MakeNamesPlain().
std::vector<std::string> PlainNamesOf(const std::vector<std::string>& names, Notes* notes) {
  SourceRobot robot;
  for (const std::string& name : names) robot.links.emplace_back().name = name;
  robot.joints.emplace_back().name = "toe ";
  MakeNamesPlain(&robot, notes);
  std::vector<std::string> plain;
  for (const SourceLink& link : robot.links) plain.push_back(link.name);
  plain.push_back(robot.joints[0].name);
  return plain;
}

TEST(PlainNames, LoseWhatIsAroundThemAndKeepWhatIsInThemApart) {
  Notes notes;
  const auto names = PlainNamesOf({"toe_ball ", "torso::link", "left knee", "-", "foot"}, &notes);
  EXPECT_EQ(names, (std::vector<std::string>{"toe_ball", "torso__link", "left_knee", "unnamed",
                                             "foot", "toe"}));
  EXPECT_TRUE(HasNote(notes, "renamed 'toe_ball ' to 'toe_ball'"));
  EXPECT_FALSE(HasNote(notes, "'foot'"));
}

TEST(PlainNames, StayDifferent) {
  Notes notes;
  EXPECT_EQ(PlainNamesOf({"a b", "a_b", "a:b"}, &notes),
            (std::vector<std::string>{"a_b_2", "a_b", "a_b_3", "toe"}));
}

TEST(PlainNames, OfAHundredLettersAndMoreBecomeWords) {
  Notes notes;
  for (const std::string& name : PlainNamesOf({std::string(300, 'x'), "x\ny"}, &notes))
    EXPECT_TRUE(IsPlainWord(name)) << name;
}

TEST(PlainNames, ThatArePlainAlreadyAreLeftAlone) {
  SourceRobot robot = SourceOf(MakerRobot());
  const std::size_t links = robot.links.size();
  Notes notes;
  MakeNamesPlain(&robot, &notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_EQ(robot.links.size(), links);
}

}  // namespace
}  // namespace sidestep::importer

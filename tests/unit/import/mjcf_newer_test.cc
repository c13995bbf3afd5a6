// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_newer.h"

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

TEST(NewerWords, WhatNobodyKnowsIsToldAtOnceWithItsLine) {
  const std::string error = MjcfErrorOf(
      SmallMjcf("<geom size=\"1\" wobble=\"3\"/>\n<replicate count=\"4\"/>\n<joint name=\"x\" "
                "magic=\"1\"/>\n<attach model=\"m\" body=\"b\" prefix=\"p\"/>\n"));
  EXPECT_EQ(
      error,
      "robot.xml:6:1: error: <geom> has wobble=\"3\", which MuJoCo 2.2 doesn't know; delete it\n"
      "robot.xml:7:1: error: <replicate> can't be taken: write out the bodies that it makes\n"
      "robot.xml:8:1: error: <joint> 'x' has magic=\"1\", which MuJoCo 2.2 doesn't know; delete "
      "it\n"
      "robot.xml:9:1: error: <attach> can't be taken: put the attached model's bodies in its "
      "place");
}

TEST(NewerWords, WhatChangesNothingIsTakenOutAndCounted) {
  Notes notes;
  SourceOfMjcf(SmallMjcf("",
                         "<actuator><position joint=\"hip\" kp=\"5\" "
                         "inheritrange=\"1\"/></actuator>\n"),
               &notes);
  EXPECT_TRUE(HasNote(notes, "changes nothing here: inheritrange (1)"));
}

TEST(NewerWords, ARatioOfDampingThatMeansNothingIsTold) {
  const auto error = [](const std::string& damping) {
    return MjcfErrorOf(SmallMjcf(
        "", "<actuator><position name=\"m\" joint=\"hip\" kp=\"5\" " + damping + "/></actuator>"));
  };
  EXPECT_EQ(error("kv=\"1\" dampratio=\"1\""),
            "robot.xml:7:11: error: <position> 'm' has kv and dampratio; delete one");
  EXPECT_EQ(
      error("dampratio=\"-1\""),
      "robot.xml:7:11: error: <position> 'm' has dampratio=\"-1\", which must not be negative");
}

TEST(NewerWords, WhatIsLackedIsToldOneByOne) {
  Notes notes;
  SourceOfMjcf(SmallMjcf("<body name=\"tail\" gravcomp=\"1\"/>\n"), &notes);
  EXPECT_TRUE(HasNote(
      notes, "robot.xml:6:1: left out gravcomp=\"1\" of <body> 'tail': gravity acts on it"));
}

TEST(NewerWords, NumbersThatAreNoneAreTold) {
  for (const std::string number : {"nan", "inf", "-inf", "1e300"}) {
    const std::string error =
        MjcfErrorOf(SmallMjcf("<geom size=\"1\" pos=\"0 " + number + " 0\"/>"));
    EXPECT_EQ(error, "robot.xml:6:1: error: <geom> has pos with '" + number +
                         "', which is no number to use");
  }
}

TEST(NewerWords, AnActuatorsRangeOfForceComesDownFromClasses) {
  const std::string classes =
      "<default><joint actuatorfrcrange=\"-7 9\"/><default class=\"strong\"><joint "
      "actuatorfrcrange=\"-70 70\"/></default></default>\n";
  const auto effort = [&](const std::string& hip) {
    return SourceOfMjcf("<mujoco>" + classes +
                        "<worldbody><body><freejoint/><inertial pos=\"0 0 0\" mass=\"1\" "
                        "diaginertia=\"1 1 1\"/><body><geom size=\"1\"/><joint name=\"hip\" " +
                        hip + "/></body></body></worldbody></mujoco>")
        .joints[0]
        .effort_Nm;
  };
  EXPECT_EQ(effort(""), 7.0) << "the nearer end";
  EXPECT_EQ(effort("class=\"strong\""), 70.0);
  EXPECT_EQ(effort("actuatorfrcrange=\"-3 3\" user=\"1 2\""), 3.0) << "not what the maker wrote";
  EXPECT_EQ(effort("actuatorfrcrange=\"-3 3\" actuatorfrclimited=\"true\""), 3.0);
}

}  // namespace
}  // namespace sidestep::importer

// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/ocp_json.h"

#include <gtest/gtest.h>

#include <limits>

#include "controller/mpc/make_solver.h"
#include "models/support/config_error.h"
#include "models/support/require.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::ocp_json_test {
namespace {

using nlohmann::json;

constexpr const char* kExample = "icub_fast_velocity_error_previous_force";

/// The error's text, or "" if `document` is read.
std::string ErrorOf(const json& document) {
  try {
    OcpFromJson(document);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

std::string ErrorOf(const CentroidalOcp& ocp, const json& block) {
  try {
    SolutionFromJson(ocp, block);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

CentroidalOcp RandomProblem() {
  CentroidalOcp ocp = FloatingProblem(4);
  OcpContact foot = Foot("left \"foot\"\n", 4);
  foot.has_previous_force = true;
  foot.previous_force_N = Eigen::Matrix3Xd::Zero(3, 4);
  foot.phases = {FixedPhase(0, 1, Eigen::Vector3d::Zero()),
                 FreePhase(2, 9, Eigen::Vector3d::Zero(), {1.0 / 3.0, 0.1, 0.0})};
  foot.force_shares = Eigen::Vector4d::Constant(0.25);  // Randomised below.
  ocp.contacts = {foot, Foot("point", 1)};
  Numbers numbers(3);
  Randomise(numbers, &ocp);
  ocp.first_step_s = ocp.step_s / 3.0;
  return ocp;
}

TEST(OcpJsonTest, EveryNumberSurvivesTheRoundTripThroughTextBitForBit) {
  const CentroidalOcp ocp = RandomProblem();
  const CentroidalOcp back = OcpFromJson(json::parse(ToJson(ocp).dump()));
  EXPECT_EQ(back.name, ocp.name);
  EXPECT_EQ(back.description, ocp.description);
  EXPECT_EQ(back.step_s, ocp.step_s);
  EXPECT_EQ(back.first_step_s, ocp.first_step_s);
  EXPECT_EQ(back.knots, ocp.knots);
  EXPECT_EQ(back.mass_kg, ocp.mass_kg);
  EXPECT_EQ(back.gravity_mps2, ocp.gravity_mps2);
  EXPECT_EQ(back.initial_p_WC, ocp.initial_p_WC);
  EXPECT_EQ(back.initial_linear_momentum, ocp.initial_linear_momentum);
  EXPECT_EQ(back.initial_angular_momentum, ocp.initial_angular_momentum);
  EXPECT_EQ(back.reference_p_WC, ocp.reference_p_WC);
  EXPECT_EQ(back.reference_angular_momentum, ocp.reference_angular_momentum);
  EXPECT_EQ(back.external_force_N, ocp.external_force_N);
  EXPECT_EQ(back.external_torque_Nm, ocp.external_torque_Nm);
  EXPECT_EQ(back.weights.com, ocp.weights.com);
  EXPECT_EQ(back.weights.angular_momentum, ocp.weights.angular_momentum);
  EXPECT_EQ(back.weights.contact_position, ocp.weights.contact_position);
  EXPECT_EQ(back.weights.force_symmetry, ocp.weights.force_symmetry);
  EXPECT_EQ(back.weights.leg_length, ocp.weights.leg_length);
  EXPECT_EQ(back.weights.foot_load, ocp.weights.foot_load);
  EXPECT_EQ(back.foot_load_limit_N, ocp.foot_load_limit_N);
  EXPECT_EQ(back.weights.force_rate, ocp.weights.force_rate);
  EXPECT_EQ(back.weights.new_contact_force, ocp.weights.new_contact_force);
  EXPECT_EQ(back.friction_A, ocp.friction_A);
  EXPECT_EQ(back.friction_b, ocp.friction_b);
  ASSERT_EQ(back.contacts.size(), ocp.contacts.size());
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    const OcpContact& was = ocp.contacts[i];
    const OcpContact& is = back.contacts[i];
    EXPECT_EQ(is.name, was.name);
    EXPECT_EQ(is.vertices_m, was.vertices_m);
    EXPECT_EQ(is.has_previous_force, was.has_previous_force);
    EXPECT_EQ(is.previous_force_N, was.previous_force_N);
    EXPECT_EQ(is.force_shares, was.force_shares);
    EXPECT_EQ(is.leg.offset_m, was.leg.offset_m);
    EXPECT_EQ(is.leg.length_m, was.leg.length_m);
    ASSERT_EQ(is.phases.size(), was.phases.size());
    for (std::size_t q = 0; q < was.phases.size(); ++q) {
      EXPECT_EQ(is.phases[q].first_knot, was.phases[q].first_knot);
      EXPECT_EQ(is.phases[q].end_knot, was.phases[q].end_knot);
      EXPECT_EQ(is.phases[q].fixed, was.phases[q].fixed);
      EXPECT_EQ(is.phases[q].R_WF, was.phases[q].R_WF);
      if (was.phases[q].fixed) {
        EXPECT_EQ(is.phases[q].p_WF, was.phases[q].p_WF);
      } else {
        EXPECT_EQ(is.phases[q].nominal_p_WF, was.phases[q].nominal_p_WF);
        EXPECT_EQ(is.phases[q].box_lower_m, was.phases[q].box_lower_m);
        EXPECT_EQ(is.phases[q].box_upper_m, was.phases[q].box_upper_m);
      }
    }
  }
}

TEST(OcpJsonTest, ReadingAndWritingAReferenceFileChangesNothingButTheDefault) {
  json expected = ReferenceJson(kExample);
  expected.erase("solution");
  expected["weights"]["new_contact_force"] = {0.01, 0.01, 0.01};
  EXPECT_EQ(ToJson(OcpFromJson(ReferenceJson(kExample))), expected);
}

TEST(OcpJsonTest, AProblemWithoutAFirstStepOfItsOwnDoesNotMentionIt) {
  CentroidalOcp ocp = RandomProblem();
  ocp.first_step_s.reset();
  const json document = ToJson(ocp);
  EXPECT_FALSE(document.contains("first_step_s"));
  EXPECT_FALSE(OcpFromJson(document).first_step_s.has_value());
}

TEST(OcpJsonTest, ALimitOfLoadsIsWrittenOnlyIfItCountsAndReadOnlyWithItsWeight) {
  CentroidalOcp ocp = RandomProblem();
  json document = ToJson(ocp);
  document.erase("foot_load_limit_N");
  document["weights"]["foot_load"] = 2;
  EXPECT_EQ(ErrorOf(document), "$.weights.foot_load: expected 0 without foot_load_limit_N, got 2");
  document["weights"]["foot_load"] = 0;
  EXPECT_EQ(ErrorOf(document), "");
  document["foot_load_limit_N"] = -1;
  EXPECT_EQ(ErrorOf(document), "$.foot_load_limit_N: expected a number of at least 0, got -1");
  ocp.weights.foot_load = 0.0;
  document = ToJson(ocp);
  EXPECT_FALSE(document.contains("foot_load_limit_N"));
  EXPECT_FALSE(document["weights"].contains("foot_load"));
  EXPECT_EQ(OcpFromJson(document).weights.foot_load, 0.0);
}

TEST(OcpJsonTest, AFirstStepIsAboveZeroAndNoLongerThanTheOthers) {
  json document = ToJson(RandomProblem());
  document["first_step_s"] = 0;
  EXPECT_EQ(ErrorOf(document), "$.first_step_s: expected a finite number above zero, got 0");
  document["first_step_s"] = 0.25;
  EXPECT_EQ(ErrorOf(document), "$.first_step_s: expected a step no longer than step_s, got 0.25");
}

TEST(OcpJsonTest, ASolutionBlockIsReadAndWrittenUnchanged) {
  const json document = ReferenceJson(kExample);
  const CentroidalOcp ocp = OcpFromJson(document);
  const MpcSolution solution = SolutionFromJson(ocp, document["solution"]);
  EXPECT_EQ(SolutionToJson(ocp, solution), document["solution"]);
}

TEST(OcpJsonTest, ASolvedProblemSurvivesTheRoundTripBitForBit) {
  const CentroidalOcp ocp = ReferenceProblem(kExample);
  const MpcSolution solution = MakeSolver(MpcBackend::kIpopt, {})->Solve(ocp, nullptr);
  const MpcSolution back = SolutionFromJson(ocp, json::parse(SolutionToJson(ocp, solution).dump()));
  EXPECT_EQ(back.status, SolveStatus::kSolved);
  EXPECT_EQ(back.cost, solution.cost);
  EXPECT_EQ(back.p_WC, solution.p_WC);
  EXPECT_EQ(back.angular_momentum, solution.angular_momentum);
  EXPECT_EQ(back.contacts[1].force_N[7], solution.contacts[1].force_N[7]);
  EXPECT_EQ(back.contacts[1].phase_p_WF[0], solution.contacts[1].phase_p_WF[0]);
}

TEST(OcpJsonTest, AnInfeasibleSolutionIsWrittenAsNulls) {
  const CentroidalOcp ocp = ReferenceProblem("infeasible_inverted_box");
  const MpcSolution solution = MakeSolver(MpcBackend::kIpopt, {})->Solve(ocp, nullptr);
  const json expected = {{"status", "infeasible"},
                         {"cost", nullptr},
                         {"constraint_violation", nullptr},
                         {"kkt_error", nullptr}};
  EXPECT_EQ(SolutionToJson(ocp, solution), expected);
  EXPECT_EQ(SolutionFromJson(ocp, expected).status, SolveStatus::kInfeasible);
}

TEST(OcpJsonTest, ErrorsNameThePlaceAndWhatWasExpected) {
  struct Case {
    const char* pointer;  // What to replace ...
    json value;           // ... by what; discarded means: erase.
    const char* error;
  };
  const json erase = json(json::value_t::discarded);
  const Case cases[] = {
      {"/knots", erase, "$: expected the key \"knots\", which is missing"},
      {"/weights/com", erase, "$.weights: expected the key \"com\", which is missing"},
      {"/extra", 1, "$: unknown key \"extra\""},
      {"/contacts/1/colour", "red", "$.contacts[1]: unknown key \"colour\""},
      {"/knots", 15.0, "$.knots: expected an integer from 1 to 10000, got 15.0"},
      {"/knots", 18446744073709551615U,
       "$.knots: expected an integer from 1 to 10000, got 18446744073709551615"},
      {"/knots", 14,
       "$.reference.com_m: expected an array of 15 rows of 3 numbers, got an array "
       "of 16"},
      {"/step_s", 0, "$.step_s: expected a finite number above zero, got 0"},
      {"/mass_kg", "heavy", "$.mass_kg: expected a finite number above zero, got \"heavy\""},
      {"/name", nullptr, "$.name: expected a string, got null"},
      {"/gravity_m_s2",
       {0, 0},
       "$.gravity_m_s2: expected an array of 3 numbers, got an array of "
       "2"},
      {"/initial", 3, "$.initial: expected an object, got 3"},
      {"/initial/com_m/2", true, "$.initial.com_m[2]: expected a finite number, got true"},
      {"/external_force_N/3/1", nullptr,
       "$.external_force_N[3][1]: expected a finite number, got null"},
      {"/weights/force_rate",
       {0.1, -0.1, 0.1},
       "$.weights.force_rate: expected three numbers >= 0, got an array of 3"},
      {"/friction_b", {0}, "$.friction_b: expected an array of 4 numbers, got an array of 1"},
      {"/contacts", json::object(), "$.contacts: expected an array, got an object"},
      {"/contacts/0/vertices_m", json::array(),
       "$.contacts[0].vertices_m: expected at least one vertex, got an array of 0"},
      {"/contacts/0/force_shares",
       {0.3, 0.3, 0.3, 0.3},
       "$.contacts[0].force_shares: expected shares of a force, at least 0 and 1 in sum, got an "
       "array of 4"},
      {"/contacts/0/previous_force_N/0",
       {1, 2},
       "$.contacts[0].previous_force_N[0]: expected an array of 3 numbers, got an array of 2"},
      {"/contacts/0/phases/0/fixed", 1,
       "$.contacts[0].phases[0].fixed: expected true or false, got 1"},
      {"/contacts/0/phases/1/first_knot", 4,
       "$.contacts[0].phases[1].first_knot: expected an integer from 9 to 999999, got 4"},
      {"/contacts/0/phases/1/end_knot", 15,
       "$.contacts[0].phases[1].end_knot: expected an integer from 16 to 1000000, got 15"},
      {"/contacts/0/phases/0/rotation/0", 2,
       "$.contacts[0].phases[0].rotation: expected an orthonormal, right-handed matrix, got an "
       "array of 9"},
      {"/contacts/0/phases/0/position_m", erase,
       "$.contacts[0].phases[0]: expected the key \"position_m\", which is missing"},
      {"/contacts/0/phases/0/box_upper_m",
       {0, 0, 0},
       "$.contacts[0].phases[0]: unknown key \"box_upper_m\""},
  };
  for (const Case& c : cases) {
    json document = ReferenceJson(kExample);
    const json::json_pointer pointer(c.pointer);
    if (c.value.is_discarded()) {
      document[pointer.parent_pointer()].erase(pointer.back());
    } else {
      document[pointer] = c.value;
    }
    EXPECT_EQ(ErrorOf(document), c.error);
  }
}

TEST(OcpJsonTest, NumbersThatAreNotFiniteAreRefusedEvenInMemory) {
  json document = ReferenceJson(kExample);
  document["mass_kg"] = std::numeric_limits<double>::infinity();
  EXPECT_NE(ErrorOf(document), "");
  document = ReferenceJson(kExample);
  document["initial"]["com_m"][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(ErrorOf(document), "");
}

TEST(OcpJsonTest, OptionalKeysMayBeAbsentAndTheSolutionIsIgnored) {
  json document = ReferenceJson(kExample);
  document["contacts"][0].erase("previous_force_N");
  document["solution"] = "anything";
  document.erase("description");
  const CentroidalOcp ocp = OcpFromJson(document);
  EXPECT_FALSE(ocp.contacts[0].has_previous_force);
  EXPECT_EQ(ocp.weights.new_contact_force, Eigen::Vector3d::Constant(0.01));
  document["weights"]["new_contact_force"] = {1, 2, 3};
  EXPECT_EQ(OcpFromJson(document).weights.new_contact_force, Eigen::Vector3d(1, 2, 3));
}

TEST(OcpJsonTest, AnyValueAnywhereIsEitherReadOrRefusedInOneLine) {
  const json example = ToJson(RandomProblem());
  const json values[] = {nullptr,
                         true,
                         -1,
                         1e308,
                         18446744073709551615U,
                         "text",
                         "\xff\n",
                         json::array(),
                         json::object(),
                         json::array({json::array()})};
  int num_refused = 0;
  const json flat = example.flatten();
  for (const auto& leaf : flat.items()) {
    // The leaf itself, and every node above it.
    for (json::json_pointer at(leaf.key()); !at.empty(); at = at.parent_pointer()) {
      for (const json& value : values) {
        json document = example;
        document[at] = value;
        const std::string error = ErrorOf(document);
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        num_refused += error.empty() ? 0 : 1;
      }
    }
  }
  EXPECT_GT(num_refused, 1000);
  for (const json& value : values) {
    EXPECT_NE(ErrorOf(value), "");
  }
}

TEST(OcpJsonTest, SolutionErrorsNameThePlaceToo) {
  const json document = ReferenceJson(kExample);
  const CentroidalOcp ocp = OcpFromJson(document);
  json block = document["solution"];
  block["status"] = "splendid";
  EXPECT_EQ(ErrorOf(ocp, block),
            "$.status: expected one of not_solved, solved, acceptable, infeasible, "
            "iteration_limit, numerical_error, got \"splendid\"");
  block = document["solution"];
  block.erase("com_m");
  EXPECT_EQ(ErrorOf(ocp, block), "$: expected the key \"com_m\", which is missing");
  block = document["solution"];
  block["contacts"][0]["forces_N"][10][0] = {0, 0, 0};
  EXPECT_EQ(ErrorOf(ocp, block),
            "$.contacts[0].forces_N[10][0]: expected null where the contact is inactive, got an "
            "array of 3");
  block = document["solution"];
  block["contacts"][0]["forces_N"][0] = nullptr;
  EXPECT_EQ(ErrorOf(ocp, block),
            "$.contacts[0].forces_N[0]: expected an array of 4 rows of 3 numbers, got null");
  block = document["solution"];
  block["contacts"][1]["name"] = "tail";
  EXPECT_EQ(ErrorOf(ocp, block),
            "$.contacts[1].name: expected \"" + ocp.contacts[1].name + "\", got \"tail\"");
}

TEST(OcpJsonTest, WritingInconsistentShapesBreaksTheContract) {
  CentroidalOcp ocp = RandomProblem();
  ocp.external_force_N.resize(3, 1);
  EXPECT_THROW(ToJson(ocp), ContractViolation);
  MpcSolution solution;
  solution.status = SolveStatus::kSolved;
  EXPECT_THROW(SolutionToJson(RandomProblem(), solution), ContractViolation);
}

}  // namespace
}  // namespace sidestep::mpc::ocp_json_test

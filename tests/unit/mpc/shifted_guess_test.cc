// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/shifted_guess.h"

#include <gtest/gtest.h>

#include "controller/mpc/problem/solution_shape.h"
#include "models/support/require.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::shifted_guess_test {
namespace {

constexpr int kKnots = 6;
const Eigen::Vector3d kBox(0.1, 0.1, 0.0);

/// A robot of 2 kg with point feet.
CentroidalOcp WithFeet(const std::vector<std::vector<ContactPhase>>& phases_of_feet) {
  CentroidalOcp ocp = FloatingProblem(kKnots);
  ocp.gravity_mps2 << 0, 0, -10;
  for (const auto& phases : phases_of_feet) {
    ocp.contacts.push_back(Foot("foot", 1));
    ocp.contacts.back().phases = phases;
  }
  return ocp;
}

/// A solution in which every number tells its place: force z = 100 contact + knot + 1.
MpcSolution Labelled(const CentroidalOcp& ocp) {
  MpcSolution solution;
  ResetToShape(ocp, &solution);
  for (int k = 0; k <= ocp.knots; ++k) {
    solution.p_WC.col(k) << k, 0, 0;
    solution.linear_momentum.col(k) << 0, k, 0;
    solution.angular_momentum.col(k) << 0, 0, k;
  }
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    for (std::size_t q = 0; q < ocp.contacts[i].phases.size(); ++q) {
      solution.contacts[i].phase_p_WF[q] << static_cast<double>(i), static_cast<double>(q), 7;
    }
    for (int k = 0; k < ocp.knots; ++k) {
      if (ActivePhase(ocp.contacts[i], k) >= 0) {
        solution.contacts[i].force_N[static_cast<std::size_t>(k)](2, 0) =
            100.0 * static_cast<double>(i) + k + 1;
      }
    }
  }
  return solution;
}

std::vector<double> ForcesZ(const MpcSolution& solution, std::size_t contact) {
  std::vector<double> forces;
  for (const Eigen::Matrix3Xd& force_N : solution.contacts[contact].force_N) {
    forces.push_back(force_N(2, 0));
  }
  return forces;
}

MpcSolution Shifted(const CentroidalOcp& previous, int shift, const CentroidalOcp& next) {
  MpcSolution guess;
  ShiftedGuess(previous, Labelled(previous), shift, next, &guess);
  return guess;
}

TEST(ShiftedGuessTest, StatesMoveOnAndTheComCoastsBeyondTheHorizon) {
  const CentroidalOcp previous = WithFeet({});
  CentroidalOcp next = previous;
  next.initial_p_WC << 9, 9, 9;
  const MpcSolution guess = Shifted(previous, 2, next);
  EXPECT_EQ(guess.p_WC.col(0), Eigen::Vector3d(9, 9, 9));
  EXPECT_EQ(guess.linear_momentum.col(0), Eigen::Vector3d::Zero());
  for (int k = 1; k <= 4; ++k) {
    EXPECT_EQ(guess.p_WC.col(k), Eigen::Vector3d(k + 2, 0, 0));
    EXPECT_EQ(guess.linear_momentum.col(k), Eigen::Vector3d(0, k + 2, 0));
    EXPECT_EQ(guess.angular_momentum.col(k), Eigen::Vector3d(0, 0, k + 2));
  }
  // 6 kg m/s and 2 kg are 3 m/s: 0.3 m a knot.
  EXPECT_TRUE(guess.p_WC.col(5).isApprox(Eigen::Vector3d(6, 0.3, 0)));
  EXPECT_TRUE(guess.p_WC.col(6).isApprox(Eigen::Vector3d(6, 0.6, 0)));
  EXPECT_EQ(guess.linear_momentum.col(6), Eigen::Vector3d(0, 6, 0));
}

TEST(ShiftedGuessTest, ShiftOfZeroRepeatsTheSolution) {
  const CentroidalOcp ocp = WithFeet({{FixedPhase(0, 2, Eigen::Vector3d::Zero()),
                                       FreePhase(3, 9, Eigen::Vector3d::Zero(), kBox)}});
  const MpcSolution guess = Shifted(ocp, 0, ocp);
  EXPECT_EQ(ForcesZ(guess, 0), (std::vector<double>{1, 2, 0, 4, 5, 6}));
  EXPECT_EQ(guess.contacts[0].phase_p_WF[1], Eigen::Vector3d(0, 1, 7));
  EXPECT_EQ(guess.p_WC.col(6), Eigen::Vector3d(6, 0, 0));
}

TEST(ShiftedGuessTest, WithinAKnotTheShiftIsZeroAndOnlyTheStateNowIsAnother) {
  const CentroidalOcp previous = WithFeet({{FixedPhase(0, 99, Eigen::Vector3d::Zero())}});
  CentroidalOcp next = previous;
  next.first_step_s = 0.3 * previous.step_s;
  next.initial_p_WC << 0.7, 0, 0;
  const MpcSolution guess = Shifted(previous, 0, next);
  EXPECT_EQ(guess.p_WC.col(0), Eigen::Vector3d(0.7, 0, 0));
  for (int k = 1; k <= kKnots; ++k) EXPECT_EQ(guess.p_WC.col(k), Eigen::Vector3d(k, 0, 0)) << k;
  EXPECT_EQ(ForcesZ(guess, 0), (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST(ShiftedGuessTest, ForcesMoveOnAndTheLastOneStays) {
  const CentroidalOcp ocp = WithFeet({{FixedPhase(0, 99, Eigen::Vector3d::Zero())}});
  EXPECT_EQ(ForcesZ(Shifted(ocp, 2, ocp), 0), (std::vector<double>{3, 4, 5, 6, 6, 6}));
}

TEST(ShiftedGuessTest, APhaseThatEndedIsDroppedAndTheNextTakesItsIndex) {
  const CentroidalOcp previous = WithFeet({{FixedPhase(0, 1, Eigen::Vector3d::Zero()),
                                            FreePhase(2, 5, Eigen::Vector3d::Zero(), kBox)}});
  const CentroidalOcp next = WithFeet({{FreePhase(1, 4, Eigen::Vector3d::Zero(), kBox)}});
  const MpcSolution guess = Shifted(previous, 1, next);
  EXPECT_EQ(guess.contacts[0].phase_p_WF[0], Eigen::Vector3d(0, 1, 7));
  EXPECT_EQ(ForcesZ(guess, 0), (std::vector<double>{0, 3, 4, 5, 0, 0}));
}

TEST(ShiftedGuessTest, AFootThatHasLandedStandsWhereItIsGivenWithItsPlannedForces) {
  const CentroidalOcp previous = WithFeet({{FreePhase(1, 5, Eigen::Vector3d::Zero(), kBox)}});
  const CentroidalOcp next = WithFeet({{FixedPhase(0, 4, Eigen::Vector3d(0.5, 0.5, 0.5))}});
  const MpcSolution guess = Shifted(previous, 1, next);
  EXPECT_EQ(guess.contacts[0].phase_p_WF[0], Eigen::Vector3d(0.5, 0.5, 0.5));
  EXPECT_EQ(ForcesZ(guess, 0), (std::vector<double>{2, 3, 4, 5, 0, 0}));
}

TEST(ShiftedGuessTest, APhaseExtendedAtItsStartHoldsItsFirstForce) {
  const CentroidalOcp previous = WithFeet({{FreePhase(3, 9, Eigen::Vector3d::Zero(), kBox)}});
  const CentroidalOcp next = WithFeet({{FreePhase(1, 8, Eigen::Vector3d::Zero(), kBox)}});
  EXPECT_EQ(ForcesZ(Shifted(previous, 1, next), 0), (std::vector<double>{0, 4, 4, 5, 6, 6}));
}

TEST(ShiftedGuessTest, ANewPhaseStartsAtItsNominalPlaceWithItsShareOfTheWeight) {
  // 2 kg at 10 m/s^2 on two feet is 10 N each; alone it is 20 N.
  const CentroidalOcp previous = WithFeet({{FixedPhase(0, 5, Eigen::Vector3d::Zero())}, {}});
  const CentroidalOcp next = WithFeet({{FixedPhase(0, 5, Eigen::Vector3d::Zero())},
                                       {FreePhase(4, 9, Eigen::Vector3d(0.3, 0.2, 0.1), kBox)}});
  const MpcSolution guess = Shifted(previous, 0, next);
  EXPECT_EQ(guess.contacts[1].phase_p_WF[0], Eigen::Vector3d(0.3, 0.2, 0.1));
  EXPECT_EQ(ForcesZ(guess, 1), (std::vector<double>{0, 0, 0, 0, 10, 20}));
}

TEST(ShiftedGuessTest, ForcesOfAFootSeenForTwoKnotsOrLessRestartButItsPlaceDoesNot) {
  for (const int landing : {6, 5, 4}) {
    const CentroidalOcp previous =
        WithFeet({{FreePhase(landing, 9, Eigen::Vector3d::Zero(), kBox)}});
    const CentroidalOcp next =
        WithFeet({{FreePhase(landing - 1, 8, Eigen::Vector3d::Zero(), kBox)}});
    const MpcSolution guess = Shifted(previous, 1, next);
    EXPECT_EQ(guess.contacts[0].phase_p_WF[0], Eigen::Vector3d(0, 0, 7)) << landing;
    EXPECT_EQ(ForcesZ(guess, 0)[static_cast<std::size_t>(landing) - 1], 20.0) << landing;
    EXPECT_EQ(ForcesZ(guess, 0)[5], 20.0) << landing;
  }
  const CentroidalOcp previous = WithFeet({{FreePhase(3, 9, Eigen::Vector3d::Zero(), kBox)}});
  const CentroidalOcp next = WithFeet({{FreePhase(2, 8, Eigen::Vector3d::Zero(), kBox)}});
  EXPECT_EQ(ForcesZ(Shifted(previous, 1, next), 0), (std::vector<double>{0, 0, 4, 5, 6, 6}));
}

TEST(ShiftedGuessTest, AStanceAboutToEndKeepsItsForces) {
  const CentroidalOcp previous = WithFeet({{FixedPhase(0, 2, Eigen::Vector3d::Zero())}});
  const CentroidalOcp next = WithFeet({{FixedPhase(0, 1, Eigen::Vector3d::Zero())}});
  EXPECT_EQ(ForcesZ(Shifted(previous, 1, next), 0), (std::vector<double>{2, 0, 0, 0, 0, 0}));
}

TEST(ShiftedGuessTest, AShiftBeyondTheWholeHorizonStartsAnew) {
  const CentroidalOcp previous = WithFeet({{FixedPhase(0, 7, Eigen::Vector3d::Zero())}});
  const CentroidalOcp next = WithFeet({{FixedPhase(0, 9, Eigen::Vector3d::Zero())}});
  const MpcSolution guess = Shifted(previous, 50, next);
  EXPECT_EQ(ForcesZ(guess, 0), (std::vector<double>(6, 20.0)));
  EXPECT_TRUE(guess.p_WC.allFinite());
}

TEST(ShiftedGuessTest, AnotherHorizonLengthIsAllowedAndOtherFeetAreNot) {
  const CentroidalOcp previous = WithFeet({{FixedPhase(0, 99, Eigen::Vector3d::Zero())}});
  CentroidalOcp next = FloatingProblem(8);
  next.contacts = previous.contacts;
  const MpcSolution guess = Shifted(previous, 1, next);
  EXPECT_EQ(ForcesZ(guess, 0), (std::vector<double>{2, 3, 4, 5, 6, 6, 6, 6}));
  EXPECT_TRUE(HasShape(next, guess));
  next.contacts[0] = Foot("foot", 4);
  MpcSolution unused;
  EXPECT_THROW(ShiftedGuess(previous, Labelled(previous), 1, next, &unused), ContractViolation);
  EXPECT_THROW(ShiftedGuess(previous, Labelled(previous), -1, previous, &unused),
               ContractViolation);
  EXPECT_THROW(ShiftedGuess(previous, MpcSolution(), 1, previous, &unused), ContractViolation);
}

}  // namespace
}  // namespace sidestep::mpc::shifted_guess_test

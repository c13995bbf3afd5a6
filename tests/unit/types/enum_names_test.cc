// SPDX-License-Identifier: BSD-3-Clause
// EnumNames of every enum that files spell, and what a solver's status says.
#include <gtest/gtest.h>

#include <set>
#include <string_view>

#include "controller/types/control_params.h"
#include "controller/types/solver_status.h"

namespace sidestep::enum_names_test {
namespace {

template <typename Enum>
class EnumNamesTest : public testing::Test {};

using Enums = testing::Types<SolveStatus, QpStatus, ControlMode, ExternalWrenchKnowledge,
                             EstimatorKind, GaitType, FollowMode, MpcBackend>;
TYPED_TEST_SUITE(EnumNamesTest, Enums);

TYPED_TEST(EnumNamesTest, EveryValueHasOneNameOfItsOwn) {
  std::set<int> values;
  std::set<std::string_view> names;
  for (const auto& [value, name] : EnumNames<TypeParam>::kNames) {
    EXPECT_TRUE(values.insert(static_cast<int>(value)).second) << name;
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(EnumName(value), name);
  }
  EXPECT_EQ(*values.begin(), 0);
  EXPECT_EQ(*values.rbegin(), static_cast<int>(values.size()) - 1) << "a value has no name";
}

TYPED_TEST(EnumNamesTest, NamesAreWordsOfLowerCaseAndAValueOutsideHasNone) {
  for (const auto& [value, name] : EnumNames<TypeParam>::kNames) {
    EXPECT_FALSE(name.empty());
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), name.npos) << name;
  }
  EXPECT_EQ(EnumName(static_cast<TypeParam>(EnumNames<TypeParam>::kNames.size())), "?");
}

// Told apart by what a reader must do with them. Without a default: the compiler asks for a value
// that is new.
bool CarriesATrajectory(SolveStatus status) {
  switch (status) {
    case SolveStatus::kSolved:
    case SolveStatus::kAcceptable:
      return true;
    case SolveStatus::kNotSolved:
    case SolveStatus::kInfeasible:
    case SolveStatus::kIterationLimit:
    case SolveStatus::kNumericalError:
      return false;
  }
  return false;
}

TEST(SolveStatusTest, OnlyAnOptimumOrAPointNearItIsUsable) {
  for (const auto& [status, name] : EnumNames<SolveStatus>::kNames) {
    EXPECT_EQ(IsUsable(status), CarriesATrajectory(status)) << name;
  }
}

TEST(SolveStatusTest, ThatWhichIsMadeAndNeverFilledInIsNotUsable) {
  EXPECT_EQ(SolveStatus{}, SolveStatus::kNotSolved);
  EXPECT_FALSE(IsUsable(SolveStatus{}));
  EXPECT_EQ(QpStatus{}, QpStatus::kNotSolved);
}

TEST(SolveStatusTest, BothSolversSpellWhatTheyShareAlike) {
  EXPECT_EQ(EnumName(SolveStatus::kSolved), EnumName(QpStatus::kSolved));
  EXPECT_EQ(EnumName(SolveStatus::kInfeasible), EnumName(QpStatus::kInfeasible));
  EXPECT_EQ(EnumName(SolveStatus::kIterationLimit), EnumName(QpStatus::kIterationLimit));
  EXPECT_EQ(EnumName(SolveStatus::kNumericalError), EnumName(QpStatus::kNumericalError));
  EXPECT_EQ(EnumName(SolveStatus::kNotSolved), EnumName(QpStatus::kNotSolved));
}

}  // namespace
}  // namespace sidestep::enum_names_test

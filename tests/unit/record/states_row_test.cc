// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/states_row.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

namespace sidestep::states_row_test {
namespace {

constexpr int kNq = 3;
constexpr std::size_t kRow = 1 + kNq + 6 + 2 * 12;  // doubles of a row of two feet

std::vector<double> DoublesOf(const std::string& bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

// Every number its own: the tens tell the quantity.
WorldTruth TwoFeetTruth() {
  WorldTruth truth;
  truth.qpos = Eigen::Vector3d(11.0, 12.0, 13.0);
  truth.feet.resize(2);
  truth.feet[0].f_F_W = {41.0, 42.0, 43.0};
  truth.feet[0].p_WF = {51.0, 52.0, 53.0};
  truth.feet[1].f_F_W = {61.0, 62.0, 63.0};
  truth.feet[1].p_WF = {71.0, 72.0, 73.0};
  return truth;
}

std::string RowOf(double time_s, const WorldTruth& truth, const ControlTick& control) {
  std::string bytes;
  AppendStatesRow(time_s, truth, control, bytes);
  return bytes;
}

TEST(StatesRowTest, TheHeaderTellsTheSizeThatTheRowHas) {
  const std::string header = StatesHeader({"left", "right"}, kNq, 0.002);
  const std::string first = "sidestep-states 1\n";
  ASSERT_EQ(header.substr(0, first.size()), first);
  EXPECT_EQ(header.find('\n', first.size()), header.size() - 1) << "two lines, the second whole";
  const nlohmann::json said = nlohmann::json::parse(header.substr(first.size()));
  EXPECT_EQ(said["nq"], kNq);
  EXPECT_EQ(said["feet"], nlohmann::json({"left", "right"}));
  EXPECT_EQ(said["dt_s"], 0.002);
  EXPECT_EQ(said["row_doubles"], kRow);
  EXPECT_EQ(RowOf(0.0, TwoFeetTruth(), {}).size(), 8 * kRow);
}

TEST(StatesRowTest, ARowIsTimeStatePushAndEachFootsForcePlaceNominalAndAdjusted) {
  WorldTruth truth = TwoFeetTruth();
  truth.pushes = {{{21.0, 22.0, 23.0}, {31.0, 32.0, 33.0}}};
  ControlTick control;
  control.feet.resize(2);
  control.feet[0].contact.nominal_p_WF = {81.0, 82.0, 83.0};
  control.feet[0].contact.adjusted_p_WF = {84.0, 85.0, 86.0};
  control.feet[1].contact.nominal_p_WF = {91.0, 92.0, 93.0};
  control.feet[1].contact.adjusted_p_WF = {94.0, 95.0, 96.0};
  const std::vector<double> expected{1.5, 11, 12, 13, 21, 22, 23, 31, 32, 33, 41, 42,
                                     43,  51, 52, 53, 81, 82, 83, 84, 85, 86, 61, 62,
                                     63,  71, 72, 73, 91, 92, 93, 94, 95, 96};
  EXPECT_EQ(DoublesOf(RowOf(1.5, truth, control)), expected);
}

TEST(StatesRowTest, DoublesAreLittleEndian) {
  WorldTruth truth;
  truth.qpos.resize(0);
  // 1.5 is 0x3FF8000000000000.
  EXPECT_EQ(RowOf(1.5, truth, {}).substr(0, 8), std::string("\0\0\0\0\0\0\xF8\x3F", 8));
}

TEST(StatesRowTest, RowsAreAppendedToWhatIsThere) {
  const std::string row = RowOf(1.0, TwoFeetTruth(), {});
  std::string bytes = "head\n";
  AppendStatesRow(1.0, TwoFeetTruth(), {}, bytes);
  AppendStatesRow(1.0, TwoFeetTruth(), {}, bytes);
  EXPECT_EQ(bytes, "head\n" + row + row);
}

// Force and point of the push in the row.
std::vector<double> PushIn(const WorldTruth& truth) {
  const std::vector<double> row = DoublesOf(RowOf(0.0, truth, {}));
  return {row.begin() + 1 + kNq, row.begin() + 1 + kNq + 6};
}

TEST(StatesRowTest, OfSeveralPushesTheStrongestIsShownByItsLengthAndNotBySign) {
  WorldTruth truth = TwoFeetTruth();
  EXPECT_EQ(PushIn(truth), std::vector<double>(6, 0.0)) << "none at all";
  truth.pushes = {{{6.0, 0.0, 0.0}, {1.0, 1.0, 1.0}},
                  {{-5.0, 0.0, -5.0}, {2.0, 2.0, 2.0}},  // 7.07 N
                  {{0.0, 7.0, 0.0}, {3.0, 3.0, 3.0}}};
  EXPECT_EQ(PushIn(truth), (std::vector<double>{-5, 0, -5, 2, 2, 2}));
  for (PushTruth& push : truth.pushes) push.force_W_N.setZero();
  EXPECT_EQ(PushIn(truth), std::vector<double>(6, 0.0)) << "pushes that rest have no point";
}

TEST(StatesRowTest, WithoutAPlanAFootsNominalAndAdjustedPlaceAreItsOwn) {
  ControlTick control;
  control.feet.resize(1);  // a plan for the first foot alone
  control.feet[0].contact.nominal_p_WF = {81.0, 82.0, 83.0};
  control.feet[0].contact.adjusted_p_WF = {84.0, 85.0, 86.0};
  const std::vector<double> row = DoublesOf(RowOf(0.0, TwoFeetTruth(), control));
  const auto foot = row.begin() + 1 + kNq + 6;
  EXPECT_EQ(std::vector<double>(foot + 6, foot + 12),
            (std::vector<double>{81, 82, 83, 84, 85, 86}));
  EXPECT_EQ(std::vector<double>(foot + 18, foot + 24),
            (std::vector<double>{71, 72, 73, 71, 72, 73}));
}

}  // namespace
}  // namespace sidestep::states_row_test

// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/clone_ptr.h"

#include <gtest/gtest.h>

#include <utility>

namespace sidestep::clone_ptr_test {
namespace {

// A part behind an interface that knows how often it was cloned and how many of it there are.
struct Part {
  explicit Part(int number) : value(number) { ++alive; }
  Part(const Part& other) : value(other.value), generation(other.generation + 1) { ++alive; }
  Part& operator=(const Part&) = delete;
  virtual ~Part() { --alive; }
  virtual std::unique_ptr<Part> Clone() const = 0;

  int value;
  int generation{0};
  static inline int alive = 0;
};

struct Wheel final : Part {
  using Part::Part;
  std::unique_ptr<Part> Clone() const override { return std::make_unique<Wheel>(*this); }
};

using Owner = ClonePtr<Part>;

Owner WheelOf(int value) { return std::unique_ptr<Part>(std::make_unique<Wheel>(value)); }

// Every case must leave nothing behind.
class ClonePtrTest : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(Part::alive, 0); }
  void TearDown() override { EXPECT_EQ(Part::alive, 0); }
};

TEST_F(ClonePtrTest, ACopyOwnsACloneOfTheSameKindAndNeitherSeesTheOthersChanges) {
  Owner original = WheelOf(3);
  const Owner copy = original;  // NOLINT(performance-unnecessary-copy-initialization)
  EXPECT_EQ(Part::alive, 2);
  EXPECT_NE(copy.get(), original.get());
  EXPECT_NE(dynamic_cast<Wheel*>(copy.get()), nullptr) << "not cut down to its interface";
  EXPECT_EQ(copy->generation, 1);
  original->value = 8;
  EXPECT_EQ(copy->value, 3);
  copy->value = 5;
  EXPECT_EQ((*original).value, 8);
}

TEST_F(ClonePtrTest, ACopyOutlivesItsOriginal) {
  auto original = std::make_unique<Owner>(WheelOf(4));
  const Owner copy = *original;
  original.reset();
  EXPECT_EQ(copy->value, 4);
}

TEST_F(ClonePtrTest, AMoveTakesThePartItselfAndLeavesNothing) {
  Owner original = WheelOf(3);
  const Part* part = original.get();
  Owner moved = std::move(original);
  EXPECT_EQ(moved.get(), part);
  EXPECT_EQ(moved->generation, 0) << "never cloned";
  EXPECT_EQ(original.get(), nullptr);  // NOLINT(bugprone-use-after-move): what it promises
}

TEST_F(ClonePtrTest, AnEmptyOneIsCopiedAndAssignedAsEmpty) {
  Owner empty = WheelOf(1);
  const Owner taken = std::move(empty);
  const Owner copy = empty;  // NOLINT(bugprone-use-after-move)
  EXPECT_EQ(copy.get(), nullptr);
  Owner assigned = WheelOf(2);
  assigned = empty;
  EXPECT_EQ(assigned.get(), nullptr);
  EXPECT_EQ(Part::alive, 1) << "the wheel that was there is gone";
}

TEST_F(ClonePtrTest, AssignmentClonesAndLetsTheOldPartGo) {
  const Owner one = WheelOf(1);
  Owner other = WheelOf(2);
  other = one;
  EXPECT_EQ(Part::alive, 2);
  EXPECT_EQ(other->value, 1);
  EXPECT_NE(other.get(), one.get());
}

TEST_F(ClonePtrTest, MoveAssignmentTakesThePartAndLetsTheOldOneGo) {
  Owner one = WheelOf(1);
  Owner other = WheelOf(2);
  other = std::move(one);
  EXPECT_EQ(Part::alive, 1);
  EXPECT_EQ(other->value, 1);
  EXPECT_EQ(other->generation, 0);
}

TEST_F(ClonePtrTest, AssignedToItselfItKeepsItsVeryPart) {
  Owner owner = WheelOf(7);
  const Part* part = owner.get();
  const Owner& itself = owner;
  owner = itself;
  EXPECT_EQ(owner.get(), part);
  EXPECT_EQ(owner->generation, 0);
}

}  // namespace
}  // namespace sidestep::clone_ptr_test

// SPDX-License-Identifier: BSD-3-Clause
// Whatever is read, in whatever order, belongs to the last state; a copy is a robot of its own.
#include <gtest/gtest.h>

#include <functional>

#include "controller/model/rigid_body.h"
#include "models/support/require.h"
#include "tests/support/icub3.h"

namespace sidestep::rigid_body_order_test {
namespace {

using Numbers = Eigen::MatrixXd;

/// Each quantity of a RigidBody, by name.
struct Quantity {
  const char* name;
  std::function<Numbers(const RigidBody&)> read;
};

const std::vector<Quantity>& Quantities() {
  static const std::vector<Quantity> kQuantities{
      {"velocity", [](const RigidBody& body) { return Numbers(body.velocity()); }},
      {"foot", [](const RigidBody& body) { return Numbers(body.feet()[1].R_WF); }},
      {"imu", [](const RigidBody& body) { return Numbers(body.imu().v_WU); }},
      {"torso", [](const RigidBody& body) { return Numbers(body.torso().w_WT); }},
      {"mass matrix", [](const RigidBody& body) { return Numbers(body.mass_matrix()); }},
      {"base inertia", [](const RigidBody& body) { return Numbers(body.base_inertia()); }},
      {"bias", [](const RigidBody& body) { return Numbers(body.bias()); }},
      {"CoM Jacobian", [](const RigidBody& body) { return Numbers(body.com_jacobian()); }},
      {"CoM bias", [](const RigidBody& body) { return Numbers(body.com_bias_mps2()); }},
      {"foot Jacobian", [](const RigidBody& body) { return Numbers(body.foot_jacobian(0).J); }},
      {"foot turn", [](const RigidBody& body) { return Numbers(body.foot_jacobian(1).J_rot); }},
      {"foot bias", [](const RigidBody& body) { return Numbers(body.foot_bias(0).linear_mps2); }},
      {"torso Jacobian", [](const RigidBody& body) { return Numbers(body.torso_jacobian()); }},
      {"torso bias", [](const RigidBody& body) { return Numbers(body.torso_bias_radps2()); }},
      {"momentum Jacobian",
       [](const RigidBody& body) { return Numbers(body.angular_momentum_jacobian()); }},
      {"momentum bias",
       [](const RigidBody& body) { return Numbers(body.angular_momentum_bias_Nm()); }},
  };
  return kQuantities;
}

/// A state and what bodies read there, each quantity by a body that has never been at another state
/// and reads nothing else.
struct Known {
  Known(const RigidBody& fresh, const RobotState& at) : state(at) {
    for (const Quantity& quantity : Quantities()) {
      RigidBody body(fresh);
      body.Update(state);
      alone.push_back(quantity.read(body));
    }
  }
  RobotState state;
  std::vector<Numbers> alone;
};

class RigidBodyOrderTest : public testing::Test {
 protected:
  static void ExpectAll(const RigidBody& body, const Known& known, const char* why) {
    for (std::size_t i = 0; i < Quantities().size(); ++i) {
      EXPECT_EQ(Quantities()[i].read(body), known.alone[i]) << Quantities()[i].name << ", " << why;
    }
  }

  // A robot is dear to compile and to copy: nothing here is changed, nor fresh_ read.
  static const RigidBody& Fresh() {
    static const RigidBody kFresh(Icub3());
    return kFresh;
  }
  static const Known& First() {
    static const Known kFirst(Fresh(), MovingIcub(Fresh(), 0));
    return kFirst;
  }
  static const Known& Second() {
    static const Known kSecond(Fresh(), MovingIcub(Fresh(), 1));
    return kSecond;
  }

  const RigidBody& fresh_{Fresh()};
  const Known &first_{First()}, &second_{Second()};
};

TEST_F(RigidBodyOrderTest, EachQuantityBelongsToTheLastStateWhicheverWereReadBefore) {
  for (const Quantity& read_before : Quantities()) {
    RigidBody body(fresh_);
    body.Update(first_.state);
    read_before.read(body);
    body.Update(second_.state);
    ExpectAll(body, second_, read_before.name);
  }
  for (std::size_t i = 0; i < Quantities().size(); ++i) {
    EXPECT_NE(first_.alone[i], second_.alone[i])
        << Quantities()[i].name << ": states that agree prove nothing";
  }
}

TEST_F(RigidBodyOrderTest, ForcePredictionsBetweenTheReadsChangeNothing) {
  const Eigen::VectorXd nudot = Eigen::VectorXd::Constant(fresh_.num_velocities(), 50.0);
  RigidBody body(fresh_);
  body.Update(first_.state);
  body.PredictForceTorque(nudot);
  ExpectAll(body, first_, "before");
  body.PredictForceTorque(nudot);
  ExpectAll(body, first_, "after");
}

TEST_F(RigidBodyOrderTest, TranslatedItReadsTheSameWhetherReadBeforeOrAfter) {
  const Eigen::Vector3d p(0.3, -2.0, 0.1), v(0.5, 0.1, -0.2);
  RigidBody before(fresh_), after(fresh_);
  before.Update(first_.state);
  after.Update(first_.state);
  ExpectAll(before, first_, "all is read");
  before.Translate(p, v);
  after.Translate(p, v);
  for (const Quantity& quantity : Quantities()) {
    EXPECT_EQ(quantity.read(before), quantity.read(after)) << quantity.name;
  }
}

TEST_F(RigidBodyOrderTest, ItBeginsAtHomeAtRest) {
  RobotState home;
  fresh_.WriteHome(&home);
  ExpectAll(RigidBody(Icub3()), Known(fresh_, home), "as compiled");
}

TEST_F(RigidBodyOrderTest, AfterLocatingTheImuThereIsNoStateToReadUntilTheNextUpdate) {
  RigidBody body(fresh_);
  body.Update(first_.state);
  ExpectAll(body, first_, "all is read");
  body.LocateImu(second_.state);
  for (const Quantity& quantity : Quantities()) {
    EXPECT_THROW(quantity.read(body), ContractViolation) << quantity.name;
  }
  RobotState state = first_.state;
  EXPECT_THROW(body.FillDerived(&state), ContractViolation);
  EXPECT_THROW(body.Translate(first_.state.p_WB, first_.state.v_WB), ContractViolation);
  EXPECT_THROW(body.PredictForceTorque(body.torque_limit_Nm()), ContractViolation);
  body.Update(first_.state);
  ExpectAll(body, first_, "again");
}

TEST_F(RigidBodyOrderTest, CopyInMidUseGoesOnByItself) {
  for (std::size_t read = 0; read < Quantities().size(); ++read) {
    RigidBody original(fresh_);
    original.Update(first_.state);
    Quantities()[read].read(original);
    RigidBody copy(original), assigned(fresh_);
    assigned = original;
    original.Update(second_.state);
    ExpectAll(copy, first_, "the original has moved on");
    ExpectAll(assigned, first_, "the original has moved on");
    ExpectAll(original, second_, "the copies are where it was");
    copy.Update(second_.state);
    original.Update(first_.state);
    ExpectAll(copy, second_, "the copy has moved on");
    ExpectAll(original, first_, "back again");
  }
}

TEST_F(RigidBodyOrderTest, CopyOutlivesItsOriginal) {
  auto original = std::make_unique<RigidBody>(fresh_);
  original->Update(first_.state);
  RigidBody copy(*original);
  original.reset();
  ExpectAll(copy, first_, "of a robot that is gone");
  EXPECT_EQ(copy.PredictForceTorque(Eigen::VectorXd::Zero(copy.num_velocities())).size(), 6U);
}

}  // namespace
}  // namespace sidestep::rigid_body_order_test

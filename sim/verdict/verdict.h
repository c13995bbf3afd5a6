// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// verdict: what a run showed, as plain data. sim/verdict/judge.h makes it, sim/record writes it.

#include <Eigen/Core>
#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "controller/types/contact_plan.h"
#include "controller/types/field.h"
#include "sim/scenario/scenario.h"
#include "sim/world/world.h"

namespace sidestep {

/// INVALID is not FAIL: it says nothing of the controller.
enum class VerdictClass { kPass, kFail, kInvalid };

template <>
struct EnumNames<VerdictClass> {
  static constexpr std::array<std::pair<VerdictClass, std::string_view>, 3> kNames{
      {{VerdictClass::kPass, "PASS"},
       {VerdictClass::kFail, "FAIL"},
       {VerdictClass::kInvalid, "INVALID"}}};
};

/// What Reason::kind may be. The first four make a FAIL, the others an INVALID.
namespace reason {
inline constexpr char kFall[] = "FALL";
inline constexpr char kSlip[] = "SLIP";
inline constexpr char kSolver[] = "SOLVER";
inline constexpr char kExpectation[] = "EXPECTATION";
inline constexpr char kDiverged[] = "DIVERGED";
inline constexpr char kInterrupted[] = "INTERRUPTED";
inline constexpr char kError[] = "ERROR";
}  // namespace reason

/// Why a run is no PASS.
struct Reason {
  std::string kind;  ///< One of namespace reason.
  std::string text;  ///< One line for a human.
  std::optional<double> time_s;
};

/// A metric's value. A number that could not be measured is NaN; one that never came, such as a
/// recovery, is infinite. Files spell both as null.
using MetricValue = std::variant<double, bool>;

/// By name, as sim/verdict/metrics.h lists them.
using Metrics = std::map<std::string, MetricValue>;

/// An expectation beside what was measured. NaN meets no bound.
struct ExpectationResult {
  Expectation expectation;
  std::optional<MetricValue> measured;  ///< Empty if there is no such metric.
  bool pass{false};
};

struct Verdict {
  VerdictClass verdict_class{VerdictClass::kPass};
  std::vector<Reason> reasons;                  ///< Empty if and only if PASS.
  std::vector<ExpectationResult> expectations;  ///< In the scenario's order.
};

/// One planned contact that began in the run, beside what the truth made of it.
struct FootstepRecord {
  int foot{0};
  PlannedContact contact;  ///< As planned on the control tick that began it.
  /// Truth at the first tick with plan and truth both in contact; empty if it never landed.
  std::optional<Eigen::Vector3d> realised_p_WF;
  double slip_m{0.0};  ///< Farthest slide while it lasted; see SlipMeter.
};

/// One push as the world applied it.
struct PushRecord {
  Push push;
  Eigen::Vector3d impulse_W_Ns{Eigen::Vector3d::Zero()};  ///< Integral of the force.
};

/// What a joint's motor was put to.
struct JointRecord {
  JointInfo joint;
  double peak_torque_Nm{0.0};  ///< Largest |torque|; N for a slide.
};

/// Everything that a run is judged by.
struct RunOutcome {
  Verdict verdict;
  Metrics metrics;
  std::vector<FootstepRecord> footsteps;  ///< In order of start.
  std::vector<PushRecord> pushes;         ///< In the scenario's order.
  std::vector<JointRecord> joints;        ///< In the order of the actuators.
  double mass_kg{0.0};                    ///< Of the plant.
};

}  // namespace sidestep

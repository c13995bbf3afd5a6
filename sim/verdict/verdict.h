// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// verdict: what a run showed, as plain data. sim/verdict/judge.h makes it, sim/record writes it.

#include <Eigen/Core>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "controller/types/contact_plan.h"
#include "controller/types/field.h"
#include "controller/types/gait_params.h"
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

/// What the program tells the shell of a run, and `check` of all of them: the greatest.
constexpr int ExitCodeOf(VerdictClass verdict) {
  switch (verdict) {
    case VerdictClass::kPass:
      return 0;
    case VerdictClass::kFail:
      return 1;
    case VerdictClass::kInvalid:
      break;
  }
  return 3;
}

/// What Reason::kind may be. The first four make a FAIL, the others an INVALID.
namespace reason {
inline constexpr char kFall[] = "FALL";  ///< At the first sign.
inline constexpr char kSlip[] = "SLIP";
inline constexpr char kSolver[] = "SOLVER";  ///< Solvers failed too often.
inline constexpr char kExpectation[] = "EXPECTATION";
inline constexpr char kDiverged[] = "DIVERGED";        ///< Non-finite state, or a MuJoCo warning.
inline constexpr char kInterrupted[] = "INTERRUPTED";  ///< By the user.
inline constexpr char kError[] = "ERROR";
}  // namespace reason

/// Why a run is no PASS.
struct Reason {
  std::string kind;              ///< One of namespace reason.
  std::string text;              ///< One line for a human.
  std::optional<double> time_s;  ///< When it came to be, if at one instant.
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

/// The decision and what it rests on. INVALID excludes all other reasons: they would be about a run
/// that did not happen.
struct Verdict {
  VerdictClass verdict_class{VerdictClass::kPass};
  std::vector<Reason> reasons;                  ///< Empty if and only if PASS.
  std::vector<ExpectationResult> expectations;  ///< In the scenario's order.
};

/// One contact of a foot: the scenario's, what the controller planned for it and what the truth
/// made of it; sim/verdict/footsteps.h tells how they are paired.
struct FootstepRecord {
  int foot{0};
  /// Of the scenario's gait, but for the place, box and yaw that the controller planned for it when
  /// it began. Index -1: a step that the gait does not have.
  PlannedContact contact;
  bool is_planned{false};  ///< False: it told no plan; the place is the gait's, there is no box.
  std::optional<Eigen::Vector3d> realised_p_WF;  ///< Where the foot came down; empty if it didn't.
  double slip_m{0.0};  ///< Farthest slide until the foot stepped again; see SlipMeter.
};

/// What followed a push, in its window: from its start to the next push's, or to the end of the
/// run. Pushes at most 1 s apart share one; sim/verdict/push_meter.h defines it all.
struct PushFigures {
  bool recovered{false};
  double recovery_time_s{std::numeric_limits<double>::infinity()};  ///< From its end; else never.
  double peak_tilt_rad{std::numeric_limits<double>::quiet_NaN()};   ///< From the start's attitude.
  int steps_taken{0};                                               ///< Touch-downs of a step.
  double max_step_adjustment_m{0.0};                                ///< Of those, in truth.
  double drift_m{std::numeric_limits<double>::quiet_NaN()};         ///< Off the path, at its end.
};

/// One push as the world applied it, and what it did to the robot.
struct PushRecord {
  Push push;
  Eigen::Vector3d impulse_W_Ns{Eigen::Vector3d::Zero()};  ///< Integral of the force.
  PushFigures figures{};
};

/// What a gait came to over its whole strides; sim/verdict/gait_meter.h defines it all. NaN without
/// a whole stride.
struct GaitFigures {
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  int strides{0};  ///< Whole ones.
  double from_s{kNaN};
  double to_s{kNaN};
  double speed_mps{kNaN};          ///< Of the CoM, horizontally, from there to there.
  double step_length_m{kNaN};      ///< Advance of the feet from one step to the next.
  double step_frequency_hz{kNaN};  ///< Steps of all feet, a second.
  double duty_factor{kNaN};        ///< Share of the time of a foot in stance; their mean.
  double flight_fraction{kNaN};    ///< Share of the time with no foot in stance.
  /// Positive mechanical work of the joints over weight times advance of the CoM; NaN without
  /// motors or on the spot.
  double cost_of_transport{kNaN};
  double max_ground_force_ratio{kNaN};  ///< Largest vertical force on one foot over the weight.
};

/// A gait that the scenario asks for, and what the robot made of it.
struct GaitRecord {
  GaitParams gait;
  GaitFigures figures{};
};

/// What a joint's motor was put to.
struct JointRecord {
  JointInfo joint;
  double peak_torque_Nm{0.0};    ///< Largest |torque|; N for a slide.
  double peak_speed_radps{0.0};  ///< Largest |velocity|; m/s for a slide.
  /// Of a hinge, by the robot's description; infinite if that tells none.
  double speed_limit_radps{std::numeric_limits<double>::infinity()};
};

/// Everything that a run is judged by.
struct RunOutcome {
  Verdict verdict;
  Metrics metrics;
  std::vector<FootstepRecord> footsteps;  ///< In order of start.
  std::vector<PushRecord> pushes;         ///< In the scenario's order.
  std::vector<GaitRecord> gaits;          ///< Likewise.
  std::vector<JointRecord> joints;        ///< In the order of the actuators.
  double mass_kg{0.0};                    ///< Of the plant.
};

}  // namespace sidestep

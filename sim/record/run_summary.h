// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_summary: what a run amounts to, as plain data, and its file summary.json.
//
// Each struct lists its fields once, in the file's order and with the file's keys, in a static
// VisitFields(self, visit); the writer and the reader both walk that list, so that they can't
// disagree. A field to add is one member and one line of that list.
//
// A number that is not finite is null in the file and NaN when read back. Which kind it was is
// told by what stands beside it, never by the number: a joint without `limit` has none, a metric of
// something that never came (`recovery_time_s`) has its truth value or its pushes to say so.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/record/log_detail.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

/// Marks a field that files of older programs lack: if absent, it keeps its default.
struct AddedLater {};
inline constexpr AddedLater kAddedLater{};

/// A number that the file does not tell.
inline constexpr double kNotTold = std::numeric_limits<double>::quiet_NaN();

/// Why a run is no PASS.
struct ReasonSummary {
  std::string kind;              ///< One of namespace reason.
  std::string text;              ///< One line for a human.
  std::optional<double> time_s;  ///< When, if at one instant.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("class", self.kind);
    visit("text", self.text);
    visit("time_s", self.time_s);
  }
};

/// What the scenario asked of a metric, beside what was measured.
struct ExpectationSummary {
  std::string metric;
  std::optional<double> min;
  std::optional<double> max;
  std::optional<bool> is;
  MetricValue measured{kNotTold};  ///< In the metric's unit.
  bool pass{false};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("metric", self.metric);
    visit("min", self.min);
    visit("max", self.max);
    visit("is", self.is);
    visit("measured", self.measured);
    visit("pass", self.pass);
  }
};

/// One push as the world applied it, and what it did to the robot; see PushFigures.
struct PushSummary {
  std::string body;
  double start_s{kNotTold};  ///< As scripted.
  double duration_s{kNotTold};
  double force_N{kNotTold};        ///< Norm of the scripted force; a half sine's peak.
  double direction_rad{kNotTold};  ///< Its angle about z in the axes it is told in; NaN if upright.
  double phase{kNotTold};          ///< Share of the first foot's stride; NaN where it has none.
  double impulse_Ns{kNotTold};     ///< Norm of the integral of the force.
  double impulse_per_mass_mps{kNotTold};  ///< That over the plant's mass.
  std::string outcome;                    ///< RECOVERED, NOT_RECOVERED, FALL or NOT_BEGUN.
  bool recovered{false};                  ///< See PushMeter for it and the figures below.
  double recovery_time_s{kNotTold};       ///< From its end; infinite if it never came.
  double peak_tilt_rad{kNotTold};
  int steps_taken{0};
  double max_step_adjustment_m{kNotTold};
  double drift_m{kNotTold};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("body", self.body);
    visit("start_s", self.start_s);
    visit("duration_s", self.duration_s);
    visit("force_N", self.force_N, kAddedLater);
    visit("direction_rad", self.direction_rad, kAddedLater);
    visit("phase", self.phase, kAddedLater);
    visit("impulse_Ns", self.impulse_Ns);
    visit("impulse_per_mass_mps", self.impulse_per_mass_mps);
    visit("outcome", self.outcome, kAddedLater);
    visit("recovered", self.recovered, kAddedLater);
    visit("recovery_time_s", self.recovery_time_s, kAddedLater);
    visit("peak_tilt_rad", self.peak_tilt_rad, kAddedLater);
    visit("steps_taken", self.steps_taken, kAddedLater);
    visit("max_step_adjustment_m", self.max_step_adjustment_m, kAddedLater);
    visit("drift_m", self.drift_m, kAddedLater);
  }
};

/// A gait that the scenario asks for, and what came of it over its whole strides; see GaitFigures.
/// A gait without whole strides has no figures.
struct GaitSummary {
  GaitType type{GaitType::kStand};
  double start_s{kNotTold};  ///< As asked.
  GaitFigures figures;

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("type", self.type);
    visit("start_s", self.start_s);
    visit("strides", self.figures.strides);
    visit("from_s", self.figures.from_s);
    visit("to_s", self.figures.to_s);
    visit("speed_mps", self.figures.speed_mps);
    visit("step_length_m", self.figures.step_length_m);
    visit("step_frequency_hz", self.figures.step_frequency_hz);
    visit("duty_factor", self.figures.duty_factor);
    visit("flight_fraction", self.figures.flight_fraction);
    visit("cost_of_transport", self.figures.cost_of_transport);
    visit("max_ground_force_ratio", self.figures.max_ground_force_ratio);
  }
};

/// What a joint's motor was put to. In the file the name is the key, and the keys tell the unit.
struct JointSummary {
  std::string name;
  bool is_slide{false};
  double peak_Nm{kNotTold};                   ///< Largest |torque|; N for a slide.
  std::optional<double> limit_Nm;             ///< N for a slide; empty if the motor has no limit.
  double peak_speed_radps{kNotTold};          ///< Largest |velocity|; m/s for a slide.
  std::optional<double> speed_limit_radps{};  ///< Of a hinge; empty if the robot tells none.

  static constexpr char kSlideKey[] = "peak_force_N";  ///< A joint that has it is a slide.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit(self.is_slide ? kSlideKey : "peak_torque_Nm", self.peak_Nm);
    visit(self.is_slide ? "limit_N" : "limit_Nm", self.limit_Nm);
    visit(self.is_slide ? "peak_speed_mps" : "peak_speed_radps", self.peak_speed_radps,
          kAddedLater);
    if (!self.is_slide) visit("speed_limit_radps", self.speed_limit_radps, kAddedLater);
  }
};

/// Figures of a stage's runs by one clock (ms). NaN without a run.
struct StageTimes {
  double mean_ms{kNotTold};
  double p50_ms{kNotTold};
  double p99_ms{kNotTold};
  double max_ms{kNotTold};
  double deadline_ms{kNotTold};  ///< The stage's period.
  int misses{0};                 ///< Runs that took longer than the deadline.
  int count{0};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("mean", self.mean_ms, kAddedLater);
    visit("p50", self.p50_ms);
    visit("p99", self.p99_ms);
    visit("max", self.max_ms);
    visit("deadline", self.deadline_ms);
    visit("misses", self.misses);
    visit("count", self.count);
  }
};

/// All of summary.json.
struct RunSummary {
  std::string program_version;  ///< Of the program that ran it.
  std::string name;             ///< The scenario's.
  VerdictClass verdict{VerdictClass::kInvalid};
  std::vector<ReasonSummary> reasons;            ///< Empty if and only if PASS.
  std::vector<ExpectationSummary> expectations;  ///< In the scenario's order.
  Metrics metrics;                               ///< By name, as sim/verdict/metrics.h lists them.
  std::vector<PushSummary> pushes;               ///< In the scenario's order.
  std::vector<GaitSummary> gaits;                ///< Likewise.
  std::vector<JointSummary> joints;              ///< In the order of the actuators.
  StageTimes solve_time;                         ///< One run a solve of the MPC; on the wall.
  StageTimes solve_cpu;                          ///< Of the processor.
  StageTimes whole_body_time;                    ///< One run a tick of the whole-body control.
  StageTimes whole_body_cpu;                     ///< Of the processor.
  std::vector<std::pair<std::string, std::string>> versions;  ///< {program or library, version}.
  std::uint64_t seed{0};
  std::vector<std::string> command;    ///< The program's arguments.
  std::vector<std::string> overrides;  ///< The command line's `--set a.b=c` and `--push TEXT`.
  std::string scenario_hash;           ///< HashText() of the resolved scenario.
  std::string model_hash;  ///< Of the MJCF that MuJoCo compiled; empty of the centroidal plant.
  LogDetail log{LogDetail::kFull};  ///< What it kept of its ticks; older programs kept all.
  double simulated_s{kNotTold};
  double wall_s{kNotTold};
  double cpu_s{kNotTold};                 ///< Of the processor.
  double real_time_factor{kNotTold};      ///< Simulated over wall time.
  double cpu_real_time_factor{kNotTold};  ///< Simulated over processor time.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("sidestep", self.program_version);
    visit("name", self.name);
    visit("verdict", self.verdict);
    visit("reasons", self.reasons);
    visit("expectations", self.expectations);
    visit("metrics", self.metrics);
    visit("pushes", self.pushes);
    visit("gaits", self.gaits, kAddedLater);
    visit("joints", self.joints, kAddedLater);
    visit("solve_time_ms", self.solve_time);
    visit("solve_cpu_ms", self.solve_cpu, kAddedLater);
    visit("whole_body_time_ms", self.whole_body_time, kAddedLater);
    visit("whole_body_cpu_ms", self.whole_body_cpu, kAddedLater);
    visit("versions", self.versions);
    visit("seed", self.seed);
    visit("command", self.command);
    visit("overrides", self.overrides, kAddedLater);
    visit("scenario_hash", self.scenario_hash, kAddedLater);
    visit("model_hash", self.model_hash, kAddedLater);
    visit("log", self.log, kAddedLater);
    visit("simulated_s", self.simulated_s);
    visit("wall_s", self.wall_s);
    visit("cpu_s", self.cpu_s, kAddedLater);
    visit("real_time_factor", self.real_time_factor);
    visit("cpu_real_time_factor", self.cpu_real_time_factor, kAddedLater);
  }
};

/// The text of summary.json: JSON, indented, with a final newline. Bytes that are no UTF-8 (of a
/// command line) are replaced by U+FFFD.
std::string SummaryJson(const RunSummary& summary);

/// Reads the text of a summary.json. Keys that this program does not know are passed over.
///
/// @param file  Its name, for the errors.
/// @throws ConfigError of one line that names the file and the place (line and column where the
///         JSON breaks; else the key, as in `pushes[1].start_s`) if `text` is not JSON, is nested
///         deeper than a summary is, or lacks a field or has it with another type.
RunSummary ParseSummary(const std::string& text, const std::filesystem::path& file);

/// Reads `run_dir/summary.json`. @throws ConfigError if it can't be read, and as ParseSummary.
RunSummary ReadSummary(const std::filesystem::path& run_dir);

}  // namespace sidestep

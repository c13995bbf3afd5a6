// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/synthetic_run.h"

#include <unistd.h>

#include <Eigen/Core>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <vector>

#include "sim/record/run_summary.h"
#include "tests/support/toy_motion.h"
#include "tests/support/toy_robot.h"

namespace sidestep::testing {
namespace {

constexpr double kMpcPeriod_s = 0.05;

// One CSV row: names in the first pass, numbers in the others, so that they can't drift apart.
class Row {
 public:
  void Add(const std::string& name, double value) {
    names_ += (names_.empty() ? "" : ",") + name;
    values_ << (values_.tellp() > 0 ? "," : "") << value;
  }
  void AddVector(const std::string& stem, const std::string& unit, const Eigen::Vector3d& v) {
    for (int i = 0; i < 3; ++i) Add(stem + "_" + "xyz"[i] + "_" + unit, v[i]);
  }
  const std::string& names() const { return names_; }
  std::string values() const { return values_.str(); }

 private:
  std::string names_;
  std::ostringstream values_;
};

void AddFoot(const FootNow& foot, Row* row) {
  const std::string& name = foot.name;
  row->AddVector("truth_p_WF_" + name, "m", foot.p_WF);
  row->AddVector("truth_f_F_W_" + name, "N", foot.f_F_W);
  row->AddVector("truth_m_F_W_" + name, "Nm", Eigen::Vector3d(0.3, -0.5, 0.0));
  row->AddVector("swing_p_WF_" + name, "m", foot.p_WF);
  row->Add("truth_contact_" + name, foot.is_down ? 1 : 0);
  row->Add("planned_contact_" + name, foot.is_down ? 1 : 0);
  row->AddVector("mpc_f_F_W_" + name, "N", 0.95 * foot.f_F_W);
  row->AddVector("nominal_p_WF_" + name, "m", foot.nominal_p_WF);
  row->AddVector("adjusted_p_WF_" + name, "m", foot.adjusted_p_WF);
}

Row TrajectoryRow(double time_s, const Moment& moment) {
  Row row;
  const Eigen::Vector3d reference(0.1 * time_s, 0.01 * std::sin(2.0 * std::numbers::pi * time_s),
                                  0.6);
  row.Add("time_s", time_s);
  row.AddVector("truth_p_WC", "m", moment.p_WC);
  row.AddVector("truth_v_WC", "mps", moment.v_WC);
  row.AddVector("truth_h_C_W", "kgm2ps", {2.0 * moment.tilt_rad, 0.1 * std::sin(time_s), 0.02});
  row.AddVector("truth_p_WB", "m", moment.p_WC);
  row.Add("truth_q_WB_w", std::cos(0.5 * moment.tilt_rad));
  row.Add("truth_q_WB_x", std::sin(-0.5 * moment.tilt_rad));
  row.Add("truth_q_WB_y", 0.0);
  row.Add("truth_q_WB_z", 0.0);
  row.Add("truth_tilt_rad", moment.tilt_rad);
  for (const FootNow& foot : FeetAt(moment)) AddFoot(foot, &row);
  row.AddVector("push_force_W", "N", moment.push_N);
  row.AddVector("push_torque_C_W", "Nm", 0.1 * moment.push_N);
  row.AddVector("belief_push_force_W", "N", 0.8 * moment.push_N);
  row.AddVector("belief_push_torque_C_W", "Nm", 0.08 * moment.push_N);
  row.AddVector("belief_p_WC", "m", moment.p_WC + Eigen::Vector3d(0.001, -0.001, 0.0));
  row.AddVector("belief_v_WC", "mps", moment.v_WC);
  row.AddVector("belief_h_C_W", "kgm2ps", Eigen::Vector3d::Zero());
  row.AddVector("reference_p_WC", "m", reference);
  row.AddVector("reference_v_WC", "mps",
                {0.1, 0.02 * std::numbers::pi * std::cos(2.0 * std::numbers::pi * time_s), 0.0});
  row.AddVector("mpc_p_WC", "m", 0.5 * (reference + moment.p_WC));
  row.AddVector("mpc_v_WC", "mps", moment.v_WC);
  row.Add("wall_mpc_ms", 4.0);
  return row;
}

void WriteStates(const std::filesystem::path& dir, const SyntheticRun& run, long rows) {
  std::ofstream states(dir / "states.bin", std::ios::binary);
  const int row_doubles = 1 + 13 + 6 + 2 * 12;
  const nlohmann::json header{
      {"nq", 13}, {"feet", {"left", "right"}}, {"row_doubles", row_doubles}, {"dt_s", run.dt_s}};
  states << "sidestep-states 1\n" << header.dump() << "\n";
  std::ofstream trajectory(dir / "trajectory.csv");
  trajectory.precision(17);
  for (long i = 0; i < rows; ++i) {
    const double time_s = static_cast<double>(i) * run.dt_s;
    const Moment moment = MomentAt(run, time_s);
    std::vector<double> numbers{time_s};
    const auto append = [&](const auto& v) { numbers.insert(numbers.end(), v.begin(), v.end()); };
    append(QposAt(moment));
    append(moment.push_N);
    append(Eigen::Vector3d(moment.p_WC + Eigen::Vector3d(0.0, -0.11, 0.1)));
    for (const FootNow& foot : FeetAt(moment)) {
      append(foot.f_F_W);
      append(foot.p_WF);
      append(foot.nominal_p_WF);
      append(foot.adjusted_p_WF);
    }
    states.write(reinterpret_cast<const char*>(numbers.data()),
                 static_cast<std::streamsize>(numbers.size() * sizeof(double)));
    const Row row = TrajectoryRow(time_s, moment);
    if (i == 0) trajectory << row.names() << "\n";
    trajectory << row.values() << "\n";
  }
}

void WriteFootsteps(const std::filesystem::path& dir, const SyntheticRun& run) {
  const double lift_s = run.push_start_s + run.push_duration_s;
  std::ofstream out(dir / "footsteps.csv");
  out << "foot,index,start_s,end_s,nominal_x_m,nominal_y_m,nominal_z_m,adjusted_x_m,adjusted_y_m,"
         "adjusted_z_m,realised_x_m,realised_y_m,realised_z_m,slip_m,box_lower_x_m,box_lower_y_m,"
         "box_upper_x_m,box_upper_y_m,yaw_rad\n"
      << "left,0,0," << run.duration_s << ",0,0.08,0,0,0.08,0,0,0.08,0,0.001,0,0,0,0,0\n"
      << "right,0,0," << lift_s << ",0,-0.08,0,0,-0.08,0,0,-0.08,0,0.001,0,0,0,0,0\n";
  if (lift_s + kToySwing_s < run.duration_s) {
    out << "right,1," << lift_s + kToySwing_s << "," << run.duration_s
        << ",0.1,-0.08,0,0.12,-0.03,0,0.118,-0.032,0,0.002,-0.05,-0.03,0.05,0.07,0.3\n";
  }
}

void WriteMpc(const std::filesystem::path& dir, const SyntheticRun& run) {
  std::ofstream out(dir / "mpc.csv");
  out << "time_s,status,iterations,cost,constraint_violation,kkt_error,wall_ms\n";
  int count = 0;
  for (double t = 0.0; t < run.duration_s; t += kMpcPeriod_s, ++count) {
    out << t << ",solved," << 6 + count % 4 << ",12.5,1e-9,1e-8," << 4.0 + 0.7 * (count % 5)
        << "\n";
  }
}

RunSummary SummaryOf(const SyntheticRun& run) {
  const bool is_fail = run.verdict == VerdictClass::kFail;
  const double impulse_Ns = run.push_force_N * run.push_duration_s;
  RunSummary summary;
  summary.program_version = "0.1.0";
  summary.name = run.name;
  summary.verdict = run.verdict;
  if (is_fail) summary.reasons = {{"FALL", "base tilted beyond 1 rad", 0.8 * run.duration_s}};
  summary.expectations = {{"fall", {}, {}, false, is_fail, !is_fail},
                          {"mean_step_adjustment_m", 0.01, 0.1, {}, 0.0539, true}};
  summary.metrics = {{"fall", is_fail}, {"mean_step_adjustment_m", 0.0539}, {"max_tilt_rad", 0.08}};
  summary.pushes.resize(1);
  PushSummary& push = summary.pushes.front();
  push.body = "trunk";
  push.start_s = run.push_start_s;
  push.duration_s = run.push_duration_s;
  push.force_N = run.push_force_N;
  push.direction_rad = 0.5 * std::numbers::pi;
  push.phase = 0.35;
  push.outcome = is_fail ? "FALL" : "RECOVERED";
  push.impulse_Ns = impulse_Ns;
  push.impulse_per_mass_mps = impulse_Ns / kToyMass_kg;
  summary.solve_time = {5.4, 5.4, 6.8, 6.8, 50.0, 0, 10};
  summary.solve_cpu = {2.7, 2.7, 3.4, 3.4, 50.0, 0, 10};
  summary.versions = {{"mujoco", "2.2.2"}, {"eigen", "3.4.0"}};
  summary.seed = 1;
  summary.command = {"sidestep", "run", "my toy.yaml", "--set", "pushes.0={a: b}"};
  summary.overrides = {"--set pushes.0={a: b}"};
  summary.scenario_hash = "0123456789abcdef";
  summary.model_hash = "fedcba9876543210";
  summary.simulated_s = run.duration_s;
  summary.wall_s = 0.8;
  summary.real_time_factor = 0.6;
  return summary;
}

}  // namespace

void WriteSyntheticRun(const std::filesystem::path& dir, const SyntheticRun& run) {
  WriteToyRobot(dir);
  const long rows = std::lround(run.duration_s / run.dt_s);
  WriteStates(dir, run, rows);
  WriteFootsteps(dir, run);
  WriteMpc(dir, run);
  std::ofstream(dir / "summary.json") << SummaryJson(SummaryOf(run));
  std::ofstream(dir / "scenario.yaml")
      << "sidestep: 1\ncontrol: {mode: passive}\nname: " << run.name
      << "\ndescription: A toy is pushed to the left.\n"
      << "robot: " << (dir / "robot.yaml").string() << "\nduration_s: " << run.duration_s
      << "\npushes:\n  - {body: trunk, force_N: [0, " << run.push_force_N
      << ", 0], start_s: " << run.push_start_s << ", duration_s: " << run.push_duration_s
      << "}\nvideo: {size: [160, 120], fps: 20}\n";
}

void GiveItSoles(const std::filesystem::path& dir) {
  std::ofstream(dir / "scenario.yaml")
      << "sidestep: 1\ncontrol: {mode: passive}\nrobot: biped\nname: shod\nduration_s: 1\n";
}

namespace {

// A folder of this process alone, since ctest runs cases side by side; gone when the process ends.
struct ProcessFolder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("sidestep_tests_" + std::to_string(::getpid()));
  ~ProcessFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace

std::filesystem::path FreshTestDir(const std::string& name) {
  static const ProcessFolder folder;
  std::filesystem::path dir = folder.path / name;
  std::filesystem::remove_all(dir);
  std::filesystem::create_directories(dir);
  return dir;
}

}  // namespace sidestep::testing

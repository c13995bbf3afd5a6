// SPDX-License-Identifier: BSD-3-Clause
#include "sim/apps/commands/print_robot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "models/robot_description/robot_figures.h"
#include "sim/scenario/world_params.h"

namespace sidestep {
namespace {

constexpr double kMillisecond_s = 1e-3;

/// To the tenth of a millimetre, without a sign of zero.
double Readable(double length_m) { return std::round(1e4 * length_m) / 1e4 + 0.0; }

void PrintServos(const RobotFigures& figures) {
  const double step_s = WorldParams{}.step_s;
  std::printf(
      "  servos  at physics steps dt of %.3g ms: k/(mgh) should be %.3g or more, d*dt/I must be "
      "below 1, and\n          shake = (2 d dt + k dt^2) / I below 4\n",
      step_s / kMillisecond_s, kStiffEnough);
  std::size_t width = 5;
  for (const ServoFigures& servo : figures.servos) width = std::max(width, servo.joint.size());
  const int w = static_cast<int>(width);
  std::printf("    %-*s  %9s  %8s  %8s  %9s  %7s  %5s\n", w, "joint", "stiffness", "k/(mgh)",
              "damping", "armature", "d*dt/I", "shake");
  for (const ServoFigures& servo : figures.servos) {
    char carries[16] = "-";
    if (servo.carries_Nm_per_rad > 0.0) {
      std::snprintf(carries, sizeof carries, "%.2f",
                    servo.stiffness_Nm_per_rad / servo.carries_Nm_per_rad);
    }
    const double damping = servo.damping_share(step_s);
    const double shake = 2.0 * damping + servo.stiffness_share(step_s);
    std::printf("    %-*s  %9.5g  %8s  %8.4g  %9.4g  %7.3f  %5.2f%s\n", w, servo.joint.c_str(),
                servo.stiffness_Nm_per_rad, carries, servo.damping_Nms_per_rad, servo.armature_kgm2,
                damping, shake,
                servo.is_stable(step_s) ? (servo.is_weak() ? "  too weak" : "") : "  unstable");
  }
}

}  // namespace

void PrintRobotFigures(const RobotDescription& robot) {
  if (!robot.model) return;
  const RobotFigures figures = FiguresOf(robot);
  std::printf("  mass    %.5g kg\n", figures.mass_kg);
  std::printf(
      "  CoM     %.4f m above the floor at the start; omega = sqrt(g / h) = %.3f 1/s, h = "
      "%.4g m\n",
      figures.com_height_m, figures.omega_per_s, robot.com_height_m);
  for (const SoleFigures& sole : figures.soles) {
    std::printf("  sole    %s: %.3f x %.3f m, at x = %.4f, y = %.4f, z = %.4f m; leg of %.3f m\n",
                sole.foot.c_str(), sole.length_m, sole.width_m, Readable(sole.p_WF.x()),
                Readable(sole.p_WF.y()), Readable(sole.p_WF.z()), sole.leg_length_m);
  }
  if (!figures.servos.empty()) PrintServos(figures);
  for (const std::string& warning : ServoWarnings(robot)) {
    std::fprintf(stderr, "%s: warning: %s\n", robot.file.c_str(), warning.c_str());
  }
}

}  // namespace sidestep

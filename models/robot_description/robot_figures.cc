// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_figures.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "models/mjcf/leg_root.h"
#include "models/mjcf/mj_state.h"
#include "models/mjcf/mjcf.h"
#include "models/mjcf/stretched_leg.h"
#include "models/robot_description/fault_parts.h"
#include "models/robot_description/home_pose.h"

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;

constexpr double kLevelAxis = 0.7;     // |z| of an axis below which it bears the robot's weight
constexpr double kCarriedShare = 0.5;  // of m g h: a hip, level with the CoM, carries little

MjState AtHome(const RobotDescription& robot) {
  const RobotModel& model = RequireModel(robot);
  MjState state(CompileMjcf(model.simulated_mjcf, "", model.file));
  PlaceAtHome(state.model(), robot, state.get());
  mj_comPos(&state.model(), state.get());
  mj_crb(&state.model(), state.get());
  return state;
}

/// Diagonal of the inverse of the mass matrix (nv).
Eigen::VectorXd Mobilities(const MjState& state) {
  const int nv = state.model().nv;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> M(nv, nv);
  mj_fullM(&state.model(), M.data(), state->qM);
  return M.llt().solve(Eigen::MatrixXd::Identity(nv, nv)).diagonal();
}

/// Whether the weight of what is above the joint would turn it.
bool Carries(const MjState& state, int joint, double mass_kg, double height_m) {
  const mjModel& model = state.model();
  const int body = model.jnt_bodyid[joint];
  const double below_kg = model.body_subtreemass[body];
  const ConstVector3Map axis_W(state->xaxis + 3 * joint);
  if (std::abs(axis_W.z()) > kLevelAxis || below_kg >= mass_kg) return false;
  const Eigen::Vector3d com = ConstVector3Map(state->subtree_com);  // of the world: all there is
  const Eigen::Vector3d below = ConstVector3Map(state->subtree_com + 3 * body);
  const double above_kg = mass_kg - below_kg;
  const double above_z = (mass_kg * com.z() - below_kg * below.z()) / above_kg;
  const double arm_m = above_z - state->xanchor[3 * joint + 2];
  return above_kg * arm_m > kCarriedShare * mass_kg * height_m;
}

void AddServos(const RobotDescription& robot, const MjState& state, RobotFigures* figures) {
  const mjModel& model = state.model();
  const Eigen::VectorXd mobility = Mobilities(state);
  std::vector<int> sites;
  for (const FootDescription& foot : robot.feet) {
    sites.push_back(RequireId(model, mjOBJ_SITE, foot.frame));
  }
  const int root = RootOfLegs(model, sites, RequireId(model, mjOBJ_BODY, robot.base));
  const double g_mps2 = -model.opt.gravity[2];
  for (const JointDescription& description : robot.joints) {
    const int joint = RequireId(model, mjOBJ_JOINT, description.name);
    const int dof = model.jnt_dofadr[joint];
    const int body = model.jnt_bodyid[joint];
    ServoFigures servo{description.name, description.servo_stiffness_Nm_per_rad,
                       description.servo_damping_Nms_per_rad, model.dof_armature[dof],
                       1.0 / mobility[dof]};
    const bool is_legs = body != root && IsAtOrBelow(model, body, root) &&
                         std::any_of(sites.begin(), sites.end(), [&](int site) {
                           return IsAtOrBelow(model, model.site_bodyid[site], body);
                         });
    if (is_legs && Carries(state, joint, figures->mass_kg, robot.com_height_m)) {
      servo.carries_Nm_per_rad = figures->mass_kg * g_mps2 * robot.com_height_m;
    }
    figures->servos.push_back(std::move(servo));
  }
}

void AddSoles(const RobotDescription& robot, const MjState& state, RobotFigures* figures) {
  const mjModel& model = state.model();
  std::vector<int> sites;
  for (const FootDescription& foot : robot.feet) {
    sites.push_back(RequireId(model, mjOBJ_SITE, foot.frame));
  }
  const int root = RootOfLegs(model, sites, RequireId(model, mjOBJ_BODY, robot.base));
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const Eigen::Matrix3Xd& vertices_m = robot.feet[i].vertices_m;
    const Eigen::Vector3d extent =
        vertices_m.rowwise().maxCoeff() - vertices_m.rowwise().minCoeff();
    SoleFigures sole{robot.feet[i].name, extent.x(), extent.y(),
                     ConstVector3Map(state->site_xpos + 3 * sites[i])};
    const auto leg = FindStretchedLeg(state, root, sites[i], vertices_m.cols() > 1);
    if (leg) sole.leg_length_m = leg->length_m;
    figures->soles.push_back(std::move(sole));
  }
}

}  // namespace

RobotFigures FiguresOf(const RobotDescription& robot) {
  const MjState state = AtHome(robot);
  RobotFigures figures;
  figures.mass_kg = mj_getTotalmass(&state.model());
  figures.com_height_m = state->subtree_com[2];
  figures.omega_per_s = std::sqrt(-state.model().opt.gravity[2] / robot.com_height_m);
  AddSoles(robot, state, &figures);
  AddServos(robot, state, &figures);
  return figures;
}

std::vector<std::string> ServoWarnings(const RobotDescription& robot) {
  std::vector<std::string> warnings;
  const RobotFigures figures = FiguresOf(robot);
  const ServoFigures* weakest = nullptr;
  std::size_t num_weak = 0, num_bare = 0;
  for (const ServoFigures& servo : figures.servos) {
    if (servo.armature_kgm2 == 0.0) ++num_bare;
    if (!servo.is_weak()) continue;
    ++num_weak;
    if (weakest == nullptr || servo.stiffness_Nm_per_rad < weakest->stiffness_Nm_per_rad) {
      weakest = &servo;
    }
  }
  if (weakest != nullptr) {
    const bool is_too_weak = weakest->stiffness_Nm_per_rad < weakest->carries_Nm_per_rad;
    warnings.push_back("servo_stiffness_Nm_per_rad of '" + weakest->joint +
                       "' = " + FigureText(weakest->stiffness_Nm_per_rad) +
                       (is_too_weak ? " can't carry " : " hardly carries ") +
                       FigureText(figures.mass_kg) + " kg at " + FigureText(robot.com_height_m) +
                       " m: m g h = " + FigureText(weakest->carries_Nm_per_rad) +
                       " Nm/rad, and legs need three times that or more (" +
                       std::to_string(num_weak) + " of their joints have less)");
  }
  if (num_bare > 0) {
    warnings.push_back(std::to_string(num_bare) + " of " + std::to_string(figures.servos.size()) +
                       " joints have no armature_kgm2, the rotor's inertia times the gear ratio "
                       "squared: servos are stable only as far as the links' inertia goes");
  }
  return warnings;
}

}  // namespace sidestep

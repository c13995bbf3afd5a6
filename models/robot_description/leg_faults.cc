// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/QR>
#include <cmath>

#include "models/mjcf/leg_root.h"
#include "models/mjcf/mj_state.h"
#include "models/mjcf/mjcf.h"
#include "models/robot_description/fault_parts.h"

namespace sidestep {
namespace {

constexpr int kSoleCoordinates = 6;
constexpr double kRankThreshold = 1e-6;  // of the largest pivot: far above rounding
constexpr double kAway = 0.3;            // rad or m from home, where no axes meet by chance

/// Velocities of the joints between `root` and the site.
std::vector<int> VelocitiesBetween(const mjModel& model, int root, int site) {
  std::vector<int> velocities;
  for (int body = model.site_bodyid[site]; body != root && body != 0;
       body = model.body_parentid[body]) {
    for (int i = 0; i < model.body_dofnum[body]; ++i) {
      velocities.push_back(model.body_dofadr[body] + i);
    }
  }
  return velocities;
}

/// In how many ways the sole moves against the root of its leg.
Eigen::Index WaysToMove(const MjState& state, int site, const std::vector<int>& velocities) {
  const mjModel& model = state.model();
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> J(3, model.nv), J_rot(3, model.nv);
  mj_jacSite(&model, state.get(), J.data(), J_rot.data(), site);
  Eigen::MatrixXd of_leg(kSoleCoordinates, static_cast<Eigen::Index>(velocities.size()));
  for (Eigen::Index i = 0; i < of_leg.cols(); ++i) {
    const int at = velocities[static_cast<std::size_t>(i)];
    of_leg.col(i) << J.col(at), J_rot.col(at);
  }
  if (of_leg.cols() == 0) return 0;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(of_leg);
  qr.setThreshold(kRankThreshold);
  return qr.rank();
}

/// The robot with each joint away from home, by another angle than the others.
MjState AwayFromHome(const RobotAtHome& at_home) {
  MjState state(CompileMjcf(at_home.robot.model->simulated_mjcf, "", at_home.robot.model->file));
  const mjModel& model = state.model();
  mju_copy(state->qpos, at_home.data.qpos, model.nq);
  for (int joint = 0; joint < model.njnt; ++joint) {
    if (model.jnt_type[joint] != mjJNT_HINGE && model.jnt_type[joint] != mjJNT_SLIDE) continue;
    state->qpos[model.jnt_qposadr[joint]] += kAway * std::sin(1.0 + 2.0 * joint);
  }
  mj_kinematics(&model, state.get());
  mj_comPos(&model, state.get());
  return state;
}

}  // namespace

void AddLegFaults(const RobotAtHome& at_home, std::vector<RobotFault>* faults) {
  const RobotDescription& robot = at_home.robot;
  if (robot.base_freedom == BaseFreedom::kSagittal) return;  // three coordinates, and it is checked
  const MjState state = AwayFromHome(at_home);
  const mjModel& model = state.model();
  std::vector<int> sites;
  for (const FootDescription& foot : robot.feet) {
    sites.push_back(RequireId(model, mjOBJ_SITE, foot.frame));
  }
  const int root = RootOfLegs(model, sites, RequireId(model, mjOBJ_BODY, robot.base));
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (!IsFlat(robot.feet[i])) continue;
    const std::vector<int> velocities = VelocitiesBetween(model, root, sites[i]);
    const Eigen::Index ways = WaysToMove(state, sites[i], velocities);
    if (ways >= kSoleCoordinates) continue;
    const char* name = mj_id2name(&model, mjOBJ_BODY, root);
    faults->push_back(
        {FootKey(i, "frame"),
         "= '" + robot.feet[i].frame + "' is at the end of a leg with " +
             std::to_string(velocities.size()) + " joints, counted from '" +
             (name != nullptr ? name : "") + "', that moves it in " + std::to_string(ways) +
             " ways: a flat sole has six coordinates to be held, so that a leg needs six joints"});
  }
}

}  // namespace sidestep

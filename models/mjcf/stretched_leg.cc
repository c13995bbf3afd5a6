// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/stretched_leg.h"

#include <algorithm>
#include <numbers>
#include <vector>

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;

constexpr int kSamples = 64;  // a range of pi: the knee to 0.05 rad, the length to its 3e-4 th part
constexpr int kRounds = 2;    // the second sees what the first made of the other joints

// From the foot up.
std::vector<int> JointsBetween(const mjModel& model, int base, int site) {
  std::vector<int> joints;
  for (int body = model.site_bodyid[site]; body != base && body != 0;
       body = model.body_parentid[body]) {
    for (int i = model.body_jntnum[body] - 1; i >= 0; --i) {
      joints.push_back(model.body_jntadr[body] + i);
    }
  }
  return joints;
}

Eigen::Vector3d AnkleOf(const MjState& state, const std::vector<int>& joints, int site,
                        bool is_sole) {
  return is_sole ? ConstVector3Map(state->xanchor + 3 * joints.front())
                 : ConstVector3Map(state->site_xpos + 3 * site);
}

double LengthOf(const MjState& state, const std::vector<int>& joints, int site, bool is_sole) {
  return (AnkleOf(state, joints, site, is_sole) -
          ConstVector3Map(state->xanchor + 3 * joints.back()))
      .norm();
}

// Leaves the joint where the leg is longest; returns that length.
double Stretch(const std::vector<int>& joints, int joint, int site, bool is_sole, MjState* state) {
  const mjModel& model = state->model();
  const bool is_limited = model.jnt_limited[joint] != 0;
  const double lower = is_limited ? model.jnt_range[2 * joint] : -std::numbers::pi;
  const double upper = is_limited ? model.jnt_range[2 * joint + 1] : std::numbers::pi;
  double& position = (*state)->qpos[model.jnt_qposadr[joint]];
  position = std::clamp(position, lower, upper);
  mj_kinematics(&model, state->get());
  double best = position, longest_m = LengthOf(*state, joints, site, is_sole);
  for (int i = 0; i <= kSamples; ++i) {
    position = lower + (upper - lower) * i / kSamples;
    mj_kinematics(&model, state->get());
    const double length_m = LengthOf(*state, joints, site, is_sole);
    if (length_m <= longest_m) continue;
    longest_m = length_m;
    best = position;
  }
  position = best;
  mj_kinematics(&model, state->get());
  return longest_m;
}

bool IsEndless(const mjModel& model, int joint) {
  return model.jnt_type[joint] == mjJNT_BALL || model.jnt_type[joint] == mjJNT_FREE ||
         (model.jnt_type[joint] == mjJNT_SLIDE && model.jnt_limited[joint] == 0);
}

}  // namespace

std::optional<StretchedLeg> FindStretchedLeg(const MjState& home, int base, int site,
                                             bool is_sole) {
  const mjModel& model = home.model();
  const std::vector<int> joints = JointsBetween(model, base, site);
  if (joints.size() < 2 || std::any_of(joints.begin(), joints.end(),
                                       [&](int joint) { return IsEndless(model, joint); })) {
    return std::nullopt;
  }
  StretchedLeg leg;
  leg.p_WHip = ConstVector3Map(home->xanchor + 3 * joints.back());
  leg.p_WAnkle = AnkleOf(home, joints, site, is_sole);
  MjState stretched(home);
  for (int round = 0; round < kRounds; ++round) {
    for (const int joint : joints) leg.length_m = Stretch(joints, joint, site, is_sole, &stretched);
  }
  return leg;
}

}  // namespace sidestep

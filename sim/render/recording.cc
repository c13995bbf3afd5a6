// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/recording.h"

#include <algorithm>

#include "models/mjcf/mjcf.h"
#include "models/support/config_error.h"

namespace sidestep::render {
namespace {

constexpr double kLowestScale_m = 0.05;  // keeps sizes positive for a log that starts fallen

std::vector<Eigen::Vector3d> ComOfRows(const StateLog& log, const mjModel& model) {
  const MjDataPtr data = MakeData(model);
  std::vector<Eigen::Vector3d> p_WC;
  p_WC.reserve(log.rows.size());
  for (const StateRow& row : log.rows) {
    mju_copy(data->qpos, row.qpos.data(), model.nq);
    mj_kinematics(&model, data.get());
    mj_comPos(&model, data.get());
    p_WC.emplace_back(Eigen::Map<const Eigen::Vector3d>(data->subtree_com));  // of the whole world
  }
  return p_WC;
}

std::vector<Sole> SolesOf(const std::vector<FootDescription>& feet) {
  std::vector<Sole> soles;
  for (const FootDescription& foot : feet) {
    if (foot.vertices_m.cols() == 0) continue;
    Sole sole;
    sole.foot = foot.name;
    sole.lower_m = foot.vertices_m.topRows<2>().rowwise().minCoeff();
    sole.upper_m = foot.vertices_m.topRows<2>().rowwise().maxCoeff();
    sole.height_m = foot.sole_height_m;
    soles.push_back(sole);
  }
  return soles;
}

}  // namespace

Recording LoadRecording(const std::filesystem::path& run_dir, const mjModel& model,
                        const std::vector<FootDescription>& feet) {
  Recording recording;
  recording.log = ReadStates(run_dir);
  if (recording.log.nq != model.nq) {
    throw ConfigError((run_dir / "states.bin").string() + ": error: holds " +
                      std::to_string(recording.log.nq) + " coordinates a row, the robot has " +
                      std::to_string(model.nq));
  }
  recording.footsteps = ReadFootsteps(run_dir);
  recording.summary = ReadSummary(run_dir);
  recording.soles = SolesOf(feet);
  recording.p_WC = ComOfRows(recording.log, model);
  recording.scale = ScaleFor(recording.log, std::max(kLowestScale_m, recording.p_WC[0].z()));
  return recording;
}

}  // namespace sidestep::render

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/sole_meter.h"

#include <cmath>

#include "models/support/require.h"

namespace sidestep {

double SoleHeight_m(const FootDescription& foot, const FootTruth& truth) {
  if (foot.vertices_m.cols() == 0) return truth.p_WF.z() - foot.sole_height_m;
  const double lowest_m = (truth.R_WF.row(2) * foot.vertices_m).minCoeff();
  const double level_m = foot.vertices_m.row(2).minCoeff();
  return truth.p_WF.z() + lowest_m - level_m - foot.sole_height_m;
}

SoleMeter::SoleMeter(const std::vector<FootDescription>& feet) {
  for (const FootDescription& foot : feet) has_sole_.push_back(foot.vertices_m.cols() >= 3);
}

void SoleMeter::Add(const WorldTruth& truth, const std::vector<StanceMeter>& stances) {
  SIDESTEP_REQUIRE(truth.feet.size() == has_sole_.size(), truth.feet.size());
  SIDESTEP_REQUIRE(stances.size() == has_sole_.size(), stances.size());
  for (std::size_t i = 0; i < has_sole_.size(); ++i) {
    if (!has_sole_[i] || !stances[i].bears_settled_load()) continue;
    const Eigen::Vector3d normal_W = truth.feet[i].R_WF.col(2);
    const double tilt_rad = std::atan2(normal_W.head<2>().norm(), normal_W.z());
    max_tilt_rad_ = std::fmax(max_tilt_rad_, tilt_rad);  // fmax drops the first NaN
  }
}

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/states_row.h"

#include <bit>
#include <nlohmann/json.hpp>

namespace sidestep {
namespace {

static_assert(std::endian::native == std::endian::little, "states.bin is little-endian");

constexpr int kPushDoubles = 6;   // force and point
constexpr int kFootDoubles = 12;  // force, point, nominal, adjusted

template <typename Vector>
void AppendDoubles(const Vector& values, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(values.data()),
               static_cast<std::size_t>(values.size()) * sizeof(double));
}

PushTruth StrongestPush(const WorldTruth& truth) {
  PushTruth strongest;
  for (const PushTruth& push : truth.pushes) {
    if (push.force_W_N.norm() > strongest.force_W_N.norm()) strongest = push;
  }
  return strongest;
}

}  // namespace

std::string StatesHeader(const std::vector<std::string>& feet, int nq, double dt_s) {
  nlohmann::json header;
  header["nq"] = nq;
  header["feet"] = feet;
  header["row_doubles"] = 1 + nq + kPushDoubles + kFootDoubles * static_cast<int>(feet.size());
  header["dt_s"] = dt_s;
  return "sidestep-states 1\n" + header.dump() + "\n";
}

void AppendStatesRow(double time_s, const WorldTruth& truth, const ControlTick& control,
                     std::string& bytes) {
  AppendDoubles(Eigen::Matrix<double, 1, 1>(time_s), bytes);
  AppendDoubles(truth.qpos, bytes);
  const PushTruth push = StrongestPush(truth);
  AppendDoubles(push.force_W_N, bytes);
  AppendDoubles(push.p_W, bytes);
  for (std::size_t i = 0; i < truth.feet.size(); ++i) {
    const FootTruth& foot = truth.feet[i];
    const bool has_plan = i < control.feet.size();
    AppendDoubles(foot.f_F_W, bytes);
    AppendDoubles(foot.p_WF, bytes);
    AppendDoubles(has_plan ? control.feet[i].contact.nominal_p_WF : foot.p_WF, bytes);
    AppendDoubles(has_plan ? control.feet[i].contact.adjusted_p_WF : foot.p_WF, bytes);
  }
}

}  // namespace sidestep

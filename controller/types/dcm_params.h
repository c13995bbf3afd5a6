// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// dcm_params: settings of the baselines that step by the divergent component of motion.

#include "controller/types/field.h"

namespace sidestep {

/// The DCM is the capture point: xi = p + v / w (capture_point.h).
/// Bounds of the steps are those of the MPC (MpcParams' boxes, PlannerParams' swing limits and
/// least width), their shortest times those of TimingParams. Weights are ratios: a step 1 m off
/// costs step_weight, one 1 s off time_weight. That the offset weighs most is the source's: of
/// place and time some may be given up, of the DCM at the landing nothing.
struct DcmParams {
  double gain_per_s{3.0};        ///< Of the DCM's error that remains, as long as the soles allow.
  double sole_share{0.9};        ///< A centre of pressure at the very edge turns the sole.
  double step_weight{1.0};       ///< Per m^2. The other three count for dcm_qp alone.
  double time_weight{0.1};       ///< Per s^2; on e^(wT) it is divided by (w e^(wT))^2.
  double offset_weight{1000.0};  ///< Per m^2.
  double viability_weight{1e5};  ///< Per m^2 beyond the bounds of the offset.
  double longest_swing_s{0.8};

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    const Range weight{1e-6, 1e9};
    visit("gain_per_s", self.gain_per_s, Range{0.0, 100.0},
          "rate at which the soles' pressure takes the DCM back to its reference");
    visit("sole_share", self.sole_share, Range{0.1, 1.0},
          "share of a sole's size, about its middle, that the centre of pressure may use");
    visit("step_weight", self.step_weight, weight,
          "weight of the foothold's distance from its nominal place");
    visit("time_weight", self.time_weight, weight,
          "weight of the step's time against its nominal time");
    visit("offset_weight", self.offset_weight, weight,
          "weight of the DCM's offset from the foothold at the landing");
    visit("viability_weight", self.viability_weight, weight,
          "weight of that offset beyond what the farthest and quickest steps can still catch");
    visit("longest_swing_s", self.longest_swing_s, Range{0.05, 5.0},
          "longest time in the air that the QP may choose");
  }
};

}  // namespace sidestep

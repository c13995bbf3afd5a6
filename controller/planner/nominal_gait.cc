// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/nominal_gait.h"

#include <algorithm>

#include "controller/planner/gait_generator.h"
#include "controller/planner/gait_writer.h"

namespace sidestep {

NominalGait BuildNominalGait(const std::vector<GaitParams>& segments, const GaitGeometry& geometry,
                             Tick end_tick, double tick_s) {
  const GaitSetup setup{segments, geometry, tick_s};
  NominalGait gait;
  GaitWriter writer(setup, StandingSupport(setup), &gait);
  bool goes_on = true;
  while (goes_on && writer.support().tick < end_tick) goes_on = writer.Step();
  if (!goes_on) writer.AddComKnot(std::max(end_tick, writer.support().tick + 2), true);
  if (gait.com.size() < 2) writer.AddComKnot(end_tick, true);
  writer.CloseAt(end_tick);
  return gait;
}

}  // namespace sidestep

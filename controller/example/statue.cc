// SPDX-License-Identifier: BSD-3-Clause
// A controller of one's own behind the door of controller/controller.h, run and judged like those
// that ship. This one is a statue: it holds every servo where it found it. Standing it passes;
// pushed it neither leans nor steps.
//
//   statue [SCENARIO] [OUT_DIR]      exit code 0: PASS, 1: no PASS, 2: a mistake in a file

#include <cstdio>
#include <exception>
#include <memory>
#include <string>

#include "controller/controller.h"
#include "models/support/config_error.h"
#include "sim/episode/run_scenario.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/read_scenario.h"

namespace {

using sidestep::Controller;
using sidestep::ControllerSetup;
using sidestep::ControlTick;
using sidestep::SensorFrame;
using sidestep::StageTimer;

class Statue final : public Controller {
 public:
  // Whatever else ControlTick has room for (belief, plan) stays empty, and so do its log's columns.
  const ControlTick& Update(const SensorFrame& frame) override {
    tick_.tick = frame.tick;
    if (tick_.command.joint_position.size() == 0) {
      tick_.command.joint_position = frame.joint_position;
      tick_.command.joint_velocity.setZero(frame.joint_position.size());
    }
    return tick_;
  }

  // All that it remembers is in tick_: a copy goes on as the original does.
  std::unique_ptr<Controller> Clone(StageTimer* /*timer*/) const override {
    return std::make_unique<Statue>(*this);
  }

 private:
  ControlTick tick_;
};

std::unique_ptr<Controller> MakeStatue(const ControllerSetup& setup, StageTimer* /*timer*/) {
  if (setup.robot.joints.empty()) throw sidestep::ConfigError("a statue needs a robot with servos");
  return std::make_unique<Statue>();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string file = argc > 1 ? argv[1] : "icub_stand";
    sidestep::RunOptions options;
    options.out_dir = argc > 2 ? argv[2] : "statue_run";
    const sidestep::Scenario scenario = sidestep::ReadScenario(sidestep::FindScenario(file), {});
    const sidestep::Verdict verdict = sidestep::RunScenario(scenario, options, MakeStatue).verdict;
    std::printf("%s\n", sidestep::EnumName(verdict.verdict_class).data());
    for (const sidestep::Reason& reason : verdict.reasons) std::printf("%s\n", reason.text.c_str());
    return verdict.verdict_class == sidestep::VerdictClass::kPass ? 0 : 1;
  } catch (const std::exception& mistake) {
    std::fprintf(stderr, "%s\n", mistake.what());
    return 2;
  }
}

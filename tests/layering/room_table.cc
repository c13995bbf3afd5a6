// SPDX-License-Identifier: BSD-3-Clause
#include "tests/layering/room_table.h"

#include <string>

namespace sidestep::layering {
namespace {

using Folders = std::vector<std::string>;

Folders operator+(Folders left, const Folders& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

const Folders kSupport{"models/support"};
const Folders kRobot{"models/support", "models/mjcf", "models/robot_description"};
const Folders kTypes{"controller/types", "models/support"};
const Folders kChain{"controller/types",   "controller/model", "controller/estimator",
                     "controller/planner", "controller/mpc",   "controller/swing",
                     "controller/wbc",     "controller/dcm"};
const Folders kDoor{"controller/controller.h", "controller/make_controller.h"};
const Folders kScenario = kRobot + Folders{"controller/types", "sim/scenario"};
const Folders kWorld = kScenario + Folders{"sim/world"};
// What shows or checks a run afterwards: it reads folders of runs and may start programs.
const Folders kTools = kWorld + Folders{"sim/record", "sim/verdict", "sim/process", "sim/palette"};

std::vector<Room> ModelRooms() {
  return {
      {"models/support", {}},
      {"models/mjcf", kSupport, true},
      {"models/robot_description", {"models/support", "models/mjcf", "models/urdf_to_mjcf"}, true},
      {"models/urdf_to_mjcf", {"models/support", "models/mjcf"}, true},
      {"models/import", kRobot + Folders{"models/urdf_to_mjcf"}, true},
  };
}

std::vector<Room> ControllerRooms() {
  return {
      {"controller/types", {}},
      {"controller/model", kTypes + kRobot, true},
      {"controller/estimator", kTypes + Folders{"controller/model"}},
      {"controller/planner", kTypes + Folders{"controller/model/upright.h",
                                              "models/robot_description/robot_description.h"}},
      {"controller/mpc/problem", kTypes},
      {"controller/mpc/ipopt", kTypes + Folders{"controller/mpc/problem"}},
      {"controller/mpc/structured", kTypes + Folders{"controller/mpc/problem"}},
      {"controller/mpc",
       kTypes + Folders{"controller/mpc/problem", "controller/mpc/ipopt/ipopt_solver.h",
                        "controller/mpc/structured/structured_solver.h"}},
      {"controller/swing", kTypes},
      {"controller/wbc/qp", kTypes},
      {"controller/wbc", kTypes + Folders{"controller/model", "controller/wbc/qp"}},
      {"controller/dcm", kTypes + Folders{"controller/planner", "controller/wbc/qp"}},
      {"controller", kChain + kRobot + Folders{"controller/mpc/problem"}},
  };
}

std::vector<Room> SimRooms() {
  return {
      // The metrics' names only: a scenario may expect what the verdict measures. Of the planner
      // the pure generator of gaits: no controller moves the scenario's nominal motion.
      {"sim/scenario",
       kRobot + Folders{"controller/types", "controller/planner/nominal_gait.h",
                        "controller/planner/gait_geometry.h", "sim/verdict/metrics.h"}},
      {"sim/actuators", kTypes + kRobot},
      {"sim/world", kScenario + Folders{"sim/actuators"}, true},
      {"sim/sensors", kWorld, true},
      {"sim/verdict", kWorld},
      {"sim/record", kWorld + Folders{"sim/verdict"}},
      // A controller is what stands behind its door: the loop knows none of its parts.
      {"sim/episode",
       kWorld + kDoor +
           Folders{"sim/sensors", "sim/record", "sim/verdict", "sim/process/interrupt.h"}},
      // Physics of a robot and its gait; of the controller only its settings and its robot's legs.
      {"sim/limit", kScenario + Folders{"controller/model"}},
      {"sim/palette", {}},  // plots and films in the same colours
      {"sim/process", kSupport},
      {"sim/render", kTools, true},
      {"sim/plot", kTools},
      {"sim/report", kTools + Folders{"sim/plot/plot_run.h"}},  // the plots' names
      {"sim/check", kTools},
      {"sim/sweep", kTools + kDoor + Folders{"sim/episode"}},
      {"sim/map", kTools + Folders{"sim/sweep", "sim/limit", "sim/report/html.h",
                                   "sim/report/report_style.h"}},
      {"sim/compare", kTools + Folders{"sim/plot", "sim/report/html.h", "sim/report/inline_svg.h",
                                       "sim/report/report_style.h"}},
      {"sim/export", kTools},
      {"sim/apps/commands",
       kTools + Folders{"controller/mpc", "controller/mpc/problem", "sim/episode", "sim/render",
                        "sim/plot", "sim/report", "sim/check", "sim/limit", "sim/sweep", "sim/map",
                        "sim/compare", "sim/export", "models/import"},
       true},
      {"sim/apps", kSupport + Folders{"sim/process/interrupt.h", "sim/apps/commands"}, true},
      // A program of a user's own, beside ours.
      {"controller/example", kScenario + kDoor + Folders{"sim/episode"}},
  };
}

}  // namespace

std::vector<Room> Rooms() {
  std::vector<Room> rooms;
  for (const std::vector<Room>& floor : {ModelRooms(), ControllerRooms(), SimRooms()}) {
    rooms.insert(rooms.end(), floor.begin(), floor.end());
  }
  return rooms;
}

}  // namespace sidestep::layering

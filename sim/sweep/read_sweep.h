// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_sweep: a sweep file, or a command line that says the same, read strictly.
//
//   sidestep_sweep: 1
//   name: hopper_map                  # a plain word; it names the folder
//   scenario: hopper_push             # one that ships, or a path beside this file
//   set: {pushes.0.duration_s: 0.1}   # for all runs
//   vary:                             # axis.h has the grammar
//     pushes.0.direction_rad: 0:2pi:16
//     pushes.0.at_phase: [0, 0.25, 0.5, 0.75]
//   limit: {key: pushes.0.impulse_Nspkg, ladder: 0.1:1:10, resolution: 0.02}
//   controllers:                      # each a set of overrides on top of `set`
//     ours: {}
//     fixed: {control.mpc.box_lower_m: [0, 0, 0], control.mpc.box_upper_m: [0, 0, 0]}
//   seeds: [1, 2, 3]                  # or how many, from 1 on
//   sample_seed: 1                    # of random and latin axes

#include <filesystem>
#include <string>
#include <vector>

#include "sim/sweep/sweep_spec.h"

namespace sidestep {

/// What the command line adds to a sweep file or to a scenario.
struct SweepOptions {
  std::vector<std::string> set;          ///< `--set a.b=c`
  std::vector<std::string> vary;         ///< `--vary key=values`
  std::string limit;                     ///< `--limit key[=ladder]`; the ladder may be varied.
  double resolution{0.0};                ///< `--resolution`; 0: of the file, or the default.
  std::vector<std::string> controllers;  ///< `--controller 'name: {a.b: c}'`
  std::string seeds;                     ///< `--seeds 5` or `[3, 4]`
};

/// Reads `target`, a sweep file (it has the key sidestep_sweep) or a scenario, file or name of one
/// that ships. Without a resolution it is an eighth of the ladder's smallest gap.
/// @throws ConfigError of one line, with file:line:column or the option.
SweepSpec ReadSweep(const std::filesystem::path& target, const SweepOptions& options = {});

/// The sweep as a file that reads back as the same.
std::string SweepYaml(const SweepSpec& spec);

}  // namespace sidestep

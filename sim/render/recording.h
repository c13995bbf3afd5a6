// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// recording: a run as the renderer needs it: logged states, footsteps, words, and sizes.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "models/robot_description/robot_description.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"
#include "sim/render/decoration.h"
#include "sim/render/foothold_marks.h"

namespace sidestep::render {

/// Read once and not changed while frames are drawn: forked processes draw from it.
struct Recording {
  StateLog log;
  std::vector<Footstep> footsteps;  ///< Planned and realised contacts.
  RunSummary summary;
  std::vector<Sole> soles;            ///< Of the feet that have vertices.
  std::vector<Eigen::Vector3d> p_WC;  ///< CoM of every row (m), by the model's kinematics.
  DrawScale scale;                    ///< From the log and the CoM's first height.
};

/// Reads a run's folder and computes the CoM of each row with the world's `model`.
/// @throws ConfigError if a file is missing or broken, or the log's nq is not the model's.
Recording LoadRecording(const std::filesystem::path& run_dir, const mjModel& model,
                        const std::vector<FootDescription>& feet);

}  // namespace sidestep::render

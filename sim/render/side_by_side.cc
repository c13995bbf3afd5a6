// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/side_by_side.h"

#include <cstddef>
#include <sstream>
#include <string>

#include "models/support/config_error.h"
#include "sim/record/run_files.h"
#include "sim/record/run_reader.h"
#include "sim/render/film.h"
#include "sim/render/frames.h"
#include "sim/render/render_run.h"
#include "sim/render/scratch_dir.h"
#include "sim/render/video_file.h"
#include "sim/scenario/read_scenario.h"

namespace sidestep {
namespace {

// Whether the controller may move a foothold at all.
bool MayAdjust(const Scenario& scenario) {
  const MpcParams& mpc = scenario.control.mpc;
  return (mpc.box_upper_m - mpc.box_lower_m).head<2>().maxCoeff() > 0.0;
}

std::array<std::string, 2> LabelsOf(const std::array<std::filesystem::path, 2>& run_dirs) {
  std::array<std::string, 2> labels;
  std::array<bool, 2> may_adjust{};
  for (std::size_t i = 0; i < run_dirs.size(); ++i) {
    const Scenario scenario = ReadScenario(run_dirs[i] / "scenario.yaml", {});
    labels[i] = scenario.name;
    may_adjust[i] = MayAdjust(scenario);
  }
  if (may_adjust[0] == may_adjust[1]) return labels;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    labels[i] += may_adjust[i] ? ": adjusts its steps" : ": may not adjust its steps";
  }
  return labels;
}

// What each half draws: the part that is asked for, or, of a run that is over before it begins, its
// last state. Throws before anything is drawn if neither run has that part.
std::array<RenderOptions, 2> HalvesOf(const std::array<std::filesystem::path, 2>& run_dirs,
                                      const RenderOptions& options) {
  const std::array<StateLog, 2> logs{ReadStates(run_dirs[0]), ReadStates(run_dirs[1])};
  const auto end_s = [&](std::size_t i) {
    return logs[i].rows.front().time_s + logs[i].duration_s();
  };
  const auto is_over = [&](std::size_t i) { return options.from_s.value_or(0.0) >= end_s(i); };
  std::array<RenderOptions, 2> halves{options, options};
  for (std::size_t i = 0; i < halves.size(); ++i) {
    if (!is_over(i)) {
      render::ClipOf(logs[i], options.from_s, options.to_s, options.speed);
      continue;
    }
    if (is_over(1 - i)) {
      std::ostringstream text;
      text << "sidestep: error: nothing from " << *options.from_s
           << " s on: " << run_dirs[0].string() << " ends at " << end_s(0) << " s, "
           << run_dirs[1].string() << " at " << end_s(1) << " s";
      throw ConfigError(text.str());
    }
    halves[i].from_s = end_s(i) - 0.5 * logs[i].dt_s;
    halves[i].to_s.reset();
  }
  return halves;
}

}  // namespace

void RenderSideBySide(const std::array<std::filesystem::path, 2>& run_dirs,
                      const RenderOptions& options, const std::filesystem::path& film) {
  const std::array<std::string, 2> labels = LabelsOf(run_dirs);
  std::array<RenderOptions, 2> halves = HalvesOf(run_dirs, options);
  const render::ScratchDir scratch(film);
  std::array<FilmedRun, 2> runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (options.on_progress) {
      halves[i].on_progress = [&options, i](double share) {
        options.on_progress(0.5 * (static_cast<double>(i) + share));
      };
    }
    runs[i] = {run_dirs[i], labels[i], scratch.path() / ("half" + std::to_string(i) + ".mp4"),
               options.from_s.value_or(0.0), options.speed};
    RenderClip(run_dirs[i], halves[i], runs[i].video);
  }
  ListIfInRun(run_dirs[0], film);
  WriteFilm(runs, scratch.path() / "both.mp4");
  const bool is_gif = film.extension() == ".gif";
  if (is_gif) {
    render::WriteGif(scratch.path() / "both.mp4", options.fps, scratch.path() / "both.gif");
  }
  scratch.MoveOut(is_gif ? "both.gif" : "both.mp4", film);
}

}  // namespace sidestep

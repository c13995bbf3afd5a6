// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/film.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/require.h"
#include "sim/process/process.h"
#include "sim/record/output_file.h"
#include "sim/record/run_summary.h"
#include "sim/render/film_graph.h"
#include "sim/render/outcome.h"
#include "sim/render/render_run.h"
#include "sim/render/scratch_dir.h"
#include "sim/render/video_file.h"
#include "sim/render/video_probe.h"

namespace sidestep {
namespace {

using render::FilterGraph;
using render::Heading;
using render::ScratchDir;

std::array<Heading, 2> HeadingsOf(const std::array<FilmedRun, 2>& runs) {
  std::array<Heading, 2> headings;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const RunSummary summary = ReadSummary(runs[i].run_dir);
    headings[i].label = runs[i].label.empty() ? summary.name : runs[i].label;
    headings[i].outcome = render::OutcomeOf(summary);
    double& from_s = headings[i].outcome.from_s;  // in the film's time
    from_s = std::max(0.0, (from_s - runs[i].from_s) / runs[i].speed);
  }
  return headings;
}

std::filesystem::path VideoOf(const FilmedRun& run) {
  if (!run.video.empty()) return run.video;
  std::filesystem::path video = run.run_dir / "video.mp4";
  if (std::filesystem::is_regular_file(video)) return video;
  throw ConfigError(video.string() + ": error: the run has no video; `sidestep render` draws it");
}

// One pass of ffmpeg over `inputs`, in the scratch folder, where the graph's texts are.
void RunGraph(const std::vector<std::filesystem::path>& inputs, const FilterGraph& graph,
              const std::vector<std::string>& output, const ScratchDir& scratch) {
  for (const auto& [name, text] : graph.text_files) WriteWholeFile(scratch.path() / name, text);
  std::vector<std::string> arguments{"ffmpeg", "-hide_banner", "-loglevel",
                                     "error",  "-nostdin",     "-y"};
  for (const std::filesystem::path& input : inputs) {
    arguments.insert(arguments.end(), {"-i", render::FileOperand(input)});
  }
  arguments.insert(arguments.end(), {"-filter_complex", graph.graph, "-map", "[out]"});
  arguments.insert(arguments.end(), output.begin(), output.end());
  RunTool(arguments, {}, scratch.path());
}

// Draws a run's pictures into the scratch folder and returns their files.
std::vector<std::filesystem::path> DrawCells(const FilmedRun& run, const std::string& name,
                                             const std::vector<double>& times_s,
                                             const render::StripLayout& layout,
                                             const ScratchDir& scratch) {
  std::vector<TimedPicture> pictures;
  std::vector<std::filesystem::path> files;
  for (const double time_s : times_s) {
    files.push_back(scratch.path() / (name + std::to_string(files.size()) + ".png"));
    pictures.push_back({time_s, files.back()});
  }
  RenderOptions options = RenderOptionsOf(run.run_dir);
  options.width_px = layout.drawn_width_px;
  options.height_px = layout.cell_px;
  options.quality = RenderQuality::kFine;
  options.has_captions = false;
  WriteFramePngs(run.run_dir, pictures, options);
  return files;
}

}  // namespace

void WriteFilm(const std::array<FilmedRun, 2>& runs, const std::filesystem::path& mp4) {
  const std::array<std::filesystem::path, 2> videos{VideoOf(runs[0]), VideoOf(runs[1])};
  const std::array<Heading, 2> headings = HeadingsOf(runs);
  RunTool({"ffmpeg", "-version"});  // name it, not its ffprobe, if it is not installed
  const render::FilmLayout layout =
      render::LayOutFilm({render::ProbeVideo(videos[0]), render::ProbeVideo(videos[1])});
  const ScratchDir scratch(mp4);
  RunGraph(
      {videos[0], videos[1]}, render::FilmGraph(layout, headings),
      {"-frames:v", std::to_string(layout.frames), "-c:v", "libx264", "-preset", "veryfast", "-crf",
       "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart", "-f", "mp4", "film.mp4"},
      scratch);
  scratch.MoveOut("film.mp4", mp4);
}

void WriteStrip(const std::array<FilmedRun, 2>& runs, const std::vector<double>& times_s,
                const std::filesystem::path& png) {
  SIDESTEP_REQUIRE(!times_s.empty(), times_s.size());
  const std::array<Heading, 2> headings = HeadingsOf(runs);
  const render::StripLayout layout = render::LayOutStrip(times_s.size());
  const ScratchDir scratch(png);
  std::vector<std::filesystem::path> cells = DrawCells(runs[0], "a", times_s, layout, scratch);
  for (std::filesystem::path& cell : DrawCells(runs[1], "b", times_s, layout, scratch)) {
    cells.push_back(std::move(cell));
  }
  RunGraph(cells, render::StripGraph(layout, times_s, headings),
           {"-frames:v", "1", "-c:v", "png", "-f", "image2", "-update", "1", "strip.png"}, scratch);
  scratch.MoveOut("strip.png", png);
}

}  // namespace sidestep

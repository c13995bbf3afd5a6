// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_run.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/nearest_name.h"
#include "sim/plot/draw_scripts.h"
#include "sim/plot/plot_data.h"
#include "sim/plot/plot_script.h"
#include "sim/record/output_file.h"
#include "sim/record/run_files.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

// A stretch of time of a run, and what its files' names end in.
struct PlottedView {
  std::optional<plot::Stretch> stretch;
  std::string suffix;
  std::string title;  // after the run's
};

void CheckNames(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const auto& known = PlotNames();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::string all, nearest = NearestName(name, known);
    for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
    throw ConfigError("sidestep: error: there is no plot '" + name + "'" +
                      (nearest.empty() ? "" : ", did you mean '" + nearest + "'?") +
                      (nearest.empty() ? "; there are: " : " There are: ") + all);
  }
}

std::vector<PlottedView> ViewsOf(const plot::PlottedRun& run, const fs::path& run_dir,
                                 const std::optional<double>& around_s) {
  if (!around_s) return {{}};
  std::vector<PlottedView> views;
  const double last_s = run.trajectory.Numbers("time_s").back();
  for (std::size_t i = 0; i < run.summary.pushes.size(); ++i) {
    const PushSummary& push = run.summary.pushes[i];
    if (!(push.start_s <= last_s)) continue;  // the run ended before
    const std::string number = std::to_string(i + 1);
    views.push_back(
        {plot::Stretch{push.start_s - *around_s, push.start_s + push.duration_s + *around_s},
         "_push" + number, ", push " + number});
  }
  if (views.empty())
    throw ConfigError(run_dir.string() + ": error: --around: the run has no push before its end");
  return views;
}

// Writes the scripts of one view and the curves of all of them; tells the scripts' names.
std::vector<std::string> WriteScripts(const plot::PlottedRun& run, const PlottedView& view,
                                      const PlotOptions& options, const fs::path& run_dir) {
  plot::PlotData data =
      plot::SelectPlotData(run, view.stretch, plot::CurveFile("curves" + view.suffix + ".bin"));
  data.title += view.title;
  data.canvas = options.canvas;
  std::vector<std::string> names, files{"plots/" + data.curves.file()};
  std::vector<std::pair<fs::path, std::string>> texts;
  for (const plot::PlotScript& script : plot::AllScripts()) {
    const auto& only = options.only;
    const bool is_asked =
        only.empty() || std::find(only.begin(), only.end(), script.name) != only.end();
    if (!is_asked) continue;
    names.push_back(script.name + view.suffix + options.canvas.suffix);
    const std::string body = script.body(data);
    texts.emplace_back(
        run_dir / "plots" / (names.back() + ".gp"),
        plot::ScriptText(data.canvas, names.back(), data.curves.Definitions(body), body));
    files.push_back("plots/" + names.back() + ".gp");
    for (const std::string& format : options.formats) {
      files.push_back("plots/" + names.back() + "." + format);
    }
  }
  ListRunFiles(run_dir, files);
  WriteWholeFile(run_dir / "plots" / data.curves.file(), data.curves.bytes());
  for (const auto& [file, text] : texts) WriteWholeFile(file, text);
  return names;
}

}  // namespace

const std::vector<std::string>& PlotNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const plot::PlotScript& script : plot::AllScripts()) names.push_back(script.name);
    return names;
  }();
  return kNames;
}

std::vector<fs::path> PlotRun(const fs::path& run_dir, const PlotOptions& options) {
  CheckNames(options.only);
  const plot::PlottedRun run = plot::ReadPlottedRun(run_dir);
  const std::vector<PlottedView> views = ViewsOf(run, run_dir, options.around_s);
  const fs::path dir = run_dir / "plots";
  std::error_code failure;
  fs::create_directories(dir, failure);
  if (failure) throw ConfigError(dir.string() + ": error: can't be created: " + failure.message());
  std::vector<fs::path> pictures;
  for (const PlottedView& view : views) {
    const std::vector<fs::path> more =
        plot::DrawScripts(WriteScripts(run, view, options, run_dir), options.formats, dir);
    pictures.insert(pictures.end(), more.begin(), more.end());
  }
  return pictures;
}

}  // namespace sidestep

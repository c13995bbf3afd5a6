// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_run.h"

#include "models/support/config_error.h"
#include "sim/plot/plot_data.h"
#include "sim/plot/plot_script.h"
#include "sim/process/gnuplot.h"
#include "sim/record/output_file.h"
#include "sim/record/run_files.h"

namespace sidestep {
namespace {

std::vector<std::string> FilesOf(PlotFiles files) {
  std::vector<std::string> names{std::string("plots/") + plot::kThinnedFile,
                                 std::string("plots/") + plot::kPhaseFile};
  for (const std::string& name : PlotNames()) {
    names.push_back("plots/" + name + ".gp");
    names.push_back("plots/" + name + ".svg");
    if (files == PlotFiles::kSvgAndPng) names.push_back("plots/" + name + ".png");
  }
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

void PlotRun(const std::filesystem::path& run_dir, PlotFiles files) {
  const plot::PlotData data = plot::LoadPlotData(run_dir);
  const std::filesystem::path dir = run_dir / "plots";
  std::error_code failure;
  std::filesystem::create_directories(dir, failure);
  if (failure) throw ConfigError(dir.string() + ": error: can't be created: " + failure.message());
  ListRunFiles(run_dir, FilesOf(files));
  WriteWholeFile(dir / plot::kThinnedFile, data.thinned_csv);
  WriteWholeFile(dir / plot::kPhaseFile, data.phase_csv);
  for (const plot::PlotScript& script : plot::AllScripts()) {
    const std::string file = script.name + ".gp";
    WriteWholeFile(dir / file, plot::Preamble(script.name) + script.body(data));
    RunGnuplot({file}, {}, dir);
    if (files == PlotFiles::kSvgAndPng) RunGnuplot({"-e", "format='png'", file}, {}, dir);
  }
}

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
// A run's folder, as plots, report, check and compare read it.

#include <string>

#include "sim/compare/compare_runs.h"
#include "sim/plot/plot_data.h"
#include "sim/plot/plot_script.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"
#include "sim/report/report_sections.h"
#include "sim/report/run_evidence.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::fuzz {
namespace {

// gnuplot runs what stands in backticks.
void WriteScripts(const std::filesystem::path& run_dir) {
  const plot::PlotData data = plot::LoadPlotData(run_dir);
  for (const plot::PlotScript& script : plot::AllScripts()) {
    const std::string body = script.body(data);
    const std::string text =
        plot::ScriptText(data.canvas, script.name, data.curves.Definitions(body), body);
    Require(text.find('`') == std::string::npos, "a backtick in " + script.name);
  }
}

void WritePage(const std::filesystem::path& run_dir) {
  const report::RunEvidence run = report::LoadEvidence(run_dir);
  report::RunSection(run, 0);
  report::ComparisonSection({run, run});
}

void WriteSummary(const std::filesystem::path& run_dir) {
  const std::string written = SummaryJson(ReadSummary(run_dir));
  RequireRead([&] {
    Require(SummaryJson(ParseSummary(written, "summary.json")) == written,
            "the summary is written as another");
  });
}

}  // namespace
}  // namespace sidestep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  const fuzz::FuzzFolder& folder = fuzz::InputFolder();
  fuzz::WriteFiles(folder, fuzz::TextOf(data, size),
                   {"summary.json", "scenario.yaml", "footsteps.csv", "trajectory.csv", "mpc.csv"});
  const std::filesystem::path& run_dir = folder.path();
  fuzz::IsRead([&] { fuzz::WriteSummary(run_dir); });
  fuzz::IsRead([&] { ReadFootsteps(run_dir); });
  fuzz::IsRead([&] { fuzz::WriteScripts(run_dir); });
  fuzz::IsRead([&] { fuzz::WritePage(run_dir); });
  fuzz::IsRead([&] { RunComparisonText(CompareRuns(run_dir, run_dir)); });
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/write_report.h"

#include <string>

#include "models/support/config_error.h"
#include "sim/record/output_file.h"
#include "sim/record/run_files.h"
#include "sim/report/html.h"
#include "sim/report/report_sections.h"
#include "sim/report/report_style.h"
#include "sim/report/run_evidence.h"

namespace sidestep {
namespace {

std::string PageTitle(const std::vector<report::RunEvidence>& runs) {
  const RunSummary& first = runs.front().summary;
  if (runs.size() == 1) return first.name + ": " + std::string(EnumName(first.verdict));
  return std::to_string(runs.size()) + " runs";
}

}  // namespace

void WriteReport(const std::vector<std::filesystem::path>& run_dirs,
                 const std::filesystem::path& out_html) {
  if (run_dirs.empty()) throw ConfigError("a report needs at least one run folder");
  std::vector<report::RunEvidence> runs;
  for (const std::filesystem::path& dir : run_dirs) runs.push_back(report::LoadEvidence(dir));

  std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" +
                     std::string("<meta name=\"viewport\" content=\"width=device-width\">\n") +
                     "<title>" + report::Escaped(PageTitle(runs)) + "</title>\n<style>" +
                     report::StyleSheet() + "</style>\n</head>\n<body>\n<main>\n";
  if (runs.size() > 1) page += report::ComparisonSection(runs);
  for (std::size_t i = 0; i < runs.size(); ++i) page += report::RunSection(runs[i], i);
  page += "</main>\n</body>\n</html>\n";

  ListIfInRun(run_dirs.front(), out_html);
  WriteWholeFile(out_html, page);
}

}  // namespace sidestep

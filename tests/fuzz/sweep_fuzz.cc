// SPDX-License-Identifier: BSD-3-Clause
// A sweep's folder: the sweep itself, the manifest of its rays, rows of runs, and the map that is
// drawn of them.

#include <algorithm>
#include <string>
#include <string_view>

#include "sim/map/compare_maps.h"
#include "sim/map/map_page.h"
#include "sim/map/pictures.h"
#include "sim/map/sweep_map.h"
#include "sim/sweep/merge_rows.h"
#include "sim/sweep/read_sweep.h"
#include "sim/sweep/row_file.h"
#include "sim/sweep/sweep_plan.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::fuzz {
namespace {

constexpr char kRows[] = "rows-0-of-1.csv";

// Any program's manifest is taken for this one's: the line after `@@ manifest.csv` tells whose.
std::string AsOfThisProgram(std::string input) {
  constexpr std::string_view kMark = "@@ manifest.csv\n";
  const std::string ours = "# sidestep sweep manifest 1, program " + ProgramHash();
  for (std::size_t at = 0; (at = input.find(kMark, at)) != std::string::npos;) {
    at += kMark.size();
    input.replace(at, std::min(input.find('\n', at), input.size()) - at, ours);
  }
  return input;
}

void WriteSweep(const std::filesystem::path& folder, const FuzzFolder& other) {
  const SweepSpec spec = ReadSweep(folder / "sweep.yaml");
  const std::string written = SweepYaml(spec);
  const std::filesystem::path file = other.Write("sweep.yaml", written);
  RequireRead([&] { Require(SweepYaml(ReadSweep(file)) == written, "is written as another"); });
  ReadRows(spec, folder / kRows);
}

void DrawMap(const map::SweepMap& map) {
  map::MapPage(map, {});
  map::SheetPicture(map);
  map::ComparisonText(map::CompareMaps(map, map));
}

}  // namespace
}  // namespace sidestep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  static const fuzz::FuzzFolder other;
  fuzz::WriteFiles(fuzz::InputFolder(), fuzz::AsOfThisProgram(fuzz::TextOf(data, size)),
                   {"sweep.yaml", "manifest.csv", fuzz::kRows, "cells.csv"});
  const std::filesystem::path& path = fuzz::InputFolder().path();
  fuzz::IsRead([&] { fuzz::WriteSweep(path, other); });
  fuzz::IsRead([&] {
    const SweepPlan plan = ReadPlan(path);
    ResultsOf(plan, ReadAllRows(plan, path, fuzz::RequireWords).rows);
  });
  fuzz::IsRead([&] { fuzz::DrawMap(map::ReadMap(path)); });
  return 0;
}

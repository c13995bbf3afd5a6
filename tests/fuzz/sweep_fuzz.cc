// SPDX-License-Identifier: BSD-3-Clause
// A sweep's folder: the sweep itself, the manifest of its rays, rows of runs, and the map that is
// drawn of them.

#include <string>

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

const std::vector<std::string>& NamesOfFiles() {
  static const std::vector<std::string> kNames{"sweep.yaml", "manifest.csv", kRows, "cells.csv"};
  return kNames;
}

// Any program's manifest is taken for this one's.
std::string AsOfThisProgram(const std::string& manifest) {
  const std::size_t first_line = manifest.find('\n');
  return "# sidestep sweep manifest 1, program " + ProgramHash() +
         (first_line == std::string::npos ? "\n" : manifest.substr(first_line));
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
  static const fuzz::FuzzFolder folder, other;
  for (const std::string& name : fuzz::NamesOfFiles()) folder.Write(name, "");
  for (const fuzz::FilePart& part :
       fuzz::SplitFiles(fuzz::TextOf(data, size), fuzz::NamesOfFiles())) {
    const bool is_manifest = part.name == "manifest.csv";
    folder.Write(part.name, is_manifest ? fuzz::AsOfThisProgram(part.text) : part.text);
  }
  const std::filesystem::path& path = folder.path();
  fuzz::IsRead([&] { fuzz::WriteSweep(path, other); });
  fuzz::IsRead([&] {
    const SweepPlan plan = ReadPlan(path);
    ResultsOf(plan, ReadAllRows(plan, path, fuzz::RequireWords).rows);
  });
  fuzz::IsRead([&] { fuzz::DrawMap(map::ReadMap(path)); });
  return 0;
}

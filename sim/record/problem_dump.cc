// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/problem_dump.h"

#include <cmath>
#include <cstdio>
#include <system_error>

#include "sim/record/output_file.h"
#include "sim/record/run_files.h"

namespace sidestep {
namespace {

constexpr int kMaxFailed = 10;

}  // namespace

ProblemDump::ProblemDump(const std::filesystem::path& run_dir, bool every)
    : run_dir_(run_dir), folder_(run_dir / "problems"), every_(every) {}

void ProblemDump::MakeFolder() const {
  std::error_code ignored;  // the first write tells
  std::filesystem::create_directories(folder_, ignored);
}

ProblemDump ProblemDump::ForkTo(const std::filesystem::path& run_dir) const {
  RequireOtherFolder(run_dir_, run_dir);
  ProblemDump fork(run_dir, every_);
  fork.num_failed_ = num_failed_;
  fork.written_ = written_;
  if (!written_.empty()) fork.MakeFolder();
  for (const std::string& name : written_) {
    ListRunFiles(run_dir, {"problems/" + name});
    CopyWholeFile(folder_ / name, fork.folder_ / name);
  }
  return fork;
}

void ProblemDump::Add(double time_s, bool failed, const ProblemText& problem_text) {
  if (failed) ++num_failed_;
  if (!every_ && (!failed || num_failed_ > kMaxFailed)) return;
  char name[32];
  std::snprintf(name, sizeof name, "mpc_%07lld", std::llround(1e3 * time_s));
  const std::string text = problem_text(name);
  if (text.empty()) return;  // a controller that keeps its problems to itself
  MakeFolder();
  const std::string file = std::string(name) + ".json";
  ListRunFiles(run_dir_, {"problems/" + file});
  WriteWholeFile(folder_ / file, text);
  written_.push_back(file);
}

}  // namespace sidestep

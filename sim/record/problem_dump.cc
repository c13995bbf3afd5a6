// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/problem_dump.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <system_error>

#include "controller/mpc/problem/ocp_json.h"
#include "models/support/config_error.h"

namespace sidestep {
namespace {

constexpr int kMaxFailed = 10;

}  // namespace

ProblemDump::ProblemDump(const std::filesystem::path& run_dir, bool every)
    : folder_(run_dir / "problems"), every_(every) {}

void ProblemDump::Add(double time_s, const mpc::CentroidalOcp& ocp, bool failed) {
  if (failed) ++num_failed_;
  if (!every_ && (!failed || num_failed_ > kMaxFailed)) return;
  std::error_code ignored;  // the write below tells
  std::filesystem::create_directories(folder_, ignored);
  char name[32];
  std::snprintf(name, sizeof name, "mpc_%07lld.json", std::llround(1e3 * time_s));
  nlohmann::json problem = mpc::ToJson(ocp);
  problem["name"] = std::filesystem::path(name).stem().string();
  std::ofstream out(folder_ / name);
  out << problem.dump(1) << "\n";
  out.close();
  if (!out) throw ConfigError((folder_ / name).string() + ": error: can't be written");
}

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "sim/render/render_run.h"
#include "tests/support/synthetic_run.h"
namespace sidestep { namespace {
TEST(Dev, Frames) {
  const auto dir = testing::FreshTestDir("dev");
  testing::SyntheticRun run; run.duration_s=4.0; run.push_start_s=1.0; run.push_duration_s=0.5; if (getenv("FAILRUN")) run.verdict="FAIL";
  testing::WriteSyntheticRun(dir, run);
  RenderOptions o; 
  for (double t : {0.5, 1.3, 1.65, 3.5}) WriteFramePng(dir, t, dir / (std::to_string(t)+".png"), o);
}
}}

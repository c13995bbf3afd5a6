// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/video_probe.h"

#include <cstdlib>
#include <sstream>

#include "models/support/config_error.h"
#include "sim/process/process.h"
#include "sim/render/video_file.h"

namespace sidestep::render {
namespace {

// "30000/1001" as a number; 0 if it is none.
double RateOf(const std::string& rate) {
  char* rest = nullptr;
  const double frames = std::strtod(rate.c_str(), &rest);
  const double seconds = *rest == '/' ? std::strtod(rest + 1, nullptr) : 1.0;
  return seconds > 0.0 ? frames / seconds : 0.0;
}

}  // namespace

VideoInfo ProbeVideo(const std::filesystem::path& file) {
  const ProcessResult result =
      RunTool({"ffprobe", "-v", "error", "-select_streams", "v:0", "-show_entries",
               "stream=width,height,r_frame_rate,duration", "-of", "default=noprint_wrappers=1",
               "-i", FileOperand(file)});
  VideoInfo info;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string key = line.substr(0, equals), value = line.substr(equals + 1);
    if (key == "width") info.width_px = std::atoi(value.c_str());
    if (key == "height") info.height_px = std::atoi(value.c_str());
    if (key == "r_frame_rate") info.rate = value;
    if (key == "duration") info.duration_s = std::strtod(value.c_str(), nullptr);
  }
  info.fps = RateOf(info.rate);
  if (info.width_px > 0 && info.height_px > 0 && info.fps > 0.0 && info.duration_s > 0.0) {
    return info;
  }
  throw ConfigError(file.string() + ": error: is no video");
}

}  // namespace sidestep::render

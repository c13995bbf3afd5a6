// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// render_test_support: what is in a video or a picture, and a PATH without programs.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "models/support/config_error.h"
#include "sim/process/process.h"

namespace sidestep::render_test_support {

/// What ffprobe says of a video's or picture's only stream, frames counted by decoding them.
inline nlohmann::json Probe(const std::filesystem::path& video) {
  const ProcessResult result =
      RunOrThrow({"ffprobe", "-v", "error", "-count_frames", "-show_streams", "-show_format", "-of",
                  "json", "file:" + video.string()});
  const nlohmann::json answer = nlohmann::json::parse(result.out);
  nlohmann::json stream = answer.at("streams").at(0);
  stream["container_duration"] = answer.at("format").value("duration", "");
  return stream;
}

/// All frames of a video or picture, one after the other: rows from the top, three bytes a pixel.
inline std::string DecodedRgb(const std::filesystem::path& file) {
  return RunOrThrow({"ffmpeg", "-v", "error", "-i", "file:" + file.string(), "-f", "rawvideo",
                     "-pix_fmt", "rgb24", "pipe:1"})
      .out;
}

/// Runs a test's body with no program in PATH but those of a folder.
class WithoutPrograms {
 public:
  explicit WithoutPrograms(const std::filesystem::path& but_of = "/nonexistent")
      : path_(std::getenv("PATH")) {
    setenv("PATH", but_of.c_str(), 1);
  }
  ~WithoutPrograms() { setenv("PATH", path_.c_str(), 1); }
  WithoutPrograms(const WithoutPrograms&) = delete;
  WithoutPrograms& operator=(const WithoutPrograms&) = delete;

 private:
  std::string path_;
};

inline std::string ErrorOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace sidestep::render_test_support

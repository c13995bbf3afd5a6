// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/video_file.h"

#include <algorithm>
#include <string>

#include "models/support/config_error.h"
#include "sim/record/output_file.h"

namespace sidestep::render {
namespace {

std::vector<std::string> RawInput(int width_px, int height_px, int fps) {
  return {"ffmpeg",     "-hide_banner",
          "-loglevel",  "error",
          "-nostdin",   "-y",
          "-f",         "rawvideo",
          "-pix_fmt",   "rgb24",
          "-s",         std::to_string(width_px) + "x" + std::to_string(height_px),
          "-framerate", std::to_string(fps),
          "-i",         "pipe:0",
          "-vf",        "vflip"};
}

std::vector<std::string> With(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

std::string FileOperand(const std::filesystem::path& file) {
  return "file:" + std::filesystem::absolute(file).string();
}

// Without B-frames, parts join at exact frame times whatever their length.
VideoWriter::VideoWriter(const std::filesystem::path& file, int width_px, int height_px, int fps)
    : ffmpeg_(With(RawInput(width_px, height_px, fps),
                   {"-c:v", "libx264", "-preset", "veryfast", "-crf", "20", "-bf", "0", "-pix_fmt",
                    "yuv420p", "-threads", "1", "-f", "matroska", FileOperand(file)}),
              ToolOptions()) {}

void VideoWriter::Add(const std::vector<std::uint8_t>& pixels) {
  if (ffmpeg_.Write(pixels.data(), pixels.size())) return;
  throw ConfigError(DescribeFailure("ffmpeg", ffmpeg_.Finish()));
}

void VideoWriter::Finish() {
  const ProcessResult result = ffmpeg_.Finish();
  if (result.exit_code != 0) throw ConfigError(DescribeFailure("ffmpeg", result));
}

void JoinVideos(const std::vector<std::filesystem::path>& parts,
                const std::filesystem::path& scratch_dir, const std::filesystem::path& mp4) {
  const std::filesystem::path list = scratch_dir / "parts.txt";
  std::string text;  // Names relative to the list, and of our making: nothing to quote.
  for (const std::filesystem::path& part : parts) {
    text += "file '" + part.filename().string() + "'\n";
  }
  WriteWholeFile(list, text);
  RunTool({"ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin", "-y", "-f", "concat",
           "-safe", "0", "-i", FileOperand(list), "-c", "copy", "-movflags", "+faststart", "-f",
           "mp4", FileOperand(mp4)});
}

void WriteGif(const std::filesystem::path& video, int fps, const std::filesystem::path& gif) {
  constexpr int kFastest = 25;
  const std::string rate = std::to_string(std::min(fps, kFastest));
  RunTool({"ffmpeg", "-hide_banner", "-loglevel", "error", "-nostdin", "-y", "-i",
           FileOperand(video), "-filter_complex",
           "fps=" + rate +
               ",split[colours][frames];[colours]palettegen=stats_mode=diff[palette];"
               "[frames][palette]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle",
           "-f", "gif", FileOperand(gif)});
}

void WritePng(const std::vector<std::uint8_t>& pixels, int width_px, int height_px,
              const std::filesystem::path& file) {
  Process ffmpeg(
      With(RawInput(width_px, height_px, 1),
           {"-frames:v", "1", "-c:v", "png", "-f", "image2", "-update", "1", FileOperand(file)}),
      ToolOptions());
  ffmpeg.Write(pixels.data(), pixels.size());
  const ProcessResult result = ffmpeg.Finish();
  if (result.exit_code != 0) throw ConfigError(DescribeFailure("ffmpeg", result));
}

}  // namespace sidestep::render

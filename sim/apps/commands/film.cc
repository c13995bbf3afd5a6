// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/film.h"

#include <cstdio>
#include <memory>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"

namespace sidestep {
namespace {

constexpr std::size_t kMostPictures = 12;  // more would be stamps

struct FilmArguments {
  std::array<std::filesystem::path, 2> run_dirs;
  std::vector<std::string> labels;
  std::filesystem::path film;   ///< Empty: none.
  std::filesystem::path strip;  ///< Empty: none.
  std::vector<double> times_s;  ///< Of the strip's pictures.
  bool is_forced{false};
};

void CheckOutputs(const FilmArguments& arguments) {
  if (arguments.film.empty() && arguments.strip.empty()) {
    throw ConfigError("sidestep: error: film needs -o FILE, or --strip FILE (see --help)");
  }
  if (!arguments.strip.empty() && arguments.times_s.size() > kMostPictures) {
    throw ConfigError("sidestep: error: --times takes at most " + std::to_string(kMostPictures) +
                      " times, got " + std::to_string(arguments.times_s.size()));
  }
  for (const std::filesystem::path& file : {arguments.film, arguments.strip}) {
    if (!file.empty()) CheckOutFile(file, arguments.is_forced);
  }
  for (const std::filesystem::path& run_dir : arguments.run_dirs) {
    std::error_code ignored;  // a film that is not there yet is no run's video
    if (!std::filesystem::equivalent(arguments.film, run_dir / "video.mp4", ignored)) continue;
    throw ConfigError(arguments.film.string() + ": error: is a run's own video");
  }
}

int Film(const FilmArguments& arguments) {
  std::array<FilmedRun, 2> runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    RequireRunFolder(arguments.run_dirs[i]);
    runs[i].run_dir = arguments.run_dirs[i];
    if (i < arguments.labels.size()) runs[i].label = arguments.labels[i];
  }
  CheckOutputs(arguments);
  if (!arguments.film.empty()) {
    WriteFilm(runs, arguments.film);
    std::printf("%s\n", arguments.film.c_str());
  }
  if (!arguments.strip.empty()) {
    WriteStrip(runs, arguments.times_s, arguments.strip);
    std::printf("%s\n", arguments.strip.c_str());
  }
  return kExitPass;
}

}  // namespace

void AddFilmCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("film", "Show two runs side by side in one video");
  const auto arguments = std::make_shared<FilmArguments>();
  command->add_option("RUN_A", arguments->run_dirs[0], "Folder of the run on the left")->required();
  command->add_option("RUN_B", arguments->run_dirs[1], "Folder of the run on the right")
      ->required();
  command->add_option("-o,--out", arguments->film, "The film, an MP4 file")->type_name("FILE");
  command
      ->add_option("--labels", arguments->labels, "What stands over the two [the scenarios' names]")
      ->delimiter(',')
      ->expected(2)
      ->type_name("A,B");
  CLI::Option* strip =
      command->add_option("--strip", arguments->strip, "Pictures of both at some times, a PNG file")
          ->type_name("FILE");
  CLI::Option* times =
      command->add_option("--times", arguments->times_s, "Times of these pictures (s)")
          ->delimiter(',')
          ->check(TimeInRun())
          ->type_name("S,S,...");
  strip->needs(times);
  times->needs(strip);
  command->add_flag("--force", arguments->is_forced, "Replace files that are there already");
  command->callback([arguments, &exit_code] { exit_code = Film(*arguments); });
}

}  // namespace sidestep

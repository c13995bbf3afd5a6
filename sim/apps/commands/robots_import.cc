// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "models/import/import_robot.h"
#include "models/support/config_error.h"
#include "models/support/plain_word.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"

namespace sidestep {
namespace {

struct ImportArguments {
  importer::ImportOptions options;
  std::vector<std::string> packages;  ///< NAME=DIR.
  bool has_no_meshes{false};
  bool may_replace{false};
};

/// A folder that holds anything is somebody's work.
void CheckFolder(const std::filesystem::path& folder, bool may_replace) {
  std::error_code error;
  const bool is_there = std::filesystem::exists(folder, error);
  if (is_there && !std::filesystem::is_directory(folder, error)) {
    throw ConfigError(folder.string() + ": error: is no folder");
  }
  if (is_there && !may_replace && !std::filesystem::is_empty(folder, error)) {
    throw ConfigError(folder.string() +
                      ": error: is not empty; --force replaces the files that import writes");
  }
}

importer::Packages ReadPackages(const std::vector<std::string>& words) {
  importer::Packages packages;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == 0 || equals == std::string::npos || equals + 1 == word.size()) {
      throw ConfigError("error: --package takes NAME=DIR, not '" + word + "'");
    }
    packages[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return packages;
}

void PrintLines(const char* title, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  std::printf("%s\n", title);
  for (const std::string& line : lines) std::printf("  %s\n", line.c_str());
}

int Import(ImportArguments arguments) {
  importer::ImportOptions& options = arguments.options;
  if (!options.name.empty() && !IsPlainWord(options.name)) {
    throw ConfigError("error: --name must be " + std::string(kPlainWordRule));
  }
  options.has_meshes = !arguments.has_no_meshes;
  options.packages = ReadPackages(arguments.packages);
  CheckFolder(options.folder, arguments.may_replace);
  const importer::ImportReport report = importer::ImportRobot(options);
  PrintLines("done", report.done);
  PrintLines("found", report.found);
  PrintLines("to decide", report.to_decide);
  std::printf("written\n");
  for (const std::string& file : report.files) {
    std::printf("  %s\n", (options.folder / file).c_str());
  }
  return kExitPass;
}

}  // namespace

void AddRobotsImportCommand(CLI::App& robots, int& exit_code) {
  CLI::App* command = robots.add_subcommand("import", "Make a robot of a maker's URDF or MJCF");
  const auto arguments = std::make_shared<ImportArguments>();
  importer::ImportOptions& options = arguments->options;
  command->add_option("FILE", options.source, "The URDF or MJCF, as it is")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("-o,--out", options.folder, "Folder for the robot and its scenarios")
      ->required()
      ->type_name("DIR");
  command->add_option("--name", options.name, "What to call it (default: the source's name)");
  command
      ->add_option("--package", arguments->packages,
                   "Where a package:// of the meshes lies; repeatable")
      ->type_name("NAME=DIR")
      ->take_all()
      ->allow_extra_args(false);
  command->add_option("--mode", options.mode, "What drives its joints")
      ->check(CLI::IsMember({"position", "torque"}))
      ->default_str("position");
  command->add_flag("--no-meshes", arguments->has_no_meshes, "Draw it with its collision shapes");
  command->add_flag("--force", arguments->may_replace, "Replace what an import wrote there before");
  command->callback([arguments, &exit_code] { exit_code = Import(*arguments); });
}

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/restore_robot.h"

#include <stdlib.h>

#include <map>
#include <string>

#include "models/import/embedded_robot.h"
#include "models/import/write_file.h"
#include "models/import/write_scenarios.h"
#include "models/robot_description/robot_faults.h"
#include "models/support/config_error.h"
#include "models/support/require.h"
#include "models/support/xml_bounds.h"

namespace sidestep::importer {
namespace {

constexpr char kOtherwise[] = "take the last <custom> out of it to import what the MJCF tells";

/// A folder for the time in which it is not sure that the files are good.
class TrialFolder {
 public:
  TrialFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "sidestep_XXXXXX").string();
    const char* made = mkdtemp(pattern.data());
    SIDESTEP_REQUIRE(made != nullptr, pattern);
    path_ = made;
  }
  ~TrialFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TrialFolder(const TrialFolder&) = delete;
  TrialFolder& operator=(const TrialFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Flags of what a restored robot does not go by.
std::string Refused(const ImportOptions& options) {
  std::string flags;
  const auto add = [&](bool is_given, const char* flag) {
    if (is_given) flags += (flags.empty() ? "" : ", ") + std::string(flag);
  };
  add(!options.name.empty(), "--name");
  add(!options.mode.empty(), "--mode");
  add(!options.packages.empty(), "--package");
  add(!options.has_meshes, "--no-meshes");
  return flags;
}

/// The files of the robot and its scenarios, once they have been read as a robot.
std::map<std::string, std::string> Sound(const RobotFiles& files, const std::string& source) {
  const TrialFolder folder;
  std::map<std::string, std::string> texts;
  for (const auto& [name, text] : files) {
    WriteFile(folder.path() / name, text);
    texts[name] = text;
  }
  try {
    texts.merge(ScenariosOf(ReadSoundRobot(folder.path() / files.front().first)));
  } catch (const ConfigError& error) {
    std::string what = error.messages().front();
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at; (at = what.find(prefix)) != std::string::npos;) {
      what.erase(at, prefix.size());
    }
    throw ConfigError(source + ": error: carries a robot that can't be restored (" + what + "); " +
                      kOtherwise);
  }
  return texts;
}

}  // namespace

std::optional<ImportReport> RestoreRobot(const ImportOptions& options) {
  const std::optional<RobotFiles> files = RobotFilesIn(ReadXmlText(options.source));
  if (!files) return std::nullopt;
  const std::string source = options.source.string();
  const std::string flags = Refused(options);
  if (!flags.empty()) {
    throw ConfigError(source + ": error: carries the robot that it was exported from, which is " +
                      "restored as it was: leave out " + flags + ", or " + kOtherwise);
  }
  ImportReport report;
  report.done.push_back("restored the robot that the MJCF was exported from, as it was");
  const std::map<std::string, std::string> texts = Sound(*files, source);
  std::filesystem::create_directories(options.folder);
  for (const auto& [name, text] : texts) {
    WriteFile(options.folder / name, text);
    report.files.push_back(name);
  }
  return report;
}

}  // namespace sidestep::importer

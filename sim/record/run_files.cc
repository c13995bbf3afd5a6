// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/run_files.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <system_error>

#include "sim/record/output_file.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHead = "sidestep-run-files 1";

bool StaysInside(const fs::path& name) {
  if (name.empty() || name.is_absolute() || !name.has_filename()) return false;
  return std::none_of(name.begin(), name.end(),
                      [](const fs::path& part) { return part == ".." || part == "."; });
}

// Whether every folder from `run_dir` down to the file is one, and no link.
bool IsReachedWithoutLinks(const fs::path& run_dir, const fs::path& name) {
  fs::path folder = run_dir;
  std::error_code ignored;
  for (const fs::path& part : name.parent_path()) {
    folder /= part;
    if (!fs::is_directory(fs::symlink_status(folder, ignored))) return false;
  }
  return true;
}

}  // namespace

std::vector<std::string> ListedRunFiles(const fs::path& run_dir) {
  std::ifstream in(run_dir / kRunFilesName);
  std::vector<std::string> names;
  std::string line;
  if (!std::getline(in, line) || line != kHead) return names;
  while (std::getline(in, line)) {
    if (StaysInside(line)) names.push_back(line);
  }
  return names;
}

void ListRunFiles(const fs::path& run_dir, const std::vector<std::string>& names) {
  const std::vector<std::string> before = ListedRunFiles(run_dir);
  const std::set<std::string> known(before.begin(), before.end());
  const fs::path file = run_dir / kRunFilesName;
  std::string text;
  for (const std::string& name : names) {
    if (known.count(name) == 0) text += name + "\n";
  }
  if (text.empty()) return;
  std::error_code ignored;
  const bool is_new = !fs::exists(file) || fs::file_size(file, ignored) == 0;
  errno = 0;
  std::ofstream out(file, std::ios::app | std::ios::binary);
  out << (is_new ? std::string(kHead) + "\n" : "") << text << std::flush;
  if (!out) FailToWrite(file);
}

void ListIfInRun(const fs::path& run_dir, const fs::path& file) {
  std::error_code ignored;  // a folder that is not there is none
  if (!fs::equivalent(fs::absolute(file).parent_path(), run_dir, ignored)) return;
  ListRunFiles(run_dir, {file.filename().string()});
}

void RemoveListedRunFiles(const fs::path& run_dir) {
  std::error_code ignored;
  std::set<fs::path> folders;
  for (const fs::path name : ListedRunFiles(run_dir)) {
    if (!IsReachedWithoutLinks(run_dir, name)) continue;
    if (fs::is_regular_file(fs::symlink_status(run_dir / name, ignored))) {
      fs::remove(run_dir / name);
    }
    if (name.has_parent_path()) folders.insert(run_dir / name.parent_path());
  }
  for (const fs::path& folder : folders) {
    if (fs::is_directory(fs::symlink_status(folder, ignored)) && fs::is_empty(folder)) {
      fs::remove(folder);
    }
  }
  fs::remove(run_dir / kRunFilesName, ignored);
}

}  // namespace sidestep

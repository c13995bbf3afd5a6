// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/data_folder.h"

#include <cstdlib>
#include <system_error>

namespace sidestep {
namespace {

namespace fs = std::filesystem;

/// Folder of the running program's file; the root folder if the system doesn't tell.
fs::path ProgramFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path("/") : program.parent_path();
}

}  // namespace

fs::path DataFolder() {
  const char* from_environment = std::getenv("SIDESTEP_DATA_DIR");
  if (from_environment != nullptr && *from_environment != '\0') return from_environment;
  for (const fs::path& place :
       {(ProgramFolder() / "../share/sidestep").lexically_normal(), fs::path(SIDESTEP_SOURCE_TREE),
        fs::path("/usr/local/share/sidestep")}) {
    std::error_code ignored;
    if (fs::is_directory(place / "models", ignored)) return place;
  }
  return "/usr/share/sidestep";
}

}  // namespace sidestep

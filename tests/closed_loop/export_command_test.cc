// SPDX-License-Identifier: BSD-3-Clause
// `export` as the shell sees it where there is no room for what it writes.

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>

#include "sim/process/process.h"
#include "tests/support/run_files.h"
#include "tests/support/sidestep_program.h"
#include "tests/support/temp_folder.h"

namespace sidestep::export_command_test {
namespace {

namespace fs = std::filesystem;

// `sidestep export` that may write files of so many KiB and no larger, as on a disk that gets full.
ProcessResult ExportInto(std::uintmax_t room_KiB, const fs::path& run, const fs::path& file) {
  return RunProcess({"bash", "-c", "trap '' XFSZ; ulimit -f $0; exec \"$@\"",
                     std::to_string(room_KiB), SIDESTEP_BINARY, "export", run, "-o", file,
                     "--force"});
}

TEST(ExportCommandTest, WhereThereIsNoRoomItSaysSoInALineAndKeepsTheOlderFile) {
  const TempFolder folder;
  const fs::path scenario = folder.Write(
      "s.yaml",
      "sidestep: 1\nname: standing\nrobot: hopper\nduration_s: 0.5\nexpect: {fall: false}\n");
  const fs::path run = folder.path() / "run";
  ASSERT_EQ(Sidestep({"run", scenario, "-o", run, "--no-plots", "--no-video", "-q"}).exit_code, 0);
  for (const char* name : {"out.mat", "out.csv"}) {
    const fs::path file = folder.path() / "to" / name;
    folder.Write(std::string("to/") + name, "");
    ASSERT_EQ(Sidestep({"export", run, "-o", file, "--force"}).exit_code, 0);
    const std::uintmax_t whole_KiB = fs::file_size(file) / 1024 + 1;
    // HDF5 fails at other places, and other functions of its, the more it has written.
    for (const std::uintmax_t room_KiB : {std::uintmax_t{1}, whole_KiB / 3, whole_KiB - 1}) {
      folder.Write(std::string("to/") + name, "older");
      const ProcessResult result = ExportInto(room_KiB, run, file);
      EXPECT_EQ(result.exit_code, 2) << room_KiB << " KiB";
      EXPECT_EQ(result.err, file.string() + ": error: can't be written: File too large\n");
      EXPECT_EQ(result.out, "");
      EXPECT_EQ(TextOf(file), "older");
    }
    EXPECT_EQ(ExportInto(whole_KiB, run, file).exit_code, 0);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "to"), {}), 2) << "no halves";
}

}  // namespace
}  // namespace sidestep::export_command_test

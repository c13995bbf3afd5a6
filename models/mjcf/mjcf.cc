// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf.h"

#include <array>
#include <cstring>
#include <fstream>
#include <sstream>
#include <vector>

#include "models/support/config_error.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

constexpr char kMainFile[] = "world.xml";
constexpr char kRobotFile[] = "robot.xml";

struct VfsDeleter {
  void operator()(mjVFS* vfs) const {
    mj_deleteVFS(vfs);
    delete vfs;
  }
};

void AddFile(mjVFS* vfs, const char* name, const std::string& text) {
  const int size = static_cast<int>(text.size());
  SIDESTEP_REQUIRE(mj_makeEmptyFileVFS(vfs, name, size) == 0, name);
  const int index = mj_findFileVFS(vfs, name);
  SIDESTEP_REQUIRE(index >= 0, name);
  std::memcpy(vfs->filedata[index], text.data(), text.size());
}

}  // namespace

MjModelPtr CompileMjcf(const std::string& xml, const std::string& robot_xml,
                       const std::filesystem::path& source) {
  std::unique_ptr<mjVFS, VfsDeleter> vfs(new mjVFS);  // megabytes: never on the stack
  mj_defaultVFS(vfs.get());
  AddFile(vfs.get(), kMainFile, xml);
  if (!robot_xml.empty()) AddFile(vfs.get(), kRobotFile, robot_xml);
  std::array<char, 1000> message{};
  MjModelPtr model(
      mj_loadXML(kMainFile, vfs.get(), message.data(), static_cast<int>(message.size())));
  if (!model) throw ConfigError(std::vector{source.string() + ": error: " + message.data()});
  return model;
}

MjDataPtr MakeData(const mjModel& model) {
  MjDataPtr data(mj_makeData(&model));
  SIDESTEP_REQUIRE(data != nullptr, "no memory for mjData");
  return data;
}

std::string ReadTextFile(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (!stream || !(text << stream.rdbuf())) {
    throw ConfigError(file.string() + ": error: can't be read");
  }
  return text.str();
}

int RequireId(const mjModel& model, mjtObj type, const std::string& name) {
  const int id = mj_name2id(&model, type, name.c_str());
  if (id < 0) {
    throw ConfigError("error: the robot's MJCF has no " + std::string(mju_type2Str(type)) +
                      " called '" + name + "'");
  }
  return id;
}

}  // namespace sidestep

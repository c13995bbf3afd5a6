// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf: owning pointers to MuJoCo's structures and compilation of MJCF text.

#include <mujoco/mujoco.h>

#include <filesystem>
#include <memory>
#include <string>

namespace sidestep {

/// MuJoCo frees what it allocated; delete would not.
struct MjModelDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct MjDataDeleter {
  void operator()(mjData* data) const { mj_deleteData(data); }
};
using MjModelPtr = std::unique_ptr<mjModel, MjModelDeleter>;
using MjDataPtr = std::unique_ptr<mjData, MjDataDeleter>;

/// Compiles `xml`, a complete MJCF document. An `<include file="robot.xml"/>` in it stands for the
/// text `robot_xml` (pass "" where there is none).
/// Throws ConfigError naming `source` with MuJoCo's message if it does not compile.
MjModelPtr CompileMjcf(const std::string& xml, const std::string& robot_xml,
                       const std::filesystem::path& source);

/// New state of `model`, at its reference configuration. Throws ContractViolation without memory.
MjDataPtr MakeData(const mjModel& model);

/// Whole text of a file. Throws ConfigError if it can't be read.
std::string ReadTextFile(const std::filesystem::path& file);

/// Id of the object of `type` called `name`. Throws ConfigError naming it if the model lacks it:
/// ids are resolved once, in constructors, because an unknown name would read out of bounds.
int RequireId(const mjModel& model, mjtObj type, const std::string& name);

}  // namespace sidestep

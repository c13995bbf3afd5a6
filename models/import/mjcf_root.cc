// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_root.h"

#include <string>
#include <vector>

#include "models/import/text.h"

namespace sidestep::importer {

int RootBody(const mjModel& model, Notes* notes) {
  int root = -1;
  std::vector<std::string> others;
  for (int body = 1; body < model.nbody; ++body) {
    if (model.body_parentid[body] != 0) continue;
    bool has_hinges = false;
    for (int joint = 0; joint < model.njnt; ++joint) {
      const bool is_own = model.jnt_bodyid[joint] == body;
      has_hinges = has_hinges || (model.body_rootid[model.jnt_bodyid[joint]] == body && !is_own);
    }
    if (has_hinges && (root < 0 || model.body_subtreemass[body] > model.body_subtreemass[root])) {
      root = body;
    }
    const char* name = mj_id2name(&model, mjOBJ_BODY, body);
    others.emplace_back(name == nullptr ? "unnamed" : name);
  }
  if (root >= 0 && others.size() > 1) {
    const char* name = mj_id2name(&model, mjOBJ_BODY, root);
    std::erase(others, name == nullptr ? "unnamed" : name);
    notes->push_back("left out what else is in the world: " + Listed(others));
  }
  return root;
}

}  // namespace sidestep::importer

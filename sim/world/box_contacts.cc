// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/box_contacts.h"

#include <mujoco/mujoco.h>

#include <algorithm>

namespace sidestep {
namespace {

/// MuJoCo's own, whatever its table of functions says by then.
mjfCollision MuJoCosBoxBox() {
  static const mjfCollision box_box = mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX];
  return box_box;
}

/// Least extent of a box (m).
mjtNum Thickness_m(const mjModel& model, int geom) {
  const mjtNum* half_m = model.geom_size + 3 * geom;
  return 2.0 * std::min({half_m[0], half_m[1], half_m[2]});
}

int PossibleBoxContacts(const mjModel* model, const mjData* data, mjContact* contacts, int geom1,
                        int geom2, mjtNum margin) {
  const int found = MuJoCosBoxBox()(model, data, contacts, geom1, geom2, margin);
  const mjtNum deepest_m = std::min(Thickness_m(*model, geom1), Thickness_m(*model, geom2));
  mjContact* const end = std::remove_if(contacts, contacts + found, [&](const mjContact& contact) {
    return contact.dist < -deepest_m;
  });
  return static_cast<int>(end - contacts);
}

}  // namespace

void DropImpossibleBoxContacts() {
  MuJoCosBoxBox();
  mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX] = PossibleBoxContacts;
}

}  // namespace sidestep

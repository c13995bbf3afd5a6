// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// box_contacts: keeps MuJoCo's contacts between two boxes to those that can be.

namespace sidestep {

/// From now on, in this process, contacts of two boxes that are deeper than the thinner box is
/// thick are dropped; the others stay as they are.
///
/// MuJoCo 2.2.2 finds such where an edge of one box lies over a face of the other, parallel to its
/// sides, as the foot of a robot in a plane does over a slab of the ground: beside the true points
/// comes one at the slab's far end, as deep as the slab is long. Measured, for a foot of 20 cm on a
/// slab of 100 m: 196 of 200000 poses, dist = -99.89 m, and never one without its true points.
/// Calling it again changes nothing. Not to be called while a simulation runs in another thread.
void DropImpossibleBoxContacts();

}  // namespace sidestep

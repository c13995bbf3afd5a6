// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// data_folder: where the files that ship with the program are: models/ and scenarios/.
//
// The program finds them wherever it was put, and whatever folder it is started from:
//   1. SIDESTEP_DATA_DIR, if the environment sets it;
//   2. share/sidestep beside the bin/ that holds the running program (an installed program);
//   3. the source tree the program was built from, if it is still there (a program not installed);
//   4. /usr/local/share/sidestep, /usr/share/sidestep (a program of one's own that links the
//      installed libraries).

#include <filesystem>

namespace sidestep {

/// The folder that holds models/ and scenarios/: the first of the places above that has a models/.
/// What the environment names is taken as it is, even if nothing is there; so is the last place, if
/// none has one.
std::filesystem::path DataFolder();

}  // namespace sidestep

# Writes FILE, the body of sim/record/git_commit.h, if the commit that SOURCE_DIR stands at is another
# than the file tells: cmake -D SOURCE_DIR=... -D FILE=... -P git_commit.cmake
set(commit "")
if(EXISTS ${SOURCE_DIR}/.git)  # else a git around the sources would answer
  execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12 --exclude=*
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(NOT commit MATCHES "^[0-9a-f]+(-dirty)?$")
  set(commit unknown)
endif()
file(CONFIGURE OUTPUT ${FILE} CONTENT [[
// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/git_commit.h"

namespace sidestep {

const char* GitCommit() { return "@commit@"; }

}  // namespace sidestep
]] @ONLY)

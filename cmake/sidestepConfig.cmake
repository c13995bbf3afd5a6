# find_package(sidestep): target sidestep::sidestep has every library of Sidestep, what they need and
# the folder of the headers, so that `#include "controller/types/sensor_frame.h"` works.
# Variable sidestep_DATA_DIR is the folder of the models and scenarios that ship. A program finds them
# by itself under the prefixes /usr and /usr/local, or beside its own bin/; elsewhere, set
# SIDESTEP_DATA_DIR in its environment.
include("${CMAKE_CURRENT_LIST_DIR}/dependencies.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/sidestepTargets.cmake")

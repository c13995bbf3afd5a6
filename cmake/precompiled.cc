// SPDX-License-Identifier: BSD-3-Clause
// Gives the precompiled headers of cmake/targets.cmake a target to belong to.

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// report_style: how the page looks, in light and in dark.

namespace sidestep::report {

/// The page's CSS. Refers to no other file or font.
const char* StyleSheet();

}  // namespace sidestep::report

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// nearest_name: what a user probably meant by a name that nobody knows.

#include <span>
#include <string>
#include <string_view>

namespace sidestep {

/// The candidate with the fewest insertions, deletions, substitutions and swaps of neighbours
/// from `name`; the first of equals. Empty if none is nearer than about a third of the name.
std::string NearestName(std::string_view name, std::span<const std::string> candidates);

/// "did you mean 'x'?", or "<kind>: a, b, c" when nothing is near.
std::string DidYouMean(std::string_view name, std::span<const std::string> candidates,
                       std::string_view kind);

}  // namespace sidestep

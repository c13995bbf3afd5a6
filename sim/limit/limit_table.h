// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// limit_table: limits as people and programs read them.

#include <optional>
#include <string>
#include <vector>

#include "sim/limit/push_limit.h"

namespace sidestep::limit {

/// A point of the robot that is pushed instead of its CoM.
struct PushedPart {
  std::string name;
  double height_ratio{1.0};  ///< Its height over the CoM's, above the ground.
};

/// Limits and what they are of.
struct LimitTable {
  std::string subject;  ///< What the user named.
  LimitTask task;
  double push_s{0.0};
  /// By moment and direction, of a push at the CoM that lasts push_s: impulse over mass (N s/kg).
  std::vector<std::vector<double>> limits;
  std::optional<PushedPart> part;
};

/// Runs `task`. A hop's limits stay those of an instant push, whatever `push_s`: what a longer one
/// is worth depends on how much of it falls into flights.
LimitTable MakeLimitTable(const std::string& subject, const LimitTask& task, double push_s,
                          const std::optional<PushedPart>& part);

/// Shares of a CoM's limit that a push at `part` has. A push off the CoM's height z_C turns the
/// robot. If the feet bear the spin, m z_C a = m g (x - p) + F z, and its force F counts z / z_C;
/// if the body keeps it, F counts as at the CoM.
struct PartShares {
  double least;
  double most;
};
PartShares SharesOf(const PushedPart& part);

/// For a terminal: what was assumed, a row a moment, a column a direction (degrees), least and
/// mean.
std::string LimitText(const LimitTable& table);

/// For programs: a row a moment and direction. README.md names the columns.
std::string LimitCsv(const LimitTable& table);

}  // namespace sidestep::limit

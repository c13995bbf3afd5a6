// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/limit_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <string_view>

#include "models/support/config_node.h"
#include "models/support/gravity.h"

namespace sidestep::limit {
namespace {

constexpr std::size_t kLineWidth = 100;

std::string Printed(const char* format, double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), format, value);
  return text.data();
}

std::string Fixed(double value, int width, int digits) {
  return Printed(("%" + std::to_string(width) + "." + std::to_string(digits) + "f").c_str(), value);
}

std::string Padded(const std::string& text, std::size_t width, bool to_the_right = false) {
  const std::size_t gap = width - std::min(width, text.size());
  return to_the_right ? std::string(gap, ' ') + text : text + std::string(gap, ' ');
}

struct Spread {
  double least{std::numeric_limits<double>::infinity()};
  double mean{0.0};
};

Spread SpreadOf(const std::vector<double>& values) {
  Spread spread;
  for (const double value : values) {
    spread.least = std::min(spread.least, value);
    spread.mean += value / static_cast<double>(values.size());
  }
  return spread;
}

std::vector<double> AllOf(const LimitTable& table) {
  std::vector<double> all;
  for (const auto& row : table.limits) all.insert(all.end(), row.begin(), row.end());
  return all;
}

/// Impulse over the weight times 1 / omega: how tall a robot is plays no part.
double Dimensionless(const LimitTable& table, double limit_Ns_per_kg) {
  return limit_Ns_per_kg * table.task.params.omega_per_s / kGravity_mps2;
}

/// Whether limits of `task` depend on the parameter of that key.
bool Counts(const LimitTask& task, std::string_view key) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> keys) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  const bool is_of_hop = is_one_of({"stance_s", "flight_s"});
  if (task.gait == GaitType::kHop) {
    return is_of_hop || is_one_of({"omega_per_s", "reach_m", "swing_speed_mps"});
  }
  const bool is_sideways = is_one_of({"sole_half_width_m", "cop_inset_m", "step_width_m",
                                      "nearest_m", "farthest_m", "crossing_m"});
  return !is_of_hop && !(task.is_planar && is_sideways);
}

/// `key=value` of every parameter that counts, for the lines of the header.
class ParamWords {
 public:
  explicit ParamWords(const LimitTask& task) : task_(task) {}

  void operator()(const char* key, const double& value, Range /*range*/, Meaning /*meaning*/) {
    if (!Counts(task_, key)) return;
    words_.push_back(std::string(key) + "=" + Printed("%.4g", value));
  }

  std::string Wrapped() const {
    std::string text;
    std::size_t column = kLineWidth;
    for (const std::string& word : words_) {
      const bool is_full = column + 1 + word.size() > kLineWidth;
      text += is_full ? (text.empty() ? "  " : "\n  ") + word : " " + word;
      column = is_full ? 2 + word.size() : column + 1 + word.size();
    }
    return text + "\n";
  }

 private:
  const LimitTask& task_;
  std::vector<std::string> words_;
};

std::string Header(const LimitTable& table) {
  const LimitTask& task = table.task;
  ParamWords words(task);
  LimitParams::VisitFields(task.params, words);
  const bool is_hop = task.gait == GaitType::kHop;
  return table.subject + ": " + std::string(EnumName(task.gait)) + ", steps " +
         std::string(EnumName(task.freedom)) + ", push of " +
         (is_hop || table.push_s == 0.0 ? "an instant" : NumberText(table.push_s) + " s") +
         " at the CoM, impulse over mass (N s/kg)\n" + words.Wrapped();
}

std::string DirectionsLine(const LimitTable& table, std::size_t name_width) {
  std::string line = Padded("push at", name_width) + "   time_s";
  for (const double direction_rad : table.task.directions_rad) {
    const double degrees = direction_rad * 180.0 / std::numbers::pi;
    line += Padded(Printed("%.4g", degrees), 6, true);
  }
  return line + "     min  mean\n";
}

std::string Rows(const LimitTable& table, std::size_t name_width) {
  std::string text;
  for (std::size_t i = 0; i < table.limits.size(); ++i) {
    const PushMoment& moment = table.task.moments[i];
    text += Padded(moment.name, name_width) + Fixed(moment.time_s, 9, 3);
    for (const double limit : table.limits[i]) text += Fixed(limit, 6, 2);
    const Spread spread = SpreadOf(table.limits[i]);
    text += Fixed(spread.least, 8, 2) + Fixed(spread.mean, 6, 2) + "\n";
  }
  return text;
}

std::string PartLine(const LimitTable& table, const Spread& all) {
  if (!table.part) return {};
  const auto [least, most] = SharesOf(*table.part);
  return "pushed at " + table.part->name + " (" + Printed("%.2f", table.part->height_ratio) +
         " of the CoM's height): between " + Printed("%.2f", least) + " and " +
         Printed("%.2f", most) + " of these, min" + Fixed(least * all.least, 5, 2) + " to" +
         Fixed(most * all.least, 5, 2) + ", mean" + Fixed(least * all.mean, 5, 2) + " to" +
         Fixed(most * all.mean, 5, 2) + "\n";
}

}  // namespace

LimitTable MakeLimitTable(const std::string& subject, const LimitTask& task, double push_s,
                          const std::optional<PushedPart>& part) {
  LimitTable table{subject, task, push_s, LargestVelocitySteps(task), part};
  if (task.gait == GaitType::kHop) return table;
  const double factor = HeldPushFactor(task.params.omega_per_s, push_s);
  for (auto& row : table.limits) {
    for (double& limit : row) limit *= factor;
  }
  return table;
}

PartShares SharesOf(const PushedPart& part) {
  const double borne = 1.0 / part.height_ratio;
  return {std::min(1.0, borne), std::max(1.0, borne)};
}

std::string LimitText(const LimitTable& table) {
  std::size_t name_width = 7;
  for (const PushMoment& moment : table.task.moments) {
    name_width = std::max(name_width, moment.name.size());
  }
  const Spread all = SpreadOf(AllOf(table));
  return Header(table) + DirectionsLine(table, name_width) + Rows(table, name_width) + "all: min" +
         Fixed(all.least, 5, 2) + ", mean" + Fixed(all.mean, 5, 2) +
         " N s/kg; over m g / omega: min" + Fixed(Dimensionless(table, all.least), 6, 3) +
         ", mean" + Fixed(Dimensionless(table, all.mean), 6, 3) + "\n" + PartLine(table, all);
}

std::string LimitCsv(const LimitTable& table) {
  std::string text = "moment,time_s,direction_rad,limit_Ns_per_kg,limit_ratio";
  text += table.part ? ",part_least_Ns_per_kg,part_most_Ns_per_kg\n" : "\n";
  for (std::size_t i = 0; i < table.limits.size(); ++i) {
    const PushMoment& moment = table.task.moments[i];
    for (std::size_t j = 0; j < table.limits[i].size(); ++j) {
      const double limit = table.limits[i][j];
      text += moment.name + "," + Printed("%.4f", moment.time_s) + "," +
              Printed("%.5f", table.task.directions_rad[j]) + "," + Printed("%.4f", limit) + "," +
              Printed("%.4f", Dimensionless(table, limit));
      if (table.part) {
        const auto [least, most] = SharesOf(*table.part);
        text += "," + Printed("%.4f", least * limit) + "," + Printed("%.4f", most * limit);
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace sidestep::limit

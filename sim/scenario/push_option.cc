// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/push_option.h"

#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <regex>

#include "models/support/config_node.h"
#include "models/support/parse_number.h"

namespace sidestep {
namespace {

constexpr std::size_t kMaxPushText = 200;  // std::regex recurses over its text

constexpr char kForm[] =
    "must read BODY SIZE@DIRECTION START+DURATION: 'r_hand 60N@90deg 9.5s+1s'; sizes in N, mg or "
    "Ns/kg, directions in deg or rad, a start by phase: 'mid_swing:left>5s'";

void AddScalar(const char* key, const std::string& text, ConfigTree* map) {
  if (text.empty()) return;
  ConfigTree value;
  value.kind = ConfigKind::kScalar;
  value.place = map->place;
  value.scalar = text;
  map->keys.push_back({key, map->place});
  map->children.push_back(std::move(value));
}

std::string Radians(const std::string& number, const std::string& unit, const ConfigPlace& place) {
  if (unit == "rad") return number;
  const std::optional<double> angle_deg = ParseAs<double>(number);
  if (!angle_deg) FailAt(place, kForm);
  return NumberText(*angle_deg * std::numbers::pi / 180.0);
}

const char* SizeKey(const std::string& unit) {
  if (unit == "N") return "magnitude_N";
  return unit == "mg" ? "magnitude_mg" : "impulse_Nspkg";
}

ConfigTree PushOf(const std::string& text, const ConfigPlace& place) {
  static const std::regex kPush(
      "\\s*(\\S+)\\s+([0-9.eE-]+)(N|mg|Ns/kg)@(-?[0-9.]+)(deg|rad)\\s+"
      "(?:([0-9.]+)s|([a-z_]+)(?::([a-z]+))?(?:>([0-9.]+)s)?)\\+([0-9.]+)s\\s*");
  std::smatch part;
  if (text.size() > kMaxPushText || !std::regex_match(text, part, kPush)) FailAt(place, kForm);
  ConfigTree push;
  push.kind = ConfigKind::kMap;
  push.place = place;
  AddScalar("body", part[1], &push);
  AddScalar(SizeKey(part[3]), part[2], &push);
  AddScalar("direction_rad", Radians(part[4], part[5], place), &push);
  AddScalar("start_s", part[6], &push);
  AddScalar("at_phase", part[7], &push);
  AddScalar("foot", part[8], &push);
  AddScalar("after_s", part[9], &push);
  AddScalar("duration_s", part[10], &push);
  return push;
}

}  // namespace

void AddPush(const std::string& text, ConfigTree* root) {
  const ConfigSource source{"--push '" + text + "'", false};
  const ConfigPlace place{std::make_shared<const ConfigSource>(source), 1, 1};
  ConfigTree push = PushOf(text, place);
  ConfigTree* pushes = root->Find("pushes");
  if (pushes == nullptr) {
    ConfigTree list;
    list.kind = ConfigKind::kList;
    list.place = place;
    list.children.push_back(std::move(push));
    root->keys.push_back({"pushes", place});
    root->children.push_back(std::move(list));
    return;
  }
  if (pushes->kind != ConfigKind::kList) FailAt(pushes->place, "pushes must be a list");
  pushes->children.push_back(std::move(push));
}

}  // namespace sidestep

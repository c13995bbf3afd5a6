// SPDX-License-Identifier: BSD-3-Clause
#include "sim/report/report_style.h"

#include <array>
#include <string>

#include "sim/palette/palette.h"

namespace sidestep::report {
namespace {

constexpr char kRules[] = R"(
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
main { max-width: 1120px; margin: 0 auto; padding: 28px 20px 60px; }
article + article { margin-top: 56px; padding-top: 28px; border-top: 2px solid var(--line); }
h1, h2 { margin: 0 0 8px; font-size: 1.65rem; line-height: 1.25; }
h3 { margin: 0 0 10px; font-size: 1.02rem; }
header p { margin: 0 0 8px; color: var(--soft); }
article > h3 { margin: 28px 0 10px; }
a { color: inherit; }
.badge { display: inline-block; padding: 2px 12px; border-radius: 6px; color: #fff;
  font-size: .62em; font-weight: 700; letter-spacing: .04em; vertical-align: .18em; }
td .badge { font-size: .8em; vertical-align: 0; }
.PASS { background: var(--pass); } .FAIL { background: var(--fail); }
.INVALID { background: var(--other); }
.met { color: var(--met); font-weight: 600; } .missed { color: var(--missed); font-weight: 700; }
.reasons { margin: 4px 0 12px; padding: 10px 14px 10px 30px; background: var(--card);
  border: 1px solid var(--line); border-left: 4px solid var(--fail); border-radius: 6px; }
video { display: block; width: 100%; max-width: 800px; margin: 16px auto; border-radius: 10px;
  background: #000; }
.cards { display: grid; gap: 16px; margin: 18px 0; grid-template-columns: minmax(0, 1fr); }
.arrow { width: 1.5em; height: 1.5em; vertical-align: middle; }
details { margin-top: 12px; }
details > *:not(summary) { margin-top: 12px; }
@media (max-width: 600px) { main { padding: 14px 10px 40px; } h1, h2 { font-size: 1.3rem; }
  .card, figure, details, .command { padding: 10px 10px; border-radius: 8px; }
  figure { overflow-x: auto; } figure svg { min-width: 560px; } }
.card, figure, details, .command { background: var(--card); border: 1px solid var(--line);
  border-radius: 10px; padding: 16px 18px; margin: 0; }
.plots { display: grid; gap: 16px; }
figure svg { display: block; width: 100%; height: auto; }
.scroll { overflow-x: auto; }
table { width: 100%; border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: 6px 10px 6px 0; text-align: left; vertical-align: top;
  border-bottom: 1px solid var(--line); }
thead th { color: var(--soft); font-size: .86em; font-weight: 600; }
tbody th { font-weight: 500; }
tbody tr:last-child > * { border-bottom: 0; }
code, pre { font-family: ui-monospace, "DejaVu Sans Mono", monospace; font-size: .9em; }
.command { margin-bottom: 12px; overflow-x: auto; }
summary { cursor: pointer; font-weight: 600; }
pre { overflow-x: auto; margin: 12px 0 0; }
@media print { body { background: #fff; } video { display: none; } }
)";

// A variable of the style sheet and its colour.
struct Variable {
  const char* name;
  palette::Shades shades;
};
constexpr std::array<Variable, 10> kVariables{{{"page", palette::kGround},
                                               {"card", palette::kCard},
                                               {"ink", palette::kInk},
                                               {"soft", palette::kSoftInk},
                                               {"line", palette::kRule},
                                               {"pass", palette::kPass},
                                               {"fail", palette::kFail},
                                               {"other", palette::kInvalid},
                                               {"met", palette::kMet},
                                               {"missed", palette::kMissed}}};

std::string WholeSheet() {
  std::string light, dark;
  for (const Variable& variable : kVariables) {
    const std::string start = std::string(" --") + variable.name + ": ";
    light += start + variable.shades.light + ";";
    dark += start + variable.shades.dark + ";";
  }
  return "\n:root { color-scheme: light dark;" + light +
         " }\n@media (prefers-color-scheme: dark) { :root {" + dark + " } }" + kRules;
}

}  // namespace

const char* StyleSheet() {
  static const std::string kSheet = WholeSheet();
  return kSheet.c_str();
}

}  // namespace sidestep::report

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/map_page.h"

#include <algorithm>
#include <cmath>

#include "sim/map/pictures.h"
#include "sim/report/html.h"
#include "sim/report/report_style.h"

namespace sidestep::map {
namespace {

using report::Escaped;

constexpr std::size_t kMostSheets = 3000;  // cells that can be chosen; beyond that a page is slow

const char* PageStyles() {
  return R"(
.polars { display: grid; gap: 16px;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, max(300px,
  (100% - 48px) / var(--across))), 1fr)); }
.polars figure { padding: 10px; }
.polars svg { width: 100% !important; min-width: 0; max-width: 420px; margin: 0 auto; }
.wide { margin-top: 16px; }
.wide svg { max-width: none; }
.legend { margin-top: 16px; }
.legend svg { min-width: 0; max-width: 100%; }
svg a { cursor: pointer; }
svg a:hover, svg a:focus { opacity: .75; outline: none; }
h2 { margin-top: 34px; font-size: 1.25rem; }
.note { color: var(--soft); max-width: 75ch; }
.sheet { display: none; position: fixed; left: 0; right: 0; bottom: 0; z-index: 2;
  max-height: 70vh; overflow-y: auto; background: var(--card); padding: 14px 20px 20px;
  border-top: 3px solid var(--ink); box-shadow: 0 -6px 24px rgba(0,0,0,.28); }
.sheet:target { display: block; }
.sheet > div { max-width: 1080px; margin: 0 auto; }
.sheet h3 { padding-right: 80px; }
.close { float: right; font-weight: 600; padding: 4px 8px; }
.sheet pre { user-select: all; white-space: pre-wrap; overflow-wrap: anywhere;
  margin: 4px 0 10px; padding: 8px 10px; border: 1px solid var(--line); border-radius: 6px;
  background: var(--page); }
.evidence { display: grid; gap: 10px; margin: 8px 0 14px;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 300px), 1fr)); }
.evidence img, .evidence video { display: block; width: 100%; border-radius: 6px; }
.evidence img { background: #fff; aspect-ratio: 10 / 7; }
td, tbody th { white-space: nowrap; }
@media print { .sheet { position: static; } }
)";
}

std::string FigureElement(const Drawing& drawing, const std::string& label, const char* style) {
  return "<figure class=\"" + std::string(style) + "\">" +
         (std::string(style) == "wide" ? "<div class=\"scroll\">" : "") +
         SvgElement(drawing, label) + (std::string(style) == "wide" ? "</div>" : "") +
         "</figure>\n";
}

std::string CellLink(const SweepMap& map, const MapCell& cell, const std::string& text) {
  const auto number = static_cast<std::size_t>(&cell - map.cells.data());
  return "<a href=\"#" + CellAnchor(number) + "\">" + Escaped(text) + "</a>";
}

std::string WorstLink(const SweepMap& map, const ControllerFigures& figures) {
  if (figures.worst == nullptr) return "-";
  const std::string place = PlaceWords(map, *figures.worst);
  return CellLink(map, *figures.worst, place.empty() ? "the only one" : place);
}

std::string FiguresTable(const SweepMap& map) {
  std::vector<std::string> headings{"controller", "runs", "recovered", "lost", "INVALID"};
  const char* unit = map.has_limits ? " (N s/kg)" : " (share)";
  for (const char* name : {"minimum", "mean", "maximum"}) {
    headings.push_back(std::string(name) + unit);
  }
  if (map.has_limits) {
    headings.insert(headings.end(), {"J\u03c9/(m g) minimum", "J\u03c9/(m g) mean",
                                     "area ((N s/kg)\u00b2)", "of the pendulum"});
  }
  headings.emplace_back("worst cell");
  std::vector<std::vector<std::string>> rows;
  for (const ControllerFigures& one : FiguresOf(map)) {
    std::vector<std::string> row{Escaped(one.controller),       std::to_string(one.runs),
                                 std::to_string(one.recovered), std::to_string(one.lost),
                                 std::to_string(one.invalid),   ShortFigure(one.least),
                                 ShortFigure(one.mean),         ShortFigure(one.most)};
    if (map.has_limits) {
      const double percent = std::round(100.0 * one.physical_share);
      row.insert(row.end(), {ShortFigure(Dimensionless(map, one.least)),
                             ShortFigure(Dimensionless(map, one.mean)), ShortFigure(one.area),
                             std::isnan(percent) ? "-" : ShortFigure(percent) + " %"});
    }
    row.push_back(WorstLink(map, one));
    rows.push_back(row);
  }
  return report::Table(headings, rows);
}

// Where the worst cells' runs are to be seen.
std::string EvidenceLinks(const SweepMap& map) {
  std::string links;
  for (const MapCell& cell : map.cells) {
    if (!cell.evidence) continue;
    const std::string what = map.controllers[cell.controller] + ": " + PlaceWords(map, cell);
    links += "<li>" + CellLink(map, cell, what) + "</li>\n";
  }
  return links.empty() ? ""
                       : "<h2>Worst cells, with plots and video</h2>\n<ul>" + links + "</ul>\n";
}

std::string Pictures(const SweepMap& map) {
  std::string html = FigureElement(LegendPicture(map), "What the marks mean", "legend");
  if (!IsPolar(map)) {
    return html + "<h2>Tested strengths</h2>\n" +
           FigureElement(StripPicture(map), "Strengths tested in every cell", "wide");
  }
  html += "<h2>By direction</h2>\n<div class=\"polars\" style=\"--across:" +
          std::to_string(std::clamp<std::size_t>(map.controllers.size(), 2, 3)) + "\">\n";
  for (std::size_t panel = 0; panel < map.panels.size(); ++panel) {
    for (std::size_t i = 0; i < map.controllers.size(); ++i) {
      html += FigureElement(
          PolarPicture(map, i, panel),
          "Impulse over mass by direction, " + map.controllers[i] + " " + map.panels[panel],
          "polar");
    }
  }
  html += "</div>\n<h2>Direction by phase</h2>\n";
  for (std::size_t i = 0; i < map.controllers.size(); ++i) {
    html += FigureElement(HeatPicture(map, i),
                          "Limits by phase and direction, " + map.controllers[i], "wide");
  }
  if (map.controllers.size() < 2) return html;
  html += "<h2>Difference</h2>\n";
  for (std::size_t i = 1; i < map.controllers.size(); ++i) {
    html += FigureElement(DifferencePicture(map, i),
                          map.controllers[0] + " less " + map.controllers[i], "wide");
  }
  return html +
         "<p class=\"note\">Bold where the brackets are apart: one survived all that the other was "
         "lost at. In brackets where they overlap, and nothing is decided.</p>\n";
}

std::string Notes(const SweepMap& map) {
  std::string html = "<p class=\"note\">";
  if (map.has_limits) {
    html +=
        "A limit is a bracket: up to its lower end everything that was tried recovered, at its "
        "upper "
        "end a run was lost. Survival need not fall with strength, so nothing is said of what lies "
        "between tested points, and no line joins them. Figures are lower ends; an area is of "
        "sectors around the tested directions. J\u03c9/(m g) compares small and tall robots. ";
  }
  html += "The limit under the map: " + Escaped(map.physics_note) + ".";
  if (!map.physics_note.starts_with("none")) {
    html +=
        " It is an upper bound with this robot's soles, reach, swing speed and shortest times, for "
        "a "
        "robot that foresees the push and turns neither trunk nor arms (infinite-step capture "
        "after "
        "Koolen et al. 2012, with a choice of times); <code>sidestep limit</code> has its "
        "figures. Measured beyond it: the robot did what a pendulum can't. Directions are the "
        "robot's own: 0 ahead, 90 degrees to its left; a step of the right foot is mirrored.";
  }
  return html + "</p>\n";
}

std::string CellsTable(const SweepMap& map) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < std::min(kMostSheets, map.cells.size()); ++i) {
    const MapCell& cell = map.cells[i];
    const CellLimit limit = LimitOf(cell);
    std::string place = PlaceWords(map, cell);
    std::string reasons;
    for (const MapPoint& point : cell.points) {
      const bool is_culprit = point.impulse_Nspkg == limit.lost || std::isnan(limit.share);
      if (is_culprit && reasons.empty()) reasons = point.reasons;
    }
    rows.push_back(
        {CellLink(map, cell, map.controllers[cell.controller]), Escaped(place),
         ShortFigure(limit.survived), std::isinf(limit.lost) ? "-" : ShortFigure(limit.lost),
         std::isnan(limit.share) ? "-" : ShortFigure(100.0 * limit.share) + " %",
         ShortFigure(cell.physical_Nspkg), Escaped(reasons.substr(0, reasons.find(';')))});
  }
  const bool are_all = rows.size() == map.cells.size();
  return "<details><summary>" + std::string(are_all ? "All " : "The first ") +
         std::to_string(rows.size()) + " cells" + (are_all ? "" : "; the rest is in rays.csv") +
         "</summary>\n" +
         report::Table({"controller", "cell", "survived (N s/kg)", "lost at (N s/kg)",
                        "runs recovered", "pendulum (N s/kg)", "lost by"},
                       rows) +
         "</details>\n";
}

const char* SurvivalWord(Survival survival) {
  if (survival == Survival::kSurvived) return "recovered";
  return survival == Survival::kLost ? "lost" : "INVALID";
}

std::string EvidenceElement(const CellEvidence& evidence) {
  const std::string folder = Escaped(evidence.folder) + "/";
  std::string html = "<div>the smallest push that was lost, <a href=\"" + folder +
                     "report.html\">the run's report</a>";
  if (!evidence.note.empty()) html += "; " + Escaped(evidence.note);
  html += ":</div>\n<div class=\"evidence\">";
  if (evidence.has_video) {
    html += "<video controls preload=\"metadata\" src=\"" + folder + "video.mp4\"></video>";
  }
  for (const std::string& plot : evidence.plots) {
    const std::string file = folder + Escaped(plot);
    html += "<a href=\"" + file + "\"><img loading=\"lazy\" src=\"" + file + "\" alt=\"" +
            Escaped(plot) + "\"></a>";
  }
  return html + "</div>\n";
}

// What a chosen cell shows.
std::string CellSheet(const SweepMap& map, std::size_t number,
                      const std::vector<std::string>& kept) {
  const MapCell& cell = map.cells[number];
  std::string html = "<section class=\"sheet\" id=\"" + CellAnchor(number) +
                     "\"><div><a class=\"close\" href=\"#none\">close</a><h3>" +
                     Escaped(map.controllers[cell.controller]) + ": " +
                     Escaped(PlaceWords(map, cell)) + "</h3>\n<p>" + Escaped(LimitWords(map, cell));
  if (std::isfinite(cell.physical_Nspkg)) {
    html += "; the pendulum: " + ShortFigure(cell.physical_Nspkg);
  }
  html += "</p>\n";
  for (const auto& [what, command] : cell.commands) {
    html += "<div>" + Escaped(what) + ":</div><pre>" + Escaped(command) + "</pre>\n";
  }
  if (cell.evidence) html += EvidenceElement(*cell.evidence);
  std::vector<std::vector<std::string>> rows;
  for (const MapPoint& point : cell.points) {
    std::string run;
    const std::string folder = "runs/ray_" + std::to_string(point.ray);
    if (std::find(kept.begin(), kept.end(), folder) != kept.end()) {
      run = "<a href=\"" + Escaped(folder) + "\">kept</a>";
    }
    rows.push_back({ShortFigure(point.impulse_Nspkg), SurvivalWord(point.survival()),
                    std::to_string(point.recovered) + " of " +
                        std::to_string(point.recovered + point.lost + point.invalid),
                    run, Escaped(point.reasons)});
  }
  return html + report::Table({"N s/kg", "", "recovered", "run", "reasons"}, rows) +
         "</div></section>\n";
}

}  // namespace

std::string MapPage(const SweepMap& map, const std::vector<std::string>& kept) {
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
      Escaped(map.name) + ": map of survivable pushes</title>\n<style>" + report::StyleSheet() +
      RoleStyles() + PageStyles() + "</style>\n</head>\n<body>\n<main>\n<header><h1>" +
      Escaped(map.name) +
      "</h1>\n<p>Pushes survived, by impulse over mass (N s/kg). Choose a cell for the "
      "command that repeats it.</p></header>\n<div class=\"card\">" +
      FiguresTable(map) + "</div>\n" + Pictures(map) + EvidenceLinks(map) + Notes(map) +
      CellsTable(map);
  page += "</main>\n";
  for (std::size_t i = 0; i < std::min(kMostSheets, map.cells.size()); ++i) {
    page += CellSheet(map, i, kept);
  }
  return page + "</body>\n</html>\n";
}

}  // namespace sidestep::map

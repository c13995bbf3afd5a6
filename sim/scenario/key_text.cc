// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/key_text.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "controller/types/field.h"
#include "models/support/config_node.h"
#include "sim/scenario/key_table.h"
#include "sim/verdict/metrics.h"

namespace sidestep {
namespace {

using Row = std::vector<std::string>;

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string RangeText(const KeyInfo& key) {
  if (key.kind == KeyKind::kChoice) return Joined(key.choices);
  if (key.kind == KeyKind::kBool) return "true, false";
  if (!key.min) return "";
  const bool is_list = key.kind == KeyKind::kVector || key.kind == KeyKind::kPixelSize;
  std::string text = is_list ? "each " : "";
  text += key.excludes_min ? "above " : "";
  text += NumberText(*key.min);
  text += key.max ? " to " + NumberText(*key.max) : " and more";
  return text + (key.choices.empty() ? "" : ", or " + Joined(key.choices));
}

std::string DefaultText(const KeyInfo& key) {
  return key.is_required ? "required" : key.default_value;
}

Row RowOf(const std::string& path, const KeyInfo& key) {
  return {path, std::string(UnitOf(key.name)), RangeText(key), DefaultText(key), key.meaning};
}

/// Calls act(path, key) for `key` and all below it, parents first; not for the root.
template <typename Act>
void ForEachKey(const std::string& path, const KeyInfo& key, Act&& act) {
  if (!path.empty()) act(path, key);
  for (const KeyInfo& child : key.children) ForEachKey(KeyPath(path, key, child), child, act);
}

/// Path of `key`, which lies in `root`, as KeyPath spells it.
std::string PathTo(const KeyInfo& root, const KeyInfo& wanted) {
  std::string found;
  ForEachKey("", root, [&](const std::string& path, const KeyInfo& key) {
    if (&key == &wanted) found = path;
  });
  return found;
}

/// Columns as wide as their longest cell; the last one as it is.
std::string Aligned(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      text += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    }
    text += row.back() + "\n";
  }
  return text;
}

std::string MarkdownRow(const Row& row) {
  std::string text = "|";
  for (const std::string& cell : row) text += (cell.empty() ? " " : " " + cell + " ") + "|";
  return text + "\n";
}

std::string MarkdownHead(const Row& titles) {
  return MarkdownRow(titles) + MarkdownRow(Row(titles.size(), "---"));
}

/// The keys of a map that hold values, then the maps in it.
std::string MapMarkdown(const std::string& path, const KeyInfo& map) {
  std::string text;
  for (const KeyInfo& key : map.children) {
    if (key.has_children()) continue;
    if (text.empty()) text = MarkdownHead({"key", "unit", "range", "default", "meaning"});
    text += MarkdownRow(RowOf("`" + KeyPath(path, map, key) + "`", key));
  }
  if (!path.empty()) text = "### `" + path + "`\n" + map.meaning + "\n\n" + text;
  for (const KeyInfo& key : map.children) {
    if (!key.has_children()) continue;
    text += (text.ends_with("\n\n") || text.empty() ? "" : "\n");
    text += MapMarkdown(KeyPath(path, map, key), key);
  }
  return text;
}

}  // namespace

std::string KeysText(const std::string& prefix) {
  const KeyInfo root = ScenarioKeys();
  const KeyInfo& key = FindKey(root, prefix);
  std::vector<Row> rows{{"KEY", "UNIT", "RANGE", "DEFAULT", "MEANING"}};
  ForEachKey(PathTo(root, key), key, [&](const std::string& path, const KeyInfo& each) {
    rows.push_back(RowOf(path, each));
  });
  return Aligned(rows);
}

std::string KeysMarkdown(const std::string& prefix) {
  const KeyInfo root = ScenarioKeys();
  const KeyInfo& key = FindKey(root, prefix);
  const std::string path = PathTo(root, key);
  if (key.has_children()) return MapMarkdown(path, key);
  return MarkdownHead({"key", "unit", "range", "default", "meaning"}) +
         MarkdownRow(RowOf("`" + path + "`", key));
}

std::string MetricsText() {
  std::vector<Row> rows{{"METRIC", "UNIT", "MEANING"}};
  for (const MetricInfo& metric : KnownMetrics()) {
    rows.push_back(
        {std::string(metric.name), std::string(metric.unit), std::string(metric.meaning)});
  }
  return Aligned(rows);
}

std::string MetricsMarkdown() {
  std::string text = MarkdownHead({"metric", "unit", "meaning"});
  for (const MetricInfo& metric : KnownMetrics()) {
    text += MarkdownRow({"`" + std::string(metric.name) + "`", std::string(metric.unit),
                         std::string(metric.meaning)});
  }
  return text;
}

}  // namespace sidestep

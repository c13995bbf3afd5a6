// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/config_text.h"
#include "models/support/plain_line.h"

namespace sidestep {
namespace {

constexpr std::size_t kMaxDepth = 32;   // Our files need 5; functions recurse over the tree.
constexpr std::size_t kMaxKeys = 1000;  // Of one map; keys are looked for one after the other.

/// Builds a ConfigTree from yaml-cpp's parse events.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::shared_ptr<const ConfigSource> source) : source_(std::move(source)) {}

  void OnDocumentStart(const YAML::Mark& /*mark*/) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    ConfigTree tree;
    tree.place = PlaceOf(mark);
    if (!open_.empty() && open_.back().pending_key) tree.place = open_.back().pending_key->place;
    Add(std::move(tree));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    FailAt(PlaceOf(mark), "aliases ('*name') are not supported; write the value out");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                const std::string& value) override {
    RejectTag(mark, tag);
    ConfigTree tree;
    tree.kind = ConfigKind::kScalar;
    tree.place = PlaceOf(mark);
    tree.scalar = value;
    tree.is_quoted = tag == "!";
    Add(std::move(tree));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {
    Open(ConfigKind::kList, mark, tag);
  }
  void OnSequenceEnd() override { Close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {
    Open(ConfigKind::kMap, mark, tag);
  }
  void OnMapEnd() override { Close(); }

  /// The finished document; empty if there was none.
  std::optional<ConfigTree> root;

 private:
  struct OpenContainer {
    ConfigTree tree;
    std::optional<ConfigKey> pending_key;
  };

  // yaml-cpp counts from 0 and marks what it can't place with -1; editors count from 1.
  ConfigPlace PlaceOf(const YAML::Mark& mark) const {
    return {source_, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1};
  }

  void RejectTag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;  // none, plain, quoted
    FailAt(PlaceOf(mark), "tags ('" + tag + "') are not supported");
  }

  void Open(ConfigKind kind, const YAML::Mark& mark, const std::string& tag) {
    RejectTag(mark, tag);
    if (open_.size() == kMaxDepth) FailAt(PlaceOf(mark), "is nested too deeply");
    OpenContainer container;
    container.tree.kind = kind;
    container.tree.place = PlaceOf(mark);
    open_.push_back(std::move(container));
  }

  void Close() {
    ConfigTree tree = std::move(open_.back().tree);
    open_.pop_back();
    Add(std::move(tree));
  }

  void Add(ConfigTree tree) {
    if (open_.empty()) {
      root = std::move(tree);
      return;
    }
    OpenContainer& parent = open_.back();
    if (parent.tree.kind == ConfigKind::kMap && !parent.pending_key) {
      parent.pending_key = KeyFrom(tree, parent.tree);
      return;
    }
    if (parent.pending_key) {
      parent.tree.keys.push_back(*std::exchange(parent.pending_key, std::nullopt));
    }
    parent.tree.children.push_back(std::move(tree));
  }

  static ConfigKey KeyFrom(const ConfigTree& tree, const ConfigTree& map) {
    if (tree.kind != ConfigKind::kScalar) FailAt(tree.place, "a key must be a word");
    if (map.keys.size() == kMaxKeys) {
      FailAt(tree.place, "is one key too many: a map has at most " + std::to_string(kMaxKeys));
    }
    for (const ConfigKey& key : map.keys) {
      if (key.text != tree.scalar) continue;
      FailAt(tree.place, "key '" + key.text + "' appears twice; first at line " +
                             std::to_string(key.place.line));
    }
    return {tree.scalar, tree.place};
  }

  std::shared_ptr<const ConfigSource> source_;
  std::vector<OpenContainer> open_;
};

}  // namespace

std::string MessageAt(const ConfigPlace& place, std::string_view kind, const std::string& what) {
  const bool is_file = place.source->is_file;
  std::string message = place.source->name;
  if (is_file) message += ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
  message += ": " + std::string(kind) + ": " + what;
  const bool has_column = !is_file && place.column != 1;
  if (has_column) message += " (column " + std::to_string(place.column) + " of the value)";
  return PlainLine(message);
}

void FailAt(const ConfigPlace& place, const std::string& what) {
  throw ConfigError(MessageAt(place, "error", what));
}

const ConfigTree* ConfigTree::Find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].text == key) return &children[i];
  }
  return nullptr;
}

ConfigTree* ConfigTree::Find(std::string_view key) {
  return const_cast<ConfigTree*>(std::as_const(*this).Find(key));  // it is ours to change
}

ConfigTree ParseConfig(const std::string& text, const ConfigSource& source) {
  const auto shared = std::make_shared<const ConfigSource>(source);
  if (const std::optional<TextFault> fault = FindTextFault(text)) {
    FailAt({shared, fault->line, fault->column}, fault->what);
  }
  TreeBuilder builder(shared);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    if (!builder.root || builder.root->kind == ConfigKind::kNull) {
      FailAt({shared, 1, 1}, source.is_file ? "the file is empty" : "the value is empty");
    }
    TreeBuilder second(shared);
    if (parser.HandleNextDocument(second)) {
      FailAt(second.root ? second.root->place : ConfigPlace{shared, 1, 1},
             "a second document begins here; one is expected");
    }
  } catch (const YAML::Exception& error) {
    FailAt({shared, std::max(error.mark.line, 0) + 1, std::max(error.mark.column, 0) + 1},
           "YAML syntax: " + error.msg);
  }
  return std::move(*builder.root);
}

ConfigTree ReadConfigFile(const std::filesystem::path& file) {
  return ParseConfig(ReadConfigText(file), {file.string(), true});
}

bool IsConfigFileWith(const std::string& key, const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return false;
  try {
    return ReadConfigFile(file).Find(key) != nullptr;
  } catch (const ConfigError&) {
    return false;
  }
}

}  // namespace sidestep

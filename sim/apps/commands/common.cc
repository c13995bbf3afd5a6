// SPDX-License-Identifier: BSD-3-Clause
// What several commands share.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

#include "models/support/parse_number.h"
#include "sim/apps/commands/commands.h"
#include "sim/record/git_commit.h"
#include "sim/scenario/push_option.h"

namespace sidestep {
namespace {

// Asks for a finite number that is good, or says what else the text is.
template <typename IsGood>
CLI::Validator FiniteNumber(IsGood is_good, const std::string& complaint) {
  return {[is_good, complaint](std::string& text) {
            const std::optional<double> number = ParseAs<double>(text);
            const bool is_it = number && std::isfinite(*number) && is_good(*number);
            return is_it ? "" : "'" + text + "' " + complaint;
          },
          ""};
}

}  // namespace

void AddSetOption(CLI::App& command, std::vector<std::string>& overrides) {
  command
      .add_option("--set", overrides,
                  "Override a key of the scenario: world.friction=0.4, pushes.0.start_s=2")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
}

void AddOverrideOptions(CLI::App& command, std::vector<std::string>& overrides) {
  AddSetOption(command, overrides);
  // CLI11 hands over options in the order in which they were added: assignments are there by now.
  const auto prepend = [&overrides](const std::vector<std::string>& texts) {
    std::vector<std::string> pushes;
    for (const std::string& text : texts) pushes.push_back(std::string(kPushOption) + text);
    overrides.insert(overrides.begin(), pushes.begin(), pushes.end());
  };
  command
      .add_option_function<std::vector<std::string>>(
          "--push", prepend,
          "Add a push: 'r_hand 60N@90deg 9.5s+1s'; sizes in N, mg, Ns/kg, directions in deg, rad "
          "from the heading, a start by phase: mid_swing:left>5s")
      ->type_name("TEXT")
      ->take_all()
      ->allow_extra_args(false);
}

std::vector<std::string> OverrideWords(const std::vector<std::string>& overrides) {
  std::vector<std::string> words;
  for (const std::string& text : overrides) {
    const bool is_push = text.starts_with(kPushOption);
    words.push_back(is_push ? "--push" : "--set");
    words.push_back(is_push ? text.substr(kPushOption.size()) : text);
  }
  return words;
}

void AddPlotsOption(CLI::App& command, const std::string& help, std::string& plots) {
  CLI::Option* option = command.add_option("--plots", plots, help)
                            ->check(CLI::IsMember({"always", "failed", "never"}))
                            ->capture_default_str();
  command
      .add_flag_callback(
          "--no-plots", [&plots] { plots = "never"; }, "As --plots never")
      ->excludes(option);
}

void AddLogOption(CLI::App& command, LogDetail& detail) {
  command
      .add_option_function<std::string>(
          "--log", [&detail](const std::string& name) { detail = *EnumOfName<LogDetail>(name); },
          "Ticks that a run keeps: full (all, to the last digit), normal (every second one, "
          "rounded "
          "by unit), none (no trajectory.csv, no states.bin)")
      ->check(CLI::IsMember({"full", "normal", "none"}))
      ->default_str(std::string(EnumName(detail)));
}

CLI::Validator TimeInRun() {
  return FiniteNumber([](double time_s) { return time_s >= 0.0; }, "is not a time of a run");
}

CLI::Validator Within(double least, double most) {
  std::ostringstream range;
  range << "is no number from " << least << " to " << most;
  return FiniteNumber([=](double number) { return number >= least && number <= most; },
                      range.str());
}

CLI::Validator AboveZero() {
  return FiniteNumber([](double number) { return number > 0.0; }, "is no number above 0");
}

void RefuseEmptyWords(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() == 0) continue;  // a flag
    option->check([](const std::string& text) { return text.empty() ? "it is empty" : ""; });
  }
  for (CLI::App* command : app.get_subcommands({})) RefuseEmptyWords(*command);
}

void PrintNote(const std::string& note) { std::fprintf(stderr, "%s\n", note.c_str()); }

std::string VersionText() {
  return std::string("sidestep " SIDESTEP_VERSION " (git ") + GitCommit() + ")";
}

std::vector<std::string> CommandWords() {
  std::ifstream in("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, '\0');) words.push_back(word);
  return words;
}

std::filesystem::path ThisProgram() { return std::filesystem::read_symlink("/proc/self/exe"); }

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// commands: the subcommands of `sidestep`, one source file each.
//
// Add...Command() adds a subcommand to the app. When the command line asks for it, it runs while
// the app parses, and leaves the program's exit code in `exit_code`, which must outlive the app.
// A user's mistake leaves as ConfigError, our own as ContractViolation; main catches both.

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/record/log_detail.h"

namespace sidestep {

/// `run SCENARIO`: simulates, then draws the plots and the video and writes the report.
void AddRunCommand(CLI::App& app, int& exit_code);

/// `check PATH...`: runs many scenarios, prints a table, writes JUnit.
void AddCheckCommand(CLI::App& app, int& exit_code);

/// `sweep SWEEP`, and its parts `plan`, `run` and `merge`: many runs of a scenario, as a map.
void AddSweepCommand(CLI::App& app, int& exit_code);

/// `compare A B`: two runs or two maps, told apart in numbers; runs in pictures too.
void AddCompareCommand(CLI::App& app, int& exit_code);

/// `validate PATH...`: reads scenarios and sweeps and says what is wrong with them.
void AddValidateCommand(CLI::App& app, int& exit_code);

/// `render RUN_DIR`, `plot RUN_DIR`, `report RUN_DIR...`: what `run` draws, again.
void AddRenderCommand(CLI::App& app, int& exit_code);
void AddPlotCommand(CLI::App& app, int& exit_code);
void AddReportCommand(CLI::App& app, int& exit_code);

/// `export RUN_DIR -o FILE`: its trajectory for MATLAB and other programs' viewers.
void AddExportCommand(CLI::App& app, int& exit_code);

/// `film RUN_A RUN_B`: two runs side by side.
void AddFilmCommand(CLI::App& app, int& exit_code);

/// `scenarios`: lists the scenarios that ship.
void AddScenariosCommand(CLI::App& app, int& exit_code);

/// `robots [ROBOT]`: lists the robots that ship, or tells of one.
void AddRobotsCommand(CLI::App& app, int& exit_code);

/// `robots import FILE`: makes a robot of a maker's URDF, and scenarios for it.
void AddRobotsImportCommand(CLI::App& robots, int& exit_code);

/// `keys [PREFIX]`, `metrics`, `schema`: what a scenario may say.
void AddKeysCommand(CLI::App& app, int& exit_code);
void AddMetricsCommand(CLI::App& app, int& exit_code);
void AddSchemaCommand(CLI::App& app, int& exit_code);

/// `limit ROBOT|SCENARIO`: the pushes that a linear pendulum with its feet could survive.
void AddLimitCommand(CLI::App& app, int& exit_code);

/// `solve PROBLEM.json`: solves one MPC problem.
void AddSolveCommand(CLI::App& app, int& exit_code);

/// Adds `--set a.b=c`, repeatable; each takes one value, so a path may follow.
void AddSetOption(CLI::App& command, std::vector<std::string>& overrides);

/// Adds --set and `--push TEXT`, repeatable; pushes stand before assignments, which may edit them.
void AddOverrideOptions(CLI::App& command, std::vector<std::string>& overrides);

/// The options' words again, for another process.
std::vector<std::string> OverrideWords(const std::vector<std::string>& overrides);

/// What an option that takes a time of a run (s) asks of it: a number, not negative.
CLI::Validator TimeInRun();

/// What an option asks of a number: from `least` to `most`, or above zero. CLI11's own checks also
/// take nan, and inf as a positive number.
CLI::Validator Within(double least, double most);
CLI::Validator AboveZero();

/// Makes every option and argument of `app` and its subcommands refuse an empty word, which is
/// what a shell makes of "$A_NAME_THAT_WAS_NEVER_SET". Call it when all of them are there.
void RefuseEmptyWords(CLI::App& app);

/// Prints a line to stderr: what a reader notes although nothing is wrong.
void PrintNote(const std::string& note);

/// Adds --plots always|failed|never, with `help`, and --no-plots; both go to `plots`.
void AddPlotsOption(CLI::App& command, const std::string& help, std::string& plots);

/// Adds --log full|normal|none, how much of its ticks a run keeps; it goes to `detail`, whose value
/// now is the default.
void AddLogOption(CLI::App& command, LogDetail& detail);

/// The program's name, version and git commit, in one line.
std::string VersionText();

/// The words of this process's command line, for summary.json.
std::vector<std::string> CommandWords();

/// Path of the program that runs, for starting it again.
std::filesystem::path ThisProgram();

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// outcome: what `check` keeps of one scenario's run: verdict, why, what was measured, how long.

#include <filesystem>
#include <string>
#include <vector>

#include "sim/process/process.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

struct Outcome {
  std::string name;            ///< The scenario's.
  std::filesystem::path file;  ///< The scenario's.
  std::string robot;           ///< As the scenario calls it.
  std::filesystem::path run_dir;
  VerdictClass verdict{VerdictClass::kInvalid};
  std::vector<std::string> reasons;   ///< "FALL at 1.204 s: ..."; empty for PASS.
  std::vector<std::string> measured;  ///< "fall = false", one an expectation, its bounds after it.
  double wall_s{0.0};
  double real_time_factor{0.0};  ///< Simulated over processor time; 0 if unknown.
  std::string error_output;      ///< End of what the process wrote to stderr.
};

/// Reads the outcome of a finished process that ran `name` into `run_dir`.
///
/// The exit code and summary.json must agree. A process that crashed, one whose summary is missing
/// or is no summary, and one that says two things at once, are INVALID with reason ERROR: never a
/// fall, never a pass. Throws nothing on their account.
Outcome ReadOutcome(const std::string& name, const std::filesystem::path& file,
                    const std::filesystem::path& run_dir, const ProcessResult& process,
                    double wall_s);

/// The exit code of a whole check: that of an INVALID run if there is any, else of a FAIL, else 0.
int ExitCodeOf(const std::vector<Outcome>& outcomes);

/// All outcomes as a JSON list, for scripts: name, robot, file, run, verdict, reasons, measured,
/// wall_s.
std::string OutcomesJson(const std::vector<Outcome>& outcomes);

/// The table printed at the end: a row a scenario and a line that counts the verdicts.
std::string OutcomeTable(const std::vector<Outcome>& outcomes, double wall_s);

}  // namespace sidestep

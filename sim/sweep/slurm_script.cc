// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/slurm_script.h"

#include <algorithm>

#include "models/support/config_error.h"
#include "sim/sweep/merge_rows.h"

namespace sidestep {
namespace {

// A hundred shards keep a hundred cores busy, and share what comes before pushes among enough rays.
constexpr int kUsualShards = 100;
constexpr int kSecondsToEnd = 120;  // a cell in progress is given up, so one would do

// One word of a shell, whatever is in it.
std::string Quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
  return text + "'";
}

void CheckOneLine(const std::string& what, const std::string& text) {
  if (text.find_first_of("\n\r") == std::string::npos) return;
  throw ConfigError("sweep slurm: error: " + what + " has a line's end in it");
}

void Check(const SlurmSpec& spec) {
  CheckOneLine("the folder's name", spec.folder.string());
  CheckOneLine("the program's name", spec.program.string());
  for (const std::string& option : spec.options) {
    CheckOneLine("an option of sbatch", option);
    if (option.starts_with("--")) continue;
    throw ConfigError("--sbatch " + option +
                      ": error: must be an option of sbatch, such as "
                      "--sbatch=--time=4:00:00");
  }
}

// sbatch reads these lines with quotes of its own, and `%` stands for numbers of the job.
std::string LogOption(const SlurmSpec& spec, const std::string& name) {
  std::string path;
  for (const char letter : spec.folder.string()) {
    if (letter == '"' || letter == '\\') path += '\\';
    path += letter == '%' ? "%%" : std::string(1, letter);
  }
  return "#SBATCH --output=\"" + path + "/" + name + "\"\n#SBATCH --open-mode=append\n";
}

std::string Head(const std::string& name) {
  return "#!/bin/bash\n#SBATCH --job-name=" + name +
         "\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n#SBATCH --requeue\n";
}

constexpr char kOneThread[] = "export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1\n";

std::string RunWords(const SlurmSpec& spec, const std::string& shard) {
  return Quoted(spec.program) + " sweep run " + Quoted(spec.folder) + " --shard " + shard +
         " --jobs 1 --quiet";
}

std::string ShardOf(const SlurmSpec& spec, const std::string& number) {
  return number + "/" + std::to_string(spec.shards);
}

std::string MergeWords(const SlurmSpec& spec) {
  return Quoted(spec.program) + " sweep merge " + Quoted(spec.folder) + " --shards " +
         std::to_string(spec.shards);
}

// For a shell's list: `{0..6}`, or the numbers.
std::string TaskWords(const SlurmSpec& spec) {
  if (spec.tasks.size() == static_cast<std::size_t>(spec.shards) && spec.shards > 1) {
    return "{0.." + std::to_string(spec.shards - 1) + "}";
  }
  std::string words;
  for (const std::size_t task : spec.tasks)
    words += (words.empty() ? "" : " ") + std::to_string(task);
  return words;
}

}  // namespace

int UsualShards(std::size_t rays, int max_array_size) {
  const std::size_t most = static_cast<std::size_t>(std::min(kUsualShards, max_array_size));
  return static_cast<int>(std::max<std::size_t>(1, std::min(rays, most)));
}

std::string ArrayScript(const SlurmSpec& spec) {
  Check(spec);
  std::string text = Head(spec.name) + "#SBATCH --array=" + ArrayText(spec.tasks);
  if (spec.throttle > 0) text += "%" + std::to_string(spec.throttle);
  text += "\n#SBATCH --signal=B:USR1@" + std::to_string(kSecondsToEnd) + "\n" +
          LogOption(spec, "slurm-%A_%a.log");
  for (const std::string& option : spec.options) text += "#SBATCH " + option + "\n";
  // By exec, so that the signal for the batch shell is the program's.
  return text + kOneThread + "exec " + RunWords(spec, ShardOf(spec, "$SLURM_ARRAY_TASK_ID")) + "\n";
}

std::string MergeScript(const SlurmSpec& spec) {
  Check(spec);
  return Head(spec.name + "-merge") + LogOption(spec, "slurm-%j-merge.log") + kOneThread + "exec " +
         MergeWords(spec) + "\n";
}

std::string SubmitScript(const SlurmSpec& spec) {
  const std::string end = "END_OF_JOB\n";
  return "#!/bin/bash\n"
         "# Sweep " +
         spec.name + " in " + std::to_string(spec.shards) +
         " shards: `bash THIS` submits an array and a job that joins what it has run.\n"
         "# Should the latter tell of shards that are missing: bash THIS --array=3,7\n"
         "# One allocation: srun -n " +
         std::to_string(spec.shards) + " " + RunWords(spec, "auto") +
         "\n# No Slurm: OMP_NUM_THREADS=1 parallel -q " + RunWords(spec, ShardOf(spec, "{}")) +
         " ::: " + TaskWords(spec) + "; " + MergeWords(spec) +
         "\nset -euo pipefail\n"
         "array=\"$(sbatch --parsable \"$@\" <<'END_OF_JOB'\n" +
         ArrayScript(spec) + end +
         ")\"\n"
         "merge=\"$(sbatch --parsable --dependency=\"afterany:${array%%;*}\" <<'END_OF_JOB'\n" +
         MergeScript(spec) + end +
         ")\"\n"
         "echo \"array ${array%%;*}, merge ${merge%%;*}\"\n";
}

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/run_shard.h"

#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "models/support/config_error.h"
#include "models/support/require.h"
#include "sim/process/interrupt.h"
#include "sim/sweep/row_file.h"
#include "sim/sweep/sweep_worker.h"

namespace sidestep {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kPollPeriod_ms = 100;
constexpr int kMostDeathsBetweenRuns = 3;  // such a death is somebody's kill, or a bug of ours

double SecondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class Shard {
 public:
  Shard(const SweepPlan& plan, const std::filesystem::path& folder, const ShardOptions& options,
        const ShardListener& listener)
      : plan_(plan),
        folder_(folder),
        options_(options),
        listener_(listener),
        file_(plan.spec, RowsPath(folder, options.shard, options.shards), listener.note) {
    for (const CellRow& row : file_.rows()) Take(row);
    QueueRays();
  }

  ShardReport Run() {
    const std::size_t jobs = std::min(static_cast<std::size_t>(options_.jobs), queue_.size());
    while (workers_.size() < jobs) StartWorker();
    while (!workers_.empty()) {
      Wait();
      if (InterruptRequested()) TellToEnd();
      HandOut();
    }
    return report_;
  }

 private:
  void Take(const CellRow& row) {
    const std::size_t place = row.cell.ray;
    if (place >= plan_.rays.size() || plan_.rays[place].id != row.id) {
      throw ConfigError(folder_.string() + ": error: a row of ray " + std::to_string(place) +
                        " is of another sweep or program; take another folder");
    }
    report_.invalid += row.outcome == CellOutcome::kInvalid ? 1 : 0;
    rows_.emplace(NameOf(row.cell), row);
  }

  bool IsDone(const Ray& ray) const {
    return WalkRay(plan_.spec, ray,
                   [&](const CellKey& cell) {
                     const auto found = rows_.find(NameOf(cell));
                     return found == rows_.end() ? std::nullopt
                                                 : std::optional(found->second.outcome);
                   })
        .is_complete;
  }

  // Rays that share what comes before their push follow each other, by the time of the push.
  void QueueRays() {
    for (const PlannedRay& planned : plan_.rays) {
      const std::size_t index = planned.ray.index;
      const auto shards = static_cast<std::size_t>(options_.shards);
      if (index % shards != static_cast<std::size_t>(options_.shard)) continue;
      ++report_.rays;
      if (IsDone(planned.ray)) {
        ++report_.rays_done;
      } else {
        queue_.push_back(index);
      }
    }
    std::sort(queue_.begin(), queue_.end(), [&](std::size_t left, std::size_t right) {
      const PlannedRay& a = plan_.rays[left];
      const PlannedRay& b = plan_.rays[right];
      return std::tie(a.prefix, a.start_tick, left) < std::tie(b.prefix, b.start_tick, right);
    });
  }

  void StartWorker() {
    std::vector<SweepWorker*> others;
    for (const Running& one : workers_) others.push_back(one.worker.get());
    workers_.push_back({std::make_unique<SweepWorker>(setup_, &file_, others), Clock::now()});
    HandOutTo(&workers_.back());
  }

  bool MayStartRay() const {
    const bool has_time = SecondsSince(start_) + longest_ray_s_ <= options_.time_budget_s;
    return !queue_.empty() && !report_.was_interrupted && has_time;
  }

  struct Running {
    std::unique_ptr<SweepWorker> worker;
    Clock::time_point ray_start;
  };

  void HandOutTo(Running* one) {
    if (!MayStartRay()) return;
    one->ray_start = Clock::now();
    one->worker->Assign(queue_.front());
    queue_.pop_front();
  }

  // Those without a ray get one, or end.
  void HandOut() {
    for (Running& one : workers_) {
      if (!one.worker->ray) HandOutTo(&one);
    }
    std::erase_if(workers_, [](Running& one) {
      const bool is_idle = !one.worker->ray;
      if (is_idle) one.worker->Finish();
      return is_idle;
    });
  }

  void TellToEnd() {
    if (std::exchange(report_.was_interrupted, true)) return;
    for (const Running& one : workers_) kill(one.worker->pid(), SIGTERM);
  }

  void Wait() {
    std::vector<pollfd> sockets;
    for (const Running& one : workers_) sockets.push_back({one.worker->socket(), POLLIN, 0});
    if (poll(sockets.data(), sockets.size(), kPollPeriod_ms) <= 0) return;
    std::vector<std::size_t> gone;
    for (std::size_t i = 0; i < sockets.size(); ++i) {
      if (sockets[i].revents == 0) continue;
      const auto lines = workers_[i].worker->Read();
      if (!lines) {
        gone.push_back(i);
        continue;
      }
      for (const std::string& line : *lines) Hear(line, &workers_[i]);
    }
    for (auto i = gone.rbegin(); i != gone.rend(); ++i) Bury(*i);
  }

  void Hear(const std::string& line, Running* one) {
    const std::string text = line.substr(1);
    switch (line.at(0)) {
      case 'b':
        one->worker->crash_row = text;
        break;
      case 'r':
        one->worker->crash_row.clear();
        Store(text);
        break;
      case 'd':
        one->worker->ray.reset();
        ++report_.rays_done;
        longest_ray_s_ = std::max(longest_ray_s_, SecondsSince(one->ray_start));
        listener_.progress(report_);
        break;
      case 's':
        one->worker->ray.reset();
        report_.was_interrupted = true;
        break;
      case 'e':
        throw ConfigError(text);
      default:
        throw std::runtime_error("a worker of the sweep failed: " + text);
    }
  }

  void Store(const std::string& line) {
    deaths_between_runs_ = 0;
    file_.Append(line);
    Take(ReadRow(plan_.spec, line, "a worker's row"));
    ++report_.runs;
    listener_.progress(report_);
  }

  // A worker ended by itself: the cell in progress, if any, is told as such, and the ray goes on.
  void Bury(std::size_t number) {
    Running one = std::move(workers_[number]);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(number));
    const int exit_code = one.worker->Finish();
    if (report_.was_interrupted || !one.worker->ray) return;
    const std::string code = std::to_string(exit_code);
    if (!one.worker->crash_row.empty()) {
      listener_.note("note: a run ended its process with exit code " + code +
                     "; its cell is INVALID");
      Store(one.worker->crash_row);
    } else if (++deaths_between_runs_ > kMostDeathsBetweenRuns) {
      throw std::runtime_error("workers of the sweep end between runs, with exit code " + code);
    }
    queue_.push_front(*one.worker->ray);
    StartWorker();
  }

  const SweepPlan& plan_;
  const std::filesystem::path& folder_;
  const ShardOptions& options_;
  const ShardListener& listener_;
  RowFile file_;
  CellRows rows_;
  const WorkerSetup setup_{&plan_, &rows_, folder_, options_.keep};
  ShardReport report_;
  std::deque<std::size_t> queue_;  // indices of rays
  std::vector<Running> workers_;
  Clock::time_point start_{Clock::now()};
  double longest_ray_s_{0.0};
  int deaths_between_runs_{0};  // of workers, since the last row
};

}  // namespace

std::filesystem::path RowsPath(const std::filesystem::path& folder, int shard, int shards) {
  return folder / ("rows-" + std::to_string(shard) + "-of-" + std::to_string(shards) + ".csv");
}

ShardReport RunShard(const SweepPlan& plan, const std::filesystem::path& folder,
                     const ShardOptions& options, const ShardListener& listener) {
  SIDESTEP_REQUIRE(options.shards >= 1 && options.shard >= 0 && options.shard < options.shards,
                   options.shard);
  SIDESTEP_REQUIRE(options.jobs >= 1, options.jobs);
  SIDESTEP_REQUIRE(options.time_budget_s > 0.0, options.time_budget_s);
  return Shard(plan, folder, options, listener).Run();
}

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/curve_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

#include "models/support/require.h"

namespace sidestep::plot {
namespace {

static_assert(std::endian::native == std::endian::little, "curves are little-endian");

constexpr double kTolerance = 1.0 / 2000.0;  // of a panel: 0.3 px of the tallest
constexpr std::size_t kColumns = 1000;       // of pixels, in the widest panel
constexpr std::size_t kSamplesAColumn = 4;
constexpr std::size_t kMostPathSamples = 20000;  // the loops of a long run are drawn as such

bool IsFinite(const Sample& sample) { return std::isfinite(sample.x) && std::isfinite(sample.y); }

// First, lowest, highest and last of each column of pixels, in their order.
std::vector<Sample> ExtremesOfColumns(const std::vector<Sample>& samples) {
  if (samples.size() <= kColumns * kSamplesAColumn) return samples;
  const double x0 = samples.front().x;
  const double column = (samples.back().x - x0) / kColumns;
  std::vector<Sample> kept;
  for (std::size_t i = 0; i < samples.size();) {
    const double end = x0 + column * (std::floor((samples[i].x - x0) / column) + 1.0);
    std::array<std::size_t, kSamplesAColumn> marks{i, i, i, i};
    for (; i < samples.size() && (i == marks[0] || samples[i].x < end); ++i) {
      if (samples[i].y < samples[marks[1]].y) marks[1] = i;
      if (samples[i].y > samples[marks[2]].y) marks[2] = i;
      marks[3] = i;
    }
    std::sort(marks.begin(), marks.end());
    const auto unique_end = std::unique(marks.begin(), marks.end());
    for (auto mark = marks.begin(); mark != unique_end; ++mark) kept.push_back(samples[*mark]);
  }
  return kept;
}

double DistanceToSegment(const Sample& point, const Sample& a, const Sample& b) {
  const double x = b.x - a.x, y = b.y - a.y;
  const double square = x * x + y * y;
  const double along =
      square > 0.0 ? std::clamp(((point.x - a.x) * x + (point.y - a.y) * y) / square, 0.0, 1.0)
                   : 0.0;
  return std::hypot(point.x - a.x - along * x, point.y - a.y - along * y);
}

// Both ends and the farthest along x and y, in their order: what is read off a plot is exact.
std::vector<std::size_t> EndsAndExtremes(const std::vector<Sample>& samples) {
  const auto by_x = [](const Sample& a, const Sample& b) { return a.x < b.x; };
  const auto by_y = [](const Sample& a, const Sample& b) { return a.y < b.y; };
  const auto [left, right] = std::minmax_element(samples.begin(), samples.end(), by_x);
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end(), by_y);
  std::vector<std::size_t> marks{0, samples.size() - 1};
  for (const auto& extreme : {left, right, low, high}) {
    marks.push_back(static_cast<std::size_t>(extreme - samples.begin()));
  }
  std::sort(marks.begin(), marks.end());
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  return marks;
}

// Douglas and Peucker: keeps the sample farthest from a segment until none is far.
std::vector<Sample> KeepCorners(const std::vector<Sample>& samples, double width, double height) {
  if (samples.size() < 3) return samples;
  const auto scaled = [&](std::size_t i) {
    return Sample{width > 0.0 ? samples[i].x / width : 0.0,
                  height > 0.0 ? samples[i].y / height : 0.0};
  };
  std::vector<bool> is_kept(samples.size(), false);
  std::vector<std::pair<std::size_t, std::size_t>> segments;
  const std::vector<std::size_t> marks = EndsAndExtremes(samples);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    is_kept[marks[i]] = true;
    if (i > 0) segments.emplace_back(marks[i - 1], marks[i]);
  }
  while (!segments.empty()) {
    const auto [first, last] = segments.back();
    segments.pop_back();
    double farthest = kTolerance;
    std::size_t corner = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = DistanceToSegment(scaled(i), scaled(first), scaled(last));
      if (distance <= farthest) continue;
      farthest = distance;
      corner = i;
    }
    if (corner == first) continue;
    is_kept[corner] = true;
    segments.emplace_back(first, corner);
    segments.emplace_back(corner, last);
  }
  std::vector<Sample> kept;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (is_kept[i]) kept.push_back(samples[i]);
  }
  return kept;
}

// Every so many-th sample, and the last.
std::vector<Sample> Strided(const std::vector<Sample>& samples) {
  const std::size_t stride = (samples.size() + kMostPathSamples - 1) / kMostPathSamples;
  if (stride <= 1) return samples;
  std::vector<Sample> kept;
  for (std::size_t i = 0; i < samples.size(); i += stride) kept.push_back(samples[i]);
  if ((samples.size() - 1) % stride != 0) kept.push_back(samples.back());
  return kept;
}

// Thins each stretch between gaps on its own; a gap stays one NaN.
template <typename Thin>
std::vector<Sample> ThinStretches(const std::vector<Sample>& samples, Thin thin) {
  Span x, y;
  for (const Sample& sample : samples) {
    if (!IsFinite(sample)) continue;
    x.Include(sample.x);
    y.Include(sample.y);
  }
  std::vector<Sample> kept, stretch;
  const auto close = [&] {
    const std::vector<Sample> corners = KeepCorners(thin(stretch), x.length(), y.length());
    kept.insert(kept.end(), corners.begin(), corners.end());
    stretch.clear();
  };
  for (const Sample& sample : samples) {
    if (IsFinite(sample)) {
      stretch.push_back(sample);
    } else if (!stretch.empty()) {
      close();
      kept.push_back({sample.x, std::numeric_limits<double>::quiet_NaN()});
    }
  }
  close();
  return kept;
}

}  // namespace

void Span::Include(double value) {
  if (!std::isfinite(value)) return;
  min = std::min(min, value);
  max = std::max(max, value);
}

void Span::Include(const Span& other) {
  min = std::min(min, other.min);
  max = std::max(max, other.max);
}

std::vector<Sample> ThinGraph(const std::vector<Sample>& samples) {
  return ThinStretches(samples, ExtremesOfColumns);
}

std::vector<Sample> ThinPath(const std::vector<Sample>& samples) {
  return ThinStretches(samples, Strided);
}

CurveFile::CurveFile(std::string file, std::string prefix)
    : file_(std::move(file)), prefix_(std::move(prefix)) {}

std::string CurveFile::FreeMacro(const std::string& name) const {
  std::string macro = prefix_ + name;
  for (char& c : macro) {
    const bool is_plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!is_plain) c = '_';
  }
  const auto is_taken = [&] {
    return std::any_of(curves_.begin(), curves_.end(),
                       [&](const auto& other) { return other.second.macro == macro; });
  };
  while (is_taken()) macro += '_';
  return macro;
}

void CurveFile::Add(const std::string& name, const std::vector<Sample>& samples) {
  SIDESTEP_REQUIRE(curves_.count(name) == 0, name);
  Curve curve{FreeMacro(name), bytes_.size(), samples.size(), {}, {}};
  for (const Sample& sample : samples) {
    if (IsFinite(sample)) {
      curve.x.Include(sample.x);
      curve.y.Include(sample.y);
    }
    const std::array<float, 2> pair{static_cast<float>(sample.x), static_cast<float>(sample.y)};
    std::array<char, sizeof pair> raw;
    std::memcpy(raw.data(), pair.data(), sizeof pair);
    bytes_.append(raw.data(), raw.size());
  }
  curves_.emplace(name, std::move(curve));
}

const CurveFile::Curve& CurveFile::At(const std::string& name) const {
  const auto found = curves_.find(name);
  SIDESTEP_REQUIRE(found != curves_.end(), name);
  return found->second;
}

std::string CurveFile::Macro(const std::string& name) const { return "@" + At(name).macro; }

std::string CurveFile::Definitions(const std::string& script) const {
  std::string lines;
  for (const auto& [name, curve] : curves_) {
    const std::string macro = "@" + curve.macro;
    const auto is_used = [&](std::size_t at) {
      const std::size_t end = at + macro.size();
      return end == script.size() || script[end] == ' ' || script[end] == '\n';
    };
    std::size_t at = script.find(macro);
    while (at != std::string::npos && !is_used(at)) at = script.find(macro, at + 1);
    if (at == std::string::npos) continue;
    lines += curve.macro + " = \"";
    // gnuplot has no empty block; a curve that is nowhere is drawn as such.
    lines += curve.y.is_empty()
                 ? "NaN"
                 : "'" + file_ + "' binary skip=" + std::to_string(curve.first_byte) +
                       " record=" + std::to_string(curve.records) +
                       " format='%float32%float32' endian=little using 1:2";
    lines += "\"\n";
  }
  return lines;
}

}  // namespace sidestep::plot

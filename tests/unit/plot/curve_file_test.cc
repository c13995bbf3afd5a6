// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/curve_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "models/support/require.h"

namespace sidestep::curve_file_test {
namespace {

using plot::CurveFile;
using plot::Sample;
using plot::ThinGraph;
using plot::ThinPath;

template <typename Value>
std::vector<Sample> Sampled(int count, Value value) {
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double t = i / static_cast<double>(count);
    samples.push_back({t, value(t)});
  }
  return samples;
}

double DrawnAt(const std::vector<Sample>& kept, double x) {
  const auto after = std::lower_bound(
      kept.begin(), kept.end(), x, [](const Sample& sample, double at) { return sample.x < at; });
  if (after == kept.begin()) return after->y;
  const Sample &a = *(after - 1), &b = *after;
  return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

TEST(CurveFileTest, ASmoothCurveIsDrawnByFewSamplesToAFractionOfAPixel) {
  const std::vector<Sample> samples = Sampled(20000, [](double t) { return std::sin(20.0 * t); });
  const std::vector<Sample> kept = ThinGraph(samples);
  EXPECT_LT(kept.size(), 400U);
  for (const Sample& sample : samples) {
    // 1/2000 of width and height across the line is at most this along y where it is steepest.
    EXPECT_NEAR(DrawnAt(kept, sample.x), sample.y, 2.0 / 2000.0 * std::hypot(1.0, 10.0));
  }
}

TEST(CurveFileTest, APeakOfOneSampleIsKept) {
  std::vector<Sample> samples = Sampled(50000, [](double t) { return 0.01 * t; });
  samples[31234].y = 7.0;
  samples[31235].y = -3.0;
  const std::vector<Sample> kept = ThinGraph(samples);
  EXPECT_LT(kept.size(), 100U);
  for (const double peak : {7.0, -3.0}) {
    EXPECT_TRUE(std::any_of(kept.begin(), kept.end(), [peak](const Sample& sample) {
      return sample.y == peak;
    })) << peak;
  }
}

TEST(CurveFileTest, NoiseKeepsTheEnvelopeOfEveryColumnOfPixels) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-1.0, 1.0);
  const std::vector<Sample> samples = Sampled(60000, [&](double) { return noise(random); });
  const std::vector<Sample> kept = ThinGraph(samples);
  EXPECT_LE(kept.size(), 4000U);
  constexpr int kColumns = 900;  // other columns than its own
  const auto envelope = [](const std::vector<Sample>& curve) {
    std::vector<plot::Span> columns(kColumns + 1);
    for (const Sample& sample : curve) {
      columns[static_cast<std::size_t>(sample.x * kColumns)].Include(sample.y);
    }
    return columns;
  };
  const auto all = envelope(samples), drawn = envelope(kept);
  for (std::size_t i = 1; i + 1 < kColumns; ++i) {
    plot::Span
        near;  // what lies on an upright line is drawn by its ends, a fraction of a pixel off
    for (const std::size_t column : {i - 1, i, i + 1}) near.Include(drawn[column]);
    EXPECT_GE(near.max, all[i].max - 0.002);
    EXPECT_LE(near.min, all[i].min + 0.002);
  }
}

TEST(CurveFileTest, AStepStaysUprightAndAGapStaysAGap) {
  std::vector<Sample> samples = Sampled(1000, [](double t) { return t < 0.5 ? 0.0 : 1.0; });
  for (int i = 700; i < 800; ++i) samples[static_cast<std::size_t>(i)].y = std::nan("");
  const std::vector<Sample> kept = ThinGraph(samples);
  ASSERT_EQ(kept.size(), 7U) << "two, two across the step, a gap, two";
  EXPECT_DOUBLE_EQ(kept[2].x - kept[1].x, 0.001);
  EXPECT_EQ(std::count_if(kept.begin(), kept.end(), [](auto& s) { return std::isnan(s.y); }), 1);
}

TEST(CurveFileTest, APathMayTurnBack) {
  const auto square = [](double t) {
    const double side = std::fmod(4.0 * t, 1.0);
    return std::array{Sample{side, 0.0}, Sample{1.0, side}, Sample{1.0 - side, 1.0},
                      Sample{0.0, 1.0 - side}}[static_cast<std::size_t>(4.0 * t)];
  };
  std::vector<Sample> samples;
  for (int i = 0; i < 4000; ++i) samples.push_back(square(i / 4000.0));
  EXPECT_LE(ThinPath(samples).size(), 9U) << "corners, and what lies beside them";
}

TEST(CurveFileTest, ALongPathKeepsItsEnds) {
  for (const int count : {20000, 40000, 45001, 59999}) {  // of none, one and more strides
    std::vector<Sample> samples;
    for (int i = 0; i < count; ++i) samples.push_back({std::cos(0.7 * i), std::sin(0.7 * i)});
    const std::vector<Sample> kept = ThinPath(samples);
    EXPECT_LE(kept.size(), 20001U);
    for (const bool is_last : {false, true}) {
      const Sample &end = is_last ? samples.back() : samples.front(),
                   &drawn = is_last ? kept.back() : kept.front();
      EXPECT_EQ(drawn.x, end.x) << count;
      EXPECT_EQ(drawn.y, end.y) << count;
    }
  }
}

TEST(CurveFileTest, ScriptsReadWhatWasAdded) {
  CurveFile curves;
  curves.Add("first", {{0.0, 1.0}, {1.0, 2.0}});
  curves.Add("second", {{5.0, 6.0}, {7.0, 8.0}, {9.0, 10.0}});
  EXPECT_EQ(curves.Definitions("plot @second with lines\n"),
            "second = \"'curves.bin' binary skip=16 record=3 format='%float32%float32' "
            "endian=little using 1:2\"\n");
  float pair[2] = {};
  std::memcpy(pair, curves.bytes().data() + 24, sizeof pair);
  EXPECT_EQ(pair[0], 7.0F);
  EXPECT_EQ(pair[1], 8.0F);
  EXPECT_DOUBLE_EQ(curves.XOf("second").max, 9.0);
  EXPECT_DOUBLE_EQ(curves.YOf("second").min, 6.0);
}

TEST(CurveFileTest, MacrosAreWordsWhateverACurveIsCalledAndNoTwoAreAlike) {
  CurveFile curves("a.bin", "a_");
  curves.Add("f_`touch PWNED`", {{0.0, 1.0}});
  curves.Add("f_'touch PWNED'", {{0.0, 1.0}});
  EXPECT_EQ(curves.Macro("f_`touch PWNED`"), "@a_f__touch_PWNED_");
  EXPECT_EQ(curves.Macro("f_'touch PWNED'"), "@a_f__touch_PWNED__");
  EXPECT_EQ(curves.Definitions("@a_f__touch_PWNED__ ").find('`'), std::string::npos);
  EXPECT_EQ(curves.Definitions("@a_f__touch_PWNED__ ").find("_ ="), 17U) << "only the longer one";
  EXPECT_THROW(curves.Macro("absent"), ContractViolation);
}

TEST(CurveFileTest, ACurveThatIsNowhereIsDrawnAsSuch) {
  CurveFile curves;
  curves.Add("nothing", {{0.0, std::nan("")}});
  curves.Add("empty", {});
  EXPECT_EQ(curves.Definitions("@nothing "), "nothing = \"NaN\"\n");
  EXPECT_EQ(curves.Definitions("@empty "), "empty = \"NaN\"\n");
  EXPECT_TRUE(curves.YOf("nothing").is_empty());
}

}  // namespace
}  // namespace sidestep::curve_file_test

// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/ground.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace sidestep {
namespace {

/// Every place where a height may change along one axis, from end to end, in order.
std::vector<double> Edges_m(const std::vector<GroundPatch>& ground, double GroundPatch::*from_m,
                            double GroundPatch::*to_m) {
  std::vector<double> edges_m{-kGroundReach_m, kGroundReach_m};
  for (const GroundPatch& patch : ground) {
    edges_m.push_back(patch.*from_m);
    edges_m.push_back(patch.*to_m);
  }
  std::sort(edges_m.begin(), edges_m.end());
  edges_m.erase(std::unique(edges_m.begin(), edges_m.end()), edges_m.end());
  return edges_m;
}

/// One strip across x, cut where its height changes along y.
std::vector<GroundSlab> Strip(const std::vector<GroundPatch>& ground, double from_x_m,
                              double to_x_m, const std::vector<double>& edges_y_m) {
  std::vector<GroundSlab> strip;
  for (std::size_t i = 0; i + 1 < edges_y_m.size(); ++i) {
    const double from_y_m = edges_y_m[i], to_y_m = edges_y_m[i + 1];
    const Eigen::Vector2d middle_W(0.5 * (from_x_m + to_x_m), 0.5 * (from_y_m + to_y_m));
    const double height_m = GroundHeight_m(ground, middle_W);
    if (!strip.empty() && strip.back().height_m == height_m) {
      strip.back().to_y_m = to_y_m;
    } else {
      strip.push_back({from_x_m, to_x_m, from_y_m, to_y_m, height_m});
    }
  }
  return strip;
}

/// Adds `slab`, or makes longer the one that it continues along x.
void Join(const GroundSlab& slab, std::vector<GroundSlab>* slabs) {
  for (GroundSlab& before : *slabs) {
    if (before.to_x_m != slab.from_x_m || before.from_y_m != slab.from_y_m ||
        before.to_y_m != slab.to_y_m || before.height_m != slab.height_m) {
      continue;
    }
    before.to_x_m = slab.to_x_m;
    return;
  }
  slabs->push_back(slab);
}

/// Whether `at`, or what is just before or beyond it, lies between two edges.
bool IsBetween(double at, double from, double to, bool beyond) {
  return beyond ? from <= at && at < to : from < at && at <= to;
}

/// Height next to a place, ahead of it or behind, to its left or right: at an edge the sides
/// differ.
double HeightBeside_m(const std::vector<GroundPatch>& ground, const Eigen::Vector2d& place_W,
                      bool ahead, bool left) {
  for (const GroundPatch& patch : ground) {
    if (IsBetween(place_W.x(), patch.from_x_m, patch.to_x_m, ahead) &&
        IsBetween(place_W.y(), patch.from_y_m, patch.to_y_m, left)) {
      return patch.height_m;
    }
  }
  return 0.0;
}

}  // namespace

double GroundHeight_m(const std::vector<GroundPatch>& ground, const Eigen::Vector2d& place_W) {
  double height_m = -std::numeric_limits<double>::infinity();
  for (const bool ahead : {false, true}) {
    for (const bool left : {false, true}) {
      height_m = std::max(height_m, HeightBeside_m(ground, place_W, ahead, left));
    }
  }
  return height_m;
}

double LowestGround_m(const std::vector<GroundPatch>& ground) {
  double lowest_m = 0.0;
  for (const GroundPatch& patch : ground) lowest_m = std::min(lowest_m, patch.height_m);
  return lowest_m;
}

std::vector<GroundSlab> GroundSlabs(const std::vector<GroundPatch>& ground) {
  const double lowest_m = LowestGround_m(ground);
  const std::vector<double> edges_x_m =
      Edges_m(ground, &GroundPatch::from_x_m, &GroundPatch::to_x_m);
  const std::vector<double> edges_y_m =
      Edges_m(ground, &GroundPatch::from_y_m, &GroundPatch::to_y_m);
  std::vector<GroundSlab> slabs;
  for (std::size_t i = 0; i + 1 < edges_x_m.size(); ++i) {
    for (const GroundSlab& slab : Strip(ground, edges_x_m[i], edges_x_m[i + 1], edges_y_m)) {
      if (slab.height_m > lowest_m) Join(slab, &slabs);
    }
  }
  return slabs;
}

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/feet.h"

#include <algorithm>
#include <cmath>

#include "models/import/fit_shapes.h"
#include "models/import/foot_points.h"
#include "models/import/point_feet.h"
#include "models/import/posture.h"
#include "models/import/text.h"
#include "models/support/config_error.h"

namespace sidestep::importer {
namespace {

constexpr double kLeastLength_m = 0.03;  // less can't hold a centre of pressure against a push
constexpr double kLeastWidth_m = 0.02;
constexpr double kInset_m = 0.005;   // of the vertices from the sole's sides ...
constexpr double kInsetShare = 0.1;  // ... but no more than this share of the side
constexpr double kThickness = 0.1;   // of a sole's box, in its length
constexpr double kUnlevel_rad = 0.002;
constexpr double kSameHeight_m = 5e-4;  // of a frame and the sole that it is of
constexpr double kNearMiddle = 0.2;     // of a sole's length and width, from its middle

class FootMaker {
 public:
  FootMaker(const BodyPlan& plan, std::string file, MeshFiles* meshes, SourceRobot* robot,
            Notes* notes)
      : plan_(plan), file_(std::move(file)), meshes_(*meshes), robot_(*robot), notes_(*notes) {}

  Foot Make(std::size_t side) {
    const int link = plan_.legs[side].end;
    Foot foot = Fit(link);
    const std::string word = side == 0 ? "left" : "right";
    if (foot.sole.length_m < kLeastLength_m || foot.sole.width_m < kLeastWidth_m) {
      throw ConfigError(
          file_ + ": error: the " + word + " foot '" + Link(link).name + "' has no flat sole (" +
          Figure(1e3 * foot.sole.length_m, 2) + " mm x " + Figure(1e3 * foot.sole.width_m, 2) +
          " mm in its " + foot.found_in +
          "): a leg of six joints can't stand on points or edges; give it a <collision> box");
    }
    ReplaceMeshes(link, foot.sole);
    foot.frame = MakersFrameAt(
        robot_, link, foot.sole.X_FS,
        {kNearMiddle * foot.sole.length_m, kNearMiddle * foot.sole.width_m, kSameHeight_m},
        &notes_);
    if (foot.frame < 0) {
      foot.frame = AddFrame(
          UnusedName(robot_, word + "_sole"), link, foot.sole.X_FS,
          "middle of the sole, x forward, z up; fitted to the foot's " + foot.found_in, &robot_);
    }
    foot.force_torque =
        AddFrame(UnusedName(robot_, word + "_foot_ft"), link, Eigen::Isometry3d::Identity(),
                 "six-axis sensor between the foot and the ankle", &robot_);
    foot.vertices_m = X_FrameSole(foot) * Vertices(foot.sole);
    if (foot.sole.tilt_rad > kUnlevel_rad) {
      notes_.push_back("the " + word + " sole is tilted by " + Figure(foot.sole.tilt_rad, 2) +
                       " rad where all joints are at zero");
    }
    return foot;
  }

 private:
  SourceLink& Link(int link) { return robot_.links[static_cast<std::size_t>(link)]; }

  const SourceJoint& JointAbove(int link) const {
    const int joint = robot_.joint_above[static_cast<std::size_t>(link)];
    return robot_.joints[static_cast<std::size_t>(joint)];
  }

  /// The sole in the foot's frame F.
  Eigen::Isometry3d X_FrameSole(const Foot& foot) const {
    return JointAbove(foot.frame).X_PC.inverse() * foot.sole.X_FS;
  }

  /// Tries what collides, then what is looked at, then the inertia.
  Foot Fit(int link) {
    Foot foot;
    for (const auto& [shapes, name] :
         {std::pair<Shapes, const char*>{&SourceLink::collisions, "collision shapes"},
          std::pair<Shapes, const char*>{&SourceLink::visuals, "visual shapes"}}) {
      const Sole sole = FitTo(link, FootPoints(robot_, link, shapes, &meshes_));
      if (sole.length_m * sole.width_m <= foot.sole.length_m * foot.sole.width_m) continue;
      foot.sole = sole;
      foot.found_in = name;
      if (sole.length_m >= kLeastLength_m && sole.width_m >= kLeastWidth_m) return foot;
    }
    if (foot.found_in.empty() && Link(link).has_mass()) {
      std::vector<SurfacePoint> points;  // level where all joints are at zero, as most feet are
      const SourceShape box = BoxOfInertia(Link(link).mass, R_FootSole(link));
      for (const Eigen::Vector3d& p : SurfaceOf(box, nullptr)) points.push_back({p, 0.0});
      foot.sole = FitTo(link, points);
      foot.found_in = "inertia, as it has no shape that could be read";
      foot.is_guessed = true;
    }
    if (foot.found_in.empty()) foot.found_in = "shapes";
    return foot;
  }

  /// Axes of a sole that is level where all joints are at zero, in the foot's frame.
  Eigen::Matrix3d R_FootSole(int link) const {
    const Placement zero(robot_, ZeroPosture(robot_));
    return zero.X_WL(link).linear().transpose() *
           Eigen::AngleAxisd(plan_.facing_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }

  Sole FitTo(int link, const std::vector<SurfacePoint>& points) const {
    const Eigen::Matrix3d R_FS = R_FootSole(link);
    return FitSole(points, R_FS.col(0), R_FS.col(2));
  }

  /// A foot's meshes and points, and a foot without a shape, become one box above the sole.
  void ReplaceMeshes(int foot, const Sole& sole) {
    bool has_shape = false;
    std::vector<std::string> replaced;
    for (const int link : Subtree(robot_, foot)) {
      std::vector<SourceShape>& shapes = Link(link).collisions;
      const std::size_t before = shapes.size();
      std::erase_if(shapes,
                    [](const SourceShape& s) { return s.kind == ShapeKind::kMesh || IsEmpty(s); });
      if (shapes.size() < before) replaced.push_back(Link(link).name);
      has_shape = has_shape || !shapes.empty();
    }
    if (has_shape && replaced.empty()) return;
    SourceShape box;
    const double thickness_m = kThickness * sole.length_m;
    box.size_m << sole.length_m, sole.width_m, thickness_m;
    box.X_LS = sole.X_FS * Eigen::Translation3d(0.0, 0.0, 0.5 * thickness_m);
    box.note = replaced.empty() ? "the foot had no collision shape: its sole as a box"
                                : "its sole, fitted, instead of meshes and points";
    Link(foot).collisions.push_back(box);
    notes_.push_back("'" + Link(foot).name + "' stands on a box of " +
                     Figure(1e3 * sole.length_m, 3) + " mm x " + Figure(1e3 * sole.width_m, 3) +
                     " mm" + (replaced.empty() ? "" : " instead of meshes or points"));
  }

  static Eigen::Matrix3Xd Vertices(const Sole& sole) {
    const double x = 0.5 * sole.length_m - std::min(kInset_m, kInsetShare * sole.length_m);
    const double y = 0.5 * sole.width_m - std::min(kInset_m, kInsetShare * sole.width_m);
    Eigen::Matrix3Xd vertices_m(3, 4);
    vertices_m << x, x, -x, -x, y, -y, -y, y, 0.0, 0.0, 0.0, 0.0;
    return vertices_m;
  }

  const BodyPlan& plan_;
  std::string file_;
  MeshFiles& meshes_;
  SourceRobot& robot_;
  Notes& notes_;
};

}  // namespace

std::array<Foot, 2> MakeFeet(const BodyPlan& plan, const std::string& file, MeshFiles* meshes,
                             SourceRobot* robot, Notes* notes) {
  if (plan.stands_on_points()) return MakePointFeet(plan, file, meshes, robot, notes);
  FootMaker maker(plan, file, meshes, robot, notes);
  Foot left = maker.Make(0);
  return {left, maker.Make(1)};
}

}  // namespace sidestep::importer

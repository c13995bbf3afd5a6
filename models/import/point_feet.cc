// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/point_feet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "models/import/foot_points.h"
#include "models/import/posture.h"
#include "models/import/text.h"
#include "models/support/config_error.h"

namespace sidestep::importer {
namespace {

constexpr double kLeastRadius_m = 0.003;  // less is a needle that the floor's contact can't bear
constexpr double kFlatLength_m = 0.03;    // a foot that is flat over as much is a sole
constexpr double kFlatWidth_m = 0.02;
constexpr double kOffMiddle_m = 5e-4;  // of a maker's frame and the ball that it is of
constexpr double kFacets = 1.1;        // a round foot of a few corners looks narrower than it is
constexpr double kShinShare = 0.75;    // radius of the shin's capsule in the ball's

/// Two axes at right angles to each other and to `up`.
Eigen::Matrix<double, 2, 3> Across(const Eigen::Vector3d& up) {
  const Eigen::Vector3d x = up.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> axes;
  axes << x.transpose(), up.cross(x).transpose();
  return axes;
}

class PointFootMaker {
 public:
  PointFootMaker(const BodyPlan& plan, std::string file, MeshFiles* meshes, SourceRobot* robot,
                 Notes* notes)
      : plan_(plan), file_(std::move(file)), meshes_(*meshes), robot_(*robot), notes_(*notes) {}

  Foot Make(std::size_t side) {
    const int link = plan_.legs[side].end;
    const std::string word = side == 0 ? "left" : "right";
    const Placement zero(robot_, ZeroPosture(robot_));
    const Eigen::Matrix3d R_FW = zero.X_WL(link).linear().transpose();
    const Eigen::Matrix3d R_FS =
        R_FW * Eigen::AngleAxisd(plan_.facing_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    Foot foot;
    const std::vector<SurfacePoint> points = PointsOf(link, word, &foot.found_in);
    RequireNoSole(FitSole(points, R_FS.col(0), R_FS.col(2)), link, word);
    const Ball ball = FitBall(points, R_FS.col(2));
    foot.ball_radius_m = ball.radius_m;
    foot.sole.X_FS.linear() = R_FS;
    foot.sole.X_FS.translation() = ball.p_m;
    Replace(link, ball, R_FS.col(2));
    foot.frame = MakersFrameAt(robot_, link, foot.sole.X_FS,
                               Eigen::Vector3d::Constant(kOffMiddle_m), &notes_);
    if (foot.frame < 0) {
      foot.frame = AddFrame(
          UnusedName(robot_, word + "_ball"), link, foot.sole.X_FS,
          "middle of the ball that touches the ground; fitted to the foot's " + foot.found_in,
          &robot_);
    }
    foot.force_torque =
        AddFrame(UnusedName(robot_, word + "_foot_ft"), link, Eigen::Isometry3d::Identity(),
                 "six-axis sensor between the foot and the last joint", &robot_);
    foot.vertices_m = Eigen::Vector3d::Zero();
    return foot;
  }

 private:
  SourceLink& Link(int link) { return robot_.links[static_cast<std::size_t>(link)]; }

  [[noreturn]] void Fail(int link, const std::string& word, const std::string& what) {
    throw ConfigError(file_ + ": error: the " + word + " foot '" + Link(link).name + "' " + what);
  }

  std::vector<SurfacePoint> PointsOf(int link, const std::string& word, std::string* found_in) {
    for (const auto& [shapes, name] :
         {std::pair<Shapes, const char*>{&SourceLink::collisions, "collision shapes"},
          std::pair<Shapes, const char*>{&SourceLink::visuals, "visual shapes"}}) {
      std::vector<SurfacePoint> points = FootPoints(robot_, link, shapes, &meshes_);
      *found_in = name;
      if (!points.empty()) return points;
    }
    Fail(link, word,
         "has no shape that could be read: give it a <collision> sphere where it touches the "
         "ground (--package NAME=DIR says where meshes lie)");
  }

  void RequireNoSole(const Sole& sole, int link, const std::string& word) {
    if (sole.length_m < kFlatLength_m || sole.width_m < kFlatWidth_m) return;
    Fail(link, word,
         "has a flat sole (" + Figure(1e3 * sole.length_m, 2) + " mm x " +
             Figure(1e3 * sole.width_m, 2) +
             " mm) on a leg of three joints, which can't keep it level: give it a <collision> "
             "sphere, or the leg its ankle");
  }

  /// Meshes, and other shapes that would touch beside the ball, give way to it.
  void Replace(int foot, const Ball& ball, const Eigen::Vector3d& up) {
    bool is_replaced = false, has_ball = false;
    const Placement zero(robot_, ZeroPosture(robot_));
    for (const int link : Subtree(robot_, foot)) {
      const Eigen::Isometry3d X_FL = zero.X_WL(foot).inverse() * zero.X_WL(link);
      const auto gives_way = [&](const SourceShape& shape) {
        if (shape.kind == ShapeKind::kMesh) return true;
        return TouchesBeside(ShapePoints(shape, X_FL, &meshes_), ball, up, &has_ball);
      };
      is_replaced = std::erase_if(Link(link).collisions, gives_way) > 0 || is_replaced;
    }
    if (!has_ball) {
      SourceShape sphere;
      sphere.kind = ShapeKind::kSphere;
      sphere.size_m.x() = ball.radius_m;
      sphere.X_LS.translation() = ball.p_m;
      sphere.note = "the ball that it touches the ground with, fitted";
      Link(foot).collisions.push_back(sphere);
    }
    if (is_replaced) Link(foot).collisions.push_back(Shin(ball));
    if (is_replaced || !has_ball) {
      notes_.push_back("'" + Link(foot).name + "' stands on a ball of " +
                       Figure(1e3 * ball.radius_m, 3) + " mm" +
                       (is_replaced ? " under a capsule, instead of its shapes" : ""));
    }
  }

  /// Whether points reach below the ball's middle and are not the ball itself.
  static bool TouchesBeside(const std::vector<SurfacePoint>& points, const Ball& ball,
                            const Eigen::Vector3d& up, bool* is_ball) {
    bool touches = false;
    for (const SurfacePoint& point : points) {
      const bool is_same = point.radius_m > 0.0 && (point.p_m - ball.p_m).norm() < kOffMiddle_m;
      *is_ball = *is_ball || is_same;
      touches = touches || (!is_same && (point.p_m - ball.p_m).dot(up) < point.radius_m);
    }
    return touches;
  }

  /// From the last joint to the ball's middle: a cylinder longer than wide is a capsule.
  SourceShape Shin(const Ball& ball) const {
    SourceShape shin;
    shin.kind = ShapeKind::kCylinder;
    shin.size_m << kShinShare * ball.radius_m, ball.p_m.norm(), 0.0;
    shin.X_LS.translation() = 0.5 * ball.p_m;
    shin.X_LS.linear() =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), ball.p_m).toRotationMatrix();
    shin.note = "from the last joint to the ball, instead of a mesh";
    return shin;
  }

  const BodyPlan& plan_;
  std::string file_;
  MeshFiles& meshes_;
  SourceRobot& robot_;
  Notes& notes_;
};

}  // namespace

Ball FitBall(const std::vector<SurfacePoint>& points, const Eigen::Vector3d& up) {
  const auto bottom = [&](const SurfacePoint& p) { return p.p_m.dot(up) - p.radius_m; };
  std::vector<SurfacePoint> by_height = points;
  std::sort(by_height.begin(), by_height.end(),
            [&](const SurfacePoint& a, const SurfacePoint& b) { return bottom(a) < bottom(b); });
  const SurfacePoint& lowest = by_height.front();
  if (lowest.radius_m > 0.0) return {lowest.p_m, lowest.radius_m};

  const Eigen::Matrix<double, 2, 3> across = Across(up);
  Eigen::Vector2d least = across * lowest.p_m, most = least;
  double radius_m = kLeastRadius_m;
  for (const SurfacePoint& point : by_height) {
    if (bottom(point) - bottom(lowest) > kFacets * radius_m) break;
    least = least.cwiseMin(across * point.p_m);
    most = most.cwiseMax(across * point.p_m);
    radius_m = std::max(radius_m, 0.5 * (most - least).maxCoeff());
  }
  const Eigen::Vector2d middle = 0.5 * (least + most);
  return {across.transpose() * middle + (bottom(lowest) + radius_m) * up, radius_m};
}

std::array<Foot, 2> MakePointFeet(const BodyPlan& plan, const std::string& file, MeshFiles* meshes,
                                  SourceRobot* robot, Notes* notes) {
  PointFootMaker maker(plan, file, meshes, robot, notes);
  Foot left = maker.Make(0);
  return {left, maker.Make(1)};
}

}  // namespace sidestep::importer

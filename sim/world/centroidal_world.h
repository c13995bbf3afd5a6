// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_world: the plant `centroidal`, a body that is nothing but its centroidal momentum.
//
//   m pddot = m g + sum f_i + push,     hdot = sum (p_i - p) x f_i + moment of the push about p
//
// Source: Romualdi et al. (ICRA 2022), centroidal dynamics. Forces come straight from the
// command, one a foot vertex, and are constant over a tick, so p, v and h are integrated exactly.
// The floor gives no more than it can: a force that pulls is dropped, and the tangential part of
// one outside the circular cone of world.friction is shortened to the cone.
// Feet have no mass. A foot is where the command puts it; contact holds it where it began.
// Pushes act on `com` or at a foot (its name or its frame).

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "models/robot_description/robot_description.h"
#include "sim/scenario/push.h"
#include "sim/scenario/world_params.h"
#include "sim/world/pushes.h"
#include "sim/world/world.h"

namespace sidestep {

/// Nearest thing to `force_N` (in W, z up) that dry friction on level ground can give: zero if it
/// pulls; else the same vertical part, tangential part at most friction times it.
Eigen::Vector3d ClampToFrictionCone(const Eigen::Vector3d& force_N, double friction);

/// Position, velocity (m, m/s) and angular momentum about the CoM (kg m^2/s), in W.
struct CentroidalState {
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d angular_momentum{Eigen::Vector3d::Zero()};
};

/// Constant forces at points fixed in W (3 x n each; N, m), and a wrench that goes with the CoM.
struct CentroidalLoad {
  Eigen::Matrix3Xd force_N;
  Eigen::Matrix3Xd point_W;
  Eigen::Vector3d com_force_N{Eigen::Vector3d::Zero()};
  Eigen::Vector3d com_torque_Nm{Eigen::Vector3d::Zero()};
};

/// State after dt_s under a constant load and gravity: the closed form. Preconditions: mass_kg > 0,
/// force_N and point_W of one shape.
CentroidalState Advance(const CentroidalState& state, const CentroidalLoad& load, double mass_kg,
                        double dt_s);

/// The plant. At the start the feet stand at y = +-start_width_m / 2 (the first foot is the left
/// one; a single foot is at 0) and the CoM rests at com_height_m above their mean.
class CentroidalWorld final : public World {
 public:
  /// @param start_width_m  Between the feet at the start, along y (m).
  /// @param params         Friction, length of a tick and what every mass is multiplied by.
  /// Throws ConfigError if a push names neither `com` nor a foot, or the robot has more than two
  /// feet or no mass.
  CentroidalWorld(const RobotDescription& robot, double start_width_m, const WorldParams& params,
                  const std::vector<Push>& pushes);

  std::unique_ptr<World> Clone() const override { return std::make_unique<CentroidalWorld>(*this); }
  const WorldTruth& truth() const override { return truth_; }
  bool is_valid() const override { return invalid_reason_.empty(); }
  const std::string& invalid_reason() const override { return invalid_reason_; }
  double mass_kg() const override { return mass_kg_; }
  const std::vector<JointInfo>& joints() const override { return joints_; }

  void ReplacePushes(const std::vector<Push>& pushes, Tick tick) override;

  /// Takes one CentroidalFootCommand a foot, force_N of the foot's number of vertices (or empty for
  /// none); no feet at all means no forces. Broken shapes are a ContractViolation.
  void Apply(const ActuatorCommand& command) override;

  void Step(Tick tick) override;

 private:
  /// Forces at the vertices, where the feet are now, and the pushes.
  CentroidalLoad CurrentLoad() const;
  void ResolvePushes(const std::vector<Push>& pushes);
  void UpdatePushes(Tick tick);
  void WriteTruth();

  std::string robot_file_;  // for errors
  std::vector<FootDescription> feet_;
  double mass_kg_;  ///< The robot's times mass_scale.
  double tick_s_;
  double friction_;  ///< Of the circular cone.
  Pushes pushes_;
  std::vector<int> pushed_foot_;                  ///< One a push; -1 for the CoM.
  std::vector<Eigen::Matrix3Xd> vertex_force_N_;  ///< By foot, within the cone.
  std::vector<JointInfo> joints_;                 ///< None.
  CentroidalState state_;
  WorldTruth truth_;
  std::string invalid_reason_;
};

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/import_robot.h"

#include <array>
#include <cmath>
#include <optional>

#include "models/import/clean_up.h"
#include "models/import/imported_robot.h"
#include "models/import/lift_time.h"
#include "models/import/mjcf_couplings.h"
#include "models/import/plain_names.h"
#include "models/import/raise_base.h"
#include "models/import/read_mjcf.h"
#include "models/import/read_source.h"
#include "models/import/replace_meshes.h"
#include "models/import/restore_robot.h"
#include "models/import/self_collision.h"
#include "models/import/text.h"
#include "models/import/weak_ankles.h"
#include "models/import/weak_legs.h"
#include "models/import/write_file.h"
#include "models/import/write_robot_yaml.h"
#include "models/import/write_scenarios.h"
#include "models/import/write_urdf.h"
#include "models/support/gravity.h"
#include "models/support/plain_word.h"

namespace sidestep::importer {
namespace {

// How far the arms hang from the body: the first of these with which they touch nothing.
constexpr std::array<double, 4> kSpreads_rad{0.15, 0.25, 0.4, 0.6};
constexpr double kFeetApart_m = 0.02;  // least gap between the soles

std::string PlainName(const std::string& name) {
  const std::string word = PlainCharactersOf(name);
  return IsPlainWord(word) ? word : "robot";
}

class Import {
 public:
  explicit Import(const ImportOptions& options)
      : options_(options),
        file_(options.source.string()),
        meshes_(options.source, options.packages) {}

  ImportReport Run() {
    const bool is_mjcf = IsMjcf(options_.source);
    if (is_mjcf) {
      if (std::optional<ImportReport> restored = RestoreRobot(options_))
        return *std::move(restored);
    }
    it_.robot = is_mjcf ? ReadMjcf(options_.source, &meshes_, &report_.done)
                        : ReadSource(options_.source, &report_.done);
    it_.source = options_.source.filename().string();
    it_.name = options_.name.empty() ? PlainName(it_.robot.name) : options_.name;
    MakeNamesPlain(&it_.robot, &report_.done);
    Problems problems(file_);
    CleanUp(&it_.robot, &problems, &report_.done);
    problems.ThrowIfAny();
    it_.plan = FindBodyPlan(it_.robot, file_, &report_.done);
    ChooseMode();
    RaiseBase(it_.plan, &it_.robot, &report_.done);
    RefuseCouplings(it_.robot.couplings, it_.plan.Actuated());
    it_.feet = MakeFeet(it_.plan, file_, &meshes_, &it_.robot, &report_.done);
    ReplaceCollisionMeshes(&meshes_, &it_.robot, &report_.done);
    AddTrunkFrames();
    FindStart();
    NameSelfCollision();
    ChooseFigures();
    Tell();
    WriteFiles();
    return std::move(report_);
  }

 private:
  const SourceLink& Link(int link) const { return it_.robot.links[static_cast<std::size_t>(link)]; }

  /// Servos hold a robot on its soles; on points only torques let it fall as a pendulum does.
  void ChooseMode() {
    const bool on_points = it_.plan.stands_on_points();
    it_.mode = !options_.mode.empty() ? options_.mode : on_points ? "torque" : "position";
    if (on_points && it_.mode != "torque") {
      throw ConfigError(file_ +
                        ": error: its legs have three joints each, so it stands on points: "
                        "that works with --mode torque alone");
    }
  }

  /// An IMU where the maker has a frame for one on the trunk, and a torso frame that faces forward.
  void AddTrunkFrames() {
    const Placement zero(it_.robot, ZeroPosture(it_.robot));
    for (const int link : it_.robot.order) {
      const int above = it_.robot.joint_above[static_cast<std::size_t>(link)];
      if (!it_.imu.empty() || above < 0 || Link(link).has_mass()) continue;
      const SourceJoint& joint = it_.robot.joints[static_cast<std::size_t>(above)];
      const bool is_on_trunk = joint.parent == it_.robot.root || joint.parent == it_.plan.torso;
      if (!joint.is_moving() && is_on_trunk && HasWord(Link(link).name, "imu"))
        it_.imu = Link(link).name;
    }
    const auto add = [&](const std::string& name, int link, const std::string& note) {
      Eigen::Isometry3d X_WF = zero.X_WL(link);
      X_WF.linear() =
          Eigen::AngleAxisd(it_.plan.facing_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
      const int frame = AddFrame(UnusedName(it_.robot, name), link,
                                 zero.X_WL(link).inverse() * X_WF, note, &it_.robot);
      return Link(frame).name;
    };
    it_.torso =
        add("torso_frame", it_.plan.torso, "of the trunk: x forward, z up when it is upright");
    if (it_.imu.empty()) {
      it_.imu = add("imu_frame", it_.robot.root, "the IMU, made up");
      report_.to_decide.push_back("imu: the " + it_.robot.language +
                                  " has no frame of an IMU on the trunk; one was put at '" +
                                  Link(it_.robot.root).name + "'");
    }
  }

  static bool HasWord(const std::string& name, const std::string& word) {
    std::string small;
    for (const char c : name)
      small += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return small.find(word) != std::string::npos;
  }

  void FindStart() {
    StartPoseTask task;
    task.least_width_m = kFeetApart_m;
    for (std::size_t side = 0; side < 2; ++side) {
      const Foot& foot = it_.feet[side];
      task.sole_frames[side] = foot.frame;
      task.sole_heights_m[side] = foot.ball_radius_m;
      task.least_width_m += 0.5 * foot.sole.width_m + foot.ball_radius_m;
    }
    std::size_t fewest_near = 0;
    for (const double spread_rad : kSpreads_rad) {
      task.arm_spread_rad = spread_rad;
      const StartPose start = FindStartPose(it_.robot, it_.plan, task);
      const std::size_t near = CountArmsTooNear(it_.robot, it_.plan, start.posture);
      if (spread_rad == kSpreads_rad[0] || (start.is_found && near < fewest_near)) {
        it_.start = start;
        fewest_near = near;
      }
      if (fewest_near == 0 || !it_.start.is_found) break;
    }
    if (!it_.start.is_found) {
      throw ConfigError(file_ +
                        ": error: found no start: with the knees bent, soles flat and the CoM "
                        "over their middle something is still off by " +
                        Figure(it_.start.residual, 2) + " (m or rad); joint '" +
                        it_.start.tightest_joint + "' is nearest to an end of its range");
    }
    DropShapesInTheGround(it_.start.posture, {it_.plan.legs[0].end, it_.plan.legs[1].end},
                          &it_.robot, &report_.done);
  }

  void NameSelfCollision() {
    const auto names = [&](const std::vector<int>& links) {
      std::vector<std::string> list;
      for (const int link : links) list.push_back(Link(link).name);
      return list;
    };
    for (const auto& [first, second] : FindSelfCollision(it_.robot, it_.plan, it_.start.posture)) {
      it_.self_collision.push_back({names(first), names(second)});
    }
  }

  void ChooseFigures() {
    it_.mass_kg = TotalMass_kg(it_.robot);
    const double gravity_Nm = it_.mass_kg * kGravity_mps2 * it_.start.com_height_m;
    const bool on_points = it_.plan.stands_on_points();
    it_.gait = ChooseGait(it_.start, on_points);
    it_.motors =
        ChooseMotors(it_.plan, gravity_Nm, it_.gait.omega_radps, &it_.robot, &report_.done);
    if (!on_points) MindKnees();
    it_.control = on_points ? ChoosePointControl(it_.mass_kg, it_.start.com_height_m)
                            : ChooseControl(it_.mass_kg, it_.start.com_height_m);
    for (std::size_t side = 0; side < 2; ++side) {
      if (!it_.feet[side].is_guessed) continue;
      report_.to_decide.push_back(
          std::string("vertices_m: the ") + (side == 0 ? "left" : "right") +
          " sole is a guess from the foot's inertia, as none of its shapes could be read" +
          " (--package NAME=DIR says where meshes lie)");
    }
    if (it_.LacksArmature()) {
      report_.to_decide.push_back("armature_kgm2: the " + it_.robot.language +
                                  " has none; chosen to suit the servos");
    }
    report_.to_decide.push_back("force_torque: a sensor in each ankle is assumed");
    for (std::string& note : WeakLegs(it_.robot, it_.plan, it_.start.posture))
      report_.to_decide.push_back(std::move(note));
    if (on_points) return;
    for (std::string& note : WeakAnkles(it_.robot, it_.plan, it_.feet))
      report_.to_decide.push_back(std::move(note));
  }

  /// A knee whose motor is busy with its own rotor swings no quicker than that allows.
  void MindKnees() {
    const double least_s = LeastLiftTime_s(it_.robot, it_.plan, it_.start, it_.gait.swing_height_m);
    if (SlowDown(least_s, &it_.gait)) {
      report_.done.push_back("chose a swing of " + Figure(it_.gait.swing_s) +
                             " s: the knees' torque takes " + Figure(least_s, 3) +
                             " s for their armature and damping");
    }
  }

  void Tell() {
    std::vector<std::string> names;
    const auto chain = [&](const Limb& limb) {
      std::string text;
      for (const int joint : limb.joints) text += (text.empty() ? "" : ", ") + it_.Joint(joint);
      return text;
    };
    Notes& found = report_.found;
    found.push_back("mass " + Figure(it_.mass_kg) + " kg, CoM " + Figure(it_.start.com_height_m) +
                    " m high at the start, legs of " + Figure(it_.start.leg_length_m) +
                    " m, omega " + Figure(it_.gait.omega_radps, 3) + " rad/s");
    found.push_back("base '" + Link(it_.robot.root).name + "', legs from '" +
                    Link(it_.plan.pelvis).name + "', torso '" + Link(it_.plan.torso).name + "'");
    found.push_back("left leg: " + chain(it_.plan.legs[0]));
    found.push_back("right leg: " + chain(it_.plan.legs[1]));
    if (it_.plan.has_arms()) {
      found.push_back("left arm: " + chain(it_.plan.arms[0]));
      found.push_back("right arm: " + chain(it_.plan.arms[1]));
    } else {
      found.push_back("no arms that move");
    }
    if (!it_.plan.torso_joints.empty())
      found.push_back("torso: " + chain({it_.plan.torso_joints, -1}));
    found.push_back(std::to_string(it_.plan.locked.size()) + " joints are locked");
    for (std::size_t side = 0; side < 2; ++side) {
      const Foot& foot = it_.feet[side];
      if (foot.ball_radius_m > 0.0) {
        found.push_back(std::string(side == 0 ? "left" : "right") + " foot: a ball of " +
                        Figure(1e3 * foot.ball_radius_m, 3) + " mm, from the " + foot.found_in);
        continue;
      }
      found.push_back(std::string(side == 0 ? "left" : "right") +
                      " sole: " + Figure(1e3 * foot.sole.length_m, 3) + " mm x " +
                      Figure(1e3 * foot.sole.width_m, 3) + " mm, from the " + foot.found_in);
    }
    if (it_.plan.stands_on_points()) {
      found.push_back(
          "on points it can't stand still: its scenarios step from the start on, on torques");
    }
    found.push_back("start: " + std::string(it_.plan.stands_on_points() ? "feet " : "soles ") +
                    Figure(it_.start.step_width_m, 3) + " m apart, legs at " +
                    Figure(100.0 * it_.start.stretch, 3) + " % of their length; '" +
                    it_.start.tightest_joint + "' is nearest to an end of its range, " +
                    Figure(it_.start.least_margin_rad, 2) + " rad");
  }

  void WriteFiles() {
    std::filesystem::create_directories(options_.folder);
    WriteVisualMeshes(options_.folder, options_.has_meshes, &meshes_, &it_.robot, &report_.done);
    for (const std::string& complaint : meshes_.Complaints())
      report_.to_decide.push_back(complaint);
    Write("robot.urdf", UrdfText(it_.robot, it_.source));
    Write("robot.yaml", RobotYamlText(it_));
    for (const auto& [name, text] : ScenarioTexts(it_)) Write(name, text);
  }

  void Write(const std::string& name, const std::string& text) {
    WriteFile(options_.folder / name, text);
    report_.files.push_back(name);
  }

  const ImportOptions& options_;
  std::string file_;
  MeshFiles meshes_;
  ImportedRobot it_;
  ImportReport report_;
};

}  // namespace

ImportReport ImportRobot(const ImportOptions& options) { return Import(options).Run(); }

}  // namespace sidestep::importer

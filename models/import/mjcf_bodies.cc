// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_bodies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/import/mjcf_pose.h"
#include "models/import/mjcf_root.h"
#include "models/import/text.h"
#include "models/support/plain_word.h"
#include "models/support/require.h"

namespace sidestep::importer {
namespace {

// Of a link between two joints of one body: nothing to the robot, and something to MuJoCo.
constexpr double kBetweenMass_kg = 1e-9;
constexpr double kBetweenInertia_kgm2 = 1e-12;
constexpr double kFreeSlide_m = 10.0;  // range of a slide without one
constexpr double kTurned = 1e-6;       // rad

class BodyTaker {
 public:
  BodyTaker(const mjModel& model, const MjcfParts& parts, std::string file, Problems* problems,
            Notes* notes)
      : m_(model), parts_(parts), file_(std::move(file)), problems_(*problems), notes_(*notes) {
    taken_.link.assign(static_cast<std::size_t>(m_.nbody), -1);
    taken_.X_LB.assign(static_cast<std::size_t>(m_.nbody), Eigen::Isometry3d::Identity());
    taken_.joint.assign(static_cast<std::size_t>(m_.njnt), -1);
  }

  MjcfBodies Take() {
    const int root = RootBody(m_, &notes_);
    if (root < 0) {
      problems_.AddAt(file_, "has no robot: no body in the world carries hinges");
      problems_.ThrowIfAny();
    }
    TakeRoot(root);
    for (int body = root + 1; body < m_.nbody; ++body) {
      if (m_.body_rootid[body] == root) TakeBody(body);
    }
    for (int site = 0; site < m_.nsite; ++site) TakeSite(site);
    problems_.ThrowIfAny();
    const std::string fault = ConnectLinks(&taken_.robot);
    SIDESTEP_REQUIRE(fault.empty(), fault);
    TellSprings();
    return std::move(taken_);
  }

 private:
  std::string PlaceOf(const std::string& kind, int type, int id) const {
    const char* name = mj_id2name(&m_, type, id);
    const auto place = parts_.places.find(kind + " " + (name == nullptr ? "" : name));
    return place == parts_.places.end() ? file_ : place->second;
  }

  /// Of the object, in plain characters, or `otherwise`; not used before in a kind of objects.
  std::string NameOf(int type, int id, const std::string& otherwise) {
    const char* given = mj_id2name(&m_, type, id);
    return Unused(given == nullptr || *given == '\0' ? otherwise : given);
  }

  std::string Unused(const std::string& text) {
    std::string word = PlainCharactersOf(text);
    word.resize(std::min(word.size(), kMaxWordLength / 2));
    if (!IsPlainWord(word)) word = "part" + word;
    std::string unused = word;
    for (int i = 2; !used_.insert(unused).second; ++i) unused = word + "_" + std::to_string(i);
    return unused;
  }

  /// The root floats, whatever its joints; its link's axes are the world's.
  void TakeRoot(int body) {
    const Eigen::Matrix3d R_WB = PoseOf(nullptr, m_.body_quat + 4 * body).linear();
    SourceLink link = LinkOf(body, NameOf(mjOBJ_BODY, body, "base"));
    const auto b = static_cast<std::size_t>(body);
    taken_.X_LB[b].linear() = R_WB;
    if (Eigen::AngleAxisd(R_WB).angle() > kTurned) {
      notes_.push_back("turned the axes of '" + link.name + "' to the world's, as it is at first");
    } else {
      taken_.X_LB[b] = Eigen::Isometry3d::Identity();
    }
    link.mass = InFrame(taken_.X_LB[b], link.mass);
    taken_.link[b] = Add(std::move(link));
    const int first = m_.body_jntadr[body];
    const bool is_free = m_.body_jntnum[body] == 1 && m_.jnt_type[first] == mjJNT_FREE;
    if (is_free) return;
    notes_.push_back(m_.body_jntnum[body] == 0
                         ? "the base is fixed to the world in the MJCF; it floats here"
                         : "took the base's " + std::to_string(m_.body_jntnum[body]) +
                               " joints for a floating base");
  }

  int Add(SourceLink link) {
    taken_.robot.links.push_back(std::move(link));
    return static_cast<int>(taken_.robot.links.size()) - 1;
  }

  /// In the body's frame.
  SourceLink LinkOf(int body, const std::string& name) const {
    SourceLink link;
    link.name = name;
    if (m_.body_mass[body] <= 0.0) return link;
    const Eigen::Isometry3d X_BI = PoseOf(m_.body_ipos + 3 * body, m_.body_iquat + 4 * body);
    link.mass.mass_kg = m_.body_mass[body];
    link.mass.inertia_kgm2 =
        Eigen::Map<const Eigen::Vector3d>(m_.body_inertia + 3 * body).asDiagonal();
    link.mass = InFrame(X_BI, link.mass);
    return link;
  }

  void TakeBody(int body) {
    const auto b = static_cast<std::size_t>(body);
    const auto p = static_cast<std::size_t>(m_.body_parentid[body]);
    const Eigen::Isometry3d X_LpB =
        taken_.X_LB[p] * PoseOf(m_.body_pos + 3 * body, m_.body_quat + 4 * body);
    const int count = m_.body_jntnum[body];
    const char* given = mj_id2name(&m_, mjOBJ_BODY, body);
    if (count == 0 && (given == nullptr || *given == '\0')) {
      taken_.link[b] = taken_.link[p];
      taken_.X_LB[b] = X_LpB;
      SourceLink& parent = taken_.robot.links[static_cast<std::size_t>(taken_.link[p])];
      const MassProperties mass = LinkOf(body, "").mass;
      if (mass.mass_kg > 0.0) parent.mass = Joined(parent.mass, InFrame(X_LpB, mass));
      return;
    }
    const std::string name = NameOf(mjOBJ_BODY, body, "body_" + std::to_string(body));
    int above = taken_.link[p];
    Eigen::Isometry3d X_PL = X_LpB;
    if (count == 0) above = AddFixed(above, LinkOf(body, name), X_PL);
    for (int i = 0; i < count; ++i) {
      const int joint = m_.body_jntadr[body] + i;
      const Eigen::Vector3d p_BJ = Eigen::Map<const Eigen::Vector3d>(m_.jnt_pos + 3 * joint);
      X_PL = X_PL * Eigen::Translation3d(p_BJ);
      const bool is_last = i + 1 == count;
      SourceLink link = is_last ? LinkOf(body, name) : Between(name, joint);
      link.mass =
          is_last ? InFrame(Eigen::Isometry3d(Eigen::Translation3d(-p_BJ)), link.mass) : link.mass;
      above = AddMoving(joint, above, std::move(link), X_PL);
      X_PL = Eigen::Translation3d(-p_BJ);
    }
    taken_.link[b] = above;
    if (count > 0) taken_.X_LB[b] = X_PL;
  }

  static MassProperties Joined(const MassProperties& one, const MassProperties& other) {
    return one.mass_kg > 0.0 ? Together(one, other) : other;
  }

  SourceLink Between(const std::string& body, int joint) {
    SourceLink link;
    const char* name = mj_id2name(&m_, mjOBJ_JOINT, joint);
    link.name = Unused(body + "_" + (name == nullptr ? "joint" : name));
    link.mass.mass_kg = kBetweenMass_kg;
    link.mass.inertia_kgm2 = kBetweenInertia_kgm2 * Eigen::Matrix3d::Identity();
    link.note = "between joints that '" + body + "' has together in the MJCF";
    return link;
  }

  int AddFixed(int above, SourceLink link, const Eigen::Isometry3d& X_PL) {
    SourceJoint joint;
    joint.name = link.name + "_fixed";
    return Connect(std::move(joint), above, std::move(link), X_PL);
  }

  int AddMoving(int id, int above, SourceLink link, const Eigen::Isometry3d& X_PL) {
    SourceJoint joint;
    joint.name = mj_id2name(&m_, mjOBJ_JOINT, id);
    const int type = m_.jnt_type[id];
    if (type != mjJNT_HINGE && type != mjJNT_SLIDE) {
      problems_.AddAt(PlaceOf("joint", mjOBJ_JOINT, id),
                      "joint '" + joint.name + "' is a ball; make it three hinges, or delete it");
    }
    joint.is_mimic = parts_.mimics.count(joint.name) > 0;
    joint.name = PlainJointName(joint.name);
    const bool is_limited = m_.jnt_limited[id] != 0;
    joint.kind = type == mjJNT_SLIDE ? JointKind::kPrismatic
                 : is_limited        ? JointKind::kRevolute
                                     : JointKind::kContinuous;
    const double zero = m_.qpos0[m_.jnt_qposadr[id]];
    joint.lower = is_limited ? m_.jnt_range[2 * id] - zero : -kFreeSlide_m;
    joint.upper = is_limited ? m_.jnt_range[2 * id + 1] - zero : kFreeSlide_m;
    joint.axis = Eigen::Map<const Eigen::Vector3d>(m_.jnt_axis + 3 * id);
    const int dof = m_.jnt_dofadr[id];
    joint.damping_Nms_per_rad = m_.dof_damping[dof];
    joint.armature_kgm2 = m_.dof_armature[dof];
    if (m_.jnt_stiffness[id] != 0.0) sprung_.push_back(joint.name);
    if (m_.dof_frictionloss[dof] != 0.0) rubbing_.push_back(joint.name);
    taken_.joint[static_cast<std::size_t>(id)] = static_cast<int>(taken_.robot.joints.size());
    return Connect(std::move(joint), above, std::move(link), X_PL);
  }

  /// Joints may be called like links.
  std::string PlainJointName(const std::string& name) {
    std::swap(used_, used_by_joints_);
    std::string word = Unused(name);
    std::swap(used_, used_by_joints_);
    return word;
  }

  int Connect(SourceJoint joint, int above, SourceLink link, const Eigen::Isometry3d& X_PL) {
    joint.parent = above;
    joint.child = Add(std::move(link));
    joint.X_PC = X_PL;
    taken_.robot.joints.push_back(std::move(joint));
    return taken_.robot.joints.back().child;
  }

  void TakeSite(int site) {
    const auto body = static_cast<std::size_t>(m_.site_bodyid[site]);
    if (taken_.link[body] < 0) return;
    SourceLink frame;
    frame.name = NameOf(mjOBJ_SITE, site, "site_" + std::to_string(site));
    frame.note = "a site of the MJCF";
    AddFixed(taken_.link[body], std::move(frame),
             taken_.X_LB[body] * PoseOf(m_.site_pos + 3 * site, m_.site_quat + 4 * site));
  }

  void TellSprings() {
    if (!sprung_.empty()) notes_.push_back("left out the springs in joints " + Listed(sprung_));
    if (!rubbing_.empty()) {
      notes_.push_back("left out the dry friction (frictionloss) in joints " + Listed(rubbing_));
    }
  }

  const mjModel& m_;
  const MjcfParts& parts_;
  std::string file_;
  Problems& problems_;
  Notes& notes_;
  MjcfBodies taken_;
  std::set<std::string> used_, used_by_joints_;
  std::vector<std::string> sprung_, rubbing_;
};

}  // namespace

MjcfBodies TakeBodies(const mjModel& model, const MjcfParts& parts, const std::string& file,
                      Problems* problems, Notes* notes) {
  return BodyTaker(model, parts, file, problems, notes).Take();
}

}  // namespace sidestep::importer

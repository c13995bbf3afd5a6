// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/maker_robot.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>

namespace sidestep {
namespace {

using Vector = Eigen::Vector3d;

void ReplaceAll(const std::string& what, const std::string& with, std::string* text) {
  for (std::size_t at = 0; (at = text->find(what, at)) != std::string::npos; at += with.size())
    text->replace(at, what.size(), with);
}

std::string WithOddNames(std::string urdf) {
  ReplaceAll("\"trunk\"", "\"trunk \"", &urdf);
  ReplaceAll("_knee\"", ":knee\"", &urdf);
  return urdf;
}

class Writer {
 public:
  explicit Writer(const MakerRobot& robot)
      : robot_(robot), s_(robot.size), up_(0, 0, robot.is_drawn_from_floor ? 0.85 : 0) {}

  std::string Write() {
    out_ << "<?xml version=\"1.0\"?>\n<robot name=\"" << robot_.name << "\">\n"
         << "<material name=\"grey\"><color rgba=\"0.6 0.6 0.6 1\"/></material>\n"
         << "<transmission name=\"t\"><type>SimpleTransmission</type></transmission>\n";
    if (robot_.has_floating_root) {
      out_ << "<link name=\"world\"/>\n<joint name=\"world_joint\" type=\"floating\"><parent "
              "link=\"world\"/><child link=\""
           << (robot_.is_rooted_in_trunk ? "trunk" : "pelvis") << "\"/></joint>\n";
    }
    Link("pelvis", 9.0, up_ + Vector(0, 0, 0.02), {0.16, 0.22, 0.12});
    Link("trunk", 18.0, {0, 0, 0.2}, {0.18, 0.28, 0.4}, robot_.has_mesh_shapes);
    if (robot_.is_rooted_in_trunk) {
      Moving("waist_yaw", "trunk", "pelvis", {0, 0, -0.1}, {0, 0, 1}, -1.2, 1.2, 80);
    } else {
      Moving("waist_yaw", "pelvis", "trunk", up_ + Vector(0, 0, 0.1), {0, 0, 1}, -1.2, 1.2, 80);
    }
    Link("head", 3.0, {0, 0, 0.1}, {0.16, 0.14, 0.2});
    Moving("neck_pitch", "trunk", "head", {0, 0, 0.44}, {0, 1, 0}, -0.5, 0.5, 10);
    for (const double side : {1.0, -1.0}) {
      Leg(side);
      Arm(side);
    }
    if (robot_.has_gram_frames) {
      out_ << "<link name=\"camera\"><inertial><mass value=\"0.005\"/><inertia ixx=\"0\" ixy=\"0\" "
              "ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/></inertial></link>\n";
      Fixed("camera_mount", "head", "camera", {0.08, 0, 0.1});
      out_ << "<link name=\"imu_link\"/>\n";
      Fixed("imu_mount", robot_.is_rooted_in_trunk ? "trunk" : "pelvis", "imu_link", {0, 0, 0.05});
    }
    out_ << "</robot>\n";
    return robot_.has_odd_names ? WithOddNames(out_.str()) : out_.str();
  }

 private:
  std::string Triple(const Vector& v) const {
    std::ostringstream text;
    text << v.x() << " " << v.y() << " " << v.z();
    return text.str();
  }

  /// A homogeneous box; lengths and mass at size 1.
  void Link(const std::string& name, double mass_kg, const Vector& com, const Vector& edges,
            bool is_mesh = false, bool collides = true) {
    const double m = mass_kg * s_ * s_ * s_;
    const Vector e = (s_ * edges).cwiseAbs2();
    out_ << "<link name=\"" << name << "\"><inertial><origin xyz=\"" << Triple(s_ * com)
         << "\"/><mass value=\"" << m << "\"/><inertia ixx=\"" << m / 12 * (e.y() + e.z())
         << "\" ixy=\"0\" ixz=\"0\" iyy=\"" << m / 12 * (e.x() + e.z()) << "\" iyz=\"0\" izz=\""
         << m / 12 * (e.x() + e.y()) << "\"/></inertial>\n";
    const std::string shape = is_mesh ? "<mesh filename=\"meshes/" + name + ".stl\"/>"
                                      : "<box size=\"" + Triple(s_ * edges) + "\"/>";
    const std::string origin = is_mesh ? "" : "<origin xyz=\"" + Triple(s_ * com) + "\"/>";
    out_ << "  <visual>" << origin << "<geometry>" << shape
         << "</geometry><material name=\"grey\"/></visual>\n";
    if (collides) {
      out_ << "  <collision>" << origin << "<geometry>" << shape << "</geometry></collision>\n";
    }
    out_ << "</link>\n";
  }

  void Joint(const std::string& name, const char* type, const std::string& parent,
             const std::string& child, const Vector& at) {
    out_ << "<joint name=\"" << name << "\" type=\"" << type << "\"><parent link=\"" << parent
         << "\"/><child link=\"" << child << "\"/><origin xyz=\"" << Triple(s_ * at) << "\"/>";
  }

  void Fixed(const std::string& name, const std::string& parent, const std::string& child,
             const Vector& at) {
    Joint(name, "fixed", parent, child, at);
    out_ << "</joint>\n";
  }

  void Moving(const std::string& name, const std::string& parent, const std::string& child,
              const Vector& at, const Vector& axis, double lower, double upper, double effort_Nm) {
    Joint(name, "revolute", parent, child, at);
    out_ << "<axis xyz=\"" << Triple(axis) << "\"/><limit lower=\"" << lower << "\" upper=\""
         << upper << "\" effort=\""
         << (robot_.has_wild_limits ? 1e9 : effort_Nm * s_ * s_ * s_ * s_) << "\" velocity=\""
         << (robot_.has_wild_limits ? 0.0 : 12.0) << "\"/></joint>\n";
  }

  void Leg(double side) {
    const std::string p = side > 0 ? "left_" : "right_";
    const std::array<std::string, 3> order =
        robot_.bends_hips_first ? std::array<std::string, 3>{"pitch", "roll", "yaw"}
                                : std::array<std::string, 3>{"yaw", "roll", "pitch"};
    std::string parent = "pelvis";
    Vector at = up_ + Vector(0, 0.09 * side, -0.06);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string child = p + (i < 2 ? "hip_" + order[i] + "_link" : "thigh");
      if (i < 2) {
        Link(child, 1.2, {0, 0, 0}, {0.08, 0.08, 0.08}, false, false);
      } else {
        Link(child, 4.5, {0, 0, -0.17}, {0.12, 0.12, 0.28}, robot_.has_mesh_shapes);
      }
      Hip(p, order[i], parent, child, at, side);
      parent = child;
      at.setZero();
    }
    Link(p + "shank", 3.0, {0, 0, -0.16}, {0.09, 0.09, 0.26}, robot_.has_mesh_shapes);
    Moving(p + "knee", parent, p + "shank", {0, 0, -0.35}, {0, 1, 0}, -0.02, 2.3, 180);
    Link(p + "ankle", 0.6, {0, 0, 0}, {0.05, 0.05, 0.05}, false, false);
    const bool has_roll = robot_.leg_joints > 5;
    Moving(p + "ankle_pitch", p + "shank", has_roll ? p + "ankle" : p + "foot", {0, 0, -0.35},
           {0, 1, 0}, -1.0, 0.8, 120);
    if (has_roll) {
      Moving(p + "ankle_roll", p + "ankle", p + "foot", {0, 0, 0}, {1, 0, 0}, -0.5, 0.5, 60);
    } else {
      Fixed(p + "ankle_mount", p + "foot", p + "ankle", {0, 0, 0});
    }
    Foot(p + "foot");
  }

  void Hip(const std::string& p, const std::string& what, const std::string& parent,
           const std::string& child, const Vector& at, double side) {
    if (what == "yaw") Moving(p + "hip_yaw", parent, child, at, {0, 0, 1}, -0.9, 0.9, 80);
    if (what == "pitch") Moving(p + "hip_pitch", parent, child, at, {0, 1, 0}, -2.0, 0.8, 170);
    if (what != "roll") return;
    Moving(p + "hip_roll", parent, child, at, {1, 0, 0}, side > 0 ? -0.5 : -0.9,
           side > 0 ? 0.9 : 0.5, 130);
  }

  void Foot(const std::string& name) {
    const bool is_mesh = robot_.foot == MakerFoot::kMesh;
    const bool has_box = robot_.foot == MakerFoot::kBox || is_mesh;
    Link(name, 1.0, {0.03, 0, -0.07}, {0.22, 0.1, 0.03}, is_mesh, has_box);
    const bool is_marked = robot_.foot == MakerFoot::kMarks;
    if (robot_.foot != MakerFoot::kSpheres && !is_marked) return;
    std::string text = out_.str();
    text.erase(text.rfind("</link>"));
    out_.str(text);
    out_.seekp(0, std::ios::end);
    for (const double x : {0.135, -0.075}) {
      for (const double y : {0.045, -0.045}) {
        out_ << "  <collision><origin xyz=\"" << Triple(s_ * Vector(x, y, -0.08))
             << "\"/><geometry><sphere radius=\"" << (is_marked ? 0.0 : 0.005 * s_)
             << "\"/></geometry></collision>\n";
      }
    }
    out_ << "</link>\n";
  }

  void Arm(double side) {
    const std::string p = side > 0 ? "left_" : "right_";
    Link(p + "shoulder", 1.2, {0, 0.02 * side, 0}, {0.08, 0.08, 0.08}, false, false);
    Moving(p + "shoulder_pitch", "trunk", p + "shoulder", {0, 0.18 * side, 0.34}, {0, 1, 0}, -2.8,
           1.5, 60);
    Link(p + "shoulder_roll_link", 1.0, {0, 0, 0}, {0.08, 0.08, 0.08}, false, false);
    Moving(p + "shoulder_roll", p + "shoulder", p + "shoulder_roll_link", {0, 0.05 * side, 0},
           {1, 0, 0}, side > 0 ? -0.1 : -2.5, side > 0 ? 2.5 : 0.1, 60);
    Link(p + "upper_arm", 1.6, {0, 0, -0.12}, {0.07, 0.07, 0.2});
    Moving(p + "shoulder_yaw", p + "shoulder_roll_link", p + "upper_arm", {0, 0, 0}, {0, 0, 1},
           -1.5, 1.5, 40);
    Link(p + "forearm", 1.2, {0, 0, -0.12}, {0.06, 0.06, 0.22});
    Moving(p + "elbow", p + "upper_arm", p + "forearm", {0, 0, -0.26}, {0, 1, 0}, -2.2, 0.0, 40);
    if (!robot_.has_fingers) return;
    for (const char* finger : {"index", "thumb"}) {
      Link(p + finger, 0.05, {0, 0, -0.03}, {0.02, 0.02, 0.06});
      Moving(p + finger + "_joint", p + "forearm", p + finger,
             {0.02 * (finger[0] == 'i' ? 1 : -1), 0, -0.24}, {0, 1, 0}, -1.0, 1.0, 1);
    }
    std::string text = out_.str();
    text.insert(text.rfind("</joint>"), "<mimic joint=\"" + p + "index_joint\"/>");
    out_.str(text);
    out_.seekp(0, std::ios::end);
  }

  const MakerRobot& robot_;
  double s_;
  Vector up_;  // from the pelvis' origin to where it is drawn, at size 1
  std::ostringstream out_;
};

}  // namespace

std::string UrdfOf(const MakerRobot& robot) { return Writer(robot).Write(); }

void WriteBoxStl(const std::filesystem::path& file, const double (&size_m)[3],
                 const double (&middle_m)[3]) {
  constexpr std::array<std::array<int, 3>, 12> kTriangles{{{0, 2, 1},
                                                           {1, 2, 3},
                                                           {4, 5, 6},
                                                           {5, 7, 6},
                                                           {0, 1, 4},
                                                           {1, 5, 4},
                                                           {2, 6, 3},
                                                           {3, 6, 7},
                                                           {0, 4, 2},
                                                           {2, 4, 6},
                                                           {1, 3, 5},
                                                           {3, 7, 5}}};
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  const auto write = [&](const auto& value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  out << std::string(80, ' ');
  write(static_cast<std::uint32_t>(kTriangles.size()));
  for (const std::array<int, 3>& triangle : kTriangles) {
    for (int i = 0; i < 3; ++i) write(0.0F);
    for (const int corner : triangle) {
      for (int axis = 0; axis < 3; ++axis) {
        const double sign = ((corner >> axis) & 1) != 0 ? 0.5 : -0.5;
        write(static_cast<float>(middle_m[axis] + sign * size_m[axis]));
      }
    }
    write(std::uint16_t{0});
  }
}

std::filesystem::path WriteMakerRobot(const MakerRobot& robot,
                                      const std::filesystem::path& folder) {
  const double s = robot.size;
  const auto box = [&](const std::string& name, const Vector& size, const Vector& middle) {
    WriteBoxStl(folder / "meshes" / (name + ".stl"), {s * size.x(), s * size.y(), s * size.z()},
                {s * middle.x(), s * middle.y(), s * middle.z()});
  };
  std::filesystem::create_directories(folder);
  if (robot.has_mesh_shapes) box("trunk", {0.18, 0.28, 0.4}, {0, 0, 0.2});
  for (const std::string side : {"left_", "right_"}) {
    if (robot.has_mesh_shapes) box(side + "thigh", {0.12, 0.12, 0.28}, {0, 0, -0.17});
    if (robot.has_mesh_shapes) box(side + "shank", {0.09, 0.09, 0.26}, {0, 0, -0.16});
    if (robot.foot == MakerFoot::kMesh) box(side + "foot", {0.22, 0.1, 0.03}, {0.03, 0, -0.07});
  }
  const std::filesystem::path file = folder / (robot.name + ".urdf");
  std::ofstream(file, std::ios::binary) << UrdfOf(robot);
  return file;
}

}  // namespace sidestep

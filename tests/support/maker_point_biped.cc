// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/maker_point_biped.h"

#include <Eigen/Core>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <vector>

namespace sidestep {
namespace {

constexpr double kLink_m = 0.21;
constexpr int kSides = 24;

std::string Inertial(double mass_kg, const std::string& xyz, const std::string& inertia) {
  return "<inertial><origin xyz=\"" + xyz + "\"/><mass value=\"" + std::to_string(mass_kg) +
         "\"/><inertia " + inertia + "/></inertial>\n";
}

std::string Joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& xyz, const std::string& axis) {
  return "<joint name=\"" + name + "\" type=\"revolute\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"" + xyz + "\"/><axis xyz=\"" + axis +
         "\"/><limit lower=\"-3\" upper=\"3\" effort=\"1000\" velocity=\"1000\"/></joint>\n";
}

std::string Collision(const std::string& geometry) {
  return "<collision><geometry>" + geometry + "</geometry></collision>\n";
}

std::string FootShape(PointFoot foot) {
  switch (foot) {
    case PointFoot::kSphere:
      return Collision("<sphere radius=\"0.018\"/>");
    case PointFoot::kDiscMesh:
      return Collision("<mesh filename=\"meshes/disc.stl\"/>");
    case PointFoot::kFlatBox:
      return Collision("<box size=\"0.12 0.06 0.036\"/>");
    case PointFoot::kNone:
      return {};
  }
  return {};
}

std::string Leg(const std::string& side, double y, PointFoot foot) {
  std::ostringstream text;
  const std::string hip = "0 " + std::to_string(y) + " 0";
  const std::string down = "0 0 -" + std::to_string(kLink_m);
  const char* small = "ixx=\"2e-4\" ixy=\"0\" ixz=\"0\" iyy=\"2e-4\" iyz=\"0\" izz=\"1e-4\"";
  const char* rod = "ixx=\"6e-4\" ixy=\"0\" ixz=\"0\" iyy=\"6e-4\" iyz=\"0\" izz=\"5e-5\"";
  text << Joint(side + "_HAA", "base", side + "_hip", hip, "1 0 0") << "<link name=\"" << side
       << "_hip\">" << Inertial(0.15, "0 0 -0.01", small) << "</link>\n"
       << Joint(side + "_HFE", side + "_hip", side + "_thigh", "0 0 -0.03", "0 1 0")
       << "<link name=\"" << side << "_thigh\">" << Inertial(0.16, "0 0 -0.1", rod) << "</link>\n"
       << Joint(side + "_KFE", side + "_thigh", side + "_shin", down, "0 1 0") << "<link name=\""
       << side << "_shin\">" << Inertial(0.05, "0 0 -0.1", rod)
       << (foot == PointFoot::kNone ? "" : Collision("<mesh filename=\"meshes/shin.stl\"/>"))
       << "</link>\n<joint name=\"" << side << "_foot_fixed\" type=\"fixed\"><parent link=\""
       << side << "_shin\"/><child link=\"" << side << "_foot\"/><origin xyz=\"" << down
       << "\"/></joint>\n<link name=\"" << side << "_foot\">" << FootShape(foot) << "</link>\n";
  return text.str();
}

using Corners = std::vector<Eigen::Vector3d>;

void WriteFacets(const Corners& corners, const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "solid mesh\n";
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (std::size_t k = i; k < i + 3; ++k) out << "vertex " << corners[k].transpose() << "\n";
    out << "endloop\nendfacet\n";
  }
  out << "endsolid mesh\n";
}

/// A prism with `kSides` sides between two rims; `rim(angle, end)` is a point of one.
template <typename Rim>
Corners Prism(const Rim& rim) {
  Corners corners;
  const double step = 2.0 * std::numbers::pi / kSides;
  const auto middle = [&](int end) {
    return Eigen::Vector3d(0.5 * (rim(0.0, end) + rim(std::numbers::pi, end)));
  };
  for (int i = 0; i < kSides; ++i) {
    const double a = step * i, b = step * (i + 1);
    for (const Eigen::Vector3d& p :
         {rim(a, 0), rim(b, 0), rim(a, 1), rim(b, 0), rim(b, 1), rim(a, 1), middle(0), rim(b, 0),
          rim(a, 0), middle(1), rim(a, 1), rim(b, 1)}) {
      corners.push_back(p);
    }
  }
  return corners;
}

}  // namespace

std::string UrdfOf(const MakerPointBiped& robot) {
  return "<robot name=\"" + robot.name + "\">\n<link name=\"base\">" +
         Inertial(0.88, "0 0 0.02",
                  "ixx=\"0.007\" ixy=\"0\" ixz=\"0\" iyy=\"0.02\" iyz=\"0\" izz=\"0.025\"") +
         Collision("<box size=\"0.12 0.1 0.05\"/>") + "</link>\n" + Leg("FL", 0.07, robot.foot) +
         Leg("FR", -0.07, robot.foot) + "</robot>\n";
}

std::filesystem::path WriteMakerPointBiped(const MakerPointBiped& robot,
                                           const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "meshes");
  WriteFacets(Prism([](double angle, int end) {
                return Eigen::Vector3d(0.018 * std::sin(angle), end == 0 ? -0.006 : 0.006,
                                       -0.018 * std::cos(angle));
              }),
              folder / "meshes/disc.stl");
  WriteFacets(Prism([](double angle, int end) {
                return Eigen::Vector3d(0.01 * std::sin(angle), 0.01 * std::cos(angle),
                                       end == 0 ? 0.0 : -kLink_m);
              }),
              folder / "meshes/shin.stl");
  const std::filesystem::path file = folder / (robot.name + ".urdf");
  std::ofstream(file) << UrdfOf(robot);
  return file;
}

}  // namespace sidestep

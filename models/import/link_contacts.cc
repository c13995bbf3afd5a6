// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/link_contacts.h"

#include <algorithm>
#include <array>
#include <sstream>

#include "models/import/text.h"
#include "models/mjcf/quaternion.h"

namespace sidestep::importer {
namespace {

constexpr int kPrecision = 12;  // digits

std::string GeomName(int link, std::size_t shape) {
  return std::to_string(link) + "_" + std::to_string(shape);
}

/// A cylinder longer than wide is a capsule, as for the simulation.
std::string GeomText(const SourceShape& shape) {
  std::ostringstream out;
  out.precision(kPrecision);
  const Eigen::Vector3d& size = shape.size_m;
  const double straight_m = 0.5 * size.y() - size.x();
  if (shape.kind == ShapeKind::kBox) {
    out << "type=\"box\" size=\"" << 0.5 * size.x() << " " << 0.5 * size.y() << " "
        << 0.5 * size.z() << "\"";
  } else if (shape.kind == ShapeKind::kSphere) {
    out << "type=\"sphere\" size=\"" << size.x() << "\"";
  } else if (straight_m > 0.0) {
    out << "type=\"capsule\" size=\"" << size.x() << " " << straight_m << "\"";
  } else {
    out << "type=\"cylinder\" size=\"" << size.x() << " " << 0.5 * size.y() << "\"";
  }
  const Eigen::Quaterniond q(shape.X_LS.linear());
  const Eigen::Vector3d p = shape.X_LS.translation();
  out << " pos=\"" << p.x() << " " << p.y() << " " << p.z() << "\" quat=\"" << q.w() << " " << q.x()
      << " " << q.y() << " " << q.z() << "\"";
  return out.str();
}

const std::vector<SourceShape>& ShapesOf(const SourceRobot& robot, int link) {
  return robot.links[static_cast<std::size_t>(link)].collisions;
}

std::string WorldText(const SourceRobot& robot, const std::vector<int>& links,
                      const std::vector<LinkPair>& pairs) {
  std::ostringstream out;
  out << "<mujoco><compiler inertiafromgeom=\"false\"/><size nconmax=\"5000\"/>"
         "<option collision=\"predefined\"/><worldbody>\n";
  for (const int link : links) {
    out << "<body><freejoint/><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/>\n";
    for (std::size_t i = 0; i < ShapesOf(robot, link).size(); ++i) {
      out << "<geom name=\"" << GeomName(link, i) << "\" " << GeomText(ShapesOf(robot, link)[i])
          << "/>\n";
    }
    out << "</body>\n";
  }
  out << "</worldbody><contact>\n";
  for (const auto& [a, b] : pairs) {
    for (std::size_t i = 0; i < ShapesOf(robot, a).size(); ++i) {
      for (std::size_t k = 0; k < ShapesOf(robot, b).size(); ++k) {
        out << "<pair geom1=\"" << GeomName(a, i) << "\" geom2=\"" << GeomName(b, k) << "\"/>\n";
      }
    }
  }
  out << "</contact></mujoco>\n";
  return out.str();
}

}  // namespace

LinkContacts::LinkContacts(const SourceRobot& robot, const std::vector<LinkPair>& pairs) {
  std::set<int> used;
  for (const auto& [a, b] : pairs) used.insert({a, b});
  links_.assign(used.begin(), used.end());
  model_ = CompileMjcf(WorldText(robot, links_, pairs), "", "self-collision");
  data_ = MakeData(*model_);
}

std::set<LinkPair> LinkContacts::Near(const Placement& placement, double margin_m) {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Eigen::Isometry3d& X_WL = placement.X_WL(links_[i]);
    mjtNum* qpos = data_->qpos + 7 * i;
    std::copy_n(X_WL.translation().data(), 3, qpos);
    ToMuJoCo(Eigen::Quaterniond(X_WL.linear()), qpos + 3);
  }
  std::fill_n(model_->pair_margin, model_->npair, margin_m);
  mj_kinematics(model_.get(), data_.get());
  mj_collision(model_.get(), data_.get());
  std::set<LinkPair> near;
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    std::array<int, 2> links{};
    for (std::size_t k = 0; k < 2; ++k) {
      const int body = model_->geom_bodyid[k == 0 ? contact.geom1 : contact.geom2];
      links[k] = links_[static_cast<std::size_t>(body - 1)];
    }
    near.insert({std::min(links[0], links[1]), std::max(links[0], links[1])});
  }
  return near;
}

}  // namespace sidestep::importer

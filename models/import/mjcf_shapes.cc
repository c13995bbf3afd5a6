// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_shapes.h"

#include <cmath>
#include <numbers>
#include <set>

#include "models/import/fit_shapes.h"
#include "models/import/mjcf_pose.h"
#include "models/import/text.h"

namespace sidestep::importer {
namespace {

constexpr int kFirstHiddenGroup = 3;                     // MuJoCo's visualisation draws 0, 1 and 2
constexpr int kRingPoints = 12;                          // of an ellipsoid
const Eigen::Vector4d kPlainColour{0.5, 0.5, 0.5, 1.0};  // of a geom that nobody gave one

class ShapeTaker {
 public:
  ShapeTaker(const mjModel& model, MjcfBodies* bodies, MeshFiles* files)
      : m_(model), bodies_(*bodies), files_(*files) {
    for (int pair = 0; pair < m_.npair; ++pair) {
      paired_.insert({m_.pair_geom1[pair], m_.pair_geom2[pair]});
    }
  }

  void Take(Notes* notes) {
    takes_hidden_ = true;
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      const bool is_robots = bodies_.link[static_cast<std::size_t>(m_.geom_bodyid[geom])] >= 0;
      if (is_robots && CollidesAsWritten(geom)) takes_hidden_ = false;
    }
    if (takes_hidden_) {
      notes->push_back(
          "took hidden shapes (of group 3 and more) for what collides: by contype, "
          "conaffinity and pairs nothing does");
    }
    std::vector<std::vector<SourceShape>> seen(bodies_.robot.links.size());
    for (int geom = 0; geom < m_.ngeom; ++geom) {
      const int link = bodies_.link[static_cast<std::size_t>(m_.geom_bodyid[geom])];
      const int type = m_.geom_type[geom];
      if (link < 0 || type == mjGEOM_PLANE || type == mjGEOM_HFIELD) continue;
      SourceLink& to = bodies_.robot.links[static_cast<std::size_t>(link)];
      const SourceShape shape = ShapeOf(geom);
      const bool is_drawn = m_.geom_group[geom] < kFirstHiddenGroup && (*shape.rgba)[3] > 0.0;
      if (Collides(geom)) {
        to.collisions.push_back(shape);
        to.collisions.back().rgba.reset();
        if (is_drawn) seen[static_cast<std::size_t>(link)].push_back(shape);
        const bool is_told = !fitted_.empty() && fitted_.back() == to.name;
        if (type == mjGEOM_ELLIPSOID && !is_told) fitted_.push_back(to.name);
      } else if (is_drawn) {
        to.visuals.push_back(shape);
      }
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (bodies_.robot.links[i].visuals.empty()) bodies_.robot.links[i].visuals = seen[i];
    }
    if (!fitted_.empty()) {
      notes->push_back("fitted boxes and capsules to the ellipsoids of " + Listed(fitted_));
    }
  }

 private:
  bool Collides(int geom) const {
    return CollidesAsWritten(geom) || (takes_hidden_ && m_.geom_group[geom] >= kFirstHiddenGroup);
  }

  bool CollidesAsWritten(int geom) const {
    return m_.geom_contype[geom] != 0 || m_.geom_conaffinity[geom] != 0 || paired_.count(geom) > 0;
  }

  SourceShape ShapeOf(int geom) {
    SourceShape shape;
    const mjtNum* size = m_.geom_size + 3 * geom;
    switch (m_.geom_type[geom]) {
      case mjGEOM_BOX:
        shape.size_m << 2.0 * size[0], 2.0 * size[1], 2.0 * size[2];
        break;
      case mjGEOM_SPHERE:
        shape.kind = ShapeKind::kSphere;
        shape.size_m.x() = size[0];
        break;
      case mjGEOM_CAPSULE:
        shape.kind = ShapeKind::kCylinder;
        shape.size_m << size[0], 2.0 * (size[1] + size[0]), 0.0;
        break;
      case mjGEOM_CYLINDER:
        shape.kind = ShapeKind::kCylinder;
        shape.size_m << size[0], 2.0 * size[1], 0.0;
        break;
      case mjGEOM_ELLIPSOID:
        shape = FitShape(EllipsoidPoints(size));
        break;
      default:
        shape.kind = ShapeKind::kMesh;
        shape.mesh = TakeMesh(m_.geom_dataid[geom]);
    }
    const int body = m_.geom_bodyid[geom];
    shape.X_LS = bodies_.X_LB[static_cast<std::size_t>(body)] *
                 PoseOf(m_.geom_pos + 3 * geom, m_.geom_quat + 4 * geom) * shape.X_LS;
    shape.rgba = ColourOf(geom);
    return shape;
  }

  /// A geom's own colour, else its material's.
  Eigen::Vector4d ColourOf(int geom) const {
    Eigen::Vector4d own = Eigen::Map<const Eigen::Vector4f>(m_.geom_rgba + 4 * geom).cast<double>();
    const int material = m_.geom_matid[geom];
    if (material < 0 || own != kPlainColour) return own;
    return Eigen::Map<const Eigen::Vector4f>(m_.mat_rgba + 4 * material).cast<double>();
  }

  /// The mesh's name; its triangles go to the files once.
  std::string TakeMesh(int id) {
    const char* given = mj_id2name(&m_, mjOBJ_MESH, id);
    std::string name = given == nullptr ? "mesh " + std::to_string(id) : given;
    if (!taken_.insert(id).second || files_.IsMissing(name)) return name;
    Mesh mesh;
    for (int i = 0; i < m_.mesh_vertnum[id]; ++i) {
      mesh.vertices.emplace_back(
          Eigen::Map<const Eigen::Vector3f>(m_.mesh_vert + 3 * (m_.mesh_vertadr[id] + i)));
    }
    for (int i = 0; i < 3 * m_.mesh_facenum[id]; ++i) {
      mesh.corners.push_back(static_cast<unsigned>(m_.mesh_face[3 * m_.mesh_faceadr[id] + i]));
    }
    files_.Add(name, std::move(mesh));
    return name;
  }

  static std::vector<Eigen::Vector3d> EllipsoidPoints(const mjtNum* size) {
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < kRingPoints; ++i) {
      for (int k = 0; k <= kRingPoints; ++k) {
        const double turn = 2.0 * std::numbers::pi * i / kRingPoints;
        const double tilt = std::numbers::pi * k / kRingPoints;
        points.emplace_back(size[0] * std::sin(tilt) * std::cos(turn),
                            size[1] * std::sin(tilt) * std::sin(turn), size[2] * std::cos(tilt));
      }
    }
    return points;
  }

  const mjModel& m_;
  MjcfBodies& bodies_;
  MeshFiles& files_;
  std::set<int> paired_, taken_;
  bool takes_hidden_{false};
  std::vector<std::string> fitted_;
};

}  // namespace

void TakeShapes(const mjModel& model, MjcfBodies* bodies, MeshFiles* files, Notes* notes) {
  ShapeTaker(model, bodies, files).Take(notes);
}

}  // namespace sidestep::importer

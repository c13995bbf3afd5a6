// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/looks.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <utility>

#include "models/urdf_to_mjcf/mesh_file.h"
#include "models/urdf_to_mjcf/mjcf_text.h"

namespace sidestep {
namespace {

constexpr const char* kFolder = "folder";  // what MeshFile::fault says of a file that isn't there
constexpr const char* kFolderHint = " (meshes: FOLDER in robot.yaml names another folder)";
constexpr double kShortestStick_m = 0.01;
constexpr double kStickThickness = 0.12;  // radius over length, within the next two
constexpr double kThinnest_m = 0.008;
constexpr double kThickest_m = 0.03;
constexpr double kSmallestMesh_m = 1e-3;  // MuJoCo refuses a volume of 1e-15 m^3
constexpr std::size_t kMostNames = 10;    // of meshes in one notice
constexpr double kLargestBox_m = 0.5;     // half an edge, whatever the inertia says

/// Attributes of a `<mesh>`. Inline each triangle has corners of its own: MuJoCo refuses edges that
/// two triangles share in the same direction, and drawn flat they need no shared normals.
std::string MeshAttributes(const MeshFile& file, const Triangles& triangles,
                           const Eigen::Vector3d& scale) {
  if (triangles.is_binary_stl) {
    const std::string scaled =
        scale == Eigen::Vector3d::Ones() ? "" : Attribute("scale", Numbers(scale));
    return Attribute("file", file.path.string()) + scaled;
  }
  std::ostringstream vertices, faces;
  const bool is_mirrored = scale.prod() < 0.0;
  for (std::size_t i = 0; i < triangles.corners.size(); ++i) {
    const Eigen::Vector3f corner = triangles.corners[i].cwiseProduct(scale.cast<float>());
    vertices << (i > 0 ? " " : "") << corner.x() << " " << corner.y() << " " << corner.z();
    const std::size_t in_turn = is_mirrored ? 3 * (i / 3) + 2 - i % 3 : i;
    faces << (i > 0 ? " " : "") << in_turn;
  }
  return " vertex=\"" + vertices.str() + "\" face=\"" + faces.str() + "\"";
}

/// The longest edge of the scaled mesh's box; 0 if an axis is scaled to nothing.
double Extent_m(const Triangles& triangles, const Eigen::Vector3d& scale) {
  if (scale.prod() == 0.0) return 0.0;
  Eigen::Vector3f low = triangles.corners.front(), high = low;
  for (const Eigen::Vector3f& corner : triangles.corners) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  return (high - low).cast<double>().cwiseProduct(scale).cwiseAbs().maxCoeff();
}

/// Meshes, each read once.
class MeshFinder {
 public:
  MeshFinder(const std::vector<std::filesystem::path>& folders, FileNotes* notes)
      : folders_(folders), notes_(notes) {}

  /// Whether the shape, a mesh, can be drawn.
  bool Find(Shape* shape) {
    MeshReference& mesh = *shape->mesh;
    const auto [known, is_new] =
        attributes_.try_emplace(mesh.filename + Attribute("scale", Numbers(mesh.scale)));
    if (is_new) {
      Triangles triangles;
      const MeshFile file = FindMeshFile(mesh.filename, folders_);
      std::string fault = file.fault.empty() ? ReadMesh(file.path, &triangles) : file.fault;
      if (fault.empty() && Extent_m(triangles, mesh.scale) < kSmallestMesh_m) {
        fault = "is smaller than a millimetre";
      }
      if (fault.empty()) {
        known->second = MeshAttributes(file, triangles, mesh.scale);
      } else {
        if (!places_.contains(fault)) places_[fault] = shape->place;
        faults_[fault].insert(mesh.filename);
      }
    }
    mesh.mjcf = known->second;
    return !mesh.mjcf.empty();
  }

  void Notice() const {
    for (const auto& [fault, names] : faults_) {
      std::string list;
      std::size_t told = 0;
      for (const std::string& name : names) {
        if (told++ == kMostNames) break;
        list += (list.empty() ? "" : ", ") + name;
      }
      if (names.size() > kMostNames) {
        list += " and " + std::to_string(names.size() - kMostNames) + " more";
      }
      notes_->Notice(places_.at(fault), "no mesh is drawn that " + fault + ": " + list +
                                            (fault.ends_with(kFolder) ? kFolderHint : ""));
    }
  }

 private:
  const std::vector<std::filesystem::path>& folders_;
  FileNotes* notes_;
  std::map<std::string, std::string> attributes_;  ///< By name and scale; empty: not drawn.
  std::map<std::string, std::set<std::string>> faults_;
  std::map<std::string, TextPlace> places_;  ///< Of the first that has the fault.
};

Shape Stick(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m) {
  const Eigen::Vector3d along_m = to_m - from_m;
  Shape stick;
  stick.kind = ShapeKind::kCapsule;
  stick.size_m << std::clamp(kStickThickness * along_m.norm(), kThinnest_m, kThickest_m),
      0.5 * along_m.norm(), 0.0;
  stick.X_BS.translation() = 0.5 * (from_m + to_m);
  stick.X_BS.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), along_m).toRotationMatrix();
  return stick;
}

/// The box of even density that has this mass and inertia.
Shape InertiaBox(const MassProperties& mass) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(mass.inertia_kgm2);
  const Eigen::Vector3d& moments = solver.eigenvalues();
  const double half_sum = 0.5 * moments.sum();
  Shape box;
  for (Eigen::Index i = 0; i < 3; ++i) {  // I_j + I_k - I_i = m a_i^2 / 6 with the edge a_i
    const double edge_m2 = 12.0 * (half_sum - moments(i)) / mass.mass_kg;
    box.size_m(i) = std::clamp(0.5 * std::sqrt(std::max(edge_m2, 0.0)), kThinnest_m, kLargestBox_m);
  }
  Eigen::Matrix3d R = solver.eigenvectors();
  if (R.determinant() < 0.0) R.col(0) *= -1.0;
  box.X_BS.linear() = R;
  box.X_BS.translation() = mass.com_m;
  return box;
}

/// Where a body's sticks lead to from its own joint: joints on it, and shapes that are drawn.
std::vector<Eigen::Vector3d> EndsOfSticks(const Body& body) {
  std::vector<Eigen::Vector3d> ends;
  for (const Body& child : body.children) {
    const Eigen::Vector3d p_CJ =
        child.joint ? child.joint->p_BJ : Eigen::Vector3d(Eigen::Vector3d::Zero());
    ends.push_back(child.X_PB * p_CJ);
  }
  for (const Shape& shape : body.shapes) {
    if (shape.collides && shape.is_drawn && !shape.mesh) {
      ends.push_back(shape.X_BS.translation());
    }
  }
  return ends;
}

void AddSticks(Body* body) {
  const Eigen::Vector3d joint_m =
      body->joint ? body->joint->p_BJ : Eigen::Vector3d(Eigen::Vector3d::Zero());
  const std::vector<Eigen::Vector3d> ends = EndsOfSticks(*body);
  std::vector<Shape> sticks;
  for (const Eigen::Vector3d& end_m : ends) {
    if ((end_m - joint_m).norm() >= kShortestStick_m) sticks.push_back(Stick(joint_m, end_m));
  }
  if (sticks.empty() && body->mass.mass_kg > 0.0) {
    const Eigen::Vector3d& com_m = body->mass.com_m;
    if ((com_m - joint_m).norm() >= kShortestStick_m) sticks.push_back(Stick(joint_m, com_m));
    sticks.push_back(InertiaBox(body->mass));
  }
  for (Shape& stick : sticks) {
    stick.link = body->name;
    body->shapes.push_back(std::move(stick));
  }
}

void Dress(MeshFinder* meshes, Body* body) {
  std::set<std::string> seen;  // links with something to look at
  bool lacks_looks = body->shapes.empty();
  for (Shape& shape : body->shapes) {
    if (shape.collides) continue;
    if (shape.mesh && !meshes->Find(&shape)) {
      lacks_looks = true;
    } else {
      seen.insert(shape.link);
    }
  }
  bool has_shape = !seen.empty();
  for (Shape& shape : body->shapes) {
    if (!shape.collides) continue;
    shape.is_drawn = !seen.contains(shape.link);
    has_shape = has_shape || !shape.mesh;
  }
  if (seen.empty() && (lacks_looks || !has_shape)) AddSticks(body);
  for (Body& child : body->children) Dress(meshes, &child);
}

}  // namespace

void FindLooks(const std::vector<std::filesystem::path>& folders, Body* base, FileNotes* notes) {
  MeshFinder meshes(folders, notes);
  Dress(&meshes, base);
  meshes.Notice();
}

}  // namespace sidestep

// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_meshes.h"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "models/import/mjcf_classes.h"

namespace sidestep::importer {
namespace {

constexpr char kTetrahedron[] = "0 0 0 1 0 0 0 1 0 0 0 1";

class MeshResolver {
 public:
  MeshResolver(const XmlTree& tree, MeshFiles* files, Problems* problems)
      : tree_(tree), files_(*files), problems_(*problems) {
    for (const XmlElement& section : tree.root.children) {
      if (section.tag != "compiler") continue;
      for (const char* key : {"assetdir", "meshdir"}) {
        if (section.Find(key) != nullptr) folder_ = section.Text(key);
      }
      if (section.Find("strippath")) is_stripped_ = section.Text("strippath") == "true";
    }
  }

  void Resolve(XmlElement* mesh) {
    const std::string* file = mesh->Find("file");
    if (file == nullptr) {
      if (mesh->Find("vertex") == nullptr) {
        problems_.AddAt(tree_.Place(*mesh), "<mesh> '" + mesh->Text("name") + "' has no file");
      }
      return;
    }
    const std::filesystem::path path =
        is_stripped_ ? std::filesystem::path(*file).filename() : std::filesystem::path(*file);
    const std::string uri = (folder_ / path).string();
    if (mesh->Find("name") == nullptr) mesh->Set("name", path.stem().string());
    std::string why;
    const std::filesystem::path real = files_.FindFile(uri, &why);
    if (!real.empty() && LoadMesh(real, &why)) {
      mesh->Set("file", real.string());
      return;
    }
    files_.Complain(uri, why);
    missing_.insert(mesh->Text("name"));
    files_.Add(mesh->Text("name"), std::nullopt);
    *mesh = {"mesh",
             {{"name", mesh->Text("name")}, {"vertex", kTetrahedron}},
             {},
             mesh->file,
             mesh->place};
  }

  bool has_missing() const { return !missing_.empty(); }
  bool IsMissing(const std::string& mesh) const { return missing_.count(mesh) > 0; }

 private:
  const XmlTree& tree_;
  MeshFiles& files_;
  Problems& problems_;
  std::filesystem::path folder_;
  bool is_stripped_{false};
  std::set<std::string> missing_;
};

/// What a body's shapes hang on.
struct MassParent {
  std::string name;        ///< Of the nearest body that has one.
  std::string childclass;  ///< Likewise.
};

/// Refuses shapes that would give their body the mass of a stand-in.
class MassChecker {
 public:
  MassChecker(const XmlTree& tree, const XmlElement& root, const MeshResolver& meshes,
              Problems* problems)
      : tree_(tree), meshes_(meshes), classes_(root), problems_(*problems) {
    for (const XmlElement& section : root.children) {
      if (section.tag != "compiler") continue;
      from_geoms_ = section.Text("inertiafromgeom");
      if (const std::string* groups = section.Find("inertiagrouprange")) {
        std::istringstream(*groups) >> first_group_ >> last_group_;
      }
    }
  }

  void Check(const XmlElement& root) const {
    if (from_geoms_ == "false") return;
    for (const XmlElement& section : root.children) {
      if (section.tag != "worldbody") continue;
      for (const XmlElement& body : section.children) CheckBody(body, {});
    }
  }

 private:
  void CheckBody(const XmlElement& body, MassParent at) const {
    if (body.tag != "body") return;
    if (body.Find("name") != nullptr) at.name = body.Text("name");
    if (body.Find("childclass") != nullptr) at.childclass = body.Text("childclass");
    const bool has_inertial = from_geoms_ != "true" && HasInertial(body);
    for (const XmlElement& child : body.children) {
      CheckBody(child, at);
      const std::string mesh = classes_.Text(child, at.childclass, "mesh");
      const bool is_missing = child.tag == "geom" && meshes_.IsMissing(mesh);
      if (has_inertial || !is_missing || !Weighs(child, at.childclass)) continue;
      problems_.AddAt(tree_.Place(child),
                      "<geom> gives body '" + at.name + "' its mass, but its " + "mesh '" + mesh +
                          "' can't be read; " +
                          (from_geoms_ == "true" ? "take inertiafromgeom out of <compiler>, or "
                                                   "give the geom mass=\"0\""
                                                 : "give the body an <inertial>"));
    }
  }

  static bool HasInertial(const XmlElement& body) {
    return std::any_of(body.children.begin(), body.children.end(),
                       [](const XmlElement& child) { return child.tag == "inertial"; });
  }

  bool Weighs(const XmlElement& geom, const std::string& childclass) const {
    const auto number = [&](const char* attribute, double otherwise) {
      const std::string text = classes_.Text(geom, childclass, attribute);
      return text.empty() ? otherwise : std::strtod(text.c_str(), nullptr);
    };
    const double group = number("group", 0.0);
    return number("mass", number("density", 1.0)) != 0.0 && group >= first_group_ &&
           group <= last_group_;
  }

  const XmlTree& tree_;
  const MeshResolver& meshes_;
  MjcfClasses classes_;
  Problems& problems_;
  std::string from_geoms_;
  double first_group_{0.0}, last_group_{mjNGROUP - 1.0};
};

}  // namespace

void ResolveMeshes(const XmlTree& tree, XmlElement* asset, XmlElement* root, MeshFiles* files,
                   Problems* problems) {
  MeshResolver resolver(tree, files, problems);
  for (XmlElement& element : asset->children) {
    if (element.tag == "mesh") resolver.Resolve(&element);
  }
  if (resolver.has_missing()) MassChecker(tree, *root, resolver, problems).Check(*root);
}

}  // namespace sidestep::importer

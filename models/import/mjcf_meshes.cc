// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_meshes.h"

#include <algorithm>
#include <set>

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
             mesh->line};
  }

  /// Refuses bodies whose mass would come from a stand-in.
  void CheckMasses(const XmlElement& body) {
    const bool has_inertial =
        std::any_of(body.children.begin(), body.children.end(),
                    [](const XmlElement& child) { return child.tag == "inertial"; });
    for (const XmlElement& child : body.children) {
      if (child.tag == "body") CheckMasses(child);
      const bool is_missing = child.tag == "geom" && missing_.count(child.Text("mesh")) > 0;
      if (!is_missing || has_inertial || body.tag != "body") continue;
      problems_.AddAt(tree_.Place(child), "<geom> gives body '" + body.Text("name") +
                                              "' its mass, but its mesh '" + child.Text("mesh") +
                                              "' can't be read; give the body an <inertial>");
    }
  }

 private:
  const XmlTree& tree_;
  MeshFiles& files_;
  Problems& problems_;
  std::filesystem::path folder_;
  bool is_stripped_{false};
  std::set<std::string> missing_;
};

}  // namespace

void ResolveMeshes(const XmlTree& tree, XmlElement* asset, XmlElement* root, MeshFiles* files,
                   Problems* problems) {
  MeshResolver resolver(tree, files, problems);
  for (XmlElement& element : asset->children) {
    if (element.tag == "mesh") resolver.Resolve(&element);
  }
  for (const XmlElement& section : root->children) {
    for (const XmlElement& body : section.children) {
      if (section.tag == "worldbody") resolver.CheckMasses(body);
    }
  }
}

}  // namespace sidestep::importer

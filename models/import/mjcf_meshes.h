// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_meshes: the files of an MJCF's meshes, found before MuJoCo opens them.

#include "models/import/mesh_files.h"
#include "models/import/problems.h"
#include "models/import/xml_tree.h"

namespace sidestep::importer {

/// Gives every <mesh> of `asset` a name and the real path of its file. A file that is missing, lies
/// where `files` may not read or is no mesh is complained of, and a tetrahedron stands in; it is a
/// problem where a body of `root` has its mass from it.
/// @param tree  For the folders that its <compiler>s name.
void ResolveMeshes(const XmlTree& tree, XmlElement* asset, XmlElement* root, MeshFiles* files,
                   Problems* problems);

}  // namespace sidestep::importer

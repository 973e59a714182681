// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "torsor/generator/mechanics/scene_content.hpp"

namespace torsor {

/// Triangles by the numbers of their corners.
struct TriangleMesh {
  std::vector<std::array<float, 3>> corners;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The file that a scene means by the name of a mesh: package://PACKAGE/REST by the folders of packages (PackageFolders),
/// file://PATH, or a name, which is relative to the folder of the file that the scene was read from. Throws FileError where
/// there is no such package or file.
std::string mesh_path(const SceneOrigin& origin, const std::string& name);

/// Reads STL, OBJ, Collada and what else Assimp reads. Throws FileError where it cannot, and where torsor was built without
/// Assimp.
TriangleMesh read_mesh(const std::string& path);

/// Numbers of corners have 16 bits in a page.
constexpr std::size_t most_corners = 65'536;

/// The mesh with at most that many triangles and `most_corners` corners, those of no triangle left out: corners in one cell of a grid become their mean, the grid being the finest
/// that leaves so few. Source: Rossignac & Borrel, Multi-resolution 3D approximations for rendering complex scenes, 1993.
TriangleMesh simplified(const TriangleMesh& mesh, std::size_t most_triangles);

}  // namespace torsor

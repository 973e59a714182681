// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/import/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "torsor/generator/base/error.hpp"
#include "torsor/generator/import/xacro_packages.hpp"

#ifdef TORSOR_WITH_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

namespace torsor {
namespace {

namespace fs = std::filesystem;

std::string path_in_package(const SceneOrigin& origin, const std::string& name) {
  static constexpr std::string_view scheme = "package://";
  const std::size_t slash = name.find('/', scheme.size());
  const std::string package = name.substr(scheme.size(), slash - scheme.size());
  PackageFolders packages(origin.path, origin.package_folders);
  const std::optional<std::string> folder = packages.find(package);
  if (!folder || slash == std::string::npos) {
    throw FileError(fmt::format("the mesh '{}' is in the package '{}', which is not found; looked at {}; give its folder by "
                                "--package-path",
                                name, package, packages.described()));
  }
  return *folder + name.substr(slash);
}

bool fits(const TriangleMesh& mesh, std::size_t most_triangles) {
  return mesh.triangles.size() <= most_triangles && mesh.corners.size() <= most_corners;
}

/// Without the corners that no triangle has.
TriangleMesh without_unused_corners(const TriangleMesh& mesh) {
  TriangleMesh result;
  std::vector<std::optional<std::uint32_t>> numbers(mesh.corners.size());
  for (std::array<std::uint32_t, 3> triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) {
      std::optional<std::uint32_t>& number = numbers[corner];
      if (!number) {
        number = static_cast<std::uint32_t>(result.corners.size());
        result.corners.push_back(mesh.corners[corner]);
      }
      corner = *number;
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

/// Corners by the cells of a grid of that many cells along the longest edge of their box.
TriangleMesh clustered(const TriangleMesh& mesh, double cells) {
  std::array<double, 3> low{}, high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-low[0]);
  for (const auto& corner : mesh.corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], static_cast<double>(corner[i]));
      high[i] = std::max(high[i], static_cast<double>(corner[i]));
    }
  }
  const double longest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
  const double size = longest > 0 ? longest / cells : 1.0;
  struct Cell {
    std::array<double, 3> sum{};
    int count = 0;
    std::uint32_t number = 0;
  };
  std::map<std::array<long, 3>, Cell> grid;
  std::vector<const Cell*> cell_of(mesh.corners.size());
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    std::array<long, 3> place{};
    for (std::size_t i = 0; i < 3; ++i) place[i] = std::lround((static_cast<double>(mesh.corners[k][i]) - low[i]) / size);
    Cell& cell = grid[place];
    for (std::size_t i = 0; i < 3; ++i) cell.sum[i] += static_cast<double>(mesh.corners[k][i]);
    ++cell.count;
    cell_of[k] = &cell;
  }
  TriangleMesh result;
  for (auto& [place, cell] : grid) {
    cell.number = static_cast<std::uint32_t>(result.corners.size());
    std::array<float, 3> mean{};
    for (std::size_t i = 0; i < 3; ++i) mean[i] = static_cast<float>(cell.sum[i] / cell.count);
    result.corners.push_back(mean);
  }
  std::set<std::array<std::uint32_t, 3>> seen;
  for (const auto& triangle : mesh.triangles) {
    const std::array<std::uint32_t, 3> corners{cell_of[triangle[0]]->number, cell_of[triangle[1]]->number,
                                               cell_of[triangle[2]]->number};
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    std::array<std::uint32_t, 3> sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    if (seen.insert(sorted).second) result.triangles.push_back(corners);
  }
  return without_unused_corners(result);
}

}  // namespace

std::string mesh_path(const SceneOrigin& origin, const std::string& name) {
  std::string path = name;
  if (name.starts_with("package://")) {
    path = path_in_package(origin, name);
  } else if (name.starts_with("file://")) {
    path = name.substr(std::string_view("file://").size());
  } else if (!origin.path.empty()) {
    path = (fs::path(origin.path).parent_path() / name).string();
  }
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) {
    throw FileError(fmt::format("there is no file '{}' for the mesh '{}'", path, name));
  }
  return path;
}

#ifdef TORSOR_WITH_ASSIMP
TriangleMesh read_mesh(const std::string& path) {
  Assimp::Importer importer;
  // Robots' files mean the axes of a Collada file as they are.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  // Corners of one place are joined only if nothing else tells them apart.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TANGENTS_AND_BITANGENTS |
                                                          aiComponent_COLORS | aiComponent_TEXCOORDS);
  const aiScene* read =
      importer.ReadFile(path, aiProcess_RemoveComponent | aiProcess_Triangulate | aiProcess_PreTransformVertices |
                                  aiProcess_JoinIdenticalVertices | aiProcess_SortByPType);
  if (read == nullptr) throw FileError(fmt::format("cannot read the mesh '{}': {}", path, importer.GetErrorString()));
  TriangleMesh mesh;
  for (unsigned m = 0; m < read->mNumMeshes; ++m) {
    const aiMesh& part = *read->mMeshes[m];
    const auto first = static_cast<std::uint32_t>(mesh.corners.size());
    for (unsigned k = 0; k < part.mNumVertices; ++k) {
      const aiVector3D& v = part.mVertices[k];
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) {
        throw FileError(fmt::format("the mesh '{}' has a corner that is no point", path));
      }
      mesh.corners.push_back({v.x, v.y, v.z});
    }
    for (unsigned k = 0; k < part.mNumFaces; ++k) {
      const aiFace& face = part.mFaces[k];
      if (face.mNumIndices == 3) {
        mesh.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
      }
    }
  }
  if (mesh.triangles.empty()) throw FileError(fmt::format("the mesh '{}' has no triangle", path));
  return mesh;
}
#else
TriangleMesh read_mesh(const std::string& path) {
  throw FileError(fmt::format("the mesh '{}' cannot be read: torsor was built without Assimp; install libassimp-dev and build "
                              "it again, or leave out --meshes",
                              path));
}
#endif

TriangleMesh simplified(const TriangleMesh& whole, std::size_t most_triangles) {
  const TriangleMesh mesh = without_unused_corners(whole);
  if (fits(mesh, most_triangles)) return mesh;
  double fewer = 1.0, more = 1024.0;
  for (int step = 0; step < 12; ++step) {
    const double middle = std::sqrt(fewer * more);
    (fits(clustered(mesh, middle), most_triangles) ? fewer : more) = middle;
  }
  return clustered(mesh, fewer);
}

}  // namespace torsor

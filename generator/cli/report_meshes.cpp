// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "torsor/generator/base/base64.hpp"
#include "torsor/generator/cli/report.hpp"
#include "torsor/generator/import/mesh_file.hpp"

namespace torsor {
namespace {

constexpr std::size_t most_triangles = 24'000;  ///< of all meshes together: some 300 kB of the page

void add(std::string& bytes, std::uint32_t number) {  // of 16 bits, the lower byte first
  bytes += static_cast<char>(number & 255U);
  bytes += static_cast<char>(number >> 8U & 255U);
}

/// Corners as shares of their box in 16 bits; numbers of corners in as many.
nlohmann::ordered_json mesh_json(const TriangleMesh& mesh) {
  std::array<float, 3> low = mesh.corners.front(), high = low;
  for (const auto& corner : mesh.corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], corner[i]);
      high[i] = std::max(high[i], corner[i]);
    }
  }
  std::string corners, triangles;
  for (const auto& corner : mesh.corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      const float size = high[i] - low[i];
      add(corners, size > 0 ? static_cast<std::uint32_t>(std::lround(65535.0F * (corner[i] - low[i]) / size)) : 0U);
    }
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) add(triangles, corner);
  }
  return {{"low", low}, {"high", high}, {"corners", base64(corners)}, {"triangles", base64(triangles)}};
}

}  // namespace

std::string report_meshes(const SceneContent& scene) {
  std::map<std::string, TriangleMesh> meshes;  // by the names that the scene has
  for (const Shown& shown : scene.shown) {
    const auto* mesh = std::get_if<form::Mesh>(&shown.form);
    if (mesh == nullptr || meshes.contains(mesh->file)) continue;
    meshes[mesh->file] = read_mesh(mesh_path(scene.origin, mesh->file));
  }
  // The small ones keep all they have, the large ones share the rest.
  std::vector<TriangleMesh*> by_size;
  for (auto& [name, mesh] : meshes) by_size.push_back(&mesh);
  std::sort(by_size.begin(), by_size.end(),
            [](const auto* a, const auto* b) { return a->triangles.size() < b->triangles.size(); });
  std::size_t left = most_triangles;
  for (std::size_t k = 0; k < by_size.size(); ++k) {
    *by_size[k] = simplified(*by_size[k], left / (by_size.size() - k));
    left -= std::min(left, by_size[k]->triangles.size());
  }
  auto json = nlohmann::ordered_json::array();
  std::map<std::string, int> numbers;
  for (const auto& [name, mesh] : meshes) {
    if (mesh.triangles.empty()) continue;
    numbers[name] = static_cast<int>(json.size());
    json.push_back(mesh_json(mesh));
  }
  auto of_forms = nlohmann::ordered_json::array();
  for (const Shown& shown : scene.shown) {
    const auto* mesh = std::get_if<form::Mesh>(&shown.form);
    const auto number = mesh == nullptr ? numbers.end() : numbers.find(mesh->file);
    of_forms.push_back(number == numbers.end() ? nlohmann::ordered_json() : nlohmann::ordered_json{{"mesh", number->second}, {"scale", mesh->scale}});
  }
  return nlohmann::ordered_json{{"meshes", json}, {"forms", of_forms}}.dump();
}

}  // namespace torsor

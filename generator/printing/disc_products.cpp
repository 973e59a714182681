// SPDX-License-Identifier: GPL-3.0-or-later
#include "torsor/generator/printing/disc_products.hpp"

#include <memory>

#include <fmt/format.h>

namespace torsor::printing {

std::vector<NamedProduct> disc_products(const Model& model) {
  Program& program = model.program();
  const SceneContent& scene = model.scene();
  std::vector<NamedProduct> products;
  for (const PointContent& point : scene.points) {
    if (!point.lowest || !point.lowest->axis) continue;
    const std::string user = name_of(point);
    const int link = model.place(point.lowest->plane, user).link;
    const Vector normal = bound(program, model.express(axis::z, point.lowest->plane, link, user));
    const Vector direction = bound(program, model.express(*point.lowest->axis, point.frame, link, user));
    const Value along = program.bind(dot(normal, direction));
    if (along.is_constant()) continue;
    // No name of a scene holds a dot; the order of creation is behind all of the scene's symbols.
    const int index = scene.symbol_count + static_cast<int>(model.coordinates().size() + products.size());
    const SymbolPointer symbol =
        std::make_shared<const Symbol>(Symbol{"n.k_" + point.name, Unit(), SymbolKind::coordinate, index, nullptr});
    products.push_back({symbol, along, point.name});
  }
  return products;
}

}  // namespace torsor::printing

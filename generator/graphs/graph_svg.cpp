// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "torsor/generator/base/as_index.hpp"
#include "torsor/generator/base/entities.hpp"
#include "torsor/generator/base/printable.hpp"
#include "torsor/generator/graphs/graph_printer.hpp"

namespace torsor {
namespace {

using Line = GraphDrawing::Line;

struct Place {
  double x = 0, y = 0;
};

/// Of some edges, in ascending order: pairs with any other that cross when vertices lie on a circle at their positions, then the
/// length along the circle.
std::pair<int, int> cost(const std::vector<int>& position, const std::vector<GraphDrawing::Edge>& edges,
                         const std::vector<std::size_t>& some) {
  const int n = static_cast<int>(position.size());
  int crossings = 0, length = 0;
  const auto chord = [&](const GraphDrawing::Edge& edge) {
    return std::minmax(position[as_index(edge.a)], position[as_index(edge.b)]);
  };
  for (const std::size_t i : some) {
    const auto [a, b] = chord(edges[i]);
    length += std::min(b - a, n - b + a);
    for (std::size_t j = 0; j < edges.size(); ++j) {
      if (j >= i && std::binary_search(some.begin(), some.end(), j)) continue;  // each pair once
      const auto [c, d] = chord(edges[j]);
      crossings += (a < c && c < b && b < d) || (c < a && a < d && d < b) ? 1 : 0;
    }
  }
  return {crossings, length};
}

/// Position of each vertex on the circle, the ground at 0: the best of all orders of a few vertices, else the best that
/// exchanges of two lead to from the order given.
std::vector<int> arrange(std::size_t count, const std::vector<GraphDrawing::Edge>& edges) {
  std::vector<int> position(count);
  std::iota(position.begin(), position.end(), 0);
  if (count < 4) return position;
  std::vector<int> best = position;
  if (count <= 8) {
    std::vector<std::size_t> all(edges.size());
    std::iota(all.begin(), all.end(), 0U);
    auto least = cost(best, edges, all);
    while (std::next_permutation(position.begin() + 1, position.end())) {
      const auto here = cost(position, edges, all);
      if (here < least) least = here, best = position;
    }
    return best;
  }
  std::vector<std::vector<std::size_t>> of(count);  // edges of each vertex, ascending
  for (std::size_t e = 0; e < edges.size(); ++e) {
    of[as_index(edges[e].a)].push_back(e);
    if (edges[e].b != edges[e].a) of[as_index(edges[e].b)].push_back(e);
  }
  for (bool better = true; better;) {
    better = false;
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t j = i + 1; j < count; ++j) {
        std::vector<std::size_t> touched;  // of all others neither crossings nor lengths change
        std::set_union(of[i].begin(), of[i].end(), of[j].begin(), of[j].end(), std::back_inserter(touched));
        const auto before = cost(best, edges, touched);
        std::swap(best[i], best[j]);
        if (cost(best, edges, touched) < before) {
          better = true;
        } else {
          std::swap(best[i], best[j]);
        }
      }
    }
  }
  return best;
}

const char* colour(Line line) {
  return line == Line::joint ? "#202020" : line == Line::constraint ? "#a03000" : "#0050a0";
}
const char* dashes(Line line) {
  return line == Line::joint        ? ""
         : line == Line::constraint ? " stroke-dasharray=\"2 4\""
                                    : " stroke-dasharray=\"7 4\"";
}

std::string escaped(const std::string& text) { return with_entities(printable(text), "&<>"); }

long whole(double x) { return std::lround(x); }

double text_width(std::size_t letters) { return 7.0 * static_cast<double>(letters); }

/// What a text or a vertex covers.
struct Box {
  Place low, high;

  double shared(const Box& other) const {
    const double x = std::min(high.x, other.high.x) - std::max(low.x, other.low.x);
    const double y = std::min(high.y, other.high.y) - std::max(low.y, other.low.y);
    return x > 0 && y > 0 ? x * y : 0.0;
  }
};

Box around(const Place& at, double aside, double above, double below) {
  return {{at.x - aside, at.y - above}, {at.x + aside, at.y + below}};
}

/// The place on an edge where its text covers least of what is taken: the middle where nothing is in the way there.
template <class On>
Place free_place(const On& on, double aside, const std::vector<Box>& taken) {
  Place best;
  std::optional<double> least;
  for (const double t : {0.5, 0.44, 0.56, 0.38, 0.62, 0.32, 0.68, 0.26, 0.74}) {
    const Place here = on(t);
    double covered = 0;
    for (const Box& box : taken) covered += around(here, aside, 14, 13).shared(box);
    if (!least || covered < *least) {
      least = covered;
      best = here;
    }
    if (!(*least > 0)) break;
  }
  return best;
}

std::string text_at(const Place& place, const std::string& text, const std::string& extra) {
  if (text.empty()) return "";
  return fmt::format("  <text x=\"{}\" y=\"{}\"{}>{}</text>\n", whole(place.x), whole(place.y), extra, escaped(text));
}

}  // namespace

std::string graph_svg(const GraphDrawing& drawing) {
  const std::size_t count = drawing.nodes.size();
  const std::vector<int> position = arrange(count, drawing.edges);
  std::map<std::pair<int, int>, int> parallel, drawn;
  int most = 0;
  for (const auto& edge : drawing.edges) most = std::max(most, ++parallel[std::minmax(edge.a, edge.b)]);
  // Neighbours 170 apart leave room for the text between them; edges that bend round others need more.
  const double beside = std::max(85.0, 50.0 * (most - 1));
  const double half = std::numbers::pi / static_cast<double>(std::max<std::size_t>(count, 2));
  const double radius = count == 1 ? 0 : std::max(90.0, beside / std::sin(half));
  std::vector<Place> places;
  for (std::size_t n = 0; n < count; ++n) {
    const double angle = std::numbers::pi / 2 + 2 * half * position[n];
    places.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  Place low, high;
  const auto make_room = [&](const Place& at, double aside, double above) {
    low = {std::min(low.x, at.x - aside), std::min(low.y, at.y - above)};
    high = {std::max(high.x, at.x + aside), std::max(high.y, at.y + above)};
  };
  std::vector<Box> taken;
  for (std::size_t n = 0; n < count; ++n) {
    taken.push_back(around(places[n], text_width(drawing.nodes[n].label.size()) / 2 + 11, 14, 14));
  }
  std::string lines, labels;
  for (const auto& edge : drawing.edges) {
    const auto [from, to] = std::minmax(edge.a, edge.b);
    const int of = parallel[{from, to}], number = drawn[{from, to}]++;
    const Place& a = places[as_index(from)];
    const Place& b = places[as_index(to)];
    const double across = (number - (of - 1) / 2.0) * 64;
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy) + 1e-9;
    const Place middle{(a.x + b.x) / 2 - across * dy / length, (a.y + b.y) / 2 + across * dx / length};
    const Place control{2 * middle.x - (a.x + b.x) / 2, 2 * middle.y - (a.y + b.y) / 2};
    std::string path = fmt::format("Q {} {} {} {}", whole(control.x), whole(control.y), whole(b.x), whole(b.y));
    std::function<Place(double)> curve = [&](double t) {
      const double u = 1 - t;
      return Place{u * u * a.x + 2 * u * t * control.x + t * t * b.x, u * u * a.y + 2 * u * t * control.y + t * t * b.y};
    };
    if (from == to) {  // parts of one body: a loop outwards
      const double away = std::hypot(a.x, a.y) + 1e-9, far = 90 + 40 * number;
      const Place out{away > 1 ? a.x / away : 0, away > 1 ? a.y / away : -1};
      const Place first{a.x + far * (out.x - out.y), a.y + far * (out.y + out.x)};
      const Place second{a.x + far * (out.x + out.y), a.y + far * (out.y - out.x)};
      path = fmt::format("C {} {} {} {} {} {}", whole(first.x), whole(first.y), whole(second.x), whole(second.y), whole(a.x),
                         whole(a.y));
      curve = [&a, first, second](double t) {
        const double u = 1 - t, of_a = u * u * u + t * t * t, of_first = 3 * u * u * t, of_second = 3 * u * t * t;
        return Place{of_a * a.x + of_first * first.x + of_second * second.x,
                     of_a * a.y + of_first * first.y + of_second * second.y};
      };
    }
    lines += fmt::format("  <path d=\"M {} {} {}\" fill=\"none\" stroke=\"{}\"{}/>\n", whole(a.x), whole(a.y), path,
                         colour(edge.line), dashes(edge.line));
    const double wide = text_width(std::max(edge.name.size(), edge.what.size())) / 2;
    const Place text = free_place(curve, wide, taken);
    taken.push_back(around(text, wide, 14, 13));
    make_room(from == to ? curve(0.5) : middle, wide + 5, 25);
    make_room(text, wide + 5, 25);
    const std::string fill = fmt::format(" class=\"edge\" fill=\"{}\"", colour(edge.line));
    labels += text_at({text.x, text.y - 3}, edge.name, fill);
    labels += text_at({text.x, text.y + 10}, edge.what, fill);
  }
  std::string bodies;
  for (std::size_t n = 0; n < count; ++n) {
    const GraphDrawing::Node& node = drawing.nodes[n];
    const double width = text_width(node.label.size()) + 22;
    const Place& p = places[n];
    make_room(p, width / 2 + 5, 25);
    if (!node.link) {
      bodies += fmt::format(
          "  <rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"28\" rx=\"{}\" fill=\"{}\" "
          "stroke=\"#202020\"/>\n",
          whole(p.x - width / 2), whole(p.y - 14), whole(width), node.ground ? 0 : 14,
          node.ground ? "#d8d8d8" : "#ffffff");
    }
    bodies += text_at({p.x, p.y + 4}, node.label,
                      node.link ? fmt::format(" class=\"edge\" fill=\"{}\"", colour(node.line)) : "");
  }
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} "
      "{3}\">\n  <title>{4}</title>\n"
      "  <style>text {{ font: 13px sans-serif; text-anchor: middle; }} .edge {{ font-size: 11px; paint-order: stroke; "
      "stroke: #ffffff; stroke-width: 4px; }}</style>\n"
      "  <rect x=\"{0}\" y=\"{1}\" width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{5}{6}{7}</svg>\n",
      whole(low.x), whole(low.y), whole(high.x - low.x), whole(high.y - low.y), escaped(drawing.title), lines, labels,
      bodies);
}

}  // namespace torsor

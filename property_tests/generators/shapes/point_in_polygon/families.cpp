#include "case/each_number.hpp"
#include "generators/narrow.hpp"
#include "generators/number_by_number.hpp"
#include "generators/outline_layouts.hpp"

namespace rayproof {

namespace point_in_polygon_family {

using outline_layout::Layout;
using outline_layout::PolygonCase;

template <const Layout& layout>
[[nodiscard]] Family planned(std::vector<MinimumShare> shares) {
  const auto ask = [](Random& random, Precision precision) -> Question {
    return rounded(precision, layout.plan(random));
  };
  return {layout.name, layout.description, ask, std::move(shares)};
}

constexpr Layout far{
    "far", "point and polygon are 1e2 to 1e6 sizes from the origin, half the time near the boundary", false,
    [](Random& random) {
      PolygonCase plan = outline_layout::either_plan(random);
      const double distance = std::pow(10, random.uniform(2, 6));
      const double x = distance * draw::symmetric<double>(random);
      const double y = distance * draw::symmetric<double>(random);
      const auto move = [&](Vec2<double>& v) { v = {v.x + x, v.y + y}; };
      move(plan.point);
      each_element(plan.vertices, move);
      return plan;
    }};

constexpr Layout near_level{"near_level", "the point is level with a vertex, or an ulp or a little more off",
                            false, [](Random& random) -> PolygonCase {
                              const Outline vertices = star(random, vertex_count(random));
                              const double y = vertices[some_index(random, vertices)].y;
                              const double off =
                                  random.one_in(2) ? 0 : draw::magnitude<double>(random, -52, -16);
                              return {{random.uniform(-8, 8), y * (1 + off)}, vertices};
                            }};

constexpr Layout many{"many", "30 to 200 vertices, half of them on a small grid", false,
                      [](Random& random) -> PolygonCase {
                        const int count = random.between(30, 200);
                        if (random.one_in(2)) return {whole_place(random, 8), scattered(random, count, 8)};
                        const double x = random.uniform(-4, 4);
                        return {{x, random.uniform(-4, 4)}, star(random, count)};
                      }};

[[nodiscard]] Question exponents(Random& random, Precision precision) {
  const double size = std::exp2(draw::any_exponent(random, precision, 8));
  return rounded(precision, grown(outline_layout::everyday.plan(random), size));
}

}  // namespace point_in_polygon_family

std::vector<Family> point_in_polygon_families() {
  using namespace point_in_polygon_family;
  namespace layout = outline_layout;
  return {
      planned<layout::whole>({in_reach, {"boundary", 0.44}, {"inside", 0.075}, {"outside", 0.3}}),
      planned<layout::everyday>({in_reach, {"inside", 0.47}, {"outside", 0.37}}),
      planned<layout::boundary>({in_reach, {"boundary", 0.95}}),
      planned<layout::near_boundary>({in_reach, {"inside", 0.3}, {"outside", 0.3}, {"boundary", 0.21}}),
      planned<layout::self_crossing>({in_reach, {"inside", 0.3}, {"outside", 0.54}}),
      planned<layout::repeated>({in_reach, {"inside", 0.09}, {"outside", 0.67}, {"boundary", 0.06}}),
      planned<layout::no_area>({in_reach, {"inside", 0.09}, {"outside", 0.15}, {"boundary", 0.6}}),
      planned<layout::narrow>({in_reach, {"inside", 0.3}, {"outside", 0.3}}),
      planned<far>({in_reach, {"inside", 0.38}, {"outside", 0.35}, {"boundary", 0.1}}),
      planned<near_level>({in_reach, {"inside", 0.26}, {"outside", 0.58}}),
      planned<many>({in_reach, {"inside", 0.4}, {"outside", 0.21}, {"boundary", 0.22}}),
      {"exponents",
       "polygons of one size, of any exponent the format has",
       exponents,
       {{"inside", 0.46}, {"outside", 0.38}}},
      special<PolygonCase>({{"inside", 0.15}, {"outside", 0.68}, {"boundary", 0.003}}),
      bit_patterns<PolygonCase>({{"inside", 0.17}, {"outside", 0.66}}),
  };
}

}  // namespace rayproof

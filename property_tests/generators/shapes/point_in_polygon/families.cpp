#include "case/similar_shapes.hpp"
#include "generators/family.hpp"
#include "generators/number_by_number.hpp"
#include "generators/outline_layouts.hpp"
#include "generators/scene.hpp"

namespace rayproof {

namespace point_in_polygon_family {

using Plan = PointAndPolygon<double>;

/// The plan with every number rounded to `T`.
template <class T>
[[nodiscard]] Question question(const Plan& plan) {
  return Plan{rounded<T>(plan.point), rounded<T>(plan.vertices)};
}

/// The layout as it is.
template <class Layout>
struct AsPlanned : Layout {
  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return question<T>(Layout::plan(random));
  }
};

struct NearLevel {
  static constexpr const char* name = "near_level";
  static constexpr const char* description =
      "the point is level with a vertex, or an ulp or a little more off";

  [[nodiscard]] static Plan plan(Random& random) {
    const Outline vertices = star(random, vertex_count(random));
    const double y = some_vertex(random, vertices).y;
    const double off = random.one_in(2) ? 0 : draw::magnitude<double>(random, -52, -16);
    return {{random.uniform(-8, 8), y * (1 + off)}, vertices};
  }
};

struct Many {
  static constexpr const char* name = "many";
  static constexpr const char* description = "30 to 200 vertices, half of them on a small grid";

  [[nodiscard]] static Plan plan(Random& random) {
    const int count = random.between(30, 200);
    if (random.one_in(2)) return {whole_place(random, 8), scattered(random, count, 8)};
    const double x = random.uniform(-4, 4);
    return {{x, random.uniform(-4, 4)}, star(random, count)};
  }
};

struct Exponents {
  static constexpr const char* name = "exponents";
  static constexpr const char* description = "polygons of one size, of any exponent the format has";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const double size = random.uniform(draw::lowest_exponent<T> + 8, draw::highest_exponent<T> - 8);
    return question<T>(grown(outline_layout::Everyday::plan(random), std::exp2(size)));
  }
};

template <class Number>
[[nodiscard]] Plan from_numbers(Random& random, Number&& number) {
  Plan plan{{}, Outline(static_cast<std::size_t>(random.between(3, 8)))};
  const auto fill = [&](double& x) { x = static_cast<double>(number()); };
  each_number(plan.point, fill);
  each_number(plan.vertices, fill);
  return plan;
}

struct SpecialPlaces : SpecialText {
  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return from_numbers(random, [&] { return draw::special<T>(random); });
  }
};

struct AnyBits : BitPatternsText {
  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return from_numbers(random, [&] { return draw::bit_pattern<T>(random); });
  }
};

}  // namespace point_in_polygon_family

std::vector<Family> point_in_polygon_families() {
  using namespace point_in_polygon_family;
  namespace layout = outline_layout;
  const char* const topic = "point_in_polygon";
  const MinimumShare in_reach{"in reach", 0.95};
  // The first family that breaks a property gives the counterexample: the most telling ones come first.
  return {
      family<AsPlanned<layout::Level>>(topic,
                                       {in_reach, {"inside", 0.14}, {"outside", 0.39}, {"boundary", 0.3}}),
      family<AsPlanned<layout::Everyday>>(topic, {in_reach, {"inside", 0.47}, {"outside", 0.37}}),
      family<AsPlanned<layout::Boundary>>(topic, {in_reach, {"boundary", 0.95}}),
      family<AsPlanned<layout::NearBoundary>>(
          topic, {in_reach, {"inside", 0.3}, {"outside", 0.3}, {"boundary", 0.21}}),
      family<AsPlanned<layout::Crossing>>(topic, {in_reach, {"inside", 0.3}, {"outside", 0.54}}),
      family<AsPlanned<layout::Repeated>>(
          topic, {in_reach, {"inside", 0.09}, {"outside", 0.67}, {"boundary", 0.06}}),
      family<AsPlanned<layout::NoArea>>(topic,
                                        {in_reach, {"inside", 0.09}, {"outside", 0.15}, {"boundary", 0.6}}),
      family<AsPlanned<layout::Far>>(topic,
                                     {in_reach, {"inside", 0.38}, {"outside", 0.35}, {"boundary", 0.1}}),
      family<AsPlanned<NearLevel>>(topic, {in_reach, {"inside", 0.26}, {"outside", 0.58}}),
      family<AsPlanned<Many>>(topic, {in_reach, {"inside", 0.4}, {"outside", 0.21}, {"boundary", 0.22}}),
      family<Exponents>(topic, {{"inside", 0.46}, {"outside", 0.38}}),
      family<SpecialPlaces>(topic, {{"inside", 0.15}, {"outside", 0.68}, {"boundary", 0.003}}),
      family<AnyBits>(topic, {{"inside", 0.17}, {"outside", 0.66}}),
  };
}

}  // namespace rayproof

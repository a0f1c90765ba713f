#include "dossier/by_hand.hpp"

#include <gtest/gtest.h>

#include "case/writer.hpp"
#include "generators/generators.hpp"
#include "oracle/oracle.hpp"

namespace rayproof::dossier {
namespace {

std::vector<double> numbers(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

NamedNumbers shape_inputs(const Sphere<double>& s) {
  return {{"center", numbers(s.center)}, {"radius", {s.radius}}};
}
NamedNumbers shape_inputs(const Triangle<double>& t) {
  return {{"a", numbers(t.a)}, {"b", numbers(t.b)}, {"c", numbers(t.c)}};
}
NamedNumbers shape_inputs(const Box<double>& b) {
  return {{"low", numbers(b.min)}, {"high", numbers(b.max)}};
}
NamedNumbers shape_inputs(const Polygon<double>& p) {
  NamedNumbers inputs;
  for (const glm::dvec3& v : p.vertices)
    for (const double x : {v.x, v.y, v.z}) inputs["vertices"].push_back(x);
  return inputs;
}

/// What the oracle's answer to a case of these shapes is compared with; nothing of other shapes and of cases
/// that have a rule of the case format's own.
std::optional<NamedNumbers> inputs_of(const RayQuestion& asked, const RayAnswer& exact) {
  if (asked.transform || exact.contact == Contact::in_surface || exact.contact == Contact::degenerate)
    return {};
  NamedNumbers inputs = std::visit(
      []<class S>(const S& shape) -> NamedNumbers {
        if constexpr (requires { shape_inputs(shape); }) return shape_inputs(shape);
        return {};
      },
      asked.shape);
  if (inputs.empty()) return {};
  inputs["origin"] = numbers(asked.ray.origin);
  inputs["direction"] = numbers(asked.ray.direction);
  inputs["t_min"] = {asked.ray.t_min};
  inputs["t_max"] = {asked.ray.t_max};
  return inputs;
}

TEST(ACalculationByHand, HasTheVerdictAndTheHitsOfTheOracle) {
  std::map<std::string, int> compared;
  for (const Family& family : families()) {
    if (family.topic == "quadratic" || family.name == "bit_patterns" || family.name == "special") continue;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const Case one = family.generate(seed, Precision::float64);
      const auto* const asked = std::get_if<RayQuestion>(&one.question);
      if (asked == nullptr) continue;
      const auto exact = std::get<RayAnswer>(oracle::answer(one));
      const auto inputs = inputs_of(*asked, exact);
      if (!inputs) continue;
      const HandCalculation right = by_hand(family.topic, *inputs);
      ++compared[family.topic];
      ASSERT_EQ(right.hits.size(), exact.hits.count) << write_case(one);
      for (std::size_t i = 0; i < right.hits.size(); ++i)
        if (right.hits[i] != exact.hits.t[i]) {  // beyond all doubles both are infinite
          EXPECT_NEAR(right.hits[i], exact.hits.t[i], 1e-13 * std::abs(exact.hits.t[i])) << write_case(one);
        }
    }
  }
  for (const char* const topic : {"sphere", "triangle", "box", "polygon"})
    EXPECT_GT(compared[topic], 150) << topic;
}

TEST(ACalculationByHand, SaysWhereAPointIsAsTheOracleDoes) {
  for (const Family& family : families()) {
    if (family.topic != "point_in_polygon") continue;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
      const Case one = family.generate(seed, Precision::float64);
      const auto& asked = std::get<PointAndPolygon<double>>(one.question);
      NamedNumbers inputs{{"point", {asked.point.x, asked.point.y}}};
      for (const auto& [x, y] : asked.vertices)
        for (const double number : {x, y}) inputs["vertices"].push_back(number);
      const HandCalculation right = by_hand("point_in_polygon", inputs);
      const auto exact = std::get<Position>(oracle::answer(one));
      EXPECT_EQ(right.is_on_boundary, exact == Position::boundary) << write_case(one);
      EXPECT_EQ(right.is_inside, exact == Position::inside) << write_case(one);
    }
  }
}

TEST(ACalculationByHand, CapsACylinder) {
  NamedNumbers inputs{{"origin", {0, 0, -3}},
                      {"direction", {0, 0, 2}},
                      {"radius", {2}},
                      {"height", {4}},
                      {"center", {0, 0, 2}}};
  EXPECT_EQ(by_hand("cylinder", inputs).hits, (std::vector<double>{1.5, 3.5}));
  inputs["origin"] = {3, 0, -3};
  EXPECT_FALSE(by_hand("cylinder", inputs).is_hit());
}

TEST(ACalculationByHand, LooksFromStartToEnd) {
  const NamedNumbers inputs{
      {"start", {0, 0, -4}}, {"end", {0, 0, 4}}, {"normal", {0, 0, 1}}, {"constant", {2}}};
  EXPECT_EQ(by_hand("plane", inputs).hits, std::vector<double>{0.75});
  EXPECT_EQ(by_hand("plane", inputs).hits_as_text, std::vector<std::string>{"0.75"});
}

TEST(ACalculationByHand, CarriesATriangleIntoTheWorld) {
  const NamedNumbers inputs{
      {"origin", {21, 2, -1}}, {"direction", {0, 0, 1}},
      {"a", {0, 0, 0}},        {"b", {4, 0, 0}},
      {"c", {0, 4, 0}},        {"matrix", {1, 10, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
  EXPECT_EQ(by_hand("triangle", inputs).hits, std::vector<double>{1});
}

TEST(ACalculationByHand, SaysWhatItLacks) {
  EXPECT_THROW((void)by_hand("sphere", {{"origin", {0, 0, 0}}}), std::runtime_error);
  EXPECT_THROW((void)by_hand("torus", {{"origin", {0, 0, 0}}, {"direction", {0, 0, 1}}}), std::runtime_error);
}

}  // namespace
}  // namespace rayproof::dossier

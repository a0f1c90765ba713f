/// \file
/// Draws situations: hits from the families of cases, in scenes of any size, and directions.

#include <algorithm>
#include <cmath>

#include "case/accepted.hpp"
#include "generators/aim.hpp"
#include "oracle/numbers/ulp.hpp"
#include "properties/leaving/situation.hpp"

namespace rayproof::leaving {

namespace {

/// The families of numbers of any size, and of no sense; and of the smallest, which are made smaller here.
constexpr std::string_view any_numbers[] = {"special", "bit_patterns", "exponents", "smallest"};

/// A unit vector, or 0.
glm::dvec3 straightened(const glm::dvec3& v) {
  const double length = std::sqrt(dot(v, v));
  return length > 0 ? 1 / length * v : glm::dvec3(0);
}

/// Mirrored, refracted into glass, anywhere, grazing, exactly along the surface where the normal's numbers
/// allow it, or along the normal.
glm::dvec3 draw_direction(Random& random, const glm::dvec3& incoming, const glm::dvec3& normal) {
  const glm::dvec3 d = straightened(incoming);
  const int kind = random.between(0, 7);
  if (kind == 0) return d - 2 * dot(d, normal) * normal;
  if (kind == 1) return d / 1.5 - 0.25 * normal;
  if (kind == 2) {
    const int axis = random.between(0, 2);
    glm::dvec3 across(0);
    across[axis] = normal[(axis + 1) % 3];
    across[(axis + 1) % 3] = -normal[axis];
    return across;
  }
  if (kind == 3) return normal;
  const glm::dvec3 anywhere = draw::unit_vector(random);
  if (kind == 4) return anywhere;
  const double steepness = std::exp2(random.uniform(-30, -2));
  return straightened(anywhere - dot(anywhere, normal) * normal) + steepness * normal;
}

/// The question in a scene `size` times as large: the world's numbers grow, and what is in an object's own
/// space only where there is no map.
RayQuestion resized(RayQuestion question, double size, Precision precision) {
  question.ray.origin *= size;
  question.ray.t_min = question.ray.t_min > 0 ? 0 : question.ray.t_min;
  question.ray.t_max = infinity<double>;
  question.ray.direction *= size;
  if (question.transform) {
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 3; ++row) (*question.transform)[column][row] *= size;
    each_number(*question.transform, [&](double& x) { x = round_to(precision, x); });
  } else {
    const auto grow = [&](auto& shape) {
      shape = grown(shape, size);
      each_number(shape, [&](double& x) { x = round_to(precision, x); });
    };
    std::visit(grow, question.shape);
  }
  each_number(question.ray.origin, [&](double& x) { x = round_to(precision, x); });
  each_number(question.ray.direction, [&](double& x) { x = round_to(precision, x); });
  return question;
}

/// The hit left `rays_from_a_hit` times.
std::vector<Situation> left_in_directions(const Situation& hit, Random& random) {
  std::vector<Situation> all;
  while (all.size() < rays_from_a_hit) {
    const double length = random.one_in(2) ? 1 : std::exp2(random.uniform(-3, 3));
    const spawn::Side side = random.one_in(2) ? spawn::Side::front : spawn::Side::back;
    glm::dvec3 direction = length * draw_direction(random, hit.question().ray.direction, hit.from.normal);
    each_number(direction, [&](double& x) { x = round_to(hit.precision(), x); });
    if (direction != glm::dvec3(0)) all.push_back(hit.turned(side, direction));
  }
  return all;
}

}  // namespace

std::vector<const Family*> families_of(const std::string& topic) {
  std::vector<const Family*> all;
  for (const Family& family : families())
    if (family.topic == topic && std::ranges::find(any_numbers, family.name) == std::end(any_numbers))
      all.push_back(&family);
  return all;
}

std::vector<Situation> draw_situations(const std::vector<const Family*>& from, std::uint64_t seed,
                                       Precision precision) {
  Random random(seed);
  for (int attempt = 0; attempt < 16; ++attempt) {
    const int family = random.between(0, static_cast<int>(from.size()) - 1);
    Departing what{from[static_cast<std::size_t>(family)]->generate(random.bits(), precision)};
    auto& question = std::get<RayQuestion>(what.incoming.question);
    const double size = random.one_in(8) ? 1 : std::pow(10, random.uniform(-6, 6));
    question = resized(question, size, precision);
    what.hit = random.one_in(2) ? 0 : 1;
    what.direction = glm::dvec3(1);  // until the normal is known
    std::optional<Situation> hit = situation_of(what);
    if (!hit && what.hit == 1) {
      what.hit = 0;
      hit = situation_of(what);
    }
    if (!hit) continue;
    return left_in_directions(*hit, random);
  }
  return {};
}

}  // namespace rayproof::leaving

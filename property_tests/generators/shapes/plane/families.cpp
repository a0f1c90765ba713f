/// \file
/// Planes in one of their three forms, and rays aimed at them: from near and far, almost along them, exactly
/// in them.

#include "generators/hard_to_round.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/whole.hpp"

namespace rayproof {

namespace plane_family {

glm::dvec3 normal_of(const Sheet& sheet) { return cross(sheet.u, sheet.v); }

/// The scene with the sheet in one of the three forms.
Scene in_some_form(Random& random, const Sheet& sheet, Scene scene) {
  const glm::dvec3 normal = normal_of(sheet);
  const int form = random.between(0, 2);
  if (form == 0) scene.shape = ImplicitPlane{normal, -dot(normal, sheet.point)};
  if (form == 1) scene.shape = PointNormalPlane{sheet.point, normal};
  if (form == 2) scene.shape = sheet;
  return scene;
}

/// A plane in a room; u and v are 1/4 to 4 long and at no small angle.
Sheet in_a_room(Random& random) {
  const glm::dvec3 u = draw::unit_vector(random);
  const double slant = random.uniform(-1, 1);
  const glm::dvec3 v = draw::perpendicular(random, u) + slant * u;
  const double length = std::exp2(random.uniform(-2, 2));
  return {point_in_a_room(random), length * u, std::exp2(random.uniform(-2, 2)) * v};
}

Sheet whole(Random& random) {
  for (;;) {
    const Sheet sheet{whole_point(random, 8), whole_vector(random, 3), whole_vector(random, 3)};
    if (normal_of(sheet) != glm::dvec3(0)) return sheet;
  }
}

glm::dvec3 somewhere(Random& random, const Sheet& sheet) {
  return at(sheet, {random.uniform(-4, 4), random.uniform(-4, 4)});
}

/// Exact for a plane of whole numbers.
glm::dvec3 exactly_somewhere(Random& random, const Sheet& sheet) {
  const double b = random.between(-3, 3);
  return at(sheet, {1.0 * random.between(-3, 3), b});
}

Scene everyday(Random& random) {
  const Sheet sheet = in_a_room(random);
  Scene scene = looked_at(random, sheet, somewhere(random, sheet));
  if (random.one_in(2)) scene = loosened(random, scene);
  if (random.one_in(4)) scene.direction = -scene.direction;
  return in_some_form(random, sheet, scene);
}

Scene near_parallel(Random& random, Precision precision) {
  const Sheet sheet = in_a_room(random);
  const double angle = draw::magnitude<double>(random, -draw::digits_of(precision), -4);
  const glm::dvec3 any_direction = draw::unit_vector(random);
  const glm::dvec3 off = random.uniform(-1, 1) * any_direction;
  const glm::dvec3 origin = somewhere(random, sheet) + off;
  const glm::dvec3 slope = angle * draw::unit_vector(random);
  return in_some_form(random, sheet, {origin, random.uniform(-2, 2) * sheet.u + sheet.v + slope});
}

Scene in_plane(Random& random) {
  const Sheet sheet = whole(random);
  const auto step = [&] { return double{1} * random.between(-3, 3); };
  const glm::dvec3 origin = at(sheet, {step(), step()});
  const double along_v = random.between(1, 3);
  Scene scene{origin, step() * sheet.u + along_v * sheet.v};
  if (random.one_in(3)) scene.origin += whole_vector(random, 2);
  return in_some_form(random, sheet, scene);
}

Scene surface(Random& random) {
  const bool exactly = random.one_in(3);
  const Sheet sheet = exactly ? whole(random) : in_a_room(random);
  const glm::dvec3 origin = exactly ? exactly_somewhere(random, sheet) : somewhere(random, sheet);
  return in_some_form(random, sheet, {origin, any_direction(random)});
}

Scene far(Random& random) {
  Sheet sheet = in_a_room(random);
  const double distance = std::pow(10, random.uniform(2, 6));
  const glm::dvec3 target = somewhere(random, sheet);
  if (random.one_in(2)) return in_some_form(random, sheet, looked_at_from_afar(random, sheet, target));
  const Scene scene = looked_at(random, sheet, target);
  const double b = distance * random.uniform(-1, 1);
  sheet.point = at(sheet, {distance * random.uniform(-1, 1), b});
  return in_some_form(random, sheet, scene);
}

Scene tiny_normal(Random& random, Precision precision) {
  Sheet sheet = in_a_room(random);
  const Scene scene = looked_at(random, sheet, somewhere(random, sheet));
  const double size = std::exp2(random.uniform(-draw::digits_of(precision) / 4.0, -2));
  sheet.u *= size;
  sheet.v *= size;
  return in_some_form(random, sheet, scene);
}

/// u and v nearly along one line: what takes them for dependent misses the plane.
Scene skewed_to(Random& random, double least) {
  Sheet sheet = in_a_room(random);
  const double angle = std::exp2(random.uniform(least, -2)), length = std::exp2(random.uniform(-2, 2));
  const glm::dvec3 along = normalize(sheet.u), across = draw::perpendicular(random, along);
  sheet.v = (random.one_in(2) ? length : -length) * (std::cos(angle) * along + std::sin(angle) * across);
  Scene scene = looked_at(random, sheet, somewhere(random, sheet));
  scene.shape = sheet;
  return scene;
}

/// A parameter is beside the middle of two numbers.
Scene hard_coordinates(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& /*grid*/) {
    hard::ShortMap map = hard::ShortMap::uneven(random);
    Sheet sheet = whole(random);
    if (random.one_in(2)) sheet.point = map.by = glm::dvec3(0);
    const bool is_u = random.one_in(2);
    const glm::dvec3 a = map.vector(is_u ? sheet.v : sheet.u), b = map.vector(is_u ? sheet.u : sheet.v);
    return map.put(hard::to_round_a_coordinate(random, precision, sheet, map.point(sheet.point), a, b));
  });
}

Scene skewed(Random& random) { return skewed_to(random, -7); }
/// The angle is so small that the square of u × v underflows where u and v are the smallest.
Scene very_skewed(Random& random, Precision precision) {
  return skewed_to(random, -0.6 * draw::digits_of(precision));
}

/// The plane's two forms with a normal have one of the grid; what else gives them is on it, too.
Scene hard_to_round(Random& random, Precision precision) {
  return hard::first_drawn(precision, [&](const hard::Grid& grid) -> std::optional<Scene> {
    const Sheet sheet = lattice::on_grid(in_a_room(random), hard::before_the_map(grid));
    const int form = random.between(0, 2);
    if (form == 0) {
      const hard::ShortMap map = hard::ShortMap::some(random);
      const Sheet mapped{map.point(sheet.point), map.vector(sheet.u), map.vector(sheet.v)};
      return map.put(hard::to_round(random, grid, sheet,
                                    hard::plane_along(grid, mapped.point, mapped.u, mapped.v),
                                    somewhere(random, mapped)));
    }
    const glm::dvec3 normal = lattice::on_grid(normal_of(sheet), grid.shape);
    const auto n = lattice::whole(normal, grid.shape);
    if (lattice::primitive(n) != n) return std::nullopt;
    if (form == 1)
      return hard::to_round(random, grid, PointNormalPlane{sheet.point, normal},
                            {n, lattice::dot(n, lattice::whole(sheet.point, grid.shape))},
                            somewhere(random, sheet));
    const double d = lattice::on_grid(-dot(normal, sheet.point), grid.shape);
    const auto height = lattice::whole({-d, 0, 0}, 2 * grid.shape)[0];
    return hard::to_round(random, grid, ImplicitPlane{normal, d}, {n, height}, somewhere(random, sheet));
  });
}

/// Of a plane given by two vectors; begins in its point now and then, or runs along one of the vectors.
Scene hard_to_meet(Random& random, Precision precision) {
  if (random.one_in(4)) {
    const Sheet sheet = in_a_room(random);
    return {sheet.point, random.one_in(2) ? sheet.u : sheet.v, sheet};
  }
  return hard::first_drawn(precision, [&](const hard::Grid& grid) {
    const hard::ShortMap map = hard::ShortMap::some(random);
    const Sheet own = lattice::on_grid(in_a_room(random), hard::before_the_map(grid)),
                sheet{map.point(own.point), map.vector(own.u), map.vector(own.v)};
    const glm::dvec3 target = random.one_in(4) ? sheet.point : somewhere(random, sheet);
    return map.put(
        hard::to_meet(random, grid, own, hard::plane_along(grid, sheet.point, sheet.u, sheet.v), target));
  });
}

/// Near the plane, and far from the point that gives it, which is the origin of coordinates or near it.
Scene beside_the_plane(Random& random) {
  Sheet sheet = in_a_room(random);
  sheet.point *= random.one_in(2) ? 0 : std::exp2(-random.uniform(6, 18));
  const glm::dvec3 off = std::exp2(-random.uniform(2, 20)) * draw::unit_vector(random);
  const glm::dvec3 origin = somewhere(random, sheet) + off;
  return in_some_form(random, sheet, {origin, any_direction(random)});
}

/// For the interval: half the time in whole numbers, so that the hit is exactly where the ray was aimed.
Scene met(Random& random) {
  const bool exactly = random.one_in(2);
  const Sheet sheet = exactly ? whole(random) : in_a_room(random);
  return in_some_form(random, sheet,
                      exactly ? looked_at_exactly(random, sheet, exactly_somewhere(random, sheet))
                              : looked_at(random, sheet, somewhere(random, sheet)));
}

/// Almost along an upright plane, at a slope of a power of two.
Scene exactly_near_parallel(Random& random) {
  const int across = random.between(0, 2);
  Sheet sheet{whole_point(random, 4), glm::dvec3(0), glm::dvec3(0)};
  sheet.u[(across + 1) % 3] = 1;
  sheet.v[(across + 2) % 3] = 1;
  glm::dvec3 sight = double{1} * random.between(-2, 2) * sheet.u + sheet.v,
             origin = exactly_somewhere(random, sheet);
  const double height = random.between(1, 4), slope = std::exp2(random.between(-23, -4));
  origin[across] += random.one_in(2) ? height : -height;
  sight[across] = random.one_in(2) ? slope : -slope;
  return in_some_form(random, sheet, {origin, sight});
}

/// Numbers so short that little of what is made of them is rounded: an axis or a small whole vector for a
/// normal, and a ray that meets the plane or runs in it or beside it.
Scene whole_numbers(Random& random) {
  if (random.one_in(3)) return in_plane(random);
  if (random.one_in(5)) return exactly_near_parallel(random);
  Sheet sheet{whole_point(random, 4), short_vector(random), short_vector(random)};
  while (normal_of(sheet) == glm::dvec3(0)) sheet.v = short_vector(random);
  const glm::dvec3 target = at(sheet, {quarters(random, -2, 2), quarters(random, -2, 2)});
  return in_some_form(random, sheet, looked_at_exactly(random, sheet, target, short_vector(random)));
}

}  // namespace plane_family

std::vector<Family> plane_families() {
  using namespace plane_family;
  return {
      laid_out<everyday>("random", "a plane in a room, in any of its forms; most rays hit",
                         {in_reach, {"hit", 0.61}, {"miss", 0.23}, {"behind", 0.23}}),
      laid_out<near_parallel>("near_parallel", "the ray comes in at 2^-4 to an ulp off the plane",
                              {in_reach, {"hit", 0.42}, {"miss", 0.42}}),
      laid_out<surface>("surface", "the origin lies in the plane or an ulp off, as secondary rays' do",
                        {in_reach, {"hit", 0.56}, {"miss", 0.27}}),
      laid_out<far>("far", "the origin, or the point that gives the plane, is 1e2 to 1e6 away",
                    {in_reach, {"hit", 0.95}}),
      laid_out<tiny_normal>("tiny_normal", "the numbers that give the plane's slope are tiny",
                            {in_reach, {"hit", 0.95}}),
      laid_out<skewed>(
          "skewed",
          "u and v, of ordinary lengths, are 1/128 to 1/4 apart in angle or run against each other so",
          {in_reach, {"hit", 0.95}}),
      laid_out<beside_the_plane>("beside_the_plane",
                                 "near the plane and far from the point that gives it, which is 0 or near it",
                                 {in_reach, {"hit", 0.4}, {"miss", 0.3}}),
      beyond_the_digits<hard_to_round>("hard_to_round", hard::to_round_description, {in_reach, {"hit", 0.3}}),
      beyond_the_digits<hard_coordinates>("hard_coordinates", hard::coordinate_description,
                                          {{"in reach", 0.5}, {"hit", 0.75}}),
      beyond_the_digits<hard_to_meet>("hard_to_meet", hard::to_meet_description,
                                      {in_reach, {"hit", 0.3}, {"miss", 0.05}}),
      of_the_smallest_size<very_skewed>({{"in reach", 0.1}, {"hit", 0.95}}),
      cut_short<met>({in_reach, {"hit", 0.49}, {"miss", 0.35}, {"in surface", 0.03}, {"behind", 0.3}}),
      placed<met>({{"in reach", 0.97}, {"hit", 0.25}, {"miss", 0.4}}),
      transformed<everyday, in_plane>(
          {in_reach, {"hit", 0.41}, {"miss", 0.43}, {"in surface", 0.21}, {"parallel", 0.06}}),
      in_whole_numbers<whole_numbers>(
          "so short that little is rounded: met at whole t, parallel, almost so, or run in",
          {in_reach, {"hit", 0.44}, {"miss", 0.39}, {"in surface", 0.28}, {"parallel", 0.06}}),
      in_any_size<everyday>({{"hit", 0.61}, {"miss", 0.23}, {"behind", 0.23}}),
      special<ImplicitPlane, PointNormalPlane, ParametricPlane>({{"hit", 0.35}, {"miss", 0.49}}),
      bit_patterns<ImplicitPlane, PointNormalPlane, ParametricPlane>({{"hit", 0.38}, {"miss", 0.46}}),
  };
}

}  // namespace rayproof

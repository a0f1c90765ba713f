#pragma once
/// \file
/// Boxes and parallelepipeds to aim at: both are a corner and three edges to a generator.

#include <array>

#include "case/independent.hpp"
#include "generators/aim.hpp"

namespace rayproof::solid_family {

/// All corner + r·edges[0] + s·edges[1] + t·edges[2] with r, s, t in [0, 1].
using Frame = Parallelepiped<double>;

[[nodiscard]] inline glm::dvec3 along(const Frame& frame, const glm::dvec3& rst) {
  return rst.x * frame.edges[0] + rst.y * frame.edges[1] + rst.z * frame.edges[2];
}
[[nodiscard]] inline glm::dvec3 at(const Frame& frame, const glm::dvec3& rst) {
  return frame.corner + along(frame, rst);
}

/// One or two edges 2^-10 to 1 times as long.
[[nodiscard]] inline Frame stretched(Random& random, Frame frame) {
  const int first = random.between(0, 2);
  for (int k = random.between(1, 2); k > 0; --k)
    frame.edges.at(static_cast<std::size_t>((first + k) % 3)) *= std::exp2(-random.uniform(0, 10));
  return frame;
}

/// Boxes. Their edges run along the axes.
struct Boxes {
  using Solid = Box<double>;

  [[nodiscard]] static Frame frame(const glm::dvec3& corner, const glm::dvec3& size) {
    return {corner, {glm::dvec3(size.x, 0, 0), glm::dvec3(0, size.y, 0), glm::dvec3(0, 0, size.z)}};
  }
  /// A solid of size about 1 in a room 20 wide.
  [[nodiscard]] static Frame in_a_room(Random& random) {
    const glm::dvec3 corner = point_in_a_room(random);
    return frame(corner, draw::vector([&] { return random.uniform(0.1, 5); }));
  }
  [[nodiscard]] static Frame whole(Random& random) {
    const glm::dvec3 corner = whole_point(random, 8);
    return frame(corner, draw::vector([&] { return double{1} * random.between(1, 8); }));
  }
  /// No thickness, or hardly any, along some axes.
  [[nodiscard]] static Frame flat(Random& random, Precision precision) {
    const bool exactly = random.one_in(2);
    Frame flat = exactly ? whole(random) : in_a_room(random);
    const double thinness =
        random.one_in(2) ? 0 : std::exp2(random.uniform(4 - draw::digits_of(precision), -4));
    const int axis = random.between(0, 2);
    flat.edges.at(static_cast<std::size_t>(axis)) *= thinness;
    if (random.one_in(8)) flat.edges.at(static_cast<std::size_t>((axis + 1) % 3)) *= thinness;
    return flat;
  }
  /// Edges of very different lengths.
  [[nodiscard]] static Frame slender(Random& random) { return stretched(random, in_a_room(random)); }
  [[nodiscard]] static Shape shape(const Frame& frame) { return Solid{frame.corner, at(frame, {1, 1, 1})}; }
};

/// Parallelepipeds. Their edges run anywhere.
struct Oblique {
  using Solid = Parallelepiped<double>;

  [[nodiscard]] static Frame in_a_room(Random& random) {
    const glm::dvec3 corner = point_in_a_room(random);
    const auto edge = [&] {
      const glm::dvec3 direction = draw::unit_vector(random);
      return random.uniform(0.1, 5) * direction;
    };
    const glm::dvec3 first = edge(), second = edge();
    return {corner, {first, second, edge()}};
  }
  [[nodiscard]] static Frame whole(Random& random) {
    for (;;) {
      const glm::dvec3 a = whole_vector(random, 4), b = whole_vector(random, 4), c = whole_vector(random, 4);
      if (dot(a, cross(b, c)) != 0) return {whole_point(random, 8), {a, b, c}};
    }
  }
  /// The third edge is almost in the plane of the others: only the last bits distinguish them.
  [[nodiscard]] static Frame flat(Random& random, Precision precision) {
    Frame flat = in_a_room(random);
    const int thinnest = 6 - draw::digits_of(precision);
    const double thinness = std::exp2(random.uniform(thinnest, random.one_in(2) ? -4 : thinnest + 6));
    const double second = random.uniform(-1, 1), first = random.uniform(-1, 1);
    flat.edges[2] = first * flat.edges[0] + second * flat.edges[1] + thinness * flat.edges[2];
    return flat;
  }
  /// Edges of very different lengths, and half the time two that run nearly along one line.
  [[nodiscard]] static Frame slender(Random& random) {
    Frame frame = stretched(random, in_a_room(random));
    if (random.one_in(2)) return frame;
    const int i = random.between(0, 2), j = (i + random.between(1, 2)) % 3;
    auto& bent = frame.edges.at(static_cast<std::size_t>(j));
    const double share = random.uniform(-1, 1);
    bent = share * frame.edges.at(static_cast<std::size_t>(i)) + std::exp2(-random.uniform(2, 8)) * bent;
    return frame;
  }
  [[nodiscard]] static Shape shape(const Frame& frame) { return frame; }
};

/// A place in the solid given by r, s, t: how many of them (1 a face, 2 an edge, 3 a corner) are at an end.
/// The others come from `free()`.
[[nodiscard]] glm::dvec3 place(Random& random, int at_an_end, auto&& free) {
  glm::dvec3 rst = draw::vector(free);
  const int first = random.between(0, 2);
  for (int k = 0; k < at_an_end; ++k) rst[(first + k) % 3] = random.between(0, 1);
  return rst;
}

[[nodiscard]] inline glm::dvec3 place(Random& random, int at_an_end) {
  return place(random, at_an_end, [&] { return random.unit(); });
}
/// The same at quarters, exact for whole solids.
[[nodiscard]] inline glm::dvec3 exact_place(Random& random, int at_an_end) {
  return place(random, at_an_end, [&] { return random.between(0, 4) / 4.0; });
}

}  // namespace rayproof::solid_family

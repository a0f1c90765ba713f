/// \file
/// Rays aimed at solids: at faces, edges and corners, along them, from inside and from afar.

#include "generators/hard_to_round.hpp"
#include "generators/layout.hpp"
#include "generators/number_by_number.hpp"
#include "generators/shapes/solid/hard_slabs.hpp"
#include "generators/shapes/solid/whole.hpp"

namespace rayproof {

namespace solid_family {

/// Whole a third of the time.
glm::dvec3 some_direction(Random& random) {
  return random.one_in(3) ? whole_vector(random, 3) : any_direction(random);
}

/// `Kind` is Boxes or Oblique.
template <class Kind>
struct SolidLayouts {
  static Scene everyday(Random& random) {
    const Frame frame = Kind::in_a_room(random);
    const glm::dvec3 target = at(frame, draw::vector([&] { return random.uniform(-0.3, 1.3); }));
    return loosened(random, looked_at(random, Kind::shape(frame), target));
  }

  static Scene edges(Random& random) {
    const Frame frame = Kind::whole(random);
    return looked_at_exactly(random, Kind::shape(frame),
                             at(frame, exact_place(random, random.between(2, 3))));
  }

  static Scene near_edges(Random& random, Precision precision) {
    const Frame frame = Kind::in_a_room(random);
    const glm::dvec3 target = at(frame, place(random, random.one_in(4) ? 3 : 2));
    return maybe_aside(random, precision, looked_at(random, Kind::shape(frame), target));
  }

  /// For the interval: aimed at a face.
  static Scene faces(Random& random) {
    const bool exactly = random.one_in(2);
    const Frame frame = exactly ? Kind::whole(random) : Kind::in_a_room(random);
    return exactly ? looked_at_exactly(random, Kind::shape(frame), at(frame, exact_place(random, 1)))
                   : looked_at(random, Kind::shape(frame), at(frame, place(random, 1)));
  }

  static Scene in_faces(Random& random) {
    const Frame frame = Kind::whole(random);
    const int across = random.between(0, 2);  // the axis the ray does not move along
    glm::dvec3 start = draw::vector([&] { return random.between(-2, 6) / 4.0; }), direction(0);
    start[across] = random.between(0, 1);
    const int other = (across + random.between(1, 2)) % 3;
    direction[other] = random.one_in(2) ? 1 : -1;
    if (random.one_in(2)) direction[3 - across - other] = random.between(-2, 2);
    Scene scene{at(frame, start), along(frame, direction), Kind::shape(frame)};
    if (random.one_in(4)) scene.t_min = -std::numeric_limits<double>::infinity();
    return scene;
  }

  static Scene surface(Random& random) {
    const bool exactly = random.one_in(2);
    const Frame frame = exactly ? Kind::whole(random) : Kind::in_a_room(random);
    const int at_an_end = random.one_in(2) ? 1 : random.between(2, 3);
    return {at(frame, exactly ? exact_place(random, at_an_end) : place(random, at_an_end)),
            some_direction(random), Kind::shape(frame)};
  }

  static Scene inside(Random& random) {
    const Frame frame = Kind::in_a_room(random);
    return {at(frame, draw::vector([&] { return random.uniform(0.001, 0.999); })), some_direction(random),
            Kind::shape(frame)};
  }

  static Scene axis_parallel(Random& random) {
    const Frame frame = random.one_in(2) ? Kind::whole(random) : Kind::in_a_room(random);
    const auto anywhere = [&] { return random.uniform(-0.3, 1.3); };
    const glm::dvec3 target = at(frame, place(random, random.one_in(3) ? 1 : 0, anywhere));
    glm::dvec3 sight = draw::vector([&] { return draw::magnitude<double>(random, -2, 0); });
    const int first = random.between(0, 2);
    for (int k = random.between(1, 2); k > 0; --k) sight[(first + k) % 3] *= 0;
    return looked_along(random, Kind::shape(frame), target, sight);
  }

  /// Aimed at a face, from without or within.
  static Scene near_parallel(Random& random, Precision precision) {
    const Frame frame = Kind::in_a_room(random);
    const int across = random.between(0, 2), tiny = random.one_in(3) ? 2 : 1;
    glm::dvec3 target = draw::vector([&] { return random.unit(); }), sight = draw::unit_vector(random);
    target[across] = random.between(0, 1);
    for (int k = 0; k < tiny; ++k)
      sight[(across + k) % 3] = draw::magnitude<double>(random, -draw::digits_of(precision), -4);
    return looked_along(random, Kind::shape(frame), at(frame, target), normalize(along(frame, sight)));
  }

  static Scene flat(Random& random, Precision precision) {
    const Frame frame = Kind::flat(random, precision);
    const glm::dvec3 target = at(frame, draw::vector([&] { return random.uniform(-0.2, 1.2); }));
    const glm::dvec3 sight = random.one_in(4) ? whole_vector(random, 1) : draw::unit_vector(random);
    return looked_along(random, Kind::shape(frame), target, sight);
  }

  static Scene far(Random& random) {
    const Frame frame = Kind::in_a_room(random);
    return looked_at_from_afar(random, Kind::shape(frame),
                               at(frame, place(random, random.one_in(2) ? 2 : 0)));
  }

  static Scene off_origin(Random& random, Precision precision) {
    return displaced(random, near_edges(random, precision));
  }

  /// The corner is the origin of coordinates or near it, and the ray begins near them.
  static Scene at_the_corner(Random& random, Precision precision) {
    Frame frame = random.one_in(3) ? Kind::flat(random, precision) : Kind::in_a_room(random);
    frame.corner *= random.one_in(3) ? 0 : std::exp2(-random.uniform(6, 18));
    const glm::dvec3 off = std::exp2(-random.uniform(4, 16)) * draw::unit_vector(random);
    return {frame.corner + off, any_direction(random), Kind::shape(frame)};
  }

  /// Edges of very different lengths, or two along nearly one line; the ray passes a few roundings from an
  /// edge.
  static Scene slender(Random& random, Precision precision) {
    const Frame frame = Kind::slender(random);
    if (random.one_in(4)) {
      const glm::dvec3 inside = draw::vector([&] { return random.uniform(0.001, 0.999); });
      return {at(frame, inside), any_direction(random), Kind::shape(frame)};
    }
    const glm::dvec3 target = at(frame, place(random, random.between(1, 3)));
    Scene scene = looked_at(random, Kind::shape(frame), target);
    if (random.one_in(4)) return scene;
    const double step = std::exp2(random.uniform(0, 4) - draw::digits_of(precision)) * glm::length(target);
    scene.origin += step * draw::unit_vector(random);
    return scene;
  }

  /// One on a grid, under a map now and then, and what the map makes of it.
  struct SolidOnGrid {
    hard::ShortMap map;
    Frame own, in_world;

    SolidOnGrid(Random& random, const hard::Grid& grid)
        : map(hard::ShortMap::some(random)),
          own(lattice::on_grid(Kind::in_a_room(random), hard::before_the_map(grid))),
          in_world{map.point(own.corner),
                   {map.vector(own.edges[0]), map.vector(own.edges[1]), map.vector(own.edges[2])}} {}
    /// Makes the edges of a face that many times as long.
    void widen(int across, double times) {
      for (Frame* frame : {&own, &in_world})
        for (const int along : {across + 1, across + 2})
          frame->edges.at(static_cast<std::size_t>(along % 3)) *= times;
    }
    [[nodiscard]] Shape shape() const { return Kind::shape(own); }
    [[nodiscard]] hard::WholePlane face(const hard::Grid& grid, int across, const glm::dvec3& end) const {
      return hard::plane_along(grid, at(in_world, end), edge(in_world, across + 1),
                               edge(in_world, across + 2));
    }
  };

  static Scene hard_to_round(Random& random, Precision precision) {
    return hard::first_drawn(precision, [&](const hard::Grid& grid) {
      const SolidOnGrid solid(random, grid);
      const int across = random.between(0, 2);
      glm::dvec3 target = draw::vector([&] { return random.unit(); }), end(0);
      target[across] = end[across] = random.between(0, 1);
      if constexpr (std::is_same_v<Kind, Boxes>)
        if (random.one_in(2)) return hard_slabs(random, grid);
      return solid.map.put(hard::to_round(random, grid, solid.shape(), solid.face(grid, across, end),
                                          at(solid.in_world, target)));
    });
  }

  static Scene hard_to_decide(Random& random, Precision precision) {
    return hard::first_drawn(precision, [&](const hard::Grid& grid) {
      const SolidOnGrid solid(random, grid);
      const int along = random.between(0, 2);
      glm::dvec3 corner = draw::vector([&] { return double{1} * random.between(0, 1); });
      corner[along] = 0;
      const glm::dvec3 from = at(solid.in_world, corner), side = edge(solid.in_world, along);
      return solid.map.put(
          hard::to_decide(random, grid, solid.shape(), from, side, from + random.unit() * side));
    });
  }

  /// Begins at a corner now and then, or runs along an edge; of some the face is as wide as a whole scene.
  static Scene hard_to_meet(Random& random, Precision precision) {
    if (random.one_in(8)) {
      const Frame frame = Kind::in_a_room(random);
      return {frame.corner, edge(frame, random.between(0, 2)), Kind::shape(frame)};
    }
    return hard::first_drawn(precision, [&](const hard::Grid& grid) {
      SolidOnGrid solid(random, grid);
      const int across = random.between(0, 2);
      if (random.one_in(3)) solid.widen(across, std::exp2(random.between(1, 2 * grid.digits)));
      glm::dvec3 target = random.one_in(4) ? glm::dvec3(0) : draw::vector([&] { return random.unit(); }),
                 end(0);
      target[across] = end[across] = random.between(0, 1);
      return solid.map.put(hard::to_meet(random, grid, solid.shape(), solid.face(grid, across, end),
                                         at(solid.in_world, target)));
    });
  }

 private:
  static glm::dvec3 edge(const Frame& frame, int i) {
    return frame.edges.at(static_cast<std::size_t>(i % 3));
  }
};

/// The families of one kind of solid. Both have the same: what is hard is where two faces meet. `flat_shares`
/// is what the flat ones must produce, of which only a box may have no thickness at all.
template <class Kind>
std::vector<Family> solid_families(const std::vector<MinimumShare>& flat_shares) {
  using Layout = SolidLayouts<Kind>;
  return {
      laid_out<Layout::everyday>("random", "a solid in a room, about half the rays hit",
                                 {in_reach, {"hit", 0.39}, {"miss", 0.43}, {"behind", 0.05}}),
      laid_out<Layout::axis_parallel>(
          "axis_parallel",
          "one or two components of the direction are exactly 0 or -0, some in the plane of a face",
          {in_reach, {"hit", 0.4}, {"miss", 0.37}, {"sharp", 0.004}}),
      laid_out<Layout::edges>("edges",
                              "in whole numbers: the line passes exactly through an edge or a corner",
                              {in_reach, {"hit", 0.95}, {"tangent", 0.32}, {"sharp", 0.74}}),
      laid_out<Layout::near_edges>("near_edges",
                                   "the line passes an ulp or so from an edge or a corner, or any small step",
                                   {in_reach, {"hit", 0.57}, {"miss", 0.24}}),
      laid_out<Layout::in_faces>(
          "in_faces", "in whole numbers: the ray runs in the plane of a face or along an edge",
          {in_reach, {"hit", 0.42}, {"miss", 0.41}, {"tangent", 0.03}, {"sharp", 0.52}}),
      laid_out<Layout::surface>(
          "surface", "the origin lies on a face, an edge or a corner, or an ulp off, as secondary rays' do",
          {in_reach, {"hit", 0.67}, {"tangent", 0.21}, {"sharp", 0.3}, {"cut", 0.24}, {"from inside", 0.03}}),
      laid_out<Layout::near_parallel>("near_parallel", "the ray comes in at 2^-4 to an ulp off a face",
                                      {in_reach, {"hit", 0.9}}),
      laid_out<Layout::flat>("flat", "the solid is nearly flat, or exactly where it may be", flat_shares),
      laid_out<Layout::inside>("inside", "the origin lies inside",
                               {in_reach, {"hit", 0.95}, {"cut", 0.95}, {"from inside", 0.95}}),
      laid_out<Layout::far>("far", "the solid is 1e2 to 1e6 sizes away, half the time aimed near an edge",
                            {in_reach, {"hit", 0.74}, {"miss", 0.1}}),
      from_the_horizon<Layout::near_edges, Layout::faces>({{"hit", 0.2}, {"miss", 0.1}}),
      laid_out<Layout::off_origin>("off_origin", displaced_description,
                                   {in_reach, {"hit", 0.5}, {"miss", 0.2}}),
      laid_out<Layout::at_the_corner>(
          "at_the_corner", "the ray begins near a corner that is the origin of coordinates or near it",
          {in_reach, {"hit", 0.2}, {"miss", 0.2}}),
      beyond_the_digits<Layout::hard_to_round>("hard_to_round", hard::to_round_description,
                                               {{"in reach", 0.35}, {"hit", 0.5}}),
      beyond_the_digits<Layout::hard_to_decide>("hard_to_decide", hard::to_decide_description,
                                                {in_reach, {"hit", 0.3}, {"miss", 0.2}}),
      beyond_the_digits<Layout::hard_to_meet>("hard_to_meet", hard::to_meet_description,
                                              {in_reach, {"hit", 0.2}, {"miss", 0.1}}),
      laid_out<Layout::slender>(
          "slender", "edges of lengths up to 1000 times another's; near an edge or a corner, or from inside",
          {in_reach, {"hit", 0.4}, {"miss", 0.2}}),
      of_the_smallest_size<Layout::slender>({{"hit", 0.4}, {"miss", 0.2}}),
      cut_short<Layout::faces>({in_reach,
                                {"hit", 0.65},
                                {"miss", 0.18},
                                {"tangent", 0.09},
                                {"sharp", 0.25},
                                {"behind", 0.18},
                                {"cut", 0.38}}),
      placed<Layout::faces>({{"in reach", 0.97}, {"hit", 0.25}, {"miss", 0.4}}),
      transformed<Layout::everyday, Layout::edges>(
          {in_reach, {"hit", 0.54}, {"miss", 0.29}, {"tangent", 0.11}, {"sharp", 0.25}}),
      in_whole_numbers<whole_numbers<Kind>>(
          "so short that little is rounded: faces, their planes, edges, corners, no thickness",
          {in_reach, {"hit", 0.62}, {"miss", 0.2}, {"tangent", 0.19}, {"sharp", 0.54}, {"cut", 0.11}}),
      in_any_size<Layout::everyday>({{"hit", 0.39}, {"miss", 0.43}, {"behind", 0.05}}),
      special<typename Kind::Solid>({{"hit", 0.03}, {"miss", 0.77}}),
      bit_patterns<typename Kind::Solid>({{"hit", 0.03}, {"miss", 0.78}}),
  };
}

}  // namespace solid_family

std::vector<Family> box_families() {
  return solid_family::solid_families<solid_family::Boxes>(
      {in_reach, {"hit", 0.4}, {"miss", 0.4}, {"sharp", 0.15}, {"tangent", 0.12}});
}
std::vector<Family> parallelepiped_families() {
  return solid_family::solid_families<solid_family::Oblique>({in_reach, {"hit", 0.6}, {"miss", 0.15}});
}

}  // namespace rayproof

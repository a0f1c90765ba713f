#include "properties/leaving/situation.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "case/accepted.hpp"
#include "generators/aim.hpp"
#include "oracle/numbers/ulp.hpp"
#include "subjects/reading.hpp"

namespace rayproof::leaving {

namespace {

/// The plain method whose hits are left, for each topic.
constexpr std::pair<const char*, const char*> plain_methods[] = {
    {"sphere", "sphere/centred"},
    {"plane", "plane/point_normal"},
    {"triangle", "triangle/moller_trumbore"},
    {"polygon", "polygon/winding"},
    {"box", "box/slabs"},
    {"parallelepiped", "parallelepiped/face_planes"},
    {"cylinder", "cylinder/centred"},
};

/// The families of numbers of any size, and of no sense.
constexpr std::string_view any_numbers[] = {"special", "bit_patterns", "exponents"};

/// The point on the surface, and its normal in the shape's own space.
struct Left {
  spawn::SurfacePoint<double> from;
  glm::dvec3 own_normal;
};

template <class T>
spawn::SurfacePoint<double> widened(const spawn::SurfacePoint<T>& from) {
  return {convert<double>(from.hit),
          convert<double>(from.point),
          convert<double>(from.normal),
          convert<double>(from.radial),
          convert<double>(from.error),
          double{from.tilt},
          double{from.bend}};
}

template <template <class> class Surface, class T>
Left left_from(const Surface<T>& surface, const RayQuestion& question,
               const std::type_identity_t<vec3<T>>& p) {
  if (!question.transform) {
    const auto from = spawn::leave(surface, p);
    return {widened(from), convert<double>(from.normal)};
  }
  const auto map = spawn::placement(glm::mat<4, 4, T>(*question.transform));
  const auto own = spawn::leave(surface, map.inverse.point(p));
  return {widened(spawn::leave(surface, map, p)), convert<double>(own.normal)};
}

template <class T>
Left leave_in(const RayQuestion& question, double t) {
  const vec3<T> p = point_at(convert<T>(question.ray), static_cast<T>(t));
  const auto leave_shape = [&](const auto& given) -> Left {
    const auto shape = convert<T>(library_shape(given));
    if constexpr (spawn::can_be_left<decltype(shape)>)
      return left_from(spawn::surface_of(shape), question, p);
    else
      throw std::logic_error("this shape can't be left");
  };
  return std::visit(leave_shape, question.shape);
}

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x + v.y + v.z); }

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

}  // namespace

const Subject* plain_method_of(const std::string& topic) {
  static const std::map<std::string, const Subject*> all = [] {
    std::map<std::string, const Subject*> found;
    for (const auto& [shape, method] : plain_methods) found[shape] = find_subject(method);
    return found;
  }();
  const auto place = all.find(topic);
  return place == all.end() ? nullptr : place->second;
}

RayQuestion Situation::leaves_from(const glm::dvec3& origin) const {
  RayQuestion leaving = question();
  leaving.ray = {origin, what.direction};
  return leaving;
}

Situation Situation::turned(spawn::Side side, const glm::dvec3& direction) const {
  Situation other = *this;
  const double least = thinnest_inside * oracle::unit_roundoff(precision()) * extent.size;
  other.what.side = extent.width < least ? spawn::Side::front : side;
  other.what.direction = direction;
  if (other.is_turned_back != (other.what.side == spawn::Side::back)) {
    other.from = towards(spawn::Side::back, from);
    other.is_turned_back = !is_turned_back;
  }
  return other;
}

std::optional<Situation> situation_of(Departing what) {
  const RayQuestion& question = std::get<RayQuestion>(what.incoming.question);
  const Subject* method = plain_method_of(topic_of(what.incoming));
  if (method == nullptr || !is_accepted(question)) return std::nullopt;
  const auto hits = std::get<RayAnswer>(method->answer(what.incoming)).hits;
  if (what.hit >= hits.count) return std::nullopt;
  const Left left = in_precision(what.incoming.precision,
                                 [&]<class T>(T) { return leave_in<T>(question, hits.t.at(what.hit)); });
  Situation made{std::move(what), left.from};
  if (!is_finite(made.from.hit) || !is_finite(made.from.point) || !is_finite(made.from.normal) ||
      !is_finite(left.own_normal) || made.what.direction == glm::dvec3(0))
    return std::nullopt;
  made.piece = oracle::piece_of(made.question().shape, left.own_normal);
  made.extent = oracle::extent_of(made.question(), made.from.hit);
  if (!(made.extent.size >= smallest_scene && made.extent.size <= largest_scene)) return std::nullopt;
  const double roundoff = oracle::unit_roundoff(made.precision()) * made.extent.size;
  const bool is_round = std::holds_alternative<Sphere<double>>(made.question().shape) ||
                        std::holds_alternative<Cylinder<double>>(made.question().shape);
  if (is_round && made.extent.width < thinnest_round * roundoff) return std::nullopt;
  return made.turned(made.what.side, made.what.direction);
}

std::vector<const Family*> families_of(const std::string& topic) {
  std::vector<const Family*> all;
  for (const Family& family : families())
    if (family.topic == topic && std::ranges::find(any_numbers, family.name) == std::end(any_numbers))
      all.push_back(&family);
  return all;
}

std::vector<std::string> topics_with_rays() {
  std::vector<std::string> all;
  for (const std::string& topic : topics())
    if (plain_method_of(topic) != nullptr) all.push_back(topic);
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
    std::vector<Situation> all;
    while (all.size() < rays_from_a_hit) {
      const double length = random.one_in(2) ? 1 : std::exp2(random.uniform(-3, 3));
      const spawn::Side side = random.one_in(2) ? spawn::Side::front : spawn::Side::back;
      glm::dvec3 direction = length * draw_direction(random, hit->question().ray.direction, hit->from.normal);
      each_number(direction, [&](double& x) { x = round_to(precision, x); });
      if (direction != glm::dvec3(0)) all.push_back(hit->turned(side, direction));
    }
    return all;
  }
  return {};
}

}  // namespace rayproof::leaving

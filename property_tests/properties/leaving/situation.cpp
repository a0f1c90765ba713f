#include "properties/leaving/situation.hpp"

#include <cmath>
#include <map>

#include "case/accepted.hpp"
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

/// The normal in its own space of the face that was left; a parallelepiped's is chosen in the world.
template <template <class> class Surface, class T>
vec3<T> own_normal(const Surface<T>& surface, const spawn::Placement<T>& map, const vec3<T>& p,
                   const spawn::SurfacePoint<T>& from) {
  if constexpr (!spawn::can_be_placed<Surface<T>>) {
    return spawn::leave(surface, map.inverse.point(p)).normal;
  } else {
    const Surface<T> placed = place(surface, map);
    const vec3<T>*own[] = {&surface.normal_x, &surface.normal_y, &surface.normal_z},
          *seen[] = {&placed.normal_x, &placed.normal_y, &placed.normal_z};
    for (int i = 0; i < 3; ++i) {
      if (from.normal == *seen[i]) return *own[i];
      if (from.normal == -*seen[i]) return -*own[i];
    }
    return vec3<T>(infinity<T>);
  }
}

template <template <class> class Surface, class T>
Left left_from(const Surface<T>& surface, const RayQuestion& question,
               const std::type_identity_t<vec3<T>>& p) {
  if (!question.transform) {
    const auto from = spawn::leave(surface, p);
    return {widened(from), convert<double>(from.normal)};
  }
  const auto map = spawn::placement(glm::mat<4, 4, T>(*question.transform));
  const auto from = spawn::leave(surface, map, p);
  return {widened(from), convert<double>(own_normal(surface, map, p, from))};
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

/// How many units roundoff of its scene a shape must be thick.
double thinnest_left(const Shape& shape) {
  if (std::holds_alternative<Parallelepiped<double>>(shape)) return thinnest_slanted;
  const bool is_round =
      std::holds_alternative<Sphere<double>>(shape) || std::holds_alternative<Cylinder<double>>(shape);
  return is_round ? thinnest_round : 0;
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
  const double least = thinnest_inside * roundoff_of(precision()) * extent.size;
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
  if (!is_finite(made.from.hit) || made.what.direction == glm::dvec3(0)) return std::nullopt;
  made.has_normal = is_finite(made.from.point) && is_finite(made.from.normal) && is_finite(left.own_normal);
  if (!made.has_normal && !oracle::has_inside(made.question().shape)) return std::nullopt;
  made.piece = oracle::piece_of(made.question().shape, left.own_normal);
  made.extent = oracle::extent_of(made.question(), made.from.hit);
  if (!(made.extent.size >= smallest_scene && made.extent.size <= largest_scene)) return std::nullopt;
  const double roundoff = roundoff_of(made.precision()) * made.extent.size;
  if (made.extent.width < thinnest_left(made.question().shape) * roundoff) return std::nullopt;
  return made.turned(made.what.side, made.what.direction);
}

std::vector<std::string> topics_with_rays() {
  std::vector<std::string> all;
  for (const std::string& topic : topics())
    if (plain_method_of(topic) != nullptr) all.push_back(topic);
  return all;
}

}  // namespace rayproof::leaving

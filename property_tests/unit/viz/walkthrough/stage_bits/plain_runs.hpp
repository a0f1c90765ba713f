#pragma once
/// \file
/// The library's functions that composed lessons show, in plain floating point.

#include <nlohmann/json.hpp>
#include <rayproof/box/slab.hpp>
#include <rayproof/camera.hpp>
#include <rayproof/formulas/largest_axis.hpp>
#include <rayproof/formulas/polygon_sides.hpp>
#include <rayproof/implicit/torus.hpp>
#include <rayproof/parametric/bilinear_quadratic.hpp>
#include <rayproof/plane/point_normal.hpp>
#include <rayproof/spawn.hpp>
#include <rayproof/transform.hpp>
#include <rayproof/triangle/barycentric.hpp>

#include "oracle/oracle.hpp"
#include "unit/viz/stage_data.hpp"
#include "unit/viz/walkthrough/stage_bits/heard_kernels.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {

using Json = nlohmann::json;

/// The library's own functions that a composed lesson shows, run in plain T; by the lesson's name, or by the
/// beginning of it.
template <class T>
class PlainRuns {
 public:
  using H = Heard<T>;
  PlainRuns(const Case& one, const Json& data) : one_(one), data_(data) { H::names.clear(); }

  NamedNumbers of(const std::string& lesson, const std::string& title) {
    if (lesson == "digits") return heard(one_, "sphere/textbook");
    if (lesson == "transformed") return heard(one_, "sphere/centred");
    if (lesson == "woop") return heard(one_, "triangle/woop");
    if (lesson == "property-test") return heard(one_, data_["method"]);
    if (lesson == "raycasting") return of_ball(title);
    if (lesson == "leak") return of_leak(title);
    if (lesson == "ray") along_ray();
    if (lesson == "polygon-in-space") return in_space();
    if (lesson == "ray-segment") return tries();
    if (lesson == "implicit-torus") torus();
    if (lesson == "parametric-patch") return patch();
    if (lesson == "leaving-a-sphere") leave_sphere();
    if (lesson == "camera") camera();
    if (lesson == "barycentric") barycentric();
    if (lesson == "slab-intervals") slabs();
    if (lesson == "transformed-normal") normal();
    if (lesson.starts_with("polygon")) sides();
    return H::names;
  }

 private:
  [[nodiscard]] const RayQuestion& asked() const { return std::get<RayQuestion>(one_.question); }
  /// A vector that the first step shows.
  [[nodiscard]] vec3<H> given(const std::string& name) const {
    for (const auto& value : data_["steps"][0]["values"]) {
      if (value["name"] != name) continue;
      const auto at = [&](std::size_t i) { return H(number_in(value["components"][i]["value"])); };
      return value["components"].size() == 3 ? vec3<H>{at(0), at(1), at(2)} : vec3<H>{at(0), H(0), H(0)};
    }
    return {H(NAN), H(NAN), H(NAN)};
  }

  void along_ray() {
    const Ray<H> ray = convert<H>(asked().ray);
    (void)named("p(0)", point_at(ray, H(0)));
    (void)named("p(1)", point_at(ray, H(1)));
    (void)named("p(2.5)", point_at(ray, H(2.5)));
    (void)named("p(-0.5)", point_at(ray, H(-0.5)));
    const H length = named("|d|", sqrt(dot(ray.direction, ray.direction)));
    (void)named("distance", H(2.5) * length);
  }
  void leave_sphere() {
    const Answer exact = oracle::answer(one_);
    const vec3<H> p = named("p", point_at(convert<H>(asked().ray), H(std::get<RayAnswer>(exact).hits.t[0])));
    const auto from = spawn::leave(convert<H>(std::get<Sphere<double>>(asked().shape)), p);
    (void)named("q", from.point);
    (void)named("n", from.normal);
    (void)spawn::Proven::origin(from);
  }
  void camera() {
    const rayproof::Camera<H> camera{given("eye"), given("center"), given("up"), given("half_w").x,
                                     given("half_h").x};
    const auto axes = camera::axes(camera);
    (void)camera::PixelCentre::ray(camera, axes, ImageSize<H>{H(8), H(6)}, H(4), H(2));
  }
  void barycentric() {
    const auto flat = [](const glm::dvec3& p) { return Vec2<H>{H(p.x), H(p.y)}; };
    const auto& triangle = std::get<Triangle<double>>(asked().shape);
    (void)triangle::barycentric(flat(asked().ray.origin), flat(triangle.a), flat(triangle.b),
                                flat(triangle.c));
  }
  void slabs() {
    const Ray<H> ray = convert<H>(asked().ray);
    const auto box = convert<H>(std::get<rayproof::Box<double>>(asked().shape));
    const auto slab = [&](H vec3<H>::*axis, const std::string& name) {
      const auto one = box::slab_of(ray.direction.*axis, box.min.*axis - ray.origin.*axis,
                                    box.max.*axis - ray.origin.*axis);
      (void)named((name + "_in").c_str(), one.entry);
      (void)named((name + "_out").c_str(), one.exit);
      return one;
    };
    const auto x = slab(&vec3<H>::x, "x");
    const auto y = slab(&vec3<H>::y, "y");
    const auto z = slab(&vec3<H>::z, "z");
    (void)box::overlap(x, y, z);
  }
  void normal() {
    const auto column = [&](int i) { return convert<H>(glm::dvec3((*asked().transform)[i])); };
    const auto space = object_space<H>(column(0), column(1), column(2), column(3));
    const double t = std::get<RayAnswer>(oracle::answer(one_)).hits.t[0];
    const vec3<H> q = named("q", point_at(to_object(space, convert<H>(asked().ray)), H(t)));
    (void)named("r", H(std::get<Sphere<double>>(asked().shape).radius));
    (void)named("n", q);
    (void)named("A·n", vec3<H>(q.x * column(0) + q.y * column(1) + q.z * column(2)));
    (void)named("m", vec3<H>(q.x * space.row_x + q.y * space.row_y + q.z * space.row_z));
  }
  void sides() {
    const auto question = convert<H>(std::get<PointAndPolygon<double>>(one_.question));
    const auto& v = question.vertices;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const auto [s, t] = polygon::cross_side(question.point, v[i], v[polygon::next(i, v.size())]);
      (void)named(("s" + subscript(i)).c_str(), s);
      (void)named(("t" + subscript(i)).c_str(), t);
    }
  }
  void side(std::size_t i, const Vec2<H>& p, const Vec2<H>& a, const Vec2<H>& b) {
    const auto [s, t] = polygon::cross_side(p, a, b);
    (void)named(("s" + subscript(i)).c_str(), s);
    (void)named(("t" + subscript(i)).c_str(), t);
  }
  NamedNumbers in_space() {
    const Ray<H> ray = convert<H>(asked().ray);
    std::vector<vec3<H>> v;
    for (const glm::dvec3& vertex : std::get<rayproof::Polygon<double>>(asked().shape).vertices)
      v.push_back(convert<H>(vertex));
    const vec3<H> n = named("n", polygon::newell_normal<H>(v, v.front()));
    const vec3<H> q = named("q", point_at(ray, plane::meet(ray, v.front(), n).lo));
    const LargestAxisLast<H> turned(n);
    for (std::size_t i = 0; i < v.size(); ++i)
      side(i, turned.dropped(q), turned.dropped(v[i]), turned.dropped(v[polygon::next(i, v.size())]));
    return H::names;
  }
  NamedNumbers tries() {
    const auto question = convert<H>(std::get<PointAndPolygon<double>>(one_.question));
    const std::array<Vec2<double>, 3> origins{{{-1.1, 0.3}, {-1.1, 1.2}, {1.6, 0.1}}};
    for (std::size_t i = 0; i < origins.size(); ++i) {
      const Vec2<H> p{named("p.x", H(origins[i].x)), named("p.y", H(origins[i].y))};
      side(i, p, question.vertices[0], question.vertices[1]);
    }
    return H::names;
  }
  void torus() {
    const Ray<H> ray = convert<H>(asked().ray);
    const implicit::Torus<double> f{1.25, 0.5};
    const auto value = [&](const char* point, const char* name, double t) {
      const vec3<H> p = named(point, point_at(ray, H(t)));
      return named(name, f(p.x, p.y, p.z, H(1)));
    };
    const H first = value("p_a", "f(t_a)", 1);
    const H second = value("p_b", "f(t_b)", 1.5);
    const H share = named("share", first / (first - second));
    (void)named("t_s", H(1) + share * H(0.5));
  }
  NamedNumbers patch() {
    const auto at = [](double x, double y, double z) { return vec3<H>{H(x), H(y), H(z)}; };
    parametric::BilinearPatch<H> patch;
    patch.points = {{{at(-1.25, -1, 0.75), at(-1, 1.25, -0.25)}, {at(1.25, -0.75, -0.25), at(1.5, 1, 1)}}};
    (void)parametric::BilinearQuadratic::roots(convert<H>(asked().ray), patch);
    return H::names;
  }
  NamedNumbers of_ball(const std::string& title) {
    Case with_ball = one_;
    const bool is_first = title == "Meet the first object";
    std::get<RayQuestion>(with_ball.question).shape =
        is_first ? Sphere<double>{{0, 0, 0.2}, 0.75} : Sphere<double>{{1.2, -0.4, 0.6}, 0.4};
    return heard(with_ball, "sphere/centred");
  }
  NamedNumbers of_leak(const std::string& title) {
    Case judged = one_;
    auto& triangle = std::get<Triangle<double>>(std::get<RayQuestion>(judged.question).shape);
    const bool is_second = title.starts_with("The second") || title.starts_with("Woop, the second");
    if (is_second) triangle = {triangle.b, triangle.a, {2.5, static_cast<double>(1.8F), 1.5}};
    return heard(judged, title.starts_with("Woop") ? "triangle/woop" : "triangle/moller_trumbore");
  }

  const Case& one_;
  const Json& data_;
};

}  // namespace rayproof::viz

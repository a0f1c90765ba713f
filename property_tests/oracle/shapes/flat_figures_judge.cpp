/// \file
/// The judges for planes and triangles.

#include <algorithm>

#include "oracle/geometry/triangle_volumes.hpp"
#include "oracle/judge/flat_judge.hpp"
#include "oracle/shapes/plane.hpp"
#include "oracle/shapes/triangle.hpp"

namespace rayproof::oracle {
namespace {

class TriangleFigure final : public FlatFigure {
 public:
  TriangleFigure(const RayQuestion& question, const Triangle<double>& triangle)
      : FlatFigure(question, plane_of(triangle), product_of_edges(triangle), distance(triangle)),
        volumes_(ray(), triangle),
        position_(distance(triangle)) {}

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = FlatFigure::margin();
    reduce(nearest, steepness());
    const Scaled scale = abs(approximate(ray().scale));
    const Scaled length = sizes().origin + position_;
    const Scaled unit = scale * scale * scale * length * length * sizes().direction;
    for (const Ring* volume : {&volumes_.a, &volumes_.b, &volumes_.c})
      reduce(nearest, ratio(abs(approximate(*volume)), unit));
    return nearest;
  }

 protected:
  [[nodiscard]] bool holds_meeting() const override { return volumes_.is_inside(); }

 private:
  /// The product of the two longest edges.
  static Scaled product_of_edges(const Triangle<double>& t) {
    const auto edge = [](const glm::dvec3& from, const glm::dvec3& to) {
      return norm(Vector<Ring>::from(to) - Vector<Ring>::from(from));
    };
    std::array<Scaled, 3> edges{edge(t.a, t.b), edge(t.b, t.c), edge(t.c, t.a)};
    std::ranges::sort(edges, [](const Scaled& x, const Scaled& y) { return x < y; });
    return edges[1] * edges[2];
  }
  static Scaled distance(const Triangle<double>& t) { return std::max({norm(t.a), norm(t.b), norm(t.c)}); }

  TriangleVolumes volumes_;
  Scaled position_;
};

}  // namespace

Judgement judge(const RayQuestion& question, const ImplicitPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  const Scaled size = norm(plane.normal);
  const FlatEquation equation{Vector<Ring>::from(plane.normal), Ring(-plane.d)};
  const FlatFigure figure(question, equation, size, abs(Scaled(plane.d)) / size);
  return judge_hits(question, figure, precision, claimed);
}

Judgement judge(const RayQuestion& question, const PointNormalPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  const auto normal = Vector<Ring>::from(plane.normal);
  const FlatEquation equation{normal, dot(normal, Vector<Ring>::from(plane.point))};
  const FlatFigure figure(question, equation, norm(plane.normal), norm(plane.point));
  return judge_hits(question, figure, precision, claimed);
}

Judgement judge(const RayQuestion& question, const ParametricPlane& plane, Precision precision,
                const RayAnswer& claimed) {
  const Vector<Ring> normal = cross(Vector<Ring>::from(plane.u), Vector<Ring>::from(plane.v));
  const FlatEquation equation{normal, dot(normal, Vector<Ring>::from(plane.point))};
  const FlatFigure figure(question, equation, norm(plane.u) * norm(plane.v), norm(plane.point));
  return judge_hits(question, figure, precision, claimed);
}

Judgement judge(const RayQuestion& question, const Triangle<double>& triangle, Precision precision,
                const RayAnswer& claimed) {
  return judge_hits(question, TriangleFigure(question, triangle), precision, claimed);
}

}  // namespace rayproof::oracle

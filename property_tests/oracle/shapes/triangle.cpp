#include "oracle/shapes/triangle.hpp"

#include <algorithm>

#include "oracle/geometry/triangle_volumes.hpp"
#include "oracle/judge/flat_judge.hpp"

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

RayAnswer answer(const RayQuestion& question, const Triangle<double>& triangle, Precision precision) {
  const FlatEquation plane = plane_of(triangle);
  RayAnswer miss;
  if (is_zero(plane.normal)) {
    miss.contact = Contact::degenerate;
    return miss;
  }
  const ObjectRay<Ring> ray(question);
  const FlatMeeting meeting(ray, plane);
  if (meeting.is_parallel()) {
    miss.contact = meeting.parallel_contact();
    return miss;
  }
  const TriangleVolumes volumes(ray, triangle);
  if (!volumes.is_inside()) return miss;
  const Quotient t = meeting.t();
  if (!is_in_interval(t, question.ray)) return miss;

  const int on_sides = volumes.zeros();
  const Contact contact = on_sides == 2 ? Contact::vertex : on_sides == 1 ? Contact::edge : Contact::crossing;
  RayAnswer result = flat_answer(question, ray, plane.normal, t, contact, precision);
  const Ring sum = volumes.sum();
  result.barycentric = glm::dvec3(round_correctly(Quotient(volumes.a, sum), precision),
                                  round_correctly(Quotient(volumes.b, sum), precision),
                                  round_correctly(Quotient(volumes.c, sum), precision));
  return result;
}

Judgement judge(const RayQuestion& question, const Triangle<double>& triangle, Precision precision,
                const RayAnswer& claimed) {
  return judge_hits(question, TriangleFigure(question, triangle), precision, claimed);
}

}  // namespace rayproof::oracle

#include <gtest/gtest.h>

#include "unit/answering/panel.hpp"

namespace rayproof {
namespace {

/// A vector of somebody else's.
struct Triple {
  double x, y, z;
};

std::string with_shape(const std::string& shape) {
  return R"({"id": 7, "ray": {"origin": [0, 0, -5], "direction": [0, 0, 2]}, "shape": )" + shape + "}";
}
const std::string triangle =
    with_shape(R"({"type": "triangle", "a": [0, 0, 0], "b": [1, 2, 0], "c": [0, 4, 0]})");
const std::string plane = with_shape(R"({"type": "plane", "point": [0, 0, 6], "normal": [0, 0, 1]})");

TEST(parameters_of_a_function, may_be_the_librarys_structures) {
  const auto f = [](const Ray<float>& ray, const Sphere<float>& sphere) -> std::optional<float> {
    return ray.t_min - ray.origin.z - sphere.radius;
  };
  EXPECT_EQ(answer_of(sphere_case("-5"), f), hit_at("4"));
  EXPECT_EQ(answer_of(sphere_case("-5", R"(, "t_min": 9)"), f), hit_at("13"));
  const auto planes = [](const Ray<double>&, const Plane<double>& given) -> std::optional<double> {
    return given.form == PlaneForm::point_normal ? given.point.z : -1;
  };
  EXPECT_EQ(answer_of(plane, planes), hit_at("6"));
}

TEST(parameters_of_a_function, may_be_vectors_of_any_class_and_plain_numbers) {
  const auto triples = [](Triple o, const Triple& d, Triple a, Triple b, Triple c) {
    return d.z - o.z + a.x + b.y + c.y;
  };
  EXPECT_EQ(answer_of(triangle, triples), hit_at("13"));
  const auto arrays = [](std::array<double, 3> o, const double* d, const double* a, const double* b,
                         const double* c) { return d[2] - o[2] + a[0] + b[1] + c[1]; };
  EXPECT_EQ(answer_of(triangle, arrays), hit_at("13"));
  const auto numbers = [](float ox, float oy, float oz, float dx, float dy, float dz, float x, float y,
                          float z, float r) { return ox + oy - oz + dx + dy + dz + x + y + z + r; };
  EXPECT_EQ(answer_of(sphere_case("-5"), numbers), hit_at("8"));
}

TEST(parameters_of_a_function, may_have_the_interval_before_or_behind_the_shape) {
  const auto before = [](D3, D3, double t_min, double t_max, D3, double) -> std::optional<double> {
    return t_max - t_min;
  };
  const auto behind = [](D3, D3, D3, double, double t_min, double t_max) -> std::optional<double> {
    return t_max - t_min;
  };
  const std::string asked = sphere_case("-5", R"(, "t_min": 2, "t_max": 9)", "float64");
  EXPECT_EQ(answer_of(asked, before), hit_at("7"));
  EXPECT_EQ(answer_of(asked, behind), hit_at("7"));
}

TEST(parameters_of_a_function, may_be_the_transform_and_then_the_ray_is_in_the_world) {
  const auto seen = [](D3 origin, D3, D3, double, glm::dmat4 m) { return glm::dvec4(m[3].x, origin); };
  const std::string moved = R"({"id": 7, "ray": {"origin": [4, 5, 6], "direction": [0, 0, 1]}, "transform": )"
                            R"([[1, 0, 0, 3], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], )" +
                            unit_sphere;
  EXPECT_EQ(answer_of(moved, seen), R"({"id": 7, "verdict": "hit", "hits": [{"t": 3}], "normal": [4, 5, 6]})"
                                    "\n");
  const auto translation = [](D3, D3, D3, double, glm::dmat4 m) { return m == glm::dmat4(1) ? 2.0 : -1.0; };
  EXPECT_EQ(answer_of(sphere_case("-5", "", "float64"), translation), hit_at("2"))
      << "the identity, where there is none";
}

TEST(parameters_of_a_function, that_name_no_shape_of_the_format_are_refused_in_one_sentence) {
  const auto two_numbers = [](D3, D3, double, double) { return 1.0; };
  try {
    (void)answer_of(plane, two_numbers);
    ADD_FAILURE() << "not refused";
  } catch (const std::invalid_argument& why) {
    const std::string words = why.what();
    EXPECT_NE(words.find("takes a vector, a vector, a number, a number, which no shape"), std::string::npos)
        << words;
    EXPECT_NE(words.find("docs/your-own-code.md"), std::string::npos) << words;
  }
}

TEST(parameters_of_a_function, that_look_like_several_shapes_mean_no_plane_unless_it_is_named) {
  const auto two_vectors = [](D3, D3, D3 a, D3 b) { return a.z + b.z; };
  EXPECT_EQ(answer_of(plane, two_vectors), unsupported);
  EXPECT_EQ(answer_of(with_shape(R"({"type": "box", "min": [0, 0, 1], "max": [1, 1, 4]})"), two_vectors),
            hit_at("5"));
  EXPECT_EQ(answer_of(plane, takes<PointNormalPlane>(two_vectors)), hit_at("7"));
}

TEST(parameters_of_a_function, say_every_shape_of_the_format) {
  const auto polygon = [](D3, D3, const std::vector<D3>& all) { return static_cast<double>(all.size()); };
  EXPECT_EQ(
      answer_of(with_shape(R"({"type": "polygon", "vertices": [[0,0,0],[1,0,0],[0,1,0],[3,3,3]]})"), polygon),
      hit_at("4"));
  const auto cylinder = [](D3, D3, double rx, double ry, double height, bool capped) {
    return rx + ry + height + capped;
  };
  EXPECT_EQ(answer_of(with_shape(R"({"type": "cylinder", "rx": 1, "ry": 2, "height": 3, "capped": true})"),
                      cylinder),
            hit_at("7"));
  EXPECT_EQ(answer_of(with_shape(R"({"type": "cylinder", "rx": 1, "ry": 2, "height": 3})"), cylinder),
            hit_at("6"));
  const auto solid = [](D3, D3, D3 corner, const std::array<D3, 3>& edges) { return corner.x + edges[2].z; };
  const std::string asked =
      with_shape(R"({"type": "parallelepiped", "corner": [1,0,0], "edges": [[1,0,0],[0,1,0],[0,0,4]]})");
  EXPECT_EQ(answer_of(asked, solid), hit_at("5"));
}

TEST(parameters_of_a_function, say_questions_without_a_ray) {
  const auto roots = [](double a, double b, double c) { return std::vector<double>{a, b, c}; };
  EXPECT_EQ(answer_of(R"({"id": 7, "query": "quadratic", "a": 1, "b": 2, "c": 3})", roots),
            "{\"id\": 7, \"x\": [1, 2, 3]}\n");
  const auto is_inside = [](Vec2<double> p, std::span<const glm::dvec2> all) { return p.x < all[1].x; };
  const std::string asked =
      R"({"id": 7, "query": "point_in_polygon", "point": [0, 0], "vertices": [[0,0],[2,0],[0,1]]})";
  EXPECT_EQ(answer_of(asked, is_inside), "{\"id\": 7, \"position\": \"inside\"}\n");
  const auto says_boundary = [](const PointAndPolygon<double>&) { return Position::boundary; };
  EXPECT_EQ(answer_of(asked, says_boundary), "{\"id\": 7, \"position\": \"boundary\"}\n");
}

TEST(parameters_of_a_function, say_its_precision) {
  const auto narrow = [](glm::vec3, glm::vec3, glm::vec3, float) { return 1.0F; };
  const auto wide = [](D3, D3, D3, double) { return 2.0; };
  EXPECT_EQ(answer_of(sphere_case("-5", "", "float64"), narrow), unsupported);
  EXPECT_EQ(answer_of(sphere_case("-5", "", "float64"), narrow, wide), hit_at("2"));
  EXPECT_EQ(answer_of(sphere_case("-5"), wide, narrow), hit_at("1"));
  EXPECT_EQ(answer_of(sphere_case("-5"), wide), hit_at("2"));
}

}  // namespace
}  // namespace rayproof

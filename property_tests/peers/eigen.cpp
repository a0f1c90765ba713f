/// \file
/// Eigen 3.4, ParametrizedLine and Hyperplane, in float and double. Their documentation takes direction and
/// normal for unit vectors, and the line for infinite. Of parallel lines it says nothing.
#include <Eigen/Geometry>

#include "peers/reproduction.hpp"

namespace rayproof {
namespace {

template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;

template <class T>
Vector<T> eigen(const vec3<T>& v) {
  return {v.x, v.y, v.z};
}

/// What is asked of a line and a plane that the text in between makes, by `normal` and what places it.
template <class T, class V>
T meet(const vec3<T>& origin, const vec3<T>& direction, const Eigen::Hyperplane<T, 3>& plane,
       const char* made, const vec3<T>& normal, const peers::Given<V>& place) {
  using peers::given;
  peers::LibraryCall call("Eigen::ParametrizedLine::intersectionParameter", R"(#include <Eigen/Geometry>
using Vector = Eigen::Matrix<$T, 3, 1>;
Eigen::ParametrizedLine<$T, 3> line(Vector($origin), Vector($direction));)",
                          given("t_min", -infinity<T>), given("origin", origin),
                          given("direction", direction));
  call.add(made, given("normal", normal), place);
  call.add(R"(std::printf("t = $g\n", line.intersectionParameter(plane));)", given("t_max", infinity<T>));
  call.ask();
  const T t =
      Eigen::ParametrizedLine<T, 3>(eigen<T>(origin), eigen<T>(direction)).intersectionParameter(plane);
  call.said(given("t", t));
  return t;
}

template <class T>
T point_normal(vec3<T> origin, vec3<T> direction, vec3<T> point, vec3<T> normal) {
  const Eigen::Hyperplane<T, 3> plane(eigen<T>(normal).normalized(), eigen<T>(point));
  return meet<T>(origin, direction, plane,
                 "Eigen::Hyperplane<$T, 3> plane(Vector($normal).normalized(), Vector($point));", normal,
                 peers::given("point", point));
}

template <class T>
T implicit(vec3<T> origin, vec3<T> direction, vec3<T> normal, T d) {
  Eigen::Hyperplane<T, 3> plane(eigen<T>(normal), d);
  plane.normalize();
  return meet<T>(origin, direction, plane,
                 "Eigen::Hyperplane<$T, 3> plane(Vector($normal), $d);\nplane.normalize();", normal,
                 peers::given("d", d));
}

}  // namespace
}  // namespace rayproof

int main(int count, char** arguments) {
  using namespace rayproof;
  const std::string version = std::to_string(EIGEN_WORLD_VERSION) + "." +
                              std::to_string(EIGEN_MAJOR_VERSION) + "." + std::to_string(EIGEN_MINOR_VERSION);
  peers::introduce(count, arguments,
                   {"Eigen", version, peers::built_with("-I/usr/include/eigen3"),
                    "https://gitlab.com/libeigen/eigen/-/issues"});
  return answer_cases(takes<PointNormalPlane>(point_normal<float>),
                      takes<PointNormalPlane>(point_normal<double>), takes<ImplicitPlane>(implicit<float>),
                      takes<ImplicitPlane>(implicit<double>), unit_direction, whole_line);
}

/// \file
/// Eigen 3.4, ParametrizedLine and Hyperplane, in float and double. Their documentation takes direction and
/// normal for unit vectors, and the line for infinite. Of parallel lines it says nothing.
#include <Eigen/Geometry>

#include "answer_cases.hpp"

namespace rayproof {
namespace {

template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;

template <class T>
Vector<T> eigen(const vec3<T>& v) {
  return {v.x, v.y, v.z};
}

template <class T>
T meet(const vec3<T>& origin, const vec3<T>& direction, const Eigen::Hyperplane<T, 3>& plane) {
  return Eigen::ParametrizedLine<T, 3>(eigen<T>(origin), eigen<T>(direction)).intersectionParameter(plane);
}

template <class T>
T point_normal(vec3<T> origin, vec3<T> direction, vec3<T> point, vec3<T> normal) {
  return meet<T>(origin, direction, Eigen::Hyperplane<T, 3>(eigen<T>(normal).normalized(), eigen<T>(point)));
}

template <class T>
T implicit(vec3<T> origin, vec3<T> direction, vec3<T> normal, T d) {
  Eigen::Hyperplane<T, 3> plane(eigen<T>(normal), d);
  plane.normalize();
  return meet<T>(origin, direction, plane);
}

}  // namespace
}  // namespace rayproof

int main() {
  using namespace rayproof;
  return answer_cases(takes<PointNormalPlane>(point_normal<float>),
                      takes<PointNormalPlane>(point_normal<double>), takes<ImplicitPlane>(implicit<float>),
                      takes<ImplicitPlane>(implicit<double>), unit_direction, whole_line);
}

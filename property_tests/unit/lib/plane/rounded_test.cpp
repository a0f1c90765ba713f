/// \file
/// What the correctly rounded ray/plane method has over the others: every t rounded once in each form of the
/// plane, and a transform composed exactly.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <rayproof/plane/methods.hpp>

namespace rayproof::plane {
namespace {

/// The plane z = height in its three forms.
template <class T>
std::array<Plane<T>, 3> level_planes(T height) {
  return {{{PlaneForm::implicit, {}, {0, 0, 1}, -height, {}, {}},
           {PlaneForm::point_normal, {5, 7, height}, {0, 0, 3}, 0, {}, {}},
           {PlaneForm::parametric, {0, 0, height}, {}, 0, {3, 0, 0}, {1, 3, 0}}}};
}

template <class T>
class RoundedPlane : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(RoundedPlane, Precisions);

TYPED_TEST(RoundedPlane, RoundsTiesToEven) {
  using T = TypeParam;
  const T most = T(2) / std::numeric_limits<T>::epsilon();  // every second whole number from here is a number
  for (const Plane<T>& plane : level_planes<T>(most)) {
    SCOPED_TRACE(static_cast<int>(plane.form));
    EXPECT_EQ(Rounded::roots(Ray<T>{{0, 0, -1}, {0, 0, 1}}, plane).lo, most);
    EXPECT_EQ(Rounded::roots(Ray<T>{{0, 0, -3}, {0, 0, 1}}, plane).lo, most + 4);
  }
}

/// The map's third is no float: a ray that is rounded into object space first loses what decides.
TYPED_TEST(RoundedPlane, ComposesATransformExactly) {
  using T = TypeParam;
  const T e = std::numeric_limits<T>::epsilon();
  for (const T scale : {T(3), T(-3)}) {
    const auto third = object_space(glm::scale(glm::mat<4, 4, T>(1), vec3<T>(1, 1, scale)));
    for (const Plane<T>& plane : level_planes<T>(scale / 3)) {  // z = 3 in the world
      SCOPED_TRACE(static_cast<int>(plane.form));
      const auto along = [&](const vec3<T>& direction) {
        return roots_in_world<Rounded>(third, Ray<T>{{0, 3, 1}, direction}, plane);
      };
      EXPECT_EQ(along({0, 0, 1}).lo, 2);
      EXPECT_EQ(along({0, 0, 1 + e}).lo, 2 - 2 * e);  // 2/(1 + e), rounded once
      EXPECT_EQ(along({1, 1, 0}).discriminant, -1);
      if (plane.form == PlaneForm::parametric) {
        EXPECT_EQ(along({0, 0, 1}).u, -T(1) / 3);
        EXPECT_EQ(along({0, 0, 1}).v, 1);
      }
    }
  }
}

TEST(RoundedPlaneInDouble, TrustsOnlyWhatIsClear) {
  for (const Plane<double>& plane : level_planes<double>(1)) {
    SCOPED_TRACE(static_cast<int>(plane.form));
    const auto is_sure = [&](const Ray<double>& ray) {
      return rounded_roots(ray, Rounded::enclosed(ray, plane)).is_sure;
    };
    EXPECT_TRUE(is_sure({{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}}));
    EXPECT_TRUE(is_sure({{0.1, 0.2, 0.3}, {0.4, 0.5, 0}}));         // parallel, term by term
    EXPECT_FALSE(is_sure({{0.1, 0.2, 0.25}, {0, 0, 1}, 0, 0.75}));  // ends on the plane
    EXPECT_FALSE(is_sure({{0.1, 0.2, 0.3}, {0, 0, infinity<double>}}));
    EXPECT_FALSE(is_sure({{0.1, 0.2, 0.3}, {0, 0, std::nan("")}}));
  }
  const Plane<double> slanted{PlaneForm::implicit, {}, {1, 1, 0}, 1, {}, {}};
  const Ray<double> parallel{{0, 0, 0}, {1, -1, 0}};
  EXPECT_FALSE(rounded_roots(parallel, Rounded::enclosed(parallel, slanted)).is_sure);
}

}  // namespace
}  // namespace rayproof::plane

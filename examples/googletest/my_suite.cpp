#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <rayproof/laboratory/rapidcheck.hpp>

#include "my_intersect.hpp"

using namespace rayproof;

RC_GTEST_PROP(MyIntersect, HitsWhereTheTriangleIs, ()) {
  const Case one = *cases("triangle", "random");
  const auto& [ray, shape, transform] = std::get<RayQuestion>(one.question);
  const auto& [a, b, c] = std::get<Triangle<double>>(shape);
  const double t = myIntersect(ray.origin, ray.direction, a, b, c);
  const bool is_on_ray = ray.t_min <= t && t <= ray.t_max;
  RC_ASSERT(!oracle::judge(one, nearest_answer(is_on_ray ? t : INFINITY)).wrong);
}

/// \file
/// Every ray/disk method on the special values of its arithmetic, named one by one.

#include <gtest/gtest.h>

#include <rayproof/disk/methods.hpp>

namespace rayproof::disk {
namespace {

template <class T>
class EveryDiskMethod : public testing::Test {
 protected:
  const Ray<T> ray_{{4, 6, -5}, {0, 0, 1}};
  /// (4, 6, 1) lies on the rim.
  const Disk<T> disk_{{1, 2, 1}, {0, 0, -2}, 5};

  void expect_nearest(const Ray<T>& ray, const Disk<T>& disk, T expected) {
    Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
      EXPECT_EQ(nearest(ray, Method::roots(ray, disk)), expected) << Method::name;
    });
  }
  void expect_miss(const Ray<T>& ray, const Disk<T>& disk) { expect_nearest(ray, disk, infinity<T>); }
};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(EveryDiskMethod, Precisions);

TYPED_TEST(EveryDiskMethod, CountsTheRimAndNothingBeyond) {
  this->expect_nearest(this->ray_, this->disk_, 6);
  Ray<TypeParam> ray = this->ray_;
  ray.origin.x = std::nextafter(TypeParam(4), TypeParam(5));
  this->expect_miss(ray, this->disk_);
}

TYPED_TEST(EveryDiskMethod, MeetsADiskOfNoRadiusInItsCentre) {
  Disk<TypeParam> disk = this->disk_;
  disk.radius = 0;
  this->expect_miss(this->ray_, disk);
  this->expect_nearest({{1, 2, -5}, {0, 0, 1}}, disk, 6);
}

TYPED_TEST(EveryDiskMethod, MissesWhenParallelOrInThePlane) {
  this->expect_miss({{1, 2, 0}, {1, 1, 0}}, this->disk_);
  this->expect_miss({{1, 2, 1}, {1, 1, TypeParam(-0.0)}}, this->disk_);
}

TYPED_TEST(EveryDiskMethod, MissesOnNaNAnywhere) {
  constexpr TypeParam nan = not_a_number<TypeParam>;
  for (int i = 0; i < 3; ++i) {
    Ray<TypeParam> ray = this->ray_;
    ray.origin[i] = nan;
    this->expect_miss(ray, this->disk_);
    ray = this->ray_;
    ray.direction[i] = nan;
    this->expect_miss(ray, this->disk_);
    Disk<TypeParam> disk = this->disk_;
    disk.center[i] = nan;
    this->expect_miss(this->ray_, disk);
    disk = this->disk_;
    disk.normal[i] = nan;
    this->expect_miss(this->ray_, disk);
  }
  Disk<TypeParam> disk = this->disk_;
  disk.radius = nan;
  this->expect_miss(this->ray_, disk);
}

}  // namespace
}  // namespace rayproof::disk

#include <memory>
#include <rayproof/sphere/methods.hpp>

#include "bench/figures/sphere_passes.hpp"

namespace rayproof::report {

namespace {

template <class T>
std::vector<Contender> sphere_contenders_in(const std::vector<Case>& cases) {
  const auto rays = std::make_shared<SphereRays<T>>(cases);
  std::vector<Contender> all;
  sphere::Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    all.push_back({Method::name, Arrangement::scalar,
                   [rays](std::size_t count) { hit_one_by_one<Method>(*rays, count); }});
    all.push_back({Method::name, Arrangement::batch,
                   [rays](std::size_t count) { hit_in_batch<Method>(*rays, count); }});
  });
  all.push_back({"glm", Arrangement::scalar, [rays](std::size_t count) { hit_by_glm(*rays, count); }});
  all.push_back(
      {BenchRow::floor_name, Arrangement::batch, [rays](std::size_t count) { only_stream(*rays, count); }});
  return all;
}

}  // namespace

std::vector<Contender> sphere_contenders(const std::vector<Case>& cases, Precision precision) {
  return precision == Precision::float32 ? sphere_contenders_in<float>(cases)
                                         : sphere_contenders_in<double>(cases);
}

}  // namespace rayproof::report

#include <memory>
#include <rayproof/rayproof.hpp>

#include "bench/contenders/contender.hpp"
#include "bench/scaling/scaling.hpp"
#include "bench/scenes/random_scene.hpp"
#include "bench/scenes/ray_columns.hpp"
#ifdef RAYPROOF_HAS_EMBREE
#include <rayproof/objects/embree_tree.hpp>

#include "bench/scenes/embree_scene.hpp"
#endif

namespace rayproof::report {

namespace {

/// A list meets every object with every ray: beyond this it takes too long.
constexpr std::size_t longest_list = 1000;

/// Asks `searched` for the nearest hit of each ray.
template <class Searched>
Contender contender_of(std::string name, std::shared_ptr<const Searched> searched,
                       const std::shared_ptr<const std::vector<Ray<float>>>& rays) {
  const auto t = std::make_shared<std::vector<float>>(rays->size());
  const auto pass = [searched = std::move(searched), rays, t](std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      const auto hit = searched->nearest((*rays)[i]);
      if constexpr (std::is_same_v<decltype(hit), const float>)
        (*t)[i] = hit;
      else
        (*t)[i] = hit ? hit->t : infinity<float>;
      one_at_a_time();
    }
  };
  return {std::move(name), Arrangement::scalar, pass};
}

/// Asks a list for the nearest hits of all rays at once.
template <class List>
Contender contender_in_packs(std::string name, std::shared_ptr<const List> list,
                             const std::vector<Ray<float>>& rays) {
  const auto columns = std::make_shared<RayColumns>();
  for (const Ray<float>& ray : rays) columns->add(ray);
  const auto t = std::make_shared<std::vector<float>>(rays.size());
  const auto index = std::make_shared<std::vector<std::uint32_t>>(rays.size());
  const auto pass = [=, list = std::move(list)](std::size_t count) {
    list->nearest(columns->part(0, count), std::span(*t).first(count), std::span(*index).first(count));
  };
  return {std::move(name), Arrangement::batch, pass};
}

template <class Choice>
ObjectList<float, Choice> list_of(const RandomScene& scene) {
  ObjectList<float, Choice> list;
  for (const auto& sphere : scene.spheres) list.add(sphere);
  for (const auto& triangle : scene.triangles) list.add(triangle);
  return list;
}

template <class Choice>
std::vector<Contender> scene_contenders(const std::string& prefix, const RandomScene& scene) {
  const auto rays = std::make_shared<const std::vector<Ray<float>>>(rays_through_scene());
  const auto list = list_of<Choice>(scene);
  std::vector<Contender> all;
  if (list.size() <= longest_list) {
    const auto shared = std::make_shared<const ObjectList<float, Choice>>(list);
    all.push_back(contender_of(prefix + "list", shared, rays));
    all.push_back(contender_in_packs(prefix + "list", shared, *rays));
  }
  all.push_back(contender_of(prefix + "tree", std::make_shared<const ObjectTree<float, Choice>>(list), rays));
#ifdef RAYPROOF_HAS_EMBREE
  using InEmbree = ObjectTree<float, Choice, objects::EmbreeTree>;
  all.push_back(contender_of(prefix + "tree_in_embree", std::make_shared<const InEmbree>(list), rays));
  if (std::is_same_v<Choice, PlainMethods>)
    all.push_back(contender_of("embree", std::make_shared<const EmbreeOnly>(scene), rays));
#endif
  return all;
}

}  // namespace

std::vector<ScalingStep> scenes_scaling(const BenchOptions& options) {
  const double seconds = options.seconds;
  std::vector<ScalingStep> steps;
  for (const char* const kind : {"spheres", "triangles", "mixed"})
    for (const std::size_t count : {1, 3, 10, 30, 100, 1'000, 10'000, 100'000, 1'000'000}) {
      if (options.is_quick && count > 100'000) continue;
      const auto measure = [seconds](const BenchRow& pattern) {
        const RandomScene scene = random_scene(pattern.shape, pattern.size);
        std::vector<BenchRow> rows = timed_rows(scene_contenders<PlainMethods>("", scene), pattern,
                                                rays_through_scene().size(), seconds);
        std::ranges::move(timed_rows(scene_contenders<ExactMethods>("exact_", scene), pattern,
                                     rays_through_scene().size(), seconds),
                          std::back_inserter(rows));
        return rows;
      };
      BenchRow pattern{.shape = kind, .family = "scenes", .size = count};
      steps.push_back({std::move(pattern), measure});
    }
  return steps;
}

}  // namespace rayproof::report

#pragma once
/// \file
/// Families made of a layout: a struct with a `name`, a `description`, and
/// `static Scene scene(Random&, int digits)`, which puts a ray and a shape together for numbers of so many
/// digits. The same layout can be asked as it is, cut short, moved by a map, or in another size.

#include "case/similar_shapes.hpp"
#include "generators/accepted.hpp"
#include "generators/affine.hpp"
#include "generators/aim.hpp"

namespace rayproof {

/// The question of a layout's scene, once `change(scene)` has worked on it.
template <class T, class Layout, class Change>
[[nodiscard]] RayQuestion ask_changed(Random& random, Change&& change) {
  return first_accepted([&] {
    auto scene = Layout::scene(random, std::numeric_limits<T>::digits);
    change(scene);
    return question<T>(scene);
  });
}

/// The layout as it is.
template <class Layout>
struct AsLaidOut : Layout {
  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return ask_changed<T, Layout>(random, [](const auto& /*scene*/) {});
  }
};

/// `layout` aims at the surface; the interval ends there, or a few ulps beside.
template <class Layout>
struct CutShort {
  static constexpr const char* name = "interval";
  static constexpr const char* description = "t_min or t_max at a hit or a few ulps beside it; segments";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    return ask_changed<T, Layout>(random, [&](auto& scene) { cut<T>(random, scene); });
  }

 private:
  template <class T>
  static void cut(Random& random, RayScene& scene) {
    const int kind = random.between(0, 4);
    if (kind == 0 && scene.aimed_at != 0) {  // The segment [0, 1] from the origin to the hit.
      scene.direction = scene.aimed_at * scene.direction;
      scene.t_min = 0;
      scene.t_max = 1;
      return;
    }
    const auto near_hit = [&]() -> double {
      return draw::nudged<T>(static_cast<T>(scene.aimed_at), random.one_in(2) ? 0 : random.between(-3, 3));
    };
    const double t0 = near_hit(), t1 = near_hit();
    scene.t_min = kind == 1 ? -std::numeric_limits<double>::infinity() : kind == 2 ? std::min(0.0, t0) : t0;
    scene.t_max = kind == 3 ? std::numeric_limits<double>::infinity() : kind == 4 ? t1 : t0;
    if (scene.t_max < scene.t_min) std::swap(scene.t_min, scene.t_max);
  }
};

/// The layout under an affine map; a third of the time one of whole numbers under a whole map, where there is
/// such a layout, so that the world's ray, too, passes exactly where it was aimed.
template <class Layout, class Whole = void>
struct Transformed {
  static constexpr const char* name = "transformed";
  static constexpr const char* description =
      "an affine map of condition 1 to 1e6: moved, mirrored, sheared, stretched";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    if constexpr (!std::is_void_v<Whole>) {
      if (random.one_in(3))
        return ask_changed<T, Whole>(random, [&](auto& scene) { move_exactly(random, scene); });
    }
    return ask_changed<T, Layout>(random, [&](auto& scene) { move_into_the_world(random, scene); });
  }
};

/// The layout, whose numbers are between 2^-8 and 2^8, as large or small as the format has numbers.
template <class Layout>
struct AnySize {
  static constexpr const char* name = "exponents";
  static constexpr const char* description = "scenes of one size, of any exponent the format has";

  template <class T>
  [[nodiscard]] static Question ask(Random& random) {
    const auto factor = [&] {
      return std::exp2(random.uniform(draw::lowest_exponent<T> + 10, draw::highest_exponent<T> - 10));
    };
    return ask_changed<T, Layout>(random, [&](Scene& scene) {
      const double size = factor();
      scene.origin *= size;
      scene.direction *= factor();
      scene.shape = std::visit([&](const auto& shape) -> Shape { return grown(shape, size); }, scene.shape);
    });
  }
};

}  // namespace rayproof

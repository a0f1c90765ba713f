#pragma once
/// \file
/// Families made of a layout: a function of `(Random&)`, or `(Random&, Precision)`, that puts a ray and a
/// shape together. The same layout can be asked as it is, cut short, moved by a map, or in another size.

#include "case/each_number.hpp"
#include "generators/affine.hpp"
#include "generators/generators.hpp"

namespace rayproof {

/// The question of a layout's scene, once `change(random, precision, scene)` has worked on it.
template <auto layout, auto change>
[[nodiscard]] Question ask(Random& random, Precision precision) {
  return first_accepted([&] {
    Scene scene;
    if constexpr (std::is_invocable_v<decltype(layout), Random&, Precision>)
      scene = layout(random, precision);
    else
      scene = layout(random);
    change(random, precision, scene);
    return question(precision, scene);
  });
}

inline void leave(Random& /*random*/, Precision /*precision*/, const Scene& /*scene*/) {}

template <auto layout>
[[nodiscard]] Family laid_out(const char* name, const char* description, std::vector<MinimumShare> shares) {
  return {name, description, ask<layout, leave>, std::move(shares)};
}

/// Ends the interval of a ray that is aimed at the surface there, or a few ulps beside.
inline void cut(Random& random, Precision precision, Scene& scene) {
  const int kind = random.between(0, 4);
  if (kind == 0 && scene.aimed_at != 0) {  // The segment [0, 1] from the origin to the hit.
    scene.direction = scene.aimed_at * scene.direction;
    scene.t_min = 0;
    scene.t_max = 1;
    return;
  }
  const double t0 = at_or_beside(random, precision, scene.aimed_at);
  const double t1 = at_or_beside(random, precision, scene.aimed_at);
  scene.t_min = kind == 1 ? -std::numeric_limits<double>::infinity() : kind == 2 ? std::min(0.0, t0) : t0;
  scene.t_max = kind == 3 ? std::numeric_limits<double>::infinity() : kind == 4 ? t1 : t0;
  if (scene.t_max < scene.t_min) std::swap(scene.t_min, scene.t_max);
}

/// The layout, which aims at the surface, cut there.
template <auto layout>
[[nodiscard]] Family cut_short(std::vector<MinimumShare> shares) {
  return {"interval", "t_min or t_max at a hit or a few ulps beside it; segments", ask<layout, cut>,
          std::move(shares)};
}

/// The layout under an affine map; a third of the time one of whole numbers under a whole map, where there is
/// such a layout, so that the world's ray, too, passes exactly where it was aimed.
template <auto layout, auto whole = nullptr>
[[nodiscard]] Family transformed(std::vector<MinimumShare> shares) {
  const auto ask_moved = [](Random& random, Precision precision) {
    if constexpr (!std::is_null_pointer_v<decltype(whole)>)
      if (random.one_in(3)) return ask<whole, move_exactly>(random, precision);
    return ask<layout, move_into_the_world>(random, precision);
  };
  return {"transformed", "an affine map of condition 1 to 1e6: moved, mirrored, sheared, stretched",
          ask_moved, std::move(shares)};
}

/// Makes a scene, whose numbers are between 2^-8 and 2^8, as large or small as the format has numbers.
inline void resize(Random& random, Precision precision, Scene& scene) {
  const double size = std::exp2(draw::any_exponent(random, precision, 10));
  scene.origin *= size;
  scene.direction *= std::exp2(draw::any_exponent(random, precision, 10));
  std::visit([size](auto& shape) { shape = grown(shape, size); }, scene.shape);
}

template <auto layout>
[[nodiscard]] Family in_any_size(std::vector<MinimumShare> shares) {
  return {"exponents", "scenes of one size, of any exponent the format has", ask<layout, resize>,
          std::move(shares)};
}

}  // namespace rayproof

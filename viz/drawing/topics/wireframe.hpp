#pragma once
/// \file
/// The picture of a ray and any shape that can say what its outline looks like.

#include "case/answer.hpp"
#include "viz/drawing/topics.hpp"
#include "viz/drawing/topics/figure.hpp"
#include "viz/drawing/topics/ray_walk.hpp"
#include "viz/picture/picture.hpp"

namespace rayproof::viz {

/// A shape's outline, given the question.
using FigureMaker = Figure (*)(const Sight&);

[[nodiscard]] Picture wireframe_picture(FigureMaker figure, const Case& one, const Answer* exact,
                                        const Answer* claimed);

/// The view of a shape's topic.
template <class Topic, FigureMaker figure>
[[nodiscard]] TopicView wireframe_view() {
  return {Topic::name,
          [](const Case& one, const Answer* exact, const Answer* claimed) {
            return wireframe_picture(figure, one, exact, claimed);
          },
          walk_ray<Topic>, figure};
}

}  // namespace rayproof::viz

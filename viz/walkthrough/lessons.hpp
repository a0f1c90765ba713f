#pragma once
/// \file
/// The lessons that are more than one method's run: what makes their stages. All lessons stand in
/// lessons/lessons.json, in the order of teaching.

#include <array>

#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {

/// lessons/lessons.json, put into the program when it is configured.
extern const char* const lessons_text;

using Compose = Stage(const Case& one, const ReportCase& report_on);

// Each in lessons/ or lessons/numbers/.
Compose ray_stage, camera_stage, loop_stage;
Compose barycentric_stage, parity_stage, printed_stage, polygon_stage, segment_stage;
Compose digits_stage, leak_stage, leaving_stage, acne_stage, map_stage, test_stage;
Compose intervals_stage, transformed_stage, normal_stage, torus_stage, patch_stage;

/// A lesson by its name, and what composes it.
struct Composer {
  std::string_view lesson;
  Compose* compose;
};
inline constexpr std::array composers{
    Composer{"ray", ray_stage},
    Composer{"camera", camera_stage},
    Composer{"raycasting", loop_stage},
    Composer{"barycentric", barycentric_stage},
    Composer{"polygon-parity", parity_stage},
    Composer{"polygon-vertex-trap", printed_stage},
    Composer{"polygon-vertex-mended", parity_stage},
    Composer{"polygon-horizontal-trap", printed_stage},
    Composer{"polygon-star", parity_stage},
    Composer{"polygon-in-space", polygon_stage},
    Composer{"ray-segment", segment_stage},
    Composer{"digits", digits_stage},
    Composer{"leak", leak_stage},
    Composer{"leaving-a-sphere", leaving_stage},
    Composer{"acne", acne_stage},
    Composer{"error-map", map_stage},
    Composer{"property-test", test_stage},
    Composer{"slab-intervals", intervals_stage},
    Composer{"transformed", transformed_stage},
    Composer{"transformed-normal", normal_stage},
    Composer{"implicit-torus", torus_stage},
    Composer{"parametric-patch", patch_stage},
};

}  // namespace rayproof::viz

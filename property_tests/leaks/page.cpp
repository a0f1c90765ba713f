#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/escape.hpp"
#include "leaks/text.hpp"
#include "properties/report/page_style.hpp"

namespace rayproof::leaks {

namespace {

constexpr const char* leak_style = R"css(
.patch { fill: var(--panel); stroke: var(--soft); stroke-width: 1; } .truth { fill: none; stroke: var(--exact); stroke-width: 3; }
.got { fill: url(#hatch); stroke: none; } .ray { stroke: var(--claimed); stroke-width: 2; fill: none; }
article { display: grid; grid-template-columns: 320px 1fr; gap: 1rem; border-top: 1px solid var(--line); padding: 1rem 0; break-inside: avoid; }
@media screen and (max-width: 48rem) { article { grid-template-columns: 1fr; } }
)css";

/// Two axes across the ray.
struct Screen {
  glm::dvec3 right{}, up{};

  explicit Screen(const glm::dvec3& direction) {
    glm::dvec3 axis(0);
    const glm::dvec3 size = abs(direction);
    axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
    right = straight(cross(direction, axis));
    up = straight(cross(right, direction));
  }
  static glm::dvec3 straight(const glm::dvec3& v) { return v / std::sqrt(dot(v, v)); }
};

/// The corners of a triangle on the picture, where the ray is the point (0, 0).
struct CornersSeen {
  std::array<std::array<double, 2>, 3> at{};

  [[nodiscard]] std::string points(double scale) const {
    std::string text;
    for (const auto& [x, y] : at) text += fmt::format("{:.1f},{:.1f} ", 160 + scale * x, 160 - scale * y);
    return text;
  }
};

std::vector<CornersSeen> projected(const Loss& loss) {
  const Ray<double>& ray = loss.aim.ray;
  const Screen screen(ray.direction);
  std::vector<CornersSeen> all;
  for (const Case& one : loss.cases) {
    const auto& triangle = std::get<Triangle<double>>(std::get<RayQuestion>(one.question).shape);
    CornersSeen corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 f = std::array{triangle.a, triangle.b, triangle.c}[k] - ray.origin;
      corners.at[k] = {dot(f, screen.right), dot(f, screen.up)};
    }
    all.push_back(corners);
  }
  return all;
}

std::string article_of(const Outcomes& one, const Loss& loss) {
  std::string lines;
  for (std::size_t k = 0; k < loss.cases.size(); ++k) {
    if (loss.got[k].empty() && !loss.is_hit[k]) continue;
    lines += fmt::format("<li>triangle {}: {}; in truth {}</li>", loss.aim.patch[k],
                         loss.got[k].empty() ? "missed" : fmt::format("hit at t = {}", loss.got[k].front()),
                         loss.is_hit[k] ? "hit" : "missed");
  }
  return fmt::format(
      "<article><figure>{}</figure><div><h3>{} <span class=\"soft\">{}</span>: {}</h3><p>Ray {}, aimed at "
      "{} of the mesh, from {}.</p><ul>{}</ul></div></article>\n",
      picture_of(loss), escaped(one.subject->full_name()), name_of(one.precision),
      failure_names.at(static_cast<std::size_t>(loss.failure)), loss.number,
      target_names.at(static_cast<std::size_t>(loss.aim.target)),
      loss.aim.from_inside ? "its inner side" : "outside", lines);
}

}  // namespace

std::string picture_of(const Loss& loss) {
  const std::vector<CornersSeen> all = projected(loss);
  double size = 0;
  for (const CornersSeen& one : all)
    for (const auto& [x, y] : one.at) size = std::max({size, std::abs(x), std::abs(y)});
  const double scale = 140 / size;
  std::string patch, got, truth;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string points = all[k].points(scale);
    patch += fmt::format("<polygon class=\"patch\" points=\"{}\"/>", points);
    if (!loss.got[k].empty()) got += fmt::format("<polygon class=\"got\" points=\"{}\"/>", points);
    if (loss.is_hit[k]) truth += fmt::format("<polygon class=\"truth\" points=\"{}\"/>", points);
  }
  return "<svg viewBox=\"0 0 320 320\" xmlns=\"http://www.w3.org/2000/svg\" role=\"img\"><title>The "
         "triangles about the target, seen along the ray</title><defs><pattern id=\"hatch\" width=\"8\" "
         "height=\"8\" "
         "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><line x1=\"0\" y1=\"0\" x2=\"0\" "
         "y2=\"8\" stroke=\"var(--claimed)\" stroke-width=\"2\"/></pattern></defs>" +
         patch + got + truth + "<path class=\"ray\" d=\"M150 160h20M160 150v20\"/></svg>";
}

std::string html_page(const ClosedMesh& mesh, const LeakSettings& settings, const Result& result) {
  std::string losses;
  for (const Outcomes& one : result.outcomes)
    for (const std::optional<Loss>& loss : one.first)
      if (loss) losses += article_of(one, *loss);
  if (losses.empty()) losses = "<p>None.</p>";
  return html_head("rayproof leak", leak_style) +
         fmt::format(
             "</head>\n<body><main><h1>rayproof leak: {}</h1>\n<p>{} triangles, closed. Seed {}, {} rays for "
             "each precision, aimed at the mesh's own vertices and edges; those that pass an outline are "
             "left out. A leak: no triangle about the target is hit, though the ray crosses the surface "
             "there. A double hit: one crossing is reported at places more than {} units in the last place "
             "of the largest coordinate apart.</p>\n<pre>{}</pre>\n"
             "<h2>The first of each kind, as the ray sees it</h2>\n<p>The cross is the ray. Hatched: the "
             "subject reports a hit. Thick lines: hit in truth.</p>\n{}</main></body></html>\n",
             escaped(mesh.name), mesh.triangles.size(), settings.seed, settings.rays, same_hit_ulps,
             escaped(text_table(result)), losses);
}

}  // namespace rayproof::leaks

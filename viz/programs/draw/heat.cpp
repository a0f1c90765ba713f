#include "viz/programs/draw/heat.hpp"

#ifdef RAYPROOF_HAS_VTK
#include <cmath>

#include "case/json/number_text.hpp"
#include "viz/explain/case_report.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/raster_png.hpp"
#include "viz/vtk/render/heat_map.hpp"
#endif

namespace rayproof::viz {

#ifdef RAYPROOF_HAS_VTK
namespace {

/// The case with its ray aimed at a place.
Case aimed_at(Case one, const glm::dvec3& place) {
  Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  for (int axis = 0; axis < 3; ++axis)
    ray.direction[axis] = round_to(one.precision, place[axis] - ray.origin[axis]);
  return one;
}

double error_of(const Case& one, const Subject& subject) {
  const Answer exact = oracle::answer(one);
  const Answer claimed = subject.answer(one);
  return verdicts_differ(&exact, &claimed) ? -1 : worst_ulps(&exact, &claimed, one.precision);
}

}  // namespace

void write_heat_map(const CaseReport& report, const std::string& path) {
  const Subject* const subject = find_subject(report.method);
  if (subject == nullptr) throw WrongCommand("--heat needs a method of this program: give --method");
  const auto* const asked = std::get_if<RayQuestion>(&report.one.question);
  if (asked == nullptr || asked->transform || !render::has_heat_map(asked->shape))
    throw WrongCommand("--heat is for a ray and a sphere or triangle without a transform");
  const auto words = [&](const render::HeatTotals& totals) -> render::HeatWords {
    const std::string worst =
        std::isinf(totals.worst_ulps) ? "infinitely far" : fmt::format("{:.0f} ulp", totals.worst_ulps);
    return {fmt::format("{} in {}, over the surface", report.method, name_of(report.one.precision)),
            fmt::format("{} rays from the case's origin: {} wrong verdicts; where right, t is {} off at most",
                        totals.rays, totals.wrong, worst)};
  };
  const OffscreenDisplay display;
  write_png(
      render::heat_map(
          asked->shape, asked->ray.origin,
          [&](const glm::dvec3& place) { return error_of(aimed_at(report.one, place), *subject); }, words),
      path);
}
#else
void write_heat_map(const CaseReport& /*report*/, const std::string& path) {
  throw WrongCommand("--heat " + path + " needs VTK, which this build was made without");
}
#endif

}  // namespace rayproof::viz

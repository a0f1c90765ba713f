#include "bench/figures/curve.hpp"

#include <algorithm>
#include <array>

#include "bench/figures/median.hpp"

namespace rayproof::report {

namespace {

constexpr const char* exactly = "exact_";

CurvePoint point_of(const BenchRow& row) {
  CurvePoint point{row.size, row.ns_per_ray, row.ns_per_ray, row.ns_per_ray};
  if (row.passes_ns.empty()) return point;
  point.low = std::min(point.ns, quantile(row.passes_ns, 0.25));
  point.high = std::max(point.ns, quantile(row.passes_ns, 0.75));
  return point;
}

/// The one called so, made where there is none.
template <class Named>
Named& named(std::vector<Named>& all, std::string Named::*name, const std::string& wanted) {
  const auto found = std::ranges::find(all, wanted, name);
  if (found != all.end()) return *found;
  all.push_back(Named{wanted});
  return all.back();
}

void add(std::vector<CurveChart>& charts, const std::string& chart, const std::string& line,
         const BenchRow& row) {
  CurveChart& own = named(charts, &CurveChart::title, chart);
  std::vector<CurvePoint>& points = named(own.lines, &CurveLine::name, line).points;
  points.push_back(point_of(row));
  std::ranges::sort(points, std::less{}, &CurvePoint::size);
}

void add_scene(std::vector<CurveChart>& charts, const BenchRow& row) {
  const bool is_exact = row.method.starts_with(exactly), is_embree = row.method == "embree";
  const std::string method = is_exact ? row.method.substr(std::string(exactly).size()) : row.method;
  const std::string name = is_embree                               ? "Embree alone"
                           : method == "tree_in_embree"            ? "tree in Embree"
                           : row.arrangement == Arrangement::batch ? "list, rays in packs"
                                                                   : method;
  if (!is_exact) add(charts, row.shape + ", plain methods", name, row);
  if (is_exact || is_embree) add(charts, row.shape + ", exact methods", name, row);
}

}  // namespace

CurveWords words_on(const std::string& curve) {
  if (curve == "scenes")
    return {
        "The nearest hit among N objects", "objects",
        "Rays through a cube of N objects that cover its view about once, one after the other or in packs, "
        "float, one core."};
  if (curve == "polygon_size")
    return {"Polygons of n vertices", "vertices",
            "One ray, or point, after the other, each with a star of its own, float, one core."};
  return {"Rays shared out to threads", "threads",
          "Wall-clock time over the number of rays: 262,144 rays in tiles of 1,024, float."};
}

std::vector<CurveChart> charts_of(const std::vector<BenchRow>& rows, const std::string& curve) {
  std::vector<CurveChart> charts;
  for (const BenchRow& row : rows) {
    if (row.family != curve) continue;
    if (curve == "scenes")
      add_scene(charts, row);
    else
      add(charts, row.shape, row.method, row);
  }
  // The same line is drawn the same in every chart of scenes.
  constexpr std::array order{"list", "tree", "tree in Embree", "Embree alone", "list, rays in packs"};
  const auto place = [&](const CurveLine& line) { return std::ranges::find(order, line.name); };
  if (curve == "scenes")
    for (CurveChart& chart : charts) std::ranges::stable_sort(chart.lines, std::less{}, place);
  return charts;
}

std::string lack_of(const std::vector<CurveChart>& charts, const std::string& curve) {
  const bool has_embree = std::ranges::any_of(charts, [](const CurveChart& chart) {
    return std::ranges::any_of(chart.lines,
                               [](const CurveLine& line) { return line.name == "Embree alone"; });
  });
  return curve == "scenes" && !has_embree ? " Embree was not built in, so only ours are shown." : "";
}

}  // namespace rayproof::report

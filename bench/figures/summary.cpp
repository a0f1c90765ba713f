#include "bench/figures/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "bench/figures/median.hpp"

namespace rayproof::report {

namespace {

/// The larger of two numbers of which either may be NaN, for "there is none".
double larger(double x, double y) { return std::isnan(x) || y > x ? y : x; }

void add(Accuracy& sum, const Accuracy& one) {
  const auto hits = static_cast<double>(sum.agreed_hits);
  const auto more = static_cast<double>(one.agreed_hits);
  if (one.agreed_hits > 0) sum.mean_bits = (sum.mean_bits * hits + one.mean_bits * more) / (hits + more);
  sum.cases += one.cases;
  sum.wrong_hits += one.wrong_hits;
  sum.wrong_misses += one.wrong_misses;
  sum.agreed_hits += one.agreed_hits;
  sum.max_ulp = larger(sum.max_ulp, one.max_ulp);
  sum.p99_ulp = larger(sum.p99_ulp, one.p99_ulp);
  sum.max_point = larger(sum.max_point, one.max_point);
  sum.max_normal = larger(sum.max_normal, one.max_normal);
  sum.max_coordinates = larger(sum.max_coordinates, one.max_coordinates);
}

bool is_same(const MethodSummary& summary, const BenchRow& row) {
  return summary.shape == row.shape && summary.method == row.method && summary.precision == row.precision &&
         summary.arrangement == row.arrangement;
}

}  // namespace

double MethodSummary::wrong_share() const {
  if (accuracy.cases == 0) return 0;
  return static_cast<double>(accuracy.wrong_hits + accuracy.wrong_misses) /
         static_cast<double>(accuracy.cases);
}

bool is_of_scenes(const std::string& family) {
  return family != "bit_patterns" && family != "exponents" && family != "special";
}

std::vector<MethodSummary> summarise(const std::vector<BenchRow>& rows) {
  const bool has_scenes = std::ranges::any_of(rows, is_of_scenes, &BenchRow::family);
  std::vector<MethodSummary> all;
  std::vector<std::vector<double>> times;
  for (const BenchRow& row : rows) {
    if (has_scenes && !is_of_scenes(row.family)) continue;
    auto place =
        std::ranges::find_if(all, [&](const MethodSummary& summary) { return is_same(summary, row); });
    const auto index = static_cast<std::size_t>(place - all.begin());
    if (place == all.end()) {
      all.push_back({row.shape, row.method, row.precision, row.arrangement});
      times.emplace_back();
    }
    add(all[index].accuracy, row.accuracy);
    times[index].push_back(row.ns_per_ray);
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].ns_per_ray = median(times[i]);
  return all;
}

std::optional<Headline> headline(const std::vector<BenchRow>& rows) {
  const auto ns_of = [&](const char* method, Arrangement arrangement) {
    const auto found = std::ranges::find_if(rows, [&](const BenchRow& row) {
      return row.shape == "sphere" && row.method == method && row.precision == Precision::float32 &&
             row.arrangement == arrangement && row.family == "random";
    });
    return found == rows.end() ? 0 : found->ns_per_ray;
  };
  const Headline found{ns_of("centred", Arrangement::batch), ns_of("glm", Arrangement::scalar),
                       ns_of(floor_name, Arrangement::batch)};
  if (found.batch_ns == 0 || found.glm_ns == 0 || found.floor_ns == 0) return std::nullopt;
  return found;
}

std::string sentence(const Headline& headline, std::size_t rays) {
  return fmt::format(
      "sphere/centred in float, a batch of {} random rays: {:.2f} ns a ray; GLM one at a time {:.2f} ns "
      "({:.1f} times as "
      "much); merely streaming the rays {:.2f} ns (the batch takes {:.2f} times that).",
      rays, headline.batch_ns, headline.glm_ns, headline.glm_ns / headline.batch_ns, headline.floor_ns,
      headline.batch_ns / headline.floor_ns);
}

}  // namespace rayproof::report

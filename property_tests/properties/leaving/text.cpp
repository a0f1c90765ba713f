#include "properties/leaving/text.hpp"

#include <fmt/format.h>

#include "case/writer.hpp"

namespace rayproof::leaving {

namespace {

/// The sum over what `is_meant` holds for.
Count sum_of(const SearchResult& result, const auto& is_meant) {
  Count sum;
  for (const StrategyOutcome& outcome : result.outcomes)
    if (is_meant(outcome)) sum += outcome.tally.all();
  return sum;
}

std::vector<const Strategy*> strategies_of(const SearchResult& result) {
  std::vector<const Strategy*> all;
  for (const StrategyOutcome& outcome : result.outcomes)
    if (std::ranges::find(all, outcome.strategy) == all.end()) all.push_back(outcome.strategy);
  return all;
}

/// The decades of size 1e-3 to 1e3: those of everyday scenes.
Count everyday(const SearchResult& result, const Strategy* strategy, Precision precision) {
  Count sum;
  for (const StrategyOutcome& outcome : result.outcomes)
    if (outcome.strategy == strategy && outcome.precision == precision)
      for (std::size_t i = decade_of(1e-3); i < decade_of(1e3); ++i) sum += outcome.tally.by_size.at(i);
  return sum;
}

}  // namespace

std::string text_table(const SearchResult& result) {
  std::string text =
      fmt::format("{:<15} {:<8} {:>10} {:>10} {:>9} {:>9} {:>11}   {:>8} {:>8} {:>8}\n", "strategy", "",
                  "rays", "false hits", "skipped", "thickest", "misanswered", "median", "99.9 %", "largest");
  for (const Strategy* strategy : strategies_of(result))
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      const Count all = sum_of(result, [&](const StrategyOutcome& one) {
        return one.strategy == strategy && one.precision == precision;
      });
      if (all.rays == 0) continue;
      const Lengths offsets = everyday(result, strategy, precision).offsets;
      text += fmt::format("{:<15} {:<8} {:>10} {:>10} {:>9} {:>9.1e} {:>11}   {:>8.1e} {:>8.1e} {:>8.1e}\n",
                          strategy->name, name_of(precision), all.rays, all.false_hits, all.skipped,
                          all.thickest_skipped, all.misanswered, offsets.median(), offsets.quantile(0.999),
                          offsets.largest());
    }
  return text +
         "false hits: the exact ray meets again what it has left. skipped: it was to start in a solid, and "
         "starts beyond\n"
         "it; the thickest of them, relative to the size of its scene. misanswered: no exact hit, and none "
         "is true, but\n"
         "the shape's plain method reports one. Offsets, in scenes of size 1e-3 to 1e3, relative to that: "
         "what is\n"
         "nearer to a surface than its offset is skipped.\n";
}

std::string text_brief(const SearchResult& result) {
  std::string text = fmt::format("{:<15} {:>9} {:>11} {:>9}   {:>17} {:>17}\n", "leaving by", "rays",
                                 "false hits", "skipped", "offset in float32", "in float64");
  for (const Strategy* strategy : strategies_of(result)) {
    const Count all = sum_of(result, [&](const StrategyOutcome& one) { return one.strategy == strategy; });
    text += fmt::format("{:<15} {:>9} {:>11} {:>9}", strategy->name, all.rays, all.false_hits, all.skipped);
    for (const Precision precision : {Precision::float32, Precision::float64}) {
      const Lengths offsets = everyday(result, strategy, precision).offsets;
      text += fmt::format("   {:>7.0e} to {:>5.0e}", offsets.median(), offsets.largest());
    }
    text += "\n";
  }
  return text;
}

std::string text_shapes(const SearchResult& result) {
  std::string text = fmt::format("{:<15} {:<15} {:>10} {:>14} {:>14} {:>10} {:>11}\n", "strategy", "shape",
                                 "rays", "false, float32", "false, float64", "skipped", "misanswered");
  for (const Strategy* strategy : strategies_of(result))
    for (const std::string& shape : topics_with_rays()) {
      const auto of = [&](std::optional<Precision> precision) {
        return sum_of(result, [&](const StrategyOutcome& one) {
          return one.strategy == strategy && one.shape == shape &&
                 one.precision == precision.value_or(one.precision);
        });
      };
      const Count all = of({});
      if (all.rays == 0) continue;
      text += fmt::format("{:<15} {:<15} {:>10} {:>14} {:>14} {:>10} {:>11}\n", strategy->name, shape,
                          all.rays, of(Precision::float32).false_hits, of(Precision::float64).false_hits,
                          all.skipped, all.misanswered);
    }
  return text;
}

std::string text_tenfold(const SearchResult& result) {
  const auto of = [&](const char* name, Precision precision, std::size_t decade) {
    Count sum;
    for (const StrategyOutcome& one : result.outcomes)
      if (one.strategy->name == name && one.precision == precision) sum += one.tally.by_size.at(decade);
    return sum;
  };
  std::string rows;
  for (std::size_t i = decade_of(1e-3); i < decade_of(1e3); ++i) {
    std::string row = fmt::format("1e{:<+6}", least_decade + static_cast<int>(i));
    bool is_compared = false;
    for (const char* name : {"fixed", "relative"})
      for (const Precision precision : {Precision::float32, Precision::float64}) {
        const Count count = of(name, precision, i);
        const double share = 100.0 * static_cast<double>(count.tenfold) /
                             static_cast<double>(std::max<std::uint64_t>(count.compared, 1));
        row += fmt::format("   {:>6.2f} % of {:>8}", share, count.compared);
        is_compared = is_compared || count.compared > 0;
      }
    if (is_compared) rows += row + "\n";
  }
  if (rows.empty()) return "";
  return fmt::format("{:<8}   {:>20}   {:>20}   {:>20}   {:>20}\n{}", "size", "fixed, float32",
                     "fixed, float64", "relative, float32", "relative, float64", rows) +
         "Of the rays that fixed or relative starts rightly, in scenes of that power of ten: the share of "
         "which the offset of\nproven is at least ten times smaller.\n";
}

std::string case_lines(const SearchResult& result) {
  std::string lines;
  for (const WrongStart& failure : result.failures) lines += write_case(failure.left) + '\n';
  return lines;
}

std::string text_failures(const SearchResult& result) {
  std::string text;
  for (const WrongStart& failure : result.failures)
    text += fmt::format("{}, its smallest case that was found:\n{}\n", failure.strategy->name,
                        write_case(failure.left));
  return text;
}

std::vector<std::string> broken_promises(const SearchResult& result) {
  std::vector<std::string> broken;
  for (const Strategy* strategy : strategies_of(result)) {
    const Count all = sum_of(result, [&](const StrategyOutcome& one) { return one.strategy == strategy; });
    if (strategy->is_proven && all.false_hits > 0)
      broken.push_back(fmt::format("{} promises no false hit and has {}", strategy->name, all.false_hits));
    if (strategy->is_proven && all.skipped > 0)
      broken.push_back(
          fmt::format("{} promises to stay in a solid and has left {}", strategy->name, all.skipped));
  }
  return broken;
}

std::string json_text(const SearchSettings& settings, const SearchResult& result) {
  std::string rows;
  for (const StrategyOutcome& outcome : result.outcomes)
    for (int i = 0; i < decades; ++i) {
      const Count& count = outcome.tally.by_size.at(static_cast<std::size_t>(i));
      if (count.rays == 0) continue;
      rows += fmt::format(
          R"({}{{"strategy": "{}", "shape": "{}", "precision": "{}", "size": 1e{}, "rays": {}, )"
          R"("false_hits": {}, "skipped": {}, "misanswered": {}, "thickest_skipped": {:.3e}, )"
          R"("median_offset": {:.3e}, )"
          R"("largest_offset": {:.3e}}})",
          rows.empty() ? "" : ",\n", outcome.strategy->name, outcome.shape, name_of(outcome.precision),
          least_decade + i, count.rays, count.false_hits, count.skipped, count.misanswered,
          count.thickest_skipped, count.offsets.median(), count.offsets.largest());
    }
  return fmt::format("{{\"seed\": {}, \"cases\": {}, \"rows\": [\n{}\n]}}\n", settings.seed, settings.cases,
                     rows);
}

}  // namespace rayproof::leaving

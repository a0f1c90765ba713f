#include "bench/contenders/measure.hpp"

#include <tbb/parallel_for.h>

#include <map>

#include "bench/contenders/contender.hpp"
#include "bench/figures/accuracy.hpp"
#include "bench/figures/median.hpp"

namespace rayproof::report {

namespace {

/// The subjects of a family's topic that are asked for, judged side by side.
std::map<std::string, Accuracies> judge_all(const BenchOptions& options, const Family& family,
                                            const JudgedFamily& judged) {
  std::vector<const Subject*> wanted;
  for (const Subject& subject : subjects()) {
    if (subject.topic == family.topic && options.wants_method(subject.topic, subject.name))
      wanted.push_back(&subject);
  }
  std::vector<Accuracies> results(wanted.size());
  tbb::parallel_for(std::size_t{0}, wanted.size(),
                    [&](std::size_t i) { results[i] = measure(*wanted[i], judged); });

  std::map<std::string, Accuracies> named;
  for (std::size_t i = 0; i < wanted.size(); ++i) named[wanted[i]->name] = results[i];
  return named;
}

/// One family in one precision: judged first, then timed with nothing else running.
void measure_family(const BenchOptions& options, const Family& family, Precision precision,
                    std::vector<BenchRow>& rows) {
  const JudgedFamily judged = judged_family(family, precision, options.rays);
  const auto accuracies = judge_all(options, family, judged);

  std::vector<Contender> wanted;
  for (Contender& contender : contenders(family.topic, judged.cases, precision)) {
    if (contender.method == BenchRow::floor_name || accuracies.contains(contender.method))
      wanted.push_back(std::move(contender));
  }
  const auto passes = time_passes(wanted, options.rays, options.seconds);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const Contender& timed = wanted[i];
    BenchRow row{family.topic, timed.method, precision, timed.arrangement, family.name, median(passes[i])};
    row.passes_ns = passes[i];
    if (!row.is_floor()) {
      const Accuracies& found = accuracies.at(timed.method);
      row.accuracy = timed.arrangement == Arrangement::scalar ? found.scalar : found.batch;
    }
    rows.push_back(row);
  }
}

}  // namespace

Measurements measure(const BenchOptions& options, const ProgressListener& listener) {
  std::vector<const Family*> wanted;
  for (const Family& family : families()) {
    if (options.wants_family(family)) wanted.push_back(&family);
  }
  const std::vector<Precision> precisions = options.wanted_precisions();

  Measurements figures{machine_name(), RAYPROOF_COMPILER, options.rays, {}};
  std::size_t done = 0;
  for (const Family* family : wanted) {
    for (const Precision precision : precisions) {
      const auto share = static_cast<double>(done++) / static_cast<double>(wanted.size() * precisions.size());
      listener(share, family->topic + " " + family->name + " " + name_of(precision));
      measure_family(options, *family, precision, figures.rows);
    }
  }
  return figures;
}

}  // namespace rayproof::report

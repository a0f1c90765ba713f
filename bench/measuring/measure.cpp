#include "bench/measuring/measure.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "bench/contenders/contender.hpp"
#include "bench/figures/accuracy.hpp"
#include "bench/figures/summary.hpp"
#include "bench/measuring/oracle_contender.hpp"
#include "bench/peers/peer.hpp"

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
  const std::vector<Accuracies> results = measure(wanted, judged);

  std::map<std::string, Accuracies> named;
  for (std::size_t i = 0; i < wanted.size(); ++i) named[wanted[i]->name] = results[i];
  return named;
}

/// The cases of a family that a peer can be asked, as many as are to be judged.
JudgedFamily taken_by(const PeerRoutine& peer, const JudgedFamily& family) {
  JudgedFamily taken;
  for (std::size_t i = 0; i < family.exact.size() && taken.cases.size() < peer.most_cases; ++i) {
    if (!peer.takes(family.cases[i])) continue;
    taken.cases.push_back(family.cases[i]);
    taken.exact.push_back(family.exact[i]);
  }
  return taken;
}

/// The same of the peers, on the families of scenes: numbers of any size are not what these libraries are
/// made for.
void judge_peers(const BenchOptions& options, const Family& family, Precision precision,
                 const JudgedFamily& judged, std::map<std::string, Accuracies>& named) {
  std::vector<PeerRoutine> wanted = peers_of(family.topic, precision);
  std::erase_if(wanted, [&](const PeerRoutine& peer) {
    return !is_of_scenes(family.name) || !options.wants_method(family.topic, peer.subject.name) ||
           named.contains(peer.subject.name);
  });
  std::vector<Accuracies> results(wanted.size());
  tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t i) {
    // By this thread alone: a library's routine may keep something between two calls.
    tbb::task_arena(1).execute([&] {
      const Subject* subject = &wanted[i].subject;
      results[i] = measure({&subject, 1}, taken_by(wanted[i], judged)).front();
    });
  });
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (results[i].scalar.cases > 0) named[wanted[i].subject.name] = results[i];
}

/// One family in one precision: judged first, then timed with nothing else running.
void measure_family(const BenchOptions& options, const Family& family, Precision precision,
                    std::vector<BenchRow>& rows) {
  const JudgedFamily judged = judged_family(family, precision, options.rays, options.judged);
  auto accuracies = judge_all(options, family, judged);
  judge_peers(options, family, precision, judged, accuracies);

  std::vector<Contender> wanted = contenders(family.topic, judged.cases, precision);
  if (is_of_scenes(family.name))
    std::ranges::move(peer_contenders(family.topic, judged.cases, precision), std::back_inserter(wanted));
  std::erase_if(wanted, [&](const Contender& one) {
    return one.method != floor_name && !accuracies.contains(one.method);
  });
  wanted.push_back(oracle_contender(family.topic, judged.cases));
  const BenchRow pattern{.shape = family.topic, .precision = precision, .family = family.name};
  for (BenchRow& row : timed_rows(wanted, pattern, options.rays, options.seconds)) {
    if (row.has_errors()) {
      const Accuracies& found = accuracies.at(row.method);
      row.accuracy = row.arrangement == Arrangement::scalar ? found.scalar : found.batch;
    }
    rows.push_back(std::move(row));
  }
}

}  // namespace

Measurements measure(const BenchOptions& options, const std::atomic<bool>& stop,
                     const ProgressListener& listener) {
  std::vector<const Family*> wanted;
  for (const Family& family : families()) {
    if (options.wants_rows() && options.wants_family(family)) wanted.push_back(&family);
  }
  const std::vector<Precision> precisions = options.wanted_precisions();

  Measurements figures{machine_name(), RAYPROOF_COMPILER, options.rays, {}};
  std::size_t done = 0;
  for (const Family* family : wanted) {
    for (const Precision precision : precisions) {
      if (stop) return figures;
      const auto share = static_cast<double>(done++) / static_cast<double>(wanted.size() * precisions.size());
      listener(share, family->topic + " " + family->name + " " + name_of(precision));
      measure_family(options, *family, precision, figures.rows);
    }
  }
  return figures;
}

}  // namespace rayproof::report

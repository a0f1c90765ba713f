#include "properties/engine.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <functional>
#include <map>
#include <set>

#include "case/writer.hpp"
#include "generators/random.hpp"
#include "properties/hunt.hpp"
#include "properties/shrink/shrink.hpp"

namespace rayproof {

namespace {

/// The properties of the plan that the subject claims or is declared to break.
std::vector<bool> active_properties(const Plan& plan, const Subject& subject) {
  std::vector<bool> active(properties().size());
  for (std::size_t p = 0; p < active.size(); ++p)
    active[p] = plan.is_wanted[p] &&
                (claims(subject, properties()[p]) || is_declared_refuted(subject, properties()[p]));
  return active;
}

/// One run: the plan, whom to tell, and what has been found.
class Run {
 public:
  Run(const Plan& plan, const Listener& listener, const std::atomic<bool>& stop)
      : plan_(plan), listener_(listener), stop_(stop), start_(std::chrono::steady_clock::now()) {
    for (const Subject* subject : plan.subjects)
      for (const Precision precision : plan.precisions)
        for (const Family* family : plan.families)
          if (family->topic == subject->topic) result_.units.push_back({subject, family, precision, {}});
  }

  RunResult all(const std::vector<Case>& corpus) {
    for (const Case& one : corpus) put_corpus_case(one);
    count_all_labels();
    put_families();
    result_.was_interrupted = stop_;
    return std::move(result_);
  }

 private:
  void put_corpus_case(const Case& one) {
    bool was_put = false;
    for (const Subject* subject : plan_.subjects) {
      if (subject->topic != topic_of(one) || stop_) continue;
      was_put = true;
      const std::vector<bool> active = active_properties(plan_, *subject);
      for (std::size_t p = 0; p < active.size(); ++p) {
        Trial trial(*subject, one);
        // A declared refutation is to be found by the families, not handed over.
        if (active[p] && claims(*subject, properties()[p]) && properties()[p].rule(trial) == Ruling::broken)
          tell({subject, p, one, "corpus"});
      }
    }
    result_.corpus_cases += was_put ? 1 : 0;
  }

  void count_all_labels() {
    std::vector<LabelCount> counts;
    for (const Family* family : plan_.families)
      for (const Precision precision : plan_.precisions) counts.push_back({family, precision});
    listener_.progress({"labels", 0});
    const auto sample = static_cast<unsigned>(std::min<std::uint64_t>(plan_.settings.cases, label_sample));
    tbb::parallel_for(std::size_t{0}, counts.size(), [&](std::size_t i) {
      counts[i] = count_labels(*counts[i].family, counts[i].precision, plan_.settings.seed, sample);
    });
    result_.labels = std::move(counts);
  }

  /// Without a time limit all cases in one round; with one, in rounds of a block for every unit, so that each
  /// has its share when the time is over.
  void put_families() {
    const std::uint64_t cases_in_round = plan_.settings.time
                                             ? std::min<std::uint64_t>(cases_in_block, plan_.settings.cases)
                                             : plan_.settings.cases;
    const std::uint64_t rounds =
        (plan_.settings.cases + cases_in_round - 1) / std::max<std::uint64_t>(cases_in_round, 1);
    for (std::uint64_t round = 0; round < rounds && !is_over(round); ++round)
      for (std::size_t u = 0; u < result_.units.size() && !stop_ && !is_over(round); ++u)
        put_unit(result_.units[u], round,
                 std::min(cases_in_round, plan_.settings.cases - round * cases_in_round),
                 static_cast<double>(round * result_.units.size() + u) /
                     static_cast<double>(rounds * result_.units.size()),
                 1.0 / static_cast<double>(rounds * result_.units.size()));
  }

  [[nodiscard]] bool is_over(std::uint64_t round) const {
    return stop_ || (round > 0 && elapsed() > static_cast<double>(plan_.settings.time->count()));
  }

  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  void put_unit(UnitResult& unit, std::uint64_t round, std::uint64_t cases, double done, double share) {
    Hunt hunt{*unit.subject, *unit.family, unit.precision, active_properties(plan_, *unit.subject)};
    hunt.already_broken = broken_[{unit.subject, unit.precision}];
    hunt.measure = plan_.settings.measure_all;
    hunt.seed = combine(plan_.settings.seed, round);
    hunt.cases = cases;
    hunt.stop = &stop_;
    hunt.progress = [&](double of_unit) {
      // With a time limit, time tells how far we are.
      const double by_cases = done + share * of_unit;
      const double by_time =
          plan_.settings.time ? elapsed() / static_cast<double>(plan_.settings.time->count()) : 0.0;
      listener_.progress(
          {fmt::format("{} {} {}", unit.subject->full_name(), unit.family->name, name_of(unit.precision)),
           std::min(1.0, std::max(by_cases, by_time))});
    };
    hunt.found = [&](std::size_t property, const Case& one) {
      tell({unit.subject, property, one, unit.family->name});
      broken_[{unit.subject, unit.precision}].insert(property);
    };
    unit.tally += hunt.run();
  }

  struct Raw {
    const Subject* subject;
    std::size_t property;
    Case one;
    std::string family;
  };

  /// The simplest case like the one found. What is simpler is another case: it has no id, and what is noted
  /// of the first is not true of it.
  [[nodiscard]] Case simplest(const Case& found, const std::function<bool(const Case&)>& breaks) const {
    Case bare = found;
    bare.id.clear();
    bare.note.clear();
    Case shrunk = shrink(bare, breaks, {.stop = &stop_});
    return write_case(shrunk) == write_case(bare) ? found : shrunk;
  }

  /// Shrinks what was found, reports it, and keeps it.
  void tell(const Raw& raw) {
    const Property& property = properties()[raw.property];
    Finding finding{.subject = raw.subject,
                    .property = &property,
                    .family = raw.family,
                    .one = raw.one,
                    .is_declared = is_declared_refuted(*raw.subject, property)};
    Trial as_found(*raw.subject, finding.one);
    finding.evidence = property.show(as_found);
    listener_.broken(finding);
    finding.one = simplest(raw.one, striking_break(*raw.subject, property, as_found));
    Trial shrunk(*raw.subject, finding.one);
    finding.evidence = property.show(shrunk);
    listener_.finding(finding);
    result_.findings.push_back(std::move(finding));
  }

  const Plan& plan_;
  const Listener& listener_;
  const std::atomic<bool>& stop_;
  std::chrono::steady_clock::time_point start_;
  RunResult result_{};
  std::map<std::pair<const Subject*, Precision>, std::set<std::size_t>> broken_{};
};

}  // namespace

RunResult run_plan(const Plan& plan, const std::vector<Case>& corpus, const Listener& listener,
                   const std::atomic<bool>& stop) {
  const int jobs = plan.settings.jobs > 0 ? plan.settings.jobs : tbb::this_task_arena::max_concurrency();
  // The global limit lets an arena be larger than the machine, which task_arena alone refuses with a warning.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  return arena.execute([&] { return Run(plan, listener, stop).all(corpus); });
}

}  // namespace rayproof

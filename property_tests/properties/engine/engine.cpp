#include "properties/engine/engine.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "properties/engine/diagnosing.hpp"
#include "properties/engine/found.hpp"
#include "properties/engine/kind.hpp"
#include "properties/engine/units.hpp"
#include "properties/guests/one_fault.hpp"

namespace rayproof {

namespace {

/// One run: the plan, who hears of it, and what has been found.
class Run {
 public:
  Run(const Plan& plan, const Listener& listener, const std::atomic<bool>& stop)
      : plan_(plan), listener_(listener), stop_(stop), start_(std::chrono::steady_clock::now()) {
    result_.units = units_of(plan);
  }

  RunResult all(const std::vector<Case>& corpus) {
    for (const Failure& failure : plan_.failures) put_failure(failure);
    for (const Case& one : corpus) put_corpus_case(one);
    if (plan_.settings.count_labels) count_all_labels();
    const std::size_t of_families = result_.findings.size();
    put_families();
    sort_by_subjects(std::span(result_.findings).subspan(of_families));
    leave_out_twins(result_.findings);
    diagnose_findings(result_, samples_, listener_, stop_);
    put_together(result_.findings, kind_of,
                 {is_named_boundary, is_avoided, is_part_of, is_extreme, is_zero_alone});
    result_.was_interrupted = stop_;
    return std::move(result_);
  }

 private:
  /// What a guest failed at when it was first asked.
  void put_failure(const Failure& failure) {
    for (const Subject* subject : plan_.subjects)
      for (std::size_t p = 0; p < properties().size(); ++p)
        if (subject->full_name() == failure.subject && properties()[p].claim == Claim::answers &&
            plan_.is_wanted[p] && broken_[{subject, failure.one.precision}].insert(p).second)
          report(*subject, properties()[p], failure.one, "first questions", &failure.outcome);
  }

  [[nodiscard]] bool is_put_to_guest(const Subject& guest, const Case& one) const {
    return is_for_guest(guest, one) &&
           std::ranges::find(plan_.precisions, one.precision) != plan_.precisions.end();
  }

  void put_corpus_case(const Case& one) {
    bool was_put = false;
    for (const Subject* subject : plan_.subjects) {
      if (subject->topic != topic_of(one) || stop_ || subject->is_given_up()) continue;
      if (!subject->has_own_contract && !is_put_to_guest(*subject, one)) continue;
      was_put = true;
      Trial trial(*subject, one);
      for (std::size_t p = 0; p < properties().size(); ++p) {
        const Property& property = properties()[p];
        // Left to the families: the corpus has the worst cases for the digits of our own methods.
        const bool is_measured = property.asks != nullptr || property.claim == Claim::residual;
        if (!subject->has_own_contract && is_measured) continue;
        // A declared refutation is to be found by the families, not handed over.
        if (!plan_.is_wanted[p] || !claims(*subject, property) ||
            ruling_of(property, trial) != Ruling::broken)
          continue;
        if (subject->has_own_contract || broken_[{subject, one.precision}].insert(p).second)
          report(*subject, property, one, "corpus",
                 subject->function == nullptr ? &trial.outcome() : nullptr);
      }
    }
    result_.corpus_cases += was_put ? 1 : 0;
  }

  void count_all_labels() {
    for (const Family* family : plan_.families)
      for (const Precision precision : plan_.precisions) result_.labels.push_back({family, precision});
    listener_.progress("labels", 0);
    const auto sample = static_cast<unsigned>(std::min<std::uint64_t>(plan_.settings.cases, label_sample));
    tbb::parallel_for(std::size_t{0}, result_.labels.size(), [&](std::size_t i) {
      LabelCount& one = result_.labels[i];
      one = count_labels(*one.family, one.precision, plan_.settings.seed, sample);
    });
  }

  /// Without a time limit all cases in one round; with one, in rounds of a block for every unit, so that each
  /// has its share when the time is over.
  void put_families() {
    const std::uint64_t all = plan_.settings.cases;
    const std::uint64_t in_round = plan_.settings.time ? std::min<std::uint64_t>(cases_in_block, all) : all;
    const std::uint64_t rounds = (all + in_round - 1) / std::max<std::uint64_t>(in_round, 1);
    const auto hunts = static_cast<double>(rounds * result_.units.size());
    double done = 0;
    for (std::uint64_t round = 0; round < rounds; ++round)
      for (Unit& unit : by_families(result_.units)) {
        if (stop_ || (round > 0 && share_of_time() > 1)) return;
        if (unit.subject->is_given_up()) continue;
        unit.others_failed = &others_failed_[unit.subject];
        unit.judged = &judged_;
        Hunt hunt{unit, broken_[{unit.subject, unit.precision}], stop_, combine(plan_.settings.seed, round),
                  std::min(in_round, all - round * in_round)};
        hunt.progress = [&](double of_unit) {
          listener_.progress(
              fmt::format("{} {} {}", unit.subject->full_name(), unit.family->name, name_of(unit.precision)),
              std::min(1.0, std::max((done + of_unit) / hunts, share_of_time())));
        };
        hunt.found = [&](std::size_t property, const Case& one, const Outcome* outcome) {
          report(*unit.subject, properties()[property], one, unit.family->name, outcome);
        };
        hunt.sampled = [&](std::size_t property, std::uint64_t block_seed, const BlockSample& sample) {
          samples_.add(*unit.subject, *unit.family, unit.precision, properties()[property], block_seed,
                       sample);
        };
        hunt.run();
        ++done;
      }
  }

  /// By subject, then by precision, whatever was done first.
  void sort_by_subjects(std::span<Finding> findings) const {
    std::ranges::stable_sort(findings, {}, [&](const Finding& finding) {
      return std::pair(std::ranges::find(plan_.subjects, finding.subject),
                       std::ranges::find(plan_.precisions, finding.one.precision));
    });
  }

  /// How much of the time is over; 0 without a limit.
  [[nodiscard]] double share_of_time() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    return plan_.settings.time ? elapsed / *plan_.settings.time : 0;
  }

  void report(const Subject& subject, const Property& property, const Case& one, const std::string& family,
              const Outcome* outcome = nullptr) {
    if (auto finding = made_of({subject, property, one, family, outcome}, listener_, stop_))
      result_.findings.push_back(std::move(*finding));
  }

  const Plan& plan_;
  const Listener& listener_;
  const std::atomic<bool>& stop_;
  std::chrono::steady_clock::time_point start_;
  RunResult result_{};
  Samples samples_{};
  std::map<std::pair<const Subject*, Precision>, std::set<std::size_t>> broken_{};
  std::map<const Subject*, std::atomic<unsigned>> others_failed_{};
  JudgedBlocks judged_{};
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

#include "properties/worst/search.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <map>

#include "properties/claims/promise.hpp"

namespace rayproof::worst {

namespace {

/// Whether the row says something: of what is promised always, of the rest where an error was met. Under a
/// transform no ulp is promised, and only what is promised is of interest.
bool is_shown(const WorstRow& row) {
  const bool is_promised = std::isfinite(row.bound().promised);
  if (is_of_transformed(row.kind))
    return is_promised && row.found && std::string_view(measure_of(row.kind).name) != "ulp";
  return row.found || (is_promised && !measure_of(row.kind).is_of_details);
}

/// The case where it breaks what is promised.
std::optional<WorstCase> broken_by(const std::optional<WorstCase>& worst, const Subject& subject,
                                   std::size_t kind) {
  return worst && exceeds_promise(subject, worst->one, kind) ? worst : std::nullopt;
}

class Searches {
 public:
  Searches(const WorstSearch& what, const std::atomic<bool>& stop, const HearSearch& progress)
      : what_(what), plan_(make_plan(what.plan)), stop_(stop), progress_(progress) {
    if (what.plan.methods.empty())
      std::erase_if(plan_.subjects,
                    [](const Subject* one) { return one->contract.standing == Standing::printed; });
  }

  WorstResult all() {
    for (const Subject* subject : plan_.subjects)
      for (const Precision precision : plan_.precisions)
        if (!stop_) put(*subject, precision);
    result_.was_interrupted = stop_;
    return std::move(result_);
  }

 private:
  void put(const Subject& subject, Precision precision) {
    const Ground ground{families_of(subject), precision, [&](const Case& one, bool with_details) {
                          return errors_of(subject, one, with_details);
                        }};
    const Budget budget{plan_.settings.seed, plan_.settings.cases, what_.time};
    std::vector<Case>& known = known_[{subject.topic, precision}];
    const Climbed climbed = climb(ground, budget, known, stop_, hear(subject, precision));
    std::optional<Climbed> drawn;
    if (what_.compare) drawn = draw_only(ground, budget, stop_, hear(subject, precision));
    result_.climbed += climbed.cases;
    result_.drawn += drawn ? drawn->cases : 0;
    for (std::size_t kind = 0; kind < error_kinds; ++kind) {
      WorstRow row{&subject, precision, kind, std::nullopt, climbed.worst[kind]};
      if (row.found) known.push_back(row.found->one);
      row.exceeding = broken_by(row.found, subject, kind);
      if (drawn) {
        const std::optional<WorstCase>& worst = drawn->worst[kind];
        row.drawn = worst ? worst->error : 0;
        if (!row.exceeding) row.exceeding = broken_by(worst, subject, kind);
      }
      if (is_shown(row)) result_.rows.push_back(std::move(row));
    }
  }

  [[nodiscard]] std::vector<const Family*> families_of(const Subject& subject) const {
    std::vector<const Family*> all = plan_.families;
    std::erase_if(all, [&](const Family* family) { return family->topic != subject.topic; });
    return all;
  }

  /// The progress of one search as a share of all.
  [[nodiscard]] HearProgress hear(const Subject& subject, Precision precision) {
    const double before = static_cast<double>(begun_++);
    const double all =
        static_cast<double>(plan_.subjects.size() * plan_.precisions.size() * (what_.compare ? 2 : 1));
    return [this, before, all, text = fmt::format("{} {}", subject.full_name(), name_of(precision))](
               double done) { progress_((before + done) / all, text); };
  }

  const WorstSearch& what_;
  Plan plan_;
  const std::atomic<bool>& stop_;
  const HearSearch& progress_;
  std::size_t begun_ = 0;
  std::map<std::pair<std::string, Precision>, std::vector<Case>> known_{};
  WorstResult result_{};
};

}  // namespace

double WorstRow::promised() const {
  const std::string_view error = measure_of(kind).name;
  const bool is_widened = is_of_transformed(kind) && (error == "verdict" || error == "residual");
  return is_widened ? std::max(bound().promised, robust_bound(subject->topic).value_or(0)) : bound().promised;
}

bool WorstRow::is_proven() const {
  const bool is_in_world = std::string_view(measure_of(kind).name) == "point";  // which no map rounds
  return bound().is_proven && (is_in_world || !is_of_transformed(kind));
}

std::string WorstRow::error_name() const {
  return std::string(measure_of(kind).name) + (is_of_transformed(kind) ? ", transformed" : "");
}

bool WorstResult::keeps_promises() const {
  return std::ranges::none_of(rows, [](const WorstRow& row) { return row.exceeding.has_value(); });
}

WorstResult search(const WorstSearch& what, const std::atomic<bool>& stop, const HearSearch& progress) {
  const int jobs = what.plan.jobs > 0 ? what.plan.jobs : tbb::this_task_arena::max_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  return arena.execute([&] { return Searches(what, stop, progress).all(); });
}

Finding finding_of(const WorstRow& row, std::size_t number) {
  Finding finding{.number = number,
                  .subject = row.subject,
                  .property = find_property(measure_of(row.kind).name),
                  .family = row.found->family->name,
                  .one = row.found->one};
  finding.is_declared = is_declared_refuted(*row.subject, *finding.property);
  Trial trial(*row.subject, finding.one);
  finding.evidence = finding.property->show(trial);
  finding.evidence.note =
      fmt::format("from the guided search, {}: {}", row.subject->full_name(), finding.evidence.note);
  return finding;
}

}  // namespace rayproof::worst

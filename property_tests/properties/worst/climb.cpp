#include "properties/worst/climb.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "properties/worst/variation.hpp"

namespace rayproof::worst {

namespace {

/// Cases between two looks at what is the worst; each is made from those that were worst before.
constexpr unsigned cases_in_generation = 1024;
/// Generations that only draw, so that climbs begin from good places.
constexpr std::uint64_t generations_of_draws = 8;
/// One case in this many is drawn, whatever was found.
constexpr int one_draw_in = 8;
/// One variation in this many goes on along the last progress.
constexpr int one_step_in = 4;
/// Variations without progress after which a climb begins anew elsewhere, and what counts as progress.
constexpr unsigned patience = 4000;
constexpr double progress_factor = 1.001;
/// In a search by draws alone the details are measured on one case in this many, as the property tests do.
constexpr std::uint64_t details_every = 8;

/// A place from which the search climbs, and the one before its last progress.
struct Climber {
  WorstCase at{};
  std::optional<WorstCase> before{};
  unsigned tries = 0;

  /// Goes to what is as bad, or worse.
  void move_to(const WorstCase& found) {
    if (found.error > progress_factor * at.error) {
      tries = 0;
      if (at.error > 0 && found.family == at.family) before = std::move(at);
    }
    at = found;
  }
};

/// A case that was made, from which climber (none for a draw), and its errors.
struct Offspring {
  Case one{};
  const Family* family = nullptr;
  std::size_t kind = 0;
  Climber* parent = nullptr;
  ErrorList errors{};
};

class Climb {
 public:
  Climb(const Ground& ground, const Budget& budget, bool is_guided)
      : ground_(ground), budget_(budget), is_guided_(is_guided) {
    for (auto& climbers : climbers_) climbers.resize(ground.families.size() + 1);
  }

  Climbed run(const std::vector<Case>& start, const std::atomic<bool>& stop, const HearProgress& progress) {
    const auto begin = std::chrono::steady_clock::now();
    put(start);
    for (std::uint64_t generation = 0; !stop; ++generation) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
      const double done = budget_.time
                              ? elapsed / *budget_.time
                              : static_cast<double>(result_.cases) / static_cast<double>(budget_.cases);
      progress(std::min(done, 1.0));
      if (done >= 1) break;
      const std::uint64_t left = budget_.time ? cases_in_generation : budget_.cases - result_.cases;
      breed(generation, static_cast<unsigned>(std::min<std::uint64_t>(cases_in_generation, left)));
    }
    return std::move(result_);
  }

 private:
  /// Cases from elsewhere belong to the first family.
  void put(const std::vector<Case>& start) {
    std::vector<Offspring> children;
    for (const Case& one : start)
      children.push_back({one, ground_.families.front(), 0, nullptr, ground_.errors(one, true)});
    take(children);
  }

  /// One generation: its cases are made and judged side by side, and then taken in order.
  void breed(std::uint64_t generation, unsigned cases) {
    const bool draws_only = !is_guided_ || generation < generations_of_draws;
    find_what_to_climb();
    std::vector<Offspring> children(cases);
    tbb::parallel_for(0U, cases, [&](unsigned k) {
      const std::uint64_t number = generation * cases_in_generation + k;
      children[k] = draws_only ? drawn(number) : made(number);
      const bool with_details = children[k].parent == nullptr ? number % details_every == 0
                                                              : measure_of(children[k].kind).is_of_details;
      children[k].errors = ground_.errors(children[k].one, with_details);
    });
    result_.cases += cases;
    take(children);
  }

  /// The kinds of error that can become larger.
  void find_what_to_climb() {
    kinds_.clear();
    for (std::size_t kind = 0; kind < error_kinds; ++kind)
      if (result_.worst[kind] && std::isfinite(result_.worst[kind]->error)) kinds_.push_back(kind);
  }

  [[nodiscard]] std::uint64_t seed_of(std::uint64_t number) const {
    return combine(combine(budget_.seed, ground_.precision == Precision::float32 ? 32U : 64U), number);
  }

  [[nodiscard]] Offspring drawn(std::uint64_t number) const {
    const Family* family = ground_.families[number % ground_.families.size()];
    return {family->generate(seed_of(number), ground_.precision), family, 0, nullptr, {}};
  }

  [[nodiscard]] Offspring made(std::uint64_t number) {
    Random random(combine(seed_of(number), 1));
    if (kinds_.empty() || random.one_in(one_draw_in)) return drawn(number);
    const std::size_t kind =
        kinds_[static_cast<std::size_t>(random.between(0, static_cast<int>(kinds_.size()) - 1))];
    Climber& parent = pick(kind, random);
    const Climber& mate = pick(kind, random);
    if (parent.at.family == nullptr || mate.at.family == nullptr) return drawn(number);
    const bool goes_on = parent.before && random.one_in(one_step_in);
    auto one = goes_on ? further(parent, random) : varied(parent.at.one, mate.at.one, random);
    if (!one) return drawn(number);
    return {std::move(*one), parent.at.family, kind, &parent, {}};
  }

  /// On along the last progress. Near a pole, where the error is the inverse of something that goes to 0 as a
  /// straight line does, the step that its two values say leads there; from there in steps of all sizes.
  [[nodiscard]] static std::optional<Case> further(const Climber& climber, Random& random) {
    const double gained = climber.at.error / climber.before->error - 1;
    const double share = random.one_in(2) ? 1 / gained : std::exp2(random.between(-6, 3));
    return moved_on(climber.before->one, climber.at.one, random.one_in(4) ? -share : share);
  }

  /// One time in four the worst of all, the last; else the worse of two.
  [[nodiscard]] Climber& pick(std::size_t kind, Random& random) {
    std::vector<Climber>& all = climbers_[kind];
    if (random.one_in(4)) return all.back();
    const int last = static_cast<int>(all.size()) - 1;
    const auto a = static_cast<std::size_t>(random.between(0, last));
    const auto b = static_cast<std::size_t>(random.between(0, last));
    return all[a].at.error >= all[b].at.error ? all[a] : all[b];
  }

  void take(const std::vector<Offspring>& children) {
    for (const Offspring& child : children) {
      if (child.parent != nullptr) ++child.parent->tries;
      for (std::size_t kind = 0; kind < error_kinds; ++kind)
        if (child.errors[kind] > 0) take(child, kind);
    }
    for (auto& climbers : climbers_)
      for (std::size_t i = 0; i + 1 < climbers.size(); ++i)
        if (climbers[i].tries > patience) climbers[i] = {};
  }

  /// Copies the case only where it takes a place: most do not.
  void take(const Offspring& child, std::size_t kind) {
    const double error = child.errors[kind];
    const auto found = [&] { return WorstCase{child.one, error, child.family}; };
    auto& worst = result_.worst[kind];
    if (!worst || error > worst->error) worst = found();
    if (!is_guided_) return;
    const auto family = std::ranges::find(ground_.families, child.family) - ground_.families.begin();
    // What is as bad takes the place, too: a climb does not end on level ground.
    for (Climber* climber : {&climbers_[kind][static_cast<std::size_t>(family)], &climbers_[kind].back()})
      if (error >= climber->at.error) climber->move_to(found());
  }

  const Ground& ground_;
  const Budget& budget_;
  bool is_guided_;
  std::array<std::vector<Climber>, error_kinds> climbers_{};  ///< one for each family, and the worst of all
  std::vector<std::size_t> kinds_{};
  Climbed result_{};
};

}  // namespace

Climbed draw_only(const Ground& ground, const Budget& budget, const std::atomic<bool>& stop,
                  const HearProgress& progress) {
  return Climb(ground, budget, false).run({}, stop, progress);
}

Climbed climb(const Ground& ground, const Budget& budget, const std::vector<Case>& start,
              const std::atomic<bool>& stop, const HearProgress& progress) {
  return Climb(ground, budget, true).run(start, stop, progress);
}

}  // namespace rayproof::worst

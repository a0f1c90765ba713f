#include "bench/figures/accuracy.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <span>

#include "oracle/judged_answers.hpp"
#include "properties/trial.hpp"

namespace rayproof::report {

namespace {

std::span<const double> numbers_of(const Answer& answer) {
  if (const auto* ray = std::get_if<RayAnswer>(&answer)) return ray->hits.view();
  if (std::holds_alternative<Position>(answer)) return {};
  const auto& roots = std::get<QuadraticAnswer<double>>(answer);
  return {roots.roots.data(), roots.count};
}

/// How much an answer finds: the number of hits or roots, or how far inside a place is.
std::size_t count_found(const Answer& answer) {
  if (const auto* position = std::get_if<Position>(&answer)) return static_cast<std::size_t>(*position);
  return numbers_of(answer).size();
}

bool is_nearest_only(const Answer& answer) {
  const auto* ray = std::get_if<RayAnswer>(&answer);
  return ray != nullptr && ray->nearest_only;
}

bool same_numbers(const Answer& x, const Answer& y) {
  return x.index() == y.index() && count_found(x) == count_found(y) &&
         std::ranges::equal(numbers_of(x), numbers_of(y));
}

/// The place of a number among all numbers of its format: neighbours differ by 1, -0 and 0 are one.
template <class T, class Bits>
std::int64_t place_of(double number) {
  const auto bits = std::bit_cast<Bits>(static_cast<T>(std::abs(number)));
  const auto place = static_cast<std::int64_t>(bits);
  return number < 0 ? -place : place;
}

double floats_between(double x, double y, Precision precision) {
  const auto place =
      precision == Precision::float32 ? place_of<float, std::uint32_t> : place_of<double, std::uint64_t>;
  return std::abs(static_cast<double>(place(x)) - static_cast<double>(place(y)));
}

/// An answer of a subject, and what the oracle says of it.
struct JudgedAnswer {
  Answer claimed{};
  oracle::Judgement judgement{};
  std::optional<oracle::Details> details{};
};

/// Adds up the judgements of one subject in one arrangement.
class AccuracySum {
 public:
  void add(const JudgedAnswer& judged, const Answer& exact, Precision precision) {
    const auto& [claimed, judgement, details] = judged;
    ++sum_.cases;
    const auto claims = numbers_of(claimed);
    const auto truths = numbers_of(exact);
    if (judgement.wrong) {
      const bool has_too_many =
          is_nearest_only(claimed) ? truths.empty() : count_found(claimed) > count_found(exact);
      ++(has_too_many ? sum_.wrong_hits : sum_.wrong_misses);
      return;
    }
    const std::size_t agreed = std::min(claims.size(), truths.size());
    if (agreed == 0) return;
    if (details) add(*details);
    ulps_.push_back(judgement.ulp);
    sum_.agreed_hits += agreed;
    for (std::size_t i = 0; i < agreed; ++i)
      bits_ += std::log2(1 + floats_between(claims[i], truths[i], precision));
  }

  [[nodiscard]] Accuracy result() {
    std::ranges::sort(ulps_);
    sum_.max_ulp = ulps_.empty() ? none : ulps_.back();
    sum_.p99_ulp = ulps_.empty() ? none : ulps_[(ulps_.size() - 1) * 99 / 100];
    sum_.mean_bits = sum_.agreed_hits == 0 ? none : bits_ / static_cast<double>(sum_.agreed_hits);
    return sum_;
  }

 private:
  void add(const oracle::Details& details) {
    const auto note = [](double& worst, const std::optional<double>& error, double unit) {
      if (error && !(*error / unit <= worst)) worst = *error / unit;  // of NaN, too
    };
    note(sum_.max_point, details.point, 1);
    note(sum_.max_normal, details.normal, 1);
    note(sum_.max_coordinates, details.coordinates, details.condition);
  }

  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Accuracy sum_{.max_point = none, .max_normal = none, .max_coordinates = none};
  std::vector<double> ulps_;
  double bits_ = 0;
};

/// What the oracle says of the first hit beside t, of every eighth case, where it is in the usual domain:
/// beyond it a point overflows.
std::optional<oracle::Details> details_of(const Case& one, const Answer& claimed,
                                          const oracle::Judgement& judgement, std::size_t index) {
  const int reach = reach_of(Domain{}, one.precision);
  const bool is_in_domain = judgement.smallest >= -reach && judgement.largest <= reach;
  if (index % 8 != 0 || !is_in_domain) return std::nullopt;
  return oracle::judge_details(one, claimed);
}

bool is_fair(const Answer& claimed, const Case& one) {
  if (!is_nearest_only(claimed)) return true;
  const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  return ray.t_min == 0 && std::isinf(ray.t_max);
}

/// One case: nothing where the subject is not judged on it, or has no batch.
struct JudgedCase {
  std::optional<JudgedAnswer> scalar{}, batch{};
};

JudgedCase judge(const Subject& subject, const Case& one, std::size_t index, oracle::JudgedAnswers& known) {
  JudgedCase judged;
  const Answer claimed = subject.answer(one);
  if (!is_fair(claimed, one)) return judged;
  const oracle::Judgement judgement = known.judge(one, claimed);
  judged.scalar = {claimed, judgement, details_of(one, claimed, judgement, index)};
  if (subject.answer_in_batch == nullptr) return judged;
  judged.batch = judged.scalar;
  if (Answer in_batch = subject.answer_in_batch(one); !same_numbers(claimed, in_batch))
    judged.batch = {in_batch, known.judge(one, in_batch), std::nullopt};
  return judged;
}

struct AccuracySums {
  AccuracySum scalar{}, batch{};

  void add(const JudgedCase& judged, const Answer& exact, Precision precision) {
    if (judged.scalar) scalar.add(*judged.scalar, exact, precision);
    if (judged.batch) batch.add(*judged.batch, exact, precision);
  }
};

}  // namespace

JudgedFamily judged_family(const Family& family, Precision precision, std::size_t count,
                           std::size_t judged_count) {
  JudgedFamily judged{std::vector<Case>(count), std::vector<Answer>(std::min(count, judged_count))};
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    judged.cases[i] = family.generate(i, precision);
    if (i < judged.exact.size()) judged.exact[i] = oracle::answer(judged.cases[i]);
  });
  return judged;
}

std::vector<Accuracies> measure(std::span<const Subject* const> subjects, const JudgedFamily& family) {
  constexpr std::size_t cases_at_a_time = 4096;
  std::vector<AccuracySums> sums(subjects.size());
  std::vector<JudgedCase> judged(cases_at_a_time * subjects.size());
  for (std::size_t first = 0; first < family.exact.size(); first += cases_at_a_time) {
    const std::size_t count = std::min(cases_at_a_time, family.exact.size() - first);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
      oracle::JudgedAnswers known;
      for (std::size_t s = 0; s < subjects.size(); ++s)
        judged[s * cases_at_a_time + i] = judge(*subjects[s], family.cases[first + i], first + i, known);
    });
    for (std::size_t s = 0; s < subjects.size(); ++s)
      for (std::size_t i = 0; i < count; ++i)
        sums[s].add(judged[s * cases_at_a_time + i], family.exact[first + i],
                    family.cases[first + i].precision);
  }
  std::vector<Accuracies> results;
  for (AccuracySums& sum : sums) results.push_back({sum.scalar.result(), sum.batch.result()});
  return results;
}

}  // namespace rayproof::report

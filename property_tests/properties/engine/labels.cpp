#include "properties/engine/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <rayproof/method/contract.hpp>

#include "generators/random.hpp"
#include "properties/trial.hpp"

namespace rayproof {

namespace {

/// How many of the line's hits the ray's interval holds. Rounding keeps the order of numbers, so that a t can
/// lie on the wrong side of an end only where it rounds to that.
std::size_t count_in_interval(const Case& one, const RayAnswer& line) {
  const Ray<double>& ray = std::get<RayQuestion>(one.question).ray;
  const auto is_end = [&](double t) { return t == ray.t_min || t == ray.t_max; };
  if (std::ranges::any_of(line.hits.view(), is_end))
    return std::get<RayAnswer>(oracle::answer(one)).hits.count;
  const auto is_held = [&](double t) { return in_interval(ray, t); };
  return static_cast<std::size_t>(std::ranges::count_if(line.hits.view(), is_held));
}

std::vector<std::string> labels_of(const Case& one, const RayAnswer& line) {
  const auto t = line.hits.view();
  const std::size_t hits = count_in_interval(one, line);

  std::vector<std::string> labels{hits > 0 ? "hit" : "miss"};
  if (line.contact != Contact::crossing && line.contact != Contact::none)
    std::ranges::replace(labels.emplace_back(name_of(line.contact)), '_', ' ');
  if (line.hits.count > 0 && !line.normal) labels.emplace_back("sharp");
  if (hits == 0 && line.hits.count > 0) labels.emplace_back("behind");
  if (hits > 0 && hits < line.hits.count) labels.emplace_back("cut");
  if (line.hits.count > 1 && t.front() < 0 && t.back() > 0) labels.emplace_back("from inside");
  return labels;
}

std::vector<std::string> labels_of(const Case& /*one*/, const QuadraticAnswer<double>& exact) {
  return {name_of(exact.kind)};
}

std::vector<std::string> labels_of(const Case& /*one*/, Position exact) { return {name_of(exact)}; }

/// How far a sample of `cases` falls short of a share that its family keeps, by chance alone: four standard
/// deviations, once in 30,000 samples; nothing where the share is 1.
double by_chance(double share, unsigned cases) { return 4 * std::sqrt(share * (1 - share) / cases); }

}  // namespace

std::vector<std::string> labels_of(const Case& one) {
  const Case line = on_whole_line(one);
  const Answer exact = oracle::answer(line);
  std::vector<std::string> labels =
      std::visit([&](const auto& answer) { return labels_of(one, answer); }, exact);
  const oracle::Judgement judgement = oracle::judge(line, exact);
  const int reach = reach_of(Domain{}, one.precision);
  if (judgement.smallest >= -reach && judgement.largest <= reach) labels.emplace_back("in reach");
  return labels;
}

double LabelCount::share(const std::string& label) const {
  const auto found = counts.find(label);
  return found == counts.end() || cases == 0 ? 0 : static_cast<double>(found->second) / cases;
}

std::string LabelCount::shares() const {
  std::string text;
  for (const auto& [label, count] : counts)
    text += fmt::format("{}{} {:.1f} %", text.empty() ? "" : ", ", label, 100 * share(label));
  return text;
}

std::vector<std::string> LabelCount::missed() const {
  std::vector<std::string> sentences;
  if (cases < label_sample) return sentences;
  for (const MinimumShare& minimum : family->shares)
    if (share(minimum.label) + by_chance(minimum.share, cases) < minimum.share)
      sentences.push_back(fmt::format("{}/{}: {:.2f} % of the cases are \"{}\", at least {:.2f} % must be",
                                      family->topic, family->name, 100 * share(minimum.label), minimum.label,
                                      100 * minimum.share));
  return sentences;
}

LabelCount count_labels(const Family& family, Precision precision, std::uint64_t seed, unsigned cases) {
  LabelCount result{&family, precision, cases};
  for (unsigned k = 0; k < cases; ++k)
    for (const std::string& label : labels_of(family.generate(combine(seed, k), precision)))
      ++result.counts[label];
  return result;
}

}  // namespace rayproof

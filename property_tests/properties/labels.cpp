#include "properties/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <rayproof/method/contract.hpp>

#include "generators/random.hpp"
#include "oracle/oracle.hpp"

namespace rayproof {

namespace {

/// What a contact says beyond hit or miss, in words; nothing where it says no more.
std::string in_words(Contact contact) {
  if (contact == Contact::crossing || contact == Contact::none) return {};
  std::string words = name_of(contact);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::vector<std::string> labels_of(const Case& one, const RayAnswer& exact) {
  Case whole_line = one;
  auto& asked = std::get<RayQuestion>(whole_line.question);
  asked.ray.t_min = -infinity<double>;
  asked.ray.t_max = infinity<double>;
  const auto line = std::get<RayAnswer>(oracle::answer(whole_line));
  const auto t = line.hits.view();

  std::vector<std::string> labels{exact.hits.count > 0 ? "hit" : "miss"};
  if (std::string contact = in_words(line.contact); !contact.empty()) labels.push_back(std::move(contact));
  if (line.hits.count > 0 && !line.normal) labels.emplace_back("sharp");
  if (exact.hits.count == 0 && line.hits.count > 0) labels.emplace_back("behind");
  if (exact.hits.count > 0 && exact.hits.count < line.hits.count) labels.emplace_back("cut");
  if (line.hits.count > 1 && t.front() < 0 && t.back() > 0) labels.emplace_back("from inside");
  return labels;
}

std::vector<std::string> labels_of(const Case& /*one*/, const QuadraticAnswer<double>& exact) {
  switch (exact.kind) {
    case RootKind::two:
      return {"two"};
    case RootKind::twice:
      return {"double"};
    case RootKind::none:
      return {"none"};
    case RootKind::linear:
      return {"linear"};
    case RootKind::constant:
      return {"constant"};
    case RootKind::everything:
      return {"everything"};
  }
  return {};
}

std::vector<std::string> labels_of(const Case& /*one*/, Position exact) {
  switch (exact) {
    case Position::outside:
      return {"outside"};
    case Position::boundary:
      return {"boundary"};
    case Position::inside:
      return {"inside"};
  }
  return {};
}

}  // namespace

std::vector<std::string> labels_of(const Case& one) {
  const Answer exact = oracle::answer(one);
  std::vector<std::string> labels =
      std::visit([&](const auto& answer) { return labels_of(one, answer); }, exact);
  const oracle::Judgement judgement = oracle::judge(one, exact);
  const Domain domain;
  const int reach = one.precision == Precision::float32 ? domain.reach_float : domain.reach_double;
  if (judgement.smallest >= -reach && judgement.largest <= reach) labels.emplace_back("in reach");
  return labels;
}

double LabelCount::share(const std::string& label) const {
  const auto found = counts.find(label);
  return found == counts.end() || cases == 0 ? 0 : static_cast<double>(found->second) / cases;
}

std::vector<std::string> LabelCount::missed() const {
  std::vector<std::string> sentences;
  if (cases < label_sample) return sentences;
  for (const MinimumShare& minimum : family->shares)
    if (share(minimum.label) < minimum.share)
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

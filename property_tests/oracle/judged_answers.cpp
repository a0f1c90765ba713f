#include "oracle/judged_answers.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace rayproof::oracle {

namespace {

/// As bits: NaN is the same as itself, and -0 is not 0.
bool are_same(std::span<const double> a, std::span<const double> b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return std::ranges::equal(a, b, {}, bits, bits);
}

/// Whether two answers get the same judgement: nothing of the first hit but its t is part of that.
bool is_judged_alike(const RayAnswer& a, const RayAnswer& b) {
  return a.nearest_only == b.nearest_only && a.verdict_only == b.verdict_only &&
         are_same(a.hits.view(), b.hits.view());
}
bool is_judged_alike(const QuadraticAnswer<double>& a, const QuadraticAnswer<double>& b) {
  const auto roots = [](const auto& answer) { return std::span(answer.roots).first(answer.count); };
  return a.kind == b.kind && are_same(roots(a), roots(b));
}
bool is_judged_alike(Position a, Position b) { return a == b; }

}  // namespace

const Judgement* JudgedAnswers::find(const Answer& claimed) const {
  const auto is_alike = [&](const auto& judged) {
    return std::visit(
        [&](const auto& answer) {
          const auto* other = std::get_if<std::decay_t<decltype(answer)>>(&judged.first);
          return other != nullptr && is_judged_alike(answer, *other);
        },
        claimed);
  };
  const auto found = std::ranges::find_if(judged_, is_alike);
  return found == judged_.end() ? nullptr : &found->second;
}

Judgement JudgedAnswers::judge(const Case& one, const Answer& claimed) {
  if (const Judgement* known = find(claimed)) return *known;
  const Judgement judgement = oracle::judge(one, claimed);
  add(claimed, judgement);
  return judgement;
}

}  // namespace rayproof::oracle

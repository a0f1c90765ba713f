#include "subjects/default_contract.hpp"

#include <array>
#include <rayproof/topics.hpp>
#include <stdexcept>

namespace rayproof {
namespace {

/// How much wider than the bound of our own methods: others normalise the direction, invert a matrix,
/// multiply by a reciprocal.
constexpr double widened = 4;

/// Where the textbook's bounds are not the topic's robust bound, and where its domain is not the usual one.
struct TextbookBounds {
  std::string_view topic;
  double robust_bounds;  ///< the bound, in the topic's robust bounds
  int verdict_power;     ///< how both grow with `far`
  int residual_power;
  Domain domain;
};
constexpr std::array textbook{
    // b² and 4ac of a far sphere lose digits with its distance in radii.
    TextbookBounds{"sphere", 1, 1, 1, {.reach_float = 26}},
    TextbookBounds{"cylinder", 2, 1, 1, {.reach_float = 12, .reach_double = 110}},
    // The determinant is small beside its rounding where a triangle is thin, or seen edge-on.
    TextbookBounds{"triangle", 1, 1, 0, {}},
    TextbookBounds{"parallelepiped", 1, 1, 1, {.reach_float = 16, .reach_double = 150}},
};

constexpr Claims expected{Claim::verdict, Claim::residual,    Claim::ascending, Claim::moved,
                          Claim::scaled,  Claim::reversed,    Claim::contact,   Claim::point,
                          Claim::normal,  Claim::coordinates, Claim::exact,     Claim::answers};

}  // namespace

Contract default_contract(const std::string& topic) {
  double robust = 0;
  Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
    if (topic == Topic::name) robust = Topic::robust_bound;
  });
  if (robust == 0) throw std::logic_error("there is no topic " + topic);
  TextbookBounds bounds{topic, 1, 0, 0, {}};
  for (const TextbookBounds& own : textbook)
    if (own.topic == topic) bounds = own;
  const double promised = widened * bounds.robust_bounds * robust;
  Contract contract;
  contract.verdict = {.promised = promised, .far_power = bounds.verdict_power};
  contract.residual = {.promised = promised, .far_power = bounds.residual_power};
  contract.hit = {.point = {.promised = widened * 2},
                  .normal = {.promised = widened * 4},
                  .coordinates = {.promised = widened * 4}};
  contract.domain = bounds.domain;
  contract.holds = expected;
  return contract;
}

bool loses_digits_from_afar(std::string_view topic) { return topic == "sphere" || topic == "cylinder"; }

}  // namespace rayproof

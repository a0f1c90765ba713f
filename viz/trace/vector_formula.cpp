#include <array>

#include "viz/trace/expression.hpp"

namespace rayproof::viz {
namespace {

using Kind = Expression::Kind;

constexpr std::array<char, 3> axis_letters{'x', 'y', 'z'};

/// The names of the three components of one vector, as its name; null where they are no such three.
Formula merged_name(const std::vector<Formula>& components) {
  std::string vector;
  std::vector<double> values;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::string of_this = vector_of(components[i]->text, axis_letters.at(i));
    if (of_this.empty() || (i > 0 && of_this != vector)) return nullptr;
    vector = of_this;
    values.insert(values.end(), components[i]->values.begin(), components[i]->values.end());
  }
  return named_formula(vector, values);
}

/// The formulas as one, each name's components as the vector; null where they differ in more than the axis.
Formula merged(const std::vector<Formula>& components) {
  const Expression& first = *components[0];
  if (first.kind == Kind::name) {
    if (Formula vector = merged_name(components)) return vector;
  }
  for (const Formula& other : components) {
    const bool is_same = other->kind == first.kind && other->text == first.text &&
                         other->signs == first.signs && other->parts.size() == first.parts.size();
    if (!is_same) return nullptr;
  }
  if (first.kind == Kind::name) return components[0];
  Expression whole = first;
  for (std::size_t part = 0; part < first.parts.size(); ++part) {
    std::vector<Formula> parts;
    for (const Formula& component : components) parts.push_back(component->parts[part]);
    whole.parts[part] = merged(parts);
    if (whole.parts[part] == nullptr) return nullptr;
  }
  return std::make_shared<const Expression>(std::move(whole));
}

/// The same; null, too, where no name has an axis.
Formula common_vector(const std::vector<Formula>& components) {
  const Formula vector = merged(components);
  return vector != nullptr && text_of(vector) != text_of(components[0]) ? vector : nullptr;
}

/// The factor of a term of each component, beginning with that of the `first` component, so that its axes
/// are x, y and z; null where they aren't.
Formula factor(const std::vector<Formula>& components, std::size_t term, std::size_t side,
               std::size_t first) {
  std::vector<Formula> factors;
  for (std::size_t i = 0; i < 3; ++i) {
    const Formula& sum = components[(first + i) % 3];
    if (sum->kind != Kind::sum || sum->parts.size() != 2 || sum->signs != std::vector<std::string>{"", "−"})
      return nullptr;
    const Formula& product = sum->parts[term];
    if (product->kind != Kind::product) return nullptr;
    factors.push_back(product->parts[side]);
  }
  return common_vector(factors);
}

/// "a × b" of "a.y·b.z − a.z·b.y" and so on.
Formula cross_product(const std::vector<Formula>& components) {
  if (components.size() != 3) return nullptr;
  const Formula a = factor(components, 0, 0, 2), b = factor(components, 0, 1, 1);
  const Formula other_a = factor(components, 1, 0, 1), other_b = factor(components, 1, 1, 2);
  const bool is_cross =
      a != nullptr && b != nullptr && text_of(a) == text_of(other_a) && text_of(b) == text_of(other_b);
  return is_cross ? make(Kind::cross, {a, b}) : nullptr;
}

}  // namespace

Formula vector_formula(const std::vector<Formula>& components) {
  if (components.size() < 2) return nullptr;
  for (const Formula& component : components)
    if (component == nullptr) return nullptr;
  const Formula plain = common_vector(components);
  return plain != nullptr ? plain : cross_product(components);
}

Formula dot_or(const Formula& formula) {
  if (formula->kind != Kind::sum || formula->parts.size() != 3 ||
      formula->signs != std::vector<std::string>{"", "+", "+"})
    return formula;
  std::vector<Formula> vectors;
  for (std::size_t side = 0; side < 2; ++side) {
    std::vector<Formula> factors;
    for (const Formula& product : formula->parts) {
      // |n| of a vector's components would read as its length.
      if (product->kind != Kind::product || product->parts[side]->kind == Kind::absolute) return formula;
      factors.push_back(product->parts[side]);
    }
    vectors.push_back(common_vector(factors));
    if (vectors.back() == nullptr) return formula;
  }
  return make(Kind::dot, vectors);
}

}  // namespace rayproof::viz

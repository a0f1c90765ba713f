#include "oracle/judge/flat_judge.hpp"

namespace rayproof::oracle {

std::vector<ExactNumber> FlatFigure::hits() const {
  if (meeting_.is_parallel()) return {};
  const Quotient t = meeting_.t();
  if (!is_in_interval(t, question_.ray) || !holds_meeting()) return {};
  return {t};
}

Scaled FlatFigure::residual(double t) const {
  return ratio(abs(approximate(meeting_.slope * Ring(t) - meeting_.gap)), size_ * reach(Scaled(t)));
}

Scaled FlatFigure::margin() const {
  const std::vector<double> ends = finite_ends(question_.ray);
  Scaled nearest = ends.size() < 2 ? steepness() : endless();
  for (const double end : ends) reduce(nearest, residual(end));
  return nearest;
}

}  // namespace rayproof::oracle

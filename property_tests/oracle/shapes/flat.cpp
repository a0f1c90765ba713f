#include "oracle/shapes/flat.hpp"

namespace rayproof::oracle {

std::vector<ExactContact> FlatIntersection::hits() const {
  if (is_parallel()) return {};
  const Quotient at = t();
  if (!is_in_interval(at, question().ray)) return {};
  const Contact contact = contact_at(at);
  if (contact == Contact::none) return {};
  return {{at, contact}};
}

Contact FlatIntersection::miss() const {
  if (!is_parallel()) return Contact::none;
  if (sign(normal_.x) == 0 && sign(normal_.y) == 0 && sign(normal_.z) == 0) return Contact::degenerate;
  return sign(gap_) == 0 ? Contact::in_surface : Contact::parallel;
}

Scaled FlatIntersection::residual(double t) const {
  return ratio(abs(approximate(slope_ * Ring(t) - gap_)), sizes().unit(0, Scaled(t)));
}

Scaled FlatIntersection::margin() const {
  const std::vector<double> ends = finite_ends(question().ray);
  Scaled nearest = ends.size() < 2 ? steepness() : endless();
  for (const double end : ends) reduce(nearest, residual(end));
  return nearest;
}

}  // namespace rayproof::oracle

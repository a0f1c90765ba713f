#include "properties/worst/error_measure.hpp"

#include "properties/engine/plan.hpp"

namespace rayproof::worst {

ErrorList errors_of(const Subject& subject, const Case& one, bool with_details) {
  ErrorList errors{};
  Trial trial(subject, one);
  if (with_details && trial.in_domain()) (void)trial.details();
  Worst measured;
  measured.add(trial);
  const std::size_t first = is_transformed(one) ? error_measures.size() : 0;
  for (std::size_t i = 0; i < error_measures.size(); ++i) {
    const double error = measured.*error_measures[i].value;
    errors.at(first + i) = error > 0 ? error : 0;  // a NaN is no error
  }
  return errors;
}

bool exceeds_promise(const Subject& subject, const Case& one, std::size_t kind) {
  const Property& property = *find_property(measure_of(kind).name);
  if (!claims(subject, property)) return false;
  Trial trial(subject, one);
  return ruling_of(property, trial) == Ruling::broken;
}

}  // namespace rayproof::worst

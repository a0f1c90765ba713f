#include "bench/figures/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bench/figures/row.hpp"
#include "case/reader/near_names.hpp"
#include "subjects/subject.hpp"

namespace rayproof::report {

namespace {

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::ranges::find(list, name) != list.end();
}

bool passes(const std::vector<std::string>& filter, const std::string& name) {
  return filter.empty() || contains(filter, name);
}

/// Refuses a name on the command line that is not among those there are.
void demand(const char* option, const std::vector<std::string>& names,
            const std::vector<std::string>& known) {
  for (const std::string& name : names) {
    if (!contains(known, name))
      throw UnknownFilterName(
          fmt::format("{}: there is no '{}'{}", option, name, names_instead(name, known)));
  }
}

void add_once(std::vector<std::string>& list, const std::string& name) {
  if (!contains(list, name)) list.push_back(name);
}

}  // namespace

bool BenchOptions::wants_shape(const std::string& shape) const { return passes(shapes, shape); }

bool BenchOptions::wants_family(const Family& family) const {
  return wants_shape(family.topic) && passes(families, family.name);
}

bool BenchOptions::wants_method(const std::string& shape, const std::string& method) const {
  return passes(methods, method) || contains(methods, shape + "/" + method);
}

bool BenchOptions::wants_scaling(const std::string& curve) const {
  return scaling.empty() ? !has_filter() : contains(scaling, curve);
}

std::vector<Precision> BenchOptions::wanted_precisions() const {
  std::vector<Precision> wanted;
  for (const Precision precision : {Precision::float32, Precision::float64}) {
    if (passes(precisions, name_of(precision))) wanted.push_back(precision);
  }
  return wanted;
}

namespace {

/// Refuses methods and families that exclude each other: a method on no family that is asked for, a family
/// without a method. What other libraries can be asked is known once they were.
void demand_common_shapes(const BenchOptions& options) {
  if (options.methods.empty() || options.families.empty()) return;
  const auto has = [](const BenchOptions& narrow) {
    for (const Family& family : families())
      for (const Subject& subject : subjects())
        if (subject.topic == family.topic && narrow.wants_family(family) &&
            narrow.wants_method(subject.topic, subject.name))
          return true;
    return false;
  };
  const bool asks_peers =
      std::ranges::any_of(peer_names, [&](const char* peer) { return contains(options.methods, peer); });
  for (const std::string& method : options.methods) {
    BenchOptions narrow = options;
    narrow.methods = {method};
    if (!contains({peer_names.begin(), peer_names.end()}, method) && !has(narrow))
      throw UnknownFilterName(
          fmt::format("--method {} answers no case of --family {}: there is nothing to measure", method,
                      fmt::join(options.families, ",")));
  }
  for (const std::string& family : options.families) {
    BenchOptions narrow = options;
    narrow.families = {family};
    if (!asks_peers && !has(narrow))
      throw UnknownFilterName(
          fmt::format("--family {} has no case for --method {}: there is nothing to measure", family,
                      fmt::join(options.methods, ",")));
  }
}

}  // namespace

void validate(const BenchOptions& options) {
  std::vector<std::string> shapes;
  std::vector<std::string> names;
  for (const Family& family : families()) {
    add_once(shapes, family.topic);
    if (options.wants_shape(family.topic)) add_once(names, family.name);
  }
  demand("--shape", options.shapes, shapes);
  demand("--family", options.families, names);
  demand("--scaling", options.scaling, {scaling_names.begin(), scaling_names.end()});

  std::vector<std::string> methods;
  for (const Subject& subject : subjects()) {
    if (!options.wants_shape(subject.topic)) continue;
    add_once(methods, subject.name);
    add_once(methods, subject.full_name());
  }
  for (const char* const peer : peer_names) add_once(methods, peer);
  demand("--method", options.methods, methods);
  demand_common_shapes(options);
}

}  // namespace rayproof::report

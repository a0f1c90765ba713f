#include "programs/check/guests.hpp"

#include <algorithm>
#include <iterator>

#include "command_line/interrupt.hpp"
#include "programs/check/peers.hpp"
#include "subjects/command.hpp"

namespace rayproof::check {

std::vector<Subject> subjects_of(const Options& options) {
  const std::chrono::milliseconds case_time(static_cast<std::int64_t>(1000 * options.case_seconds));
  std::vector<Subject> all;
  const auto add = [&](const std::string& name, const std::string& command) {
    std::ranges::move(subjects_of_command(name, command, case_time, &is_interrupted),
                      std::back_inserter(all));
  };
  if (!options.command.empty()) add(command_name, options.command);
  for (const Peer& peer : peers_called(options.subjects)) add(peer.name, peer.command);
  const Plan wanted = make_plan(options.settings, all);  // refuses what is unknown
  std::erase_if(all, [&](const Subject& one) {
    return std::ranges::none_of(wanted.subjects, [&](const Subject* kept) { return kept == &one; });
  });
  return all;
}

std::vector<Failure> learn_all(std::vector<Subject>& guests, const Settings& settings,
                               const std::function<void(double)>& progress) {
  std::vector<Precision> precisions = settings.precisions;
  if (precisions.empty()) precisions = {Precision::float32, Precision::float64};
  std::vector<Failure> failures;
  double done = 0;
  for (Subject& guest : guests) {
    progress(done++ / static_cast<double>(guests.size()));
    for (Failure& failure : learn_abilities(guest, settings.seed, precisions, is_interrupted))
      failures.push_back(std::move(failure));
  }
  return failures;
}

}  // namespace rayproof::check

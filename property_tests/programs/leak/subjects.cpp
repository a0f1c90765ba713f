#include "programs/leak/subjects.hpp"

#include <stdexcept>

#include "case/reader/near_names.hpp"
#include "command_line/interrupt.hpp"
#include "programs/check/peers.hpp"

namespace rayproof::leaks {

namespace {

/// The one subject of triangles that a command makes.
std::unique_ptr<Subject> triangles_of(const std::string& name, const std::string& command,
                                      std::chrono::milliseconds case_time) {
  for (Subject& subject : subjects_of_command(name, command, case_time, &is_interrupted))
    if (subject.topic == "triangle") return std::make_unique<Subject>(std::move(subject));
  throw std::logic_error("there is no topic of triangles");
}

/// Why a name is none of a method of triangles.
std::runtime_error no_method(const std::string& name) {
  std::vector<std::string> names;
  for (const Subject& subject : subjects())
    if (subject.topic == "triangle") names.push_back(subject.name);
  return std::runtime_error("there is no method \"" + name + "\" of triangles" + names_instead(name, names));
}

}  // namespace

SubjectPanel panel_of(const LeakOptions& options) {
  SubjectPanel panel;
  for (const Subject& subject : subjects())
    if (options.methods.empty() && !options.has_guests() && subject.topic == "triangle" &&
        subject.contract.standing != Standing::printed)
      panel.all.push_back(&subject);
  for (const std::string& name : options.methods) {
    const Subject* subject = find_subject(name.starts_with("triangle/") ? name : "triangle/" + name);
    if (subject == nullptr) throw no_method(name);
    panel.all.push_back(subject);
  }
  const std::chrono::milliseconds case_time(static_cast<std::int64_t>(1000 * options.case_seconds));
  const auto add = [&](const std::string& name, const std::string& command) {
    panel.guests.push_back(triangles_of(name, command, case_time));
    panel.all.push_back(panel.guests.back().get());
  };
  if (!options.command.empty()) add(command_name, options.command);
  for (const check::Peer& peer : check::peers_called(options.subjects)) add(peer.name, peer.command);
  return panel;
}

}  // namespace rayproof::leaks

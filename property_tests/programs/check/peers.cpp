#include "programs/check/peers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "case/reader/near_names.hpp"
#include "properties/engine/plan.hpp"

namespace rayproof::check {

std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? "'\\''" : std::string(1, c);
  return safe + "'";
}

namespace {

constexpr const char* all_peers = "peers";

/// Where this program and its like lie.
std::filesystem::path programs_folder() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

/// A line of the registry: the peer, and whether its program is there.
struct Entry {
  Peer peer;
  bool is_built;
};

std::vector<Entry> entries() {
  const std::filesystem::path folder = programs_folder();
  std::vector<Entry> all;
  std::istringstream registry(peer_registry());
  for (std::string line; std::getline(registry, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string name, program, arguments;
    words >> name >> program;
    std::getline(words, arguments);
    const std::filesystem::path path = folder / program;
    all.push_back({{name, quoted(path.string()) + arguments}, std::filesystem::exists(path)});
  }
  return all;
}

/// Why a name calls nobody.
UnknownName nobody_called(const std::string& name, const std::vector<Entry>& known) {
  const auto is_called = [&](const Entry& entry) { return name == all_peers || name == entry.peer.name; };
  if (std::ranges::any_of(known, is_called))
    return UnknownName(fmt::format(
        "--subject {0}: it is not built; in a checkout, ./rayproof check --subject {0} builds it", name));
  std::vector<std::string> names{all_peers};
  for (const Entry& entry : known) names.push_back(entry.peer.name);
  return UnknownName(fmt::format("there is no subject \"{}\"{}", name, names_instead(name, names)));
}

}  // namespace

bool is_no_peer(const std::string& name) {
  return std::ranges::none_of(entries(), [&](const Entry& entry) { return entry.peer.name == name; });
}

std::vector<Peer> peers_called(const std::vector<std::string>& names) {
  const std::vector<Entry> known = entries();
  std::vector<Peer> called;
  for (const std::string& name : names) {
    const std::size_t before = called.size();
    for (const Entry& entry : known)
      if (entry.is_built && (name == all_peers || name == entry.peer.name)) called.push_back(entry.peer);
    if (called.size() == before) throw nobody_called(name, known);
  }
  return called;
}

}  // namespace rayproof::check

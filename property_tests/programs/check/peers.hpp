#pragma once
/// \file
/// Other people's libraries by their names: the registry of the programs under property_tests/peers.

#include <string>
#include <vector>

namespace rayproof::check {

/// One library on trial: the name of --subject, and the shell line that starts its program.
struct Peer {
  std::string name;
  std::string command;
};

/// A text as one word of a shell line.
[[nodiscard]] std::string quoted(const std::string& text);

/// The text of the registry, a line for each peer: its name, its program, the program's arguments.
[[nodiscard]] std::string peer_registry();

/// Whether the registry has no peer of this name.
[[nodiscard]] bool is_no_peer(const std::string& name);

/// The peers of these names; `peers` stands for all whose programs lie beside this one. Throws UnknownName
/// for a name that the registry lacks, and for one whose program is not built.
[[nodiscard]] std::vector<Peer> peers_called(const std::vector<std::string>& names);

}  // namespace rayproof::check

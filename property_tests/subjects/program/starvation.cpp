#include "subjects/program/starvation.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace rayproof::program {

namespace {

/// What Linux says of the processes of a group.
struct GroupState {
  bool is_ready = false;
  bool waits_for_disk = false;
  double used = 0;
};

/// Adds a process, from its /proc/N/stat: number (name) state parent group … with utime and stime as the 14th
/// and 15th.
void add(GroupState& state, const std::filesystem::path& stat, pid_t group) {
  std::string text;
  std::getline(std::ifstream(stat), text);
  const std::size_t name_end = text.rfind(')');
  if (name_end == std::string::npos) return;
  std::istringstream fields(text.substr(name_end + 1));
  std::string letter, skipped;
  long parent = 0, own_group = 0, user = 0, system = 0;
  fields >> letter >> parent >> own_group;
  if (own_group != group) return;
  for (int k = 6; k <= 13; ++k) fields >> skipped;
  fields >> user >> system;
  state.is_ready |= letter == "R";
  state.waits_for_disk |= letter == "D";
  state.used += static_cast<double>(user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

GroupState state_of(pid_t group) {
  GroupState state;
  std::error_code error;
  for (std::filesystem::directory_iterator one("/proc", error), end; !error && one != end;
       one.increment(error)) {
    const std::string name = one->path().filename().string();
    if (name.find_first_not_of("0123456789") == std::string::npos) add(state, one->path() / "stat", group);
  }
  return state;
}

}  // namespace

bool Starvation::is_idle() {
  const GroupState now = state_of(group_);
  const bool is_idle = !now.is_ready && !now.waits_for_disk && now.used <= used_idle_;
  used_idle_ = now.used;
  return is_idle;
}

bool Starvation::goes_on() {
  const GroupState now = state_of(group_);
  const Clock::time_point time = Clock::now();
  const double share = (now.used - used_) / std::chrono::duration<double>(time - last_).count();
  const bool is_starved = now.is_ready && (!was_asked_ || share < 0.5);
  was_asked_ = true;
  last_ = time;
  used_ = now.used;
  return is_starved;
}

}  // namespace rayproof::program

/// \file
/// rayproof render: draws a scene by float methods or exactly, and where the two differ.

#include <atomic>
#include <csignal>

#include "case/shape_format.hpp"
#include "viz/programs/render/run.hpp"

namespace {

using namespace rayproof;
using namespace rayproof::render;

std::atomic<bool> is_interrupted{false};

/// The first Ctrl-C lets the tiles under way end and leaves no file; a second one ends the program at once.
void interrupt(int signal) {
  is_interrupted = true;
  std::signal(signal, SIG_DFL);
}

int report(const std::exception& why, int status) {
  fmt::print(stderr, "rayproof render: {}\n", why.what());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Draws a scene: by float methods, exactly, or where the two differ.", "rayproof render");
  Options options;
  options.add_to(app);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  std::signal(SIGINT, interrupt);
  try {
    run(options, is_interrupted);
    return 0;
  } catch (const Stopped&) {
    return 130;
  } catch (const Refusal& refused) {
    return report(refused, 1);
  } catch (const std::runtime_error& mistake) {
    return report(mistake, 2);
  } catch (const std::bad_alloc&) {
    return report(std::runtime_error(options.scene + " is too large for this machine's memory"), 2);
  }
}

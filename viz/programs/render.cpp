/// \file
/// rayproof render: draws a scene by float methods or exactly, and where the two differ.

#include "command_line/interrupt.hpp"
#include "viz/programs/render/options.hpp"

int main(int argc, char** argv) {
  rayproof::CommandLine app("Draws a scene: by float methods, exactly, or where the two differ.",
                            "rayproof render");
  rayproof::render::RenderOptions options;
  options.add_to(app);
  if (const auto status = rayproof::parse_command_line(app, argc, argv)) return *status;
  rayproof::keep_on_interrupt();  // the tiles under way end, and no file is left
  try {
    return rayproof::viz::run_and_report("rayproof render", [&] { run(options, rayproof::is_interrupted); });
  } catch (const rayproof::render::Stopped&) {
    return 130;
  } catch (const std::bad_alloc&) {
    rayproof::print_to_stderr("rayproof render: {} is too large for this machine's memory\n", options.scene);
    return 2;
  }
}

/// \file
/// rayproof render: draws a scene by float methods or exactly, and where the two differ.

#include "case/shape_format.hpp"
#include "command_line/interrupt.hpp"
#include "viz/programs/render/run.hpp"

namespace {

using namespace rayproof;
using namespace rayproof::render;

int report(const std::exception& why, int status) {
  fmt::print(stderr, "rayproof render: {}\n", why.what());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Draws a scene: by float methods, exactly, or where the two differ.", "rayproof render");
  RenderOptions options;
  options.add_to(app);
  if (const auto status = parse_command_line(app, argc, argv)) return *status;
  keep_on_interrupt();  // the tiles under way end, and no file is left
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

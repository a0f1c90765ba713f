#include "viz/programs/walk/window.hpp"

#include <stdexcept>

#ifdef RAYPROOF_HAS_VTK
#include "viz/programs/plays_of.hpp"
#include "viz/vtk/window/stage_window.hpp"
#include "viz/vtk/x_display.hpp"
#endif

namespace rayproof::viz {

#ifdef RAYPROOF_HAS_VTK
void show_window(const std::optional<Stage>& one, const std::string& topic) {
  const UserDisplay display;
  Player player(one ? plays_of(*one) : plays_of(topic));
  StageWindow window(player);
  window.run();
}
#else
void show_window(const std::optional<Stage>& /*one*/, const std::string& /*topic*/) {
  throw std::runtime_error("--window needs VTK, which this build was made without; --html works");
}
#endif

}  // namespace rayproof::viz

#include "viz/programs/walk/movie.hpp"

#ifdef RAYPROOF_HAS_VTK
#include "command_line/interrupt.hpp"
#include "viz/programs/partial_file.hpp"
#include "viz/scene/film.hpp"
#include "viz/vtk/movie.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/slide_canvas.hpp"
#endif

namespace rayproof::viz {

#ifdef RAYPROOF_HAS_VTK
void write_movie(const std::vector<Walk>& walks, const std::string& path, ProgressLine& progress) {
  if (!path.ends_with(".ogv")) throw WrongCommand("--movie writes Ogg video: " + path + " must end in .ogv");
  keep_on_interrupt();  // the picture under way is drawn, and no file is left
  PartialFile file(path);
  std::size_t all = 0;
  for (const Walk& walk : walks) all += shots_of(walk.stage).size();
  std::size_t done = 0;
  {
    const OffscreenDisplay display;
    SlideCanvas canvas(1280);
    Movie movie(file.path(), film_rate);
    for (const auto& [group, stage] : walks) {
      for (const Shot& shot : shots_of(stage)) {
        if (is_interrupted) return;
        progress.show(share(done++, all), fmt::format("film of {}, step {}", stage.name, shot.step + 1));
        movie.add(canvas.draw(stage_at(stage, shot), shot.step, shot.count > 1), shot.count);
      }
    }
  }
  file.keep();
}
#else
void write_movie(const std::vector<Walk>& /*walks*/, const std::string& path, ProgressLine& /*progress*/) {
  throw WrongCommand("--movie " + path + " needs VTK, which this build was made without; --html works");
}
#endif

}  // namespace rayproof::viz

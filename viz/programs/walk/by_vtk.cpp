/// \file
/// What `rayproof walk` shows by VTK.
#include "command_line/interrupt.hpp"
#include "viz/programs/files.hpp"
#include "viz/programs/plays_of.hpp"
#include "viz/programs/walk/walks.hpp"
#include "viz/scene/film.hpp"

#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/raster_png.hpp"
#include "viz/vtk/slide_canvas.hpp"
#include "viz/vtk/window/stage_window.hpp"
#endif

namespace rayproof::viz {

#ifdef RAYPROOF_HAS_VTK
void write_pngs(const std::vector<Walk>& walks, const std::string& folder, ProgressLine& progress) {
  if (folder.ends_with(".png"))
    throw WrongCommand("--png writes a picture for each step into a folder: " + folder +
                       " names one picture");
  keep_on_interrupt();  // the picture under way is drawn
  const OffscreenDisplay display;
  SlideCanvas canvas;
  make_folder(folder);
  std::size_t all = 0;
  for (const Walk& walk : walks) all += walk.stage.steps.size();
  std::size_t done = 0;
  const auto path = [&](const std::string& name) { return fmt::format("{}/{}.png", folder, name); };
  for (const auto& [group, stage] : walks) {
    std::vector<Raster> slides;
    for (std::size_t i = 0; i < stage.steps.size(); ++i) {
      if (is_interrupted) {
        progress.clear();
        return print_to_stderr("rayproof walk: interrupted: {} of {} pictures are written\n", done, all);
      }
      const std::string name = fmt::format("{}-{}", stage.name, i + 1);
      progress.show(share(done++, all), fmt::format("picture {}.png", name));
      slides.push_back(canvas.draw(stage, i));
      write_png(slides.back(), path(name));
    }
    write_png(contact_sheet(slides), path(stage.name));
  }
}

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
        if (is_interrupted) {
          progress.clear();
          return print_to_stderr("rayproof walk: interrupted: no film is left\n");
        }
        progress.show(share(done++, all), fmt::format("film of {}, step {}", stage.name, shot.step + 1));
        movie.add(canvas.draw(stage_at(stage, shot), shot.step, shot.count > 1), shot.count);
      }
    }
  }
  file.keep();
}

void show_window(const std::optional<Stage>& one, const std::string& topic) {
  const UserDisplay display;
  Player player(one ? plays_of(*one) : plays_of(topic));
  StageWindow window(player);
  window.run();
}
#else
void write_pngs(const std::vector<Walk>& /*walks*/, const std::string& folder, ProgressLine& /*progress*/) {
  throw WrongCommand("--png " + folder + " needs VTK, which this build was made without; --html works");
}

void write_movie(const std::vector<Walk>& /*walks*/, const std::string& path, ProgressLine& /*progress*/) {
  throw WrongCommand("--movie " + path + " needs VTK, which this build was made without; --html works");
}

void show_window(const std::optional<Stage>& /*one*/, const std::string& /*topic*/) {
  throw std::runtime_error("--window needs VTK, which this build was made without; --html works");
}
#endif

}  // namespace rayproof::viz

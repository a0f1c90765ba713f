#include <fmt/format.h>

#include <array>
#include <rayproof/sphere/centred.hpp>
#include <rayproof/sphere/textbook.hpp>

#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"
#include "viz/walkthrough/stage_of.hpp"

namespace rayproof::viz {
namespace {

constexpr int columns = 10;
constexpr int rows = 10;
constexpr Sphere<double> ball{{0, 0, 0}, 1};

/// From so far along z through the pixel's centre, on a frame a little larger than the sphere; its numbers
/// are floats.
Ray<double> ray_through(int i, int j, double distance) {
  const auto at = [](int k, int count) { return 1.2 * (2 * (k + 0.5) / count - 1); };
  const glm::vec3 direction{at(i, columns) / distance, at(j, rows) / distance, 1};
  return {{0, 0, -distance}, glm::dvec3(direction)};
}

template <class Method, class T>
bool is_hit(const Ray<double>& ray) {
  return T(0) <= Method::roots(convert<T>(ray), convert<T>(ball)).discriminant;
}

/// A method's verdicts on all pixels.
struct MapPanel {
  const char* name;
  bool (*hits)(const Ray<double>& ray);
};
constexpr std::array<MapPanel, 3> panels{{{"textbook, float", is_hit<sphere::Textbook, float>},
                                          {"centred, float", is_hit<sphere::Centred, float>},
                                          {"textbook, double", is_hit<sphere::Textbook, double>}}};

/// A pixel's corner; `left` is the panel's.
glm::dvec3 corner(double left, int i, int j) {
  constexpr double size = 0.78;
  return {left + size * i / columns, -size / 2 + size * j / rows, 0};
}

constexpr double left_of(std::size_t panel) { return -1.26 + 0.87 * static_cast<double>(panel); }

/// The frames of all panels and their names.
Items frames() {
  Items items;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const auto at = [&](int i, int j) { return corner(left_of(k), i, j); };
    items.push_back(
        polyline(Role::frame, {at(0, 0), at(columns, 0), at(columns, rows), at(0, rows), at(0, 0)}));
    items.push_back(point(Role::text, at(columns / 2, rows) + glm::dvec3(0, 0.07, 0), panels.at(k).name));
  }
  return items;
}

/// One panel's pixels: what is hit, and what is judged wrongly.
std::size_t add_panel(Items& items, const MapPanel& panel, double left, double distance) {
  std::size_t wrong = 0;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const Ray<double> ray = ray_through(i, j, distance);
      const bool computed = panel.hits(ray);
      const bool is_wrong = computed != is_hit<sphere::Centred, Shadow>(ray);
      wrong += is_wrong ? 1 : 0;
      if (!computed && !is_wrong) continue;
      const std::vector<glm::dvec3> cell{corner(left, i, j), corner(left, i + 1, j),
                                         corner(left, i + 1, j + 1), corner(left, i, j + 1)};
      items.push_back(polygon(is_wrong ? Role::claimed : Role::surface, cell));
      // A cross in it: the colour is not all there is to see.
      if (is_wrong) {
        items.push_back(segment(Role::claimed, cell[0], cell[2]));
        items.push_back(segment(Role::claimed, cell[1], cell[3]));
      }
    }
  }
  return wrong;
}

StageStep map_step(double distance) {
  StageStep step{.title = fmt::format("From {} radii away", distance),
                 .words = "Filled pixels are hits, crossed ones wrong verdicts.",
                 .view = {{0, 0, 0}, 0.82},
                 .begins_anew = true};
  std::string counts;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const std::size_t wrong = add_panel(step.items, panels.at(k), left_of(k), distance);
    counts += fmt::format("{}{} {}", counts.empty() ? "" : "; ", panels.at(k).name, wrong);
  }
  step.caption = fmt::format("{} Wrong of {} pixels: {}.", step.words, columns * rows, counts);
  return step;
}

}  // namespace

/// The same image of a sphere by three methods, from ever farther away.
Stage map_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "sphere/textbook");
  const Setting setting = plot_setting(report);
  Stage stage = stage_of(report);
  stage.scene = frames();
  stage.camera = setting.camera;
  stage.slider.reset();
  stage.steps.clear();
  for (const double distance : {10.0, 1500.0, 2500.0, 4000.0, 8000.0})
    stage.steps.push_back(map_step(distance));
  stage.method = "sphere/textbook and sphere/centred for each pixel";
  stage.conclusion =
      "The textbook's error grows with the distance squared, the centred formula's does not; how many pixels "
      "that spoils goes up and down.";
  stage.steps.back().digits = stage.conclusion;
  return stage;
}

}  // namespace rayproof::viz

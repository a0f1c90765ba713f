#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <rayproof/sphere/centred.hpp>
#include <rayproof/sphere/textbook.hpp>

#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

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

/// For each number of a run a bar of its digits: what is kept, and what is lost.
Stage digits_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "sphere/textbook");
  Setting setting = plot_setting();
  const double digits = one.precision == Precision::float32 ? 24 : 53;
  std::size_t rows = 0;
  for (const WalkStep& step : report.walk->steps) rows += step.values.size();
  rows = std::max(rows, report.walk->inputs.size());
  const double row_height = 1.3 / static_cast<double>(rows);
  const auto x = [&](double bits) { return -0.7 + 1.7 * bits / digits; };
  for (const double bits : {0.0, digits / 4, digits / 2, 3 * digits / 4, digits}) {
    setting.scene.push_back(segment(Role::frame, {x(bits), -0.7, 0}, {x(bits), 0.68, 0}));
    setting.scene.push_back(point(Role::text, {x(bits), -0.75, 0}, rough(bits) + " bits"));
  }
  Stage stage = composed_stage(report, *report.walk, setting);
  const auto add_bars = [&](StageStep& step, const std::vector<WalkValue>& values, std::size_t row) {
    for (const WalkValue& value : values) {
      const double y = 0.6 - row_height * static_cast<double>(row++);
      const double kept = std::max(0.0, digits - value.bits_lost);
      step.items.push_back(segment(Role::exact, {x(0), y, 0}, {x(kept), y, 0}));
      if (value.bits_lost >= 0.5)
        step.items.push_back(segment(Role::claimed, {x(kept), y, 0}, {x(digits), y, 0},
                                     value.bits_lost >= noteworthy ? "lost" : "", Pattern::dotted));
      step.items.push_back(point(Role::text, {x(0) - 0.1, y, 0}, value.name));
    }
    return row;
  };
  (void)add_bars(stage.steps.front(), report.walk->inputs, 0);
  stage.steps.at(1).begins_anew = true;
  std::size_t row = 0;
  for (std::size_t i = 0; i < report.walk->steps.size(); ++i) {
    row = add_bars(stage.steps.at(i + 1), report.walk->steps[i].values, row);
  }
  const NumbersByName n(*report.walk, report.walk->steps.size() - 1);
  if (std::abs(n.rounded("√D")) < 0.01 * std::abs(n.rounded("b")))
    stage.steps.back().digits = "√D is small beside b, so its error weighs little in t₀ and t₁.";
  stage.steps.push_back(difference_of_values(*report.walk, setting, one.precision));
  return stage;
}

/// The same image of a sphere by three methods, from ever farther away.
Stage map_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "sphere/textbook");
  Stage stage = stage_of(report);
  stage.scene = frames();
  stage.camera = plot_setting().camera;
  stage.slider.reset();
  stage.steps.clear();
  for (const double distance : {10.0, 1500.0, 2500.0, 4000.0, 8000.0})
    stage.steps.push_back(map_step(distance));
  stage.conclusion =
      "The textbook's error grows with the distance squared, the centred formula's does not; how many pixels "
      "that spoils goes up and down.";
  stage.steps.back().digits = stage.conclusion;
  return stage;
}

}  // namespace rayproof::viz

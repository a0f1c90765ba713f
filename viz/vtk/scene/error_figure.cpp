#include "viz/vtk/scene/error_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "viz/scene/colours.hpp"
#include "viz/vtk/picture_png.hpp"
#include "viz/vtk/raster_png.hpp"

namespace rayproof::render {
namespace {

using viz::Anchor;
using viz::Picture;
using viz::png_scale;
using viz::Raster;
using viz::Role;

// All lengths are in the picture's own pixels, png_scale device pixels each.
constexpr double margin = 20, gap = 24, row_height = 22, swatch_width = 34, swatch_height = 15;
constexpr double label_width = 300, count_width = 170;
/// Small images are magnified by a whole number, so that single pixels can be seen.
constexpr int least_panel = 420;
/// Device pixels that VTK draws at most.
constexpr int widest = 8192;

/// 1234567 as "1 234 567".
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, " ");
  return digits;
}

std::string ulps_in_words(double ulps) {
  if (ulps < 1e6) return fmt::format("{:.0f} ulp", ulps);
  return std::isinf(ulps) ? "infinite" : fmt::format("{:.1e} ulp", ulps);
}

/// Where things are put.
struct Layout {
  int zoom;  ///< device pixels for one of the image's
  double panel_width, panel_height, panels_top;
  double width;

  explicit Layout(const std::vector<ErrorPanel>& panels) {
    const int w = panels.front().errors.width, h = panels.front().errors.height;
    zoom = std::max(1, least_panel * png_scale / std::max(w, 1));
    panel_width = static_cast<double>(w * zoom) / png_scale;
    panel_height = static_cast<double>(h * zoom) / png_scale;
    panels_top = margin + 2 * row_height + 8;
    const auto count = static_cast<double>(panels.size());
    const double legend = swatch_width + 10 + label_width + count * count_width;
    width = 2 * margin + std::max(legend, count * panel_width + (count - 1) * gap);
  }

  [[nodiscard]] double panel_left(std::size_t i) const {
    return margin + static_cast<double>(i) * (panel_width + gap);
  }
  [[nodiscard]] double count_right(std::size_t i) const {
    return margin + swatch_width + 10 + label_width + static_cast<double>(i + 1) * count_width;
  }
};

Rgb colour_of(const ErrorImage& errors, std::size_t i, int device_x, int device_y) {
  const Verdict verdict = errors.verdicts[i];
  if (verdict == Verdict::miss) return background;
  if (verdict == Verdict::hit) return ulp_colours[step_of(errors.ulps[i])];
  const auto* style = std::find_if(verdict_styles.begin(), verdict_styles.end(),
                                   [&](const VerdictStyle& s) { return s.verdict == verdict; });
  return hatched(*style, device_x, device_y);
}

void paint_panel(Raster& canvas, const ErrorImage& errors, int zoom, int left, int top) {
  for (int y = 0; y < errors.height * zoom; ++y) {
    for (int x = 0; x < errors.width * zoom; ++x) {
      const auto i = static_cast<std::size_t>(y / zoom) * static_cast<std::size_t>(errors.width) +
                     static_cast<std::size_t>(x / zoom);
      canvas.at(left + x, top + y) = colour_of(errors, i, x, y);
    }
  }
}

/// Writes the legend's rows into a picture and notes where its swatches are to be painted.
class Legend {
 public:
  Legend(Picture& picture, const Layout& layout, const std::vector<ErrorPanel>& panels, double top)
      : picture_(picture), layout_(layout), panels_(panels), y_(top) {}

  void heading(const std::string& text, const std::vector<std::string>& columns = {}) {
    y_ += 8;
    write(Role::text, margin, text, Anchor::start, true);
    for (std::size_t i = 0; i < columns.size(); ++i)
      write(Role::text, layout_.count_right(i), columns[i], Anchor::end, true);
    y_ += row_height;
  }
  template <class CountOf>
  void row(const std::string& label, CountOf&& count_of) {
    write(Role::text, margin + swatch_width + 10, label, Anchor::start, false);
    for (std::size_t i = 0; i < panels_.size(); ++i)
      write(Role::text, layout_.count_right(i), count_of(panels_[i].errors.totals), Anchor::end, false);
    y_ += row_height;
  }
  /// The top of the swatch of the row that comes next.
  [[nodiscard]] double swatch_top() const { return y_ + (row_height - swatch_height) / 2; }
  [[nodiscard]] double bottom() const { return y_; }

 private:
  void write(Role role, double x, const std::string& text, Anchor anchor, bool bold) {
    picture_.elements.push_back(viz::Text{role, {x, y_ + row_height - 6}, text, anchor, 14, bold, false});
  }

  Picture& picture_;
  const Layout& layout_;
  const std::vector<ErrorPanel>& panels_;
  double y_;
};

/// A swatch to be painted once the picture is pixels.
struct Swatch {
  double top;
  std::function<Rgb(int, int)> colour;
};

std::vector<Swatch> write_legend(Legend& legend, bool is_compared) {
  std::vector<Swatch> swatches;
  legend.heading("Verdicts, pixels",
                 is_compared ? std::vector<std::string>{"left", "right"} : std::vector<std::string>{});
  legend.row("all pixels", [](const Totals& t) { return grouped(t.pixels); });
  legend.row("exact hits", [](const Totals& t) { return grouped(t.exact_hits); });
  for (const VerdictStyle& style : verdict_styles) {
    swatches.push_back({legend.swatch_top(), [&style](int x, int y) { return hatched(style, x, y); }});
    legend.row(style.label, [&](const Totals& t) {
      if (style.verdict == Verdict::wrong_hit) return grouped(t.wrong_hits);
      return grouped(style.verdict == Verdict::wrong_miss ? t.wrong_misses : t.wrong_objects);
    });
  }
  legend.heading("Error of t where the verdict is right, ulps from the correctly rounded t");
  for (std::size_t step = 0; step < ulp_steps.size(); ++step) {
    swatches.push_back({legend.swatch_top(), [step](int, int) { return ulp_colours[step]; }});
    legend.row(ulp_steps[step].label, [step](const Totals& t) { return grouped(t.steps[step]); });
  }
  legend.row("the worst", [](const Totals& t) { return ulps_in_words(t.worst_ulps); });
  return swatches;
}

void paint_swatch(Raster& canvas, const Swatch& swatch) {
  const Rgb outline = rgb_of("#5a626c");
  const int left = static_cast<int>(margin * png_scale), top = static_cast<int>(swatch.top * png_scale);
  const int width = static_cast<int>(swatch_width * png_scale),
            height = static_cast<int>(swatch_height * png_scale);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool is_rim = x < 2 || y < 2 || x >= width - 2 || y >= height - 2;
      canvas.at(left + x, top + y) = is_rim ? outline : swatch.colour(x, y);
    }
  }
}

void frame(Picture& picture, double left, double top, double width, double height) {
  const double l = left - 1, t = top - 1, r = left + width + 1, b = top + height + 1;
  picture.elements.push_back(viz::Line{Role::frame, {{l, t}, {r, t}, {r, b}, {l, b}, {l, t}}, 1.5});
}

}  // namespace

Raster error_figure(const std::string& title, const std::vector<ErrorPanel>& panels) {
  const Layout layout(panels);
  if (layout.width * png_scale > widest) {
    throw std::runtime_error(fmt::format(
        "an error image of {} x {} pixels is too wide to be drawn with its legend; {} pixels across work",
        panels.size(), panels.front().errors.width, widest));
  }
  Picture picture;
  picture.width = layout.width;
  picture.elements.push_back(
      viz::Text{Role::text, {margin, margin + 14}, title, Anchor::start, 16, true, false});
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double left = layout.panel_left(i);
    picture.elements.push_back(viz::Text{
        Role::text, {left, layout.panels_top - 10}, panels[i].title, Anchor::start, 14, false, false});
    frame(picture, left, layout.panels_top, layout.panel_width, layout.panel_height);
  }
  Legend legend(picture, layout, panels, layout.panels_top + layout.panel_height + 14);
  const std::vector<Swatch> swatches = write_legend(legend, panels.size() > 1);
  picture.height = std::ceil(legend.bottom() + margin);

  Raster canvas = viz::draw_picture(picture);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    paint_panel(canvas, panels[i].errors, layout.zoom, static_cast<int>(layout.panel_left(i) * png_scale),
                static_cast<int>(layout.panels_top * png_scale));
  }
  for (const Swatch& swatch : swatches) paint_swatch(canvas, swatch);
  return canvas;
}

}  // namespace rayproof::render

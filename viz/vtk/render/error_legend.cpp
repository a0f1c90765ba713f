#include <fmt/format.h>

#include <cmath>

#include "viz/render/errors.hpp"
#include "viz/scene/shown_items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/vtk/render/error_figure.hpp"

namespace rayproof::render {
namespace {

using viz::Anchor;
using viz::Picture;

/// 1234567 as "1 234 567".
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, " ");
  return digits;
}

/// Writes the legend's rows into a picture and notes where its swatches are to be painted.
class Legend {
 public:
  Legend(Picture& picture, const std::vector<ErrorPanel>& panels, double top)
      : picture_(picture), panels_(panels), y_(top) {}

  void heading(const std::string& text, const std::vector<std::string>& columns = {}) {
    y_ += 8;
    write(margin, text, true);
    for (std::size_t i = 0; i < columns.size(); ++i) write(count_right(i), columns[i], true, Anchor::end);
    y_ += row_height;
  }
  template <class CountOf>
  void row(const std::string& label, CountOf&& count_of) {
    write(margin + swatch_width + 10, label, false);
    for (std::size_t i = 0; i < panels_.size(); ++i)
      write(count_right(i), count_of(panels_[i].errors.totals), false, Anchor::end);
    y_ += row_height;
  }
  /// The top of the swatch of the row that comes next.
  [[nodiscard]] double swatch_top() const { return y_ + (row_height - swatch_height) / 2; }
  [[nodiscard]] double bottom() const { return y_; }

 private:
  void write(double x, const std::string& text, bool is_bold, Anchor anchor = Anchor::start) {
    add_text(picture_, viz::Role::text, {x, y_ + row_height - 6}, text, letter_size, is_bold, anchor);
  }

  Picture& picture_;
  const std::vector<ErrorPanel>& panels_;
  double y_;
};

}  // namespace

ErrorLayout::ErrorLayout(const std::vector<ErrorPanel>& panels)
    : columns(panels.front().errors.width), rows(panels.front().errors.height) {
  zoom = std::max(1, (least_panel * png_scale + columns - 1) / columns);
  panel_width = std::ceil(static_cast<double>(columns * zoom) / png_scale);
  panel_height = std::ceil(static_cast<double>(rows * zoom) / png_scale);
  const auto count = static_cast<double>(panels.size());
  const double legend = swatch_width + 10 + label_width + count * count_width;
  const double inner = std::max({legend, count * panel_width + (count - 1) * gap, least_width});
  width = 2 * margin + inner;
  std::size_t lines = 1;
  for (const ErrorPanel& panel : panels) {
    titles.push_back(viz::wrapped(panel.title, panels.size() > 1 ? panel_width : inner, letter_size));
    lines = std::max(lines, titles.back().size());
  }
  panels_top = margin + row_height * static_cast<double>(1 + lines) + 8;
}

std::optional<PanelPixel> ErrorLayout::pixel_at(double x, double y) const {
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const int column = static_cast<int>(std::floor((x - std::floor(panel_left(i) * png_scale)) / zoom));
    const int row = static_cast<int>(std::floor((y - std::floor(panels_top * png_scale)) / zoom));
    if (0 <= column && column < columns && 0 <= row && row < rows) return PanelPixel{i, column, row};
  }
  return std::nullopt;
}

std::vector<Swatch> write_legend(viz::Picture& picture, const std::vector<ErrorPanel>& panels, double top) {
  Legend legend(picture, panels, top);
  const bool is_compared = panels.size() > 1;
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
  legend.heading("Where the verdict is right: ulps of t from the rounded exact t");
  for (std::size_t step = 0; step < ulp_steps.size(); ++step) {
    swatches.push_back({legend.swatch_top(), [step](int, int) { return ulp_colours[step]; }});
    legend.row(ulp_steps[step].label, [step](const Totals& t) { return grouped(t.steps[step]); });
  }
  legend.row("the worst", [](const Totals& t) { return viz::in_ulps(t.worst_ulps); });
  picture.height = std::ceil(legend.bottom() + margin);
  return swatches;
}

}  // namespace rayproof::render

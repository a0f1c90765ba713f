#include "viz/vtk/sheet/picture_item.hpp"

#include <vtkContext2D.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include "viz/picture/picture.hpp"
#include "viz/picture/raster.hpp"

namespace rayproof::viz {
namespace {

/// VTK puts the bottom of the line at the given point, not the baseline; DejaVu Sans reaches so far below,
/// in em.
constexpr double descent = 0.21;

struct Accented {
  std::string plain;
  std::vector<std::size_t> hats;  ///< where the letters begin in it above which there is one
};

Accented without_accents(std::string_view text) {
  constexpr std::string_view hat = "\u0302";
  Accented result;
  std::size_t letter = 0;
  while (!text.empty()) {
    if (text.starts_with(hat)) {
      result.hats.push_back(letter);
      text.remove_prefix(hat.size());
      continue;
    }
    const bool begins_letter = (static_cast<unsigned char>(text[0]) & 0xc0U) != 0x80U;
    if (begins_letter) letter = result.plain.size();
    result.plain += text[0];
    text.remove_prefix(1);
  }
  return result;
}

/// Keeps VTK from mixing fonts within a word. VTK remembers each font by the property that first asked for
/// it, and asks that property again when its cache of 30 fonts, sizes and colours overflows: a painter's own
/// property may by then stand for another font. A copy that nobody changes is registered before, once.
void register_font(vtkTextProperty& property, bool is_bold, Role role) {
  static std::set<std::tuple<int, bool, Role>> registered;
  if (!registered.insert({property.GetFontSize(), is_bold, role}).second) return;
  vtkNew<vtkTextProperty> copy;
  copy->ShallowCopy(&property);
  std::array<int, 4> ignored{};
  vtkTextRenderer::GetInstance()->GetBoundingBox(copy, vtkStdString("x"), ignored.data(), 72);
}

class TextPainter {
 public:
  TextPainter(vtkContext2D& context, const Text& text, double scale)
      : context_(context), text_(text), em_(text.size * scale), accented_(without_accents(text.text)) {
    vtkTextProperty& property = *context.GetTextProp();
    use_legible_font(property, text.bold);
    property.SetFontSize(static_cast<int>(std::lround(em_)));
    property.SetJustification(static_cast<int>(text.anchor));
    property.SetVerticalJustificationToBottom();
  }

  void paint(double x, double y, double scale) {
    if (text_.halo) {
      constexpr int copies = 12;
      for (int i = 0; i < copies; ++i) {
        const double angle = 2 * std::numbers::pi * i / copies;
        write(Role::background, x + 2 * scale * std::cos(angle), y + 2 * scale * std::sin(angle));
      }
    }
    write(text_.role, x, y);
    for (const std::size_t letter : accented_.hats) draw_hat(letter, x, y);
  }

  /// Of all of the text, in the context's pixels.
  [[nodiscard]] double width() const { return width_of(accented_.plain); }

 private:
  void write(Role role, double x, double y) {
    const auto [red, green, blue] = rgb_of(colour_of(role).light);
    vtkTextProperty& property = *context_.GetTextProp();
    property.SetColor(red / 255.0, green / 255.0, blue / 255.0);
    register_font(property, text_.bold, role);
    context_.DrawString(static_cast<float>(x), static_cast<float>(y - descent * em_),
                        accented_.plain.c_str());
  }

  [[nodiscard]] double width_of(const std::string& text) const {
    std::array<float, 4> box{};
    context_.ComputeStringBounds(text.c_str(), box.data());
    return static_cast<double>(box[2]);
  }

  /// Above the letter, in the text's colour.
  void draw_hat(std::size_t begin, double x, double y) {
    const std::string& plain = accented_.plain;
    std::size_t end = begin + 1;
    while (end < plain.size() && (static_cast<unsigned char>(plain[end]) & 0xc0U) == 0x80U) ++end;
    const std::string letter = plain.substr(begin, end - begin);
    const double part = text_.anchor == Anchor::start ? 0 : text_.anchor == Anchor::middle ? 0.5 : 1;
    const double right = x - part * width_of(plain) + width_of(plain.substr(0, end));
    const double middle = right - width_of(letter) / 2;
    const bool is_low = letter.find_first_of("acegmnopqrsuvwxyz") == 0;
    const double base = y + (is_low ? 0.7 : 0.94) * em_;
    std::vector<float> xy;
    for (const double along : {-1.0, 0.0, 1.0}) {
      xy.push_back(static_cast<float>(middle + 0.21 * along * em_));
      xy.push_back(static_cast<float>(base + (along == 0 ? 0.13 : -0.13) * em_));
    }
    stroke(context_, text_.role, xy, (text_.bold ? 0.11 : 0.075) * em_);
  }

  vtkContext2D& context_;
  const Text& text_;
  double em_;
  Accented accented_;
};

}  // namespace

void stroke(vtkContext2D& context, Role role, std::vector<float> xy, double width) {
  const auto [red, green, blue] = rgb_of(colour_of(role).light);
  vtkPen& pen = *context.GetPen();
  pen.SetLineType(vtkPen::SOLID_LINE);
  pen.SetColor(red, green, blue, 255);
  pen.SetWidth(static_cast<float>(width));
  context.DrawPoly(xy.data(), static_cast<int>(xy.size() / 2));
}

void paint_text(vtkContext2D& context, const Text& text, double x, double y, double scale) {
  const std::vector<TextRun> runs = runs_of(text.text);
  if (runs.size() == 1) return TextPainter(context, text, scale).paint(x, y, scale);
  const auto part = [&](const TextRun& run, bool has_halo) {
    const double size = run.is_low ? low_size * text.size : text.size;
    return Text{text.role, {}, run.text, Anchor::start, size, text.bold, has_halo};
  };
  std::vector<double> widths;
  for (const TextRun& run : runs) widths.push_back(TextPainter(context, part(run, false), scale).width());
  const double whole = std::accumulate(widths.begin(), widths.end(), 0.0);
  const double left = text.anchor == Anchor::start    ? x
                      : text.anchor == Anchor::middle ? x - whole / 2
                                                      : x - whole;
  // No halo covers the letters of the run before.
  for (const bool has_halo : {true, false}) {
    if (has_halo && !text.halo) continue;
    double at = left;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double drop = runs[i].is_low ? low_drop * text.size * scale : 0;
      const Text one = part(runs[i], has_halo);
      TextPainter(context, one, scale).paint(at, y - drop, scale);
      at += widths[i];
    }
  }
}

void use_legible_font(vtkTextProperty& text, bool bold) {
  const std::string file =
      std::string(RAYPROOF_FONT_DIR) + (bold ? "/DejaVuSans-Bold.ttf" : "/DejaVuSans.ttf");
  if (!std::filesystem::exists(file)) return;
  text.SetFontFamily(VTK_FONT_FILE);
  text.SetFontFile(file.c_str());
}

}  // namespace rayproof::viz

#ifdef RAYPROOF_HAS_VTK
#include "viz/vtk/render/error_figure.hpp"

#include <gtest/gtest.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>

#include "viz/vtk/offscreen_display.hpp"

namespace rayproof::render {
namespace {

/// Two panels of 32 by 24 pixels without errors.
std::vector<ErrorPanel> two_panels() {
  ErrorImage image{32, 24, std::vector<Verdict>(32 * 24, Verdict::miss), std::vector<double>(32 * 24), {}};
  return {{"left", image}, {"right", image}};
}

/// The middle of a pixel in the figure.
viz::Point middle_of(const ErrorLayout& layout, const PanelPixel& pixel) {
  return {layout.panel_left(pixel.panel) * png_scale + (pixel.x + 0.5) * layout.zoom,
          layout.panels_top * png_scale + (pixel.y + 0.5) * layout.zoom};
}

TEST(ErrorLayout, EveryPlaceOfAPanelIsItsPixel) {
  const ErrorLayout layout(two_panels());
  for (const PanelPixel& pixel : {PanelPixel{0, 0, 0}, {0, 31, 23}, {1, 0, 23}, {1, 17, 5}}) {
    const viz::Point at = middle_of(layout, pixel);
    const auto found = layout.pixel_at(at.x, at.y);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->panel, pixel.panel);
    EXPECT_EQ(found->x, pixel.x);
    EXPECT_EQ(found->y, pixel.y);
  }
  EXPECT_FALSE(layout.pixel_at(5, layout.panels_top * png_scale + 5)) << "the margin";
  EXPECT_FALSE(layout.pixel_at(200, 5)) << "the title";
  const double gap_middle = (layout.panel_left(1) - gap / 2) * png_scale;
  EXPECT_FALSE(layout.pixel_at(gap_middle, layout.panels_top * png_scale + 5)) << "between the panels";
}

TEST(ErrorWindow, AClickOpensThePixelUnderItAndADragNone) {
  const viz::OffscreenDisplay display("1680x1050x24");
  const std::vector<ErrorPanel> panels = two_panels();
  const ErrorLayout layout(panels);
  std::vector<PanelPixel> opened;
  ErrorWindow window(error_figure("Errors", panels), layout, [&](const PanelPixel& pixel) {
    opened.push_back(pixel);
    return std::string("opened");
  });
  const auto send = [&](const viz::Point& at, unsigned long event) {
    window.interactor().SetEventInformation(static_cast<int>(std::lround(at.x)),
                                            static_cast<int>(std::lround(at.y)));
    window.interactor().InvokeEvent(event);
  };
  const viz::Point from = window.to_window(middle_of(layout, {1, 9, 4}));
  send(from, vtkCommand::LeftButtonPressEvent);
  send(from, vtkCommand::LeftButtonReleaseEvent);
  ASSERT_EQ(opened.size(), 1U);
  EXPECT_EQ(opened[0].panel, 1U);
  EXPECT_EQ(opened[0].x, 9);
  EXPECT_EQ(opened[0].y, 4);
  EXPECT_STREQ(window.window().GetWindowName(), "opened");

  const viz::Point to{from.x - 60, from.y + 40};
  send(from, vtkCommand::LeftButtonPressEvent);
  send(to, vtkCommand::MouseMoveEvent);
  send(to, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(opened.size(), 1U);
  // The figure has followed: the pixel is where the pointer took it.
  send(to, vtkCommand::LeftButtonPressEvent);
  send(to, vtkCommand::LeftButtonReleaseEvent);
  ASSERT_EQ(opened.size(), 2U);
  EXPECT_EQ(opened[1].x, 9);
  EXPECT_EQ(opened[1].y, 4);
  const viz::Point title = window.to_window({300, 20});
  send(title, vtkCommand::LeftButtonPressEvent);
  send(title, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(opened.size(), 2U);
}

}  // namespace
}  // namespace rayproof::render
#endif

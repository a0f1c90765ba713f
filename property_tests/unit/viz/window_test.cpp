#ifdef RAYPROOF_HAS_VTK
#include <gtest/gtest.h>
#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>

#include "unit/viz/player.hpp"
#include "unit/viz/screenshot.hpp"
#include "unit/viz/x_client.hpp"
#include "viz/page/stage_json.hpp"
#include "viz/scene/label_places.hpp"
#include "viz/vtk/offscreen_display.hpp"

namespace rayproof::viz {
namespace {

/// A window on a virtual display, fed with the events that VTK makes of what a user does.
class Window : public testing::Test {
 protected:
  void send(const Point& at, vtkCommand::EventIds event) {
    const Point p = window.to_window(at);
    window.interactor().SetEventInformation(static_cast<int>(std::lround(p.x)),
                                            static_cast<int>(std::lround(p.y)));
    window.interactor().InvokeEvent(event);
  }
  void press_key(const char* key) {
    window.interactor().SetEventInformation(0, 0, 0, 0, 0, 1, key);
    window.interactor().InvokeEvent(vtkCommand::KeyPressEvent);
  }
  void drag(const Point& from, const Point& to) {
    send(from, vtkCommand::LeftButtonPressEvent);
    send(to, vtkCommand::MouseMoveEvent);
    send(to, vtkCommand::LeftButtonReleaseEvent);
  }
  [[nodiscard]] Screenshot screenshot() { return Screenshot(window); }

  OffscreenDisplay display{"1280x900x24"};
  Player player = sphere_player();
  StageWindow window{player, 1152, 864};
};

/// Where a text's letters are: a line's height above its baseline.
PixelBox letters_of(const Text& text) {
  const double width = text_width(text.text, text.size, text.bold);
  const double left = text.at.x - (text.anchor == Anchor::middle ? width / 2
                                   : text.anchor == Anchor::end  ? width
                                                                 : 0);
  return {left, text.at.y - 0.75 * text.size, width, 0.75 * text.size};
}

TEST_F(Window, EveryTextOfThePictureHasInkWhereItBelongs) {
  for (const char* key : {"Home", "2", "End", "h"}) {
    press_key(key);
    const Screenshot shot = screenshot();
    for (const Text& text : texts_of(player.picture())) {
      const PixelBox box = letters_of(text);
      EXPECT_GT(shot.ink(box), 3) << key << ": " << text.text;
    }
  }
}

TEST_F(Window, WhatThePictureLeavesFreeIsWhite) {
  const Screenshot shot = screenshot();
  EXPECT_EQ(shot.ink({0, 0, 20, 535}), 0);  // the margins
  EXPECT_EQ(shot.ink({942, 50, 18, 480}), 0);
  EXPECT_EQ(shot.ink({24, 72, 590, 30}), 0);  // above the sphere
  EXPECT_EQ(shot.ink({-200, -200, 2000, 2000}), shot.ink({0, 0, player_width, player_height}));
  EXPECT_GT(shot.ink(slide_scene), 5000);
}

TEST_F(Window, AKeyChangesTheStepAndTheSlide) {
  const Screenshot before = screenshot();
  press_key("Right");
  EXPECT_EQ(player.step(), 1U);
  const Screenshot after = screenshot();
  EXPECT_GT(after.changes(before, {24, 10, 900, 30}), 200);  // the title
  EXPECT_GT(after.changes(before, slide_scene), 200);
}

TEST_F(Window, AClickOnAButtonChangesTheStep) {
  const auto buttons = player.buttons();
  send(buttons[3].box.centre(), vtkCommand::LeftButtonPressEvent);
  send(buttons[3].box.centre(), vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(player.step(), 2U);
}

TEST_F(Window, TheSliderMovesThePointInTheScene) {
  const auto place = [&] {
    const StageSlider& slider = *player.stage().slider;
    return player.projection().to_pixels(slider.origin + player.t() * slider.direction);
  };
  const Point old_place = place();
  const Screenshot before = screenshot();
  drag(slider_track.centre(), {slider_track.left + 0.1 * slider_track.width, slider_track.centre().y});
  const Point new_place = place();
  const Screenshot after = screenshot();
  EXPECT_LT(new_place.x, old_place.x - 50);
  // The triangle stands below its point.
  for (const Point& p : {old_place, new_place})
    EXPECT_GT(after.changes(before, {p.x - 9, p.y + 3, 18, 15}), 30) << p.x;
  EXPECT_GT(after.changes(before, {214, 640, 400, 40}), 50);  // the live values
  EXPECT_EQ(after.changes(before, {24, 10, 900, 30}), 0);     // not the title
}

TEST_F(Window, DraggingTheArrowsTipComputesEverythingAgain) {
  const std::string before = stage_json(player.stage());
  const Screenshot first = screenshot();
  const Point from = seen(player, handle_of(player, Grip::tip));
  drag(from, {from.x - 40, from.y + 70});
  EXPECT_NE(stage_json(player.stage()), before);
  EXPECT_EQ(stage_json(player.stage()),
            stage_json(stage_of(report_of(player.stage().one, "sphere/centred"))));
  EXPECT_GT(screenshot().changes(first, slide_scene), 500);
}

TEST_F(Window, MovingThePointerWithNoButtonDownChangesNothing) {
  const std::string before = stage_json(player.stage());
  const Point tip = seen(player, handle_of(player, Grip::tip));
  send(tip, vtkCommand::MouseMoveEvent);
  send({tip.x, tip.y + 50}, vtkCommand::MouseMoveEvent);
  EXPECT_EQ(stage_json(player.stage()), before);
}

TEST_F(Window, ThePictureKeepsItsProportionsInAWindowOfAnySize) {
  for (const auto& [width, height] : {std::pair{600, 900}, {1200, 400}, {60, 30}, {960, 716}}) {
    window.window().SetSize(width, height);
    window.repaint();
    const Point low = window.to_window({0, player_height});
    const Point high = window.to_window({player_width, 0});
    EXPECT_NEAR((high.x - low.x) / (high.y - low.y), player_width / player_height, 1e-9);
    EXPECT_GE(low.x, -1e-9);
    EXPECT_GE(low.y, -1e-9);
    EXPECT_LE(high.x, width + 1e-9);
    EXPECT_LE(high.y, height + 1e-9);
  }
  send(player.buttons()[2].box.centre(), vtkCommand::LeftButtonPressEvent);
  EXPECT_EQ(player.step(), 1U);
}

TEST_F(Window, AnotherProgramsKeysAndMouseReachItThroughTheServer) {
  XClient user;
  ASSERT_TRUE(user.find_window());
  const auto on_screen = [&](const Point& p) {
    const Point at = window.to_window(p);
    return std::pair{static_cast<int>(at.x), 864 - 1 - static_cast<int>(at.y)};
  };
  const auto [x, y] = on_screen(slider_track.centre());
  const auto [left, same] = on_screen({slider_track.left + 1, slider_track.centre().y});
  user.press_key("Right");
  user.press_key("Right");
  user.press_button(x, y);
  user.move_pointer(left, same);
  window.handle_events();
  EXPECT_EQ(player.step(), 2U);
  EXPECT_NEAR(player.t(), player.stage().slider->from, 0.02);
  user.release_button(left, same);
  user.press_key("q");
  window.run();  // comes back
}

TEST_F(Window, ClosingTheWindowEndsIt) {
  XClient user;
  ASSERT_TRUE(user.find_window());
  user.close_window();
  window.run();
}

}  // namespace
}  // namespace rayproof::viz
#endif

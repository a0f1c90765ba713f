#ifdef RAYPROOF_HAS_VTK
#include <gtest/gtest.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "unit/viz/player.hpp"
#include "unit/viz/screenshot.hpp"
#include "unit/viz/x_client.hpp"
#include "viz/flat/stage_picture.hpp"
#include "viz/page/page.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/window/buttons.hpp"

namespace rayproof::viz {
namespace {

/// A window of a player, fed with the events that VTK makes of what a user does.
struct Shown {
  explicit Shown(Player shown, int width = 960, int height = 540)
      : player(std::move(shown)), window(player, width, height) {}

  void send(const Point& at, unsigned long event) {
    window.interactor().SetEventInformation(static_cast<int>(std::lround(at.x)),
                                            static_cast<int>(std::lround(at.y)));
    window.interactor().InvokeEvent(event);
  }
  void press_key(const char* key) {
    window.interactor().SetEventInformation(0, 0, 0, 0, 0, 1, key);
    window.interactor().InvokeEvent(vtkCommand::KeyPressEvent);
    window.handle_events();
  }
  void press(const Point& at) {
    send(at, vtkCommand::MouseMoveEvent);
    send(at, vtkCommand::LeftButtonPressEvent);
  }
  void drag(const Point& from, const Point& to) {
    press(from);
    send(to, vtkCommand::MouseMoveEvent);
    send(to, vtkCommand::LeftButtonReleaseEvent);
    window.handle_events();
  }
  [[nodiscard]] Point bar_at(double t) const {
    const StageSlider& slider = *player.stage().slider;
    const double part = (t - slider.from) / (slider.to - slider.from);
    return window.to_window({slider_track.left + part * slider_track.width, slider_track.centre().y});
  }
  [[nodiscard]] Point button(const std::string& key) const {
    for (const Button& one : buttons_of(player)) {
      if (one.key == key) return window.to_window(one.box.centre());
    }
    throw std::logic_error("no button for " + key);
  }

  Player player;
  StageWindow window;
};

class Window : public testing::Test {
 protected:
  OffscreenDisplay display{"1680x1050x24"};
  Shown shown{sphere_player()};
};

TEST_F(Window, AKeyAndAClickOnAButtonChangeTheStepAndTheSlide) {
  const Screenshot before(shown.window);
  shown.press_key("Right");
  EXPECT_EQ(shown.player.step(), 1U);
  const Screenshot after(shown.window);
  EXPECT_GT(after.changes(before, {24, 10, 900, 30}), 200);  // the title
  EXPECT_GT(after.changes(before, window_scene), 200);
  const Point third = shown.button("3");
  shown.press(third);
  shown.send(third, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(shown.player.step(), 2U);
  shown.window.repaint();
  const Point help = shown.button("h");
  shown.press(help);
  shown.send(help, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_TRUE(shown.player.is_help_shown());
}

TEST_F(Window, AButtonThatIsGreyDoesNothing) {
  const Point back = shown.button("Left");
  shown.press(back);
  shown.send(back, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(shown.player.step(), 0U);
}

TEST_F(Window, TheSliderMovesThePointInTheScene) {
  const Screenshot before(shown.window);
  const double t = shown.player.t();
  shown.drag(shown.bar_at(t), shown.bar_at(1));
  EXPECT_NEAR(shown.player.t(), 1, 0.02);
  EXPECT_EQ(shown.player.t(), static_cast<double>(static_cast<float>(shown.player.t())));
  const Screenshot after(shown.window);
  EXPECT_GT(after.changes(before, window_scene), 200);
  EXPECT_GT(after.changes(before, {140, 376, 700, 40}), 50);  // the live values
  EXPECT_EQ(after.changes(before, {24, 10, 900, 30}), 0);     // not the title
  shown.drag(shown.bar_at(shown.player.t()), {5000, shown.bar_at(1).y});
  EXPECT_EQ(shown.player.t(), static_cast<double>(static_cast<float>(shown.player.stage().slider->to)));
}

TEST_F(Window, EveryHandleIsDraggedByTheMouseAndAllIsComputedAgain) {
  const std::vector<std::string> names = handle_names(shown.player);
  EXPECT_EQ(names, (std::vector<std::string>{"origin", "tip", "center", "radius"}));
  for (const std::string& name : names) {
    const std::string before = stage_json(shown.player.stage());
    const Point from = *shown.window.seen(name);
    shown.drag(from, {from.x + 24, from.y + 30});
    EXPECT_NE(stage_json(shown.player.stage()), before) << name;
    EXPECT_EQ(stage_json(shown.player.stage()),
              stage_json(stage_of(report_of(shown.player.stage().one, "sphere/centred"))));
    shown.press_key("r");
  }
}

TEST_F(Window, TheBallStaysAtThePointerWhileItIsDragged) {
  const Point from = *shown.window.seen("center");
  shown.press(from);
  for (int i = 1; i <= 5; ++i) {
    shown.send({from.x + 8 * i, from.y + 6 * i}, vtkCommand::MouseMoveEvent);
    shown.window.repaint();
    const Point at = *shown.window.seen("center");
    EXPECT_NEAR(at.x, from.x + 8 * i, 3);
    EXPECT_NEAR(at.y, from.y + 6 * i, 3);
  }
  shown.send({from.x + 40, from.y + 30}, vtkCommand::LeftButtonReleaseEvent);
}

TEST_F(Window, HoweverManyEventsThereWereAFrameComputesTheCaseOnce) {
  const std::string before = stage_json(shown.player.stage());
  const Point from = *shown.window.seen("center");
  shown.press(from);
  for (int i = 1; i <= 5; ++i) shown.send({from.x + 8 * i, from.y + 6 * i}, vtkCommand::MouseMoveEvent);
  EXPECT_EQ(stage_json(shown.player.stage()), before);
  shown.window.handle_events();
  EXPECT_NE(stage_json(shown.player.stage()), before);
  shown.send({from.x + 40, from.y + 30}, vtkCommand::LeftButtonReleaseEvent);
}

TEST(WindowOfEveryShape, ADragOfEachHandleChangesTheCase) {
  const OffscreenDisplay display("1680x1050x24");
  const std::string ray =
      R"({"precision":"float32","ray":{"origin":[-3,-1,0.5],"direction":[1.5,0.5,-0.25]},)";
  const std::vector<std::pair<std::string, std::string>> all{
      {R"("shape":{"type":"triangle","a":[0,-1,-1],"b":[0,1.5,-1],"c":[0,0,1]}})",
       "triangle/moller_trumbore"},
      {R"("shape":{"type":"plane","point":[0,0,0],"normal":[1,0.2,0]}})", "plane/point_normal"},
      {R"("shape":{"type":"box","min":[-1,-1,-1],"max":[1,1,1]}})", "box/slabs"},
      {R"("shape":{"type":"parallelepiped","corner":[-1,-1,-1],"edges":[[1.5,0,0],[0,1.5,0],[0,0,1.5]]}})",
       "parallelepiped/unit_cube"},
      {R"("shape":{"type":"cylinder","rx":1,"ry":1.2,"height":1.5,"capped":true}})", "cylinder/textbook"},
      {R"("shape":{"type":"polygon","vertices":[[0,-1,-1],[0,1,-1],[0,1,1],[0,-1,1]]}})", "polygon/parity"},
      {R"("shape":{"type":"sphere","center":[0,0.2,0],"radius":0.8},)"
       R"("transform":[[1,0,0,0.1],[0,1.2,0,0],[0,0,1.5,0],[0,0,0,1]]})",
       "sphere/centred"},
  };
  for (const auto& [shape, method] : all) {
    Shown shown(player_of(ray + shape, method), 480, 270);
    for (const std::string& name : handle_names(shown.player)) {
      const auto from = shown.window.seen(name);
      ASSERT_TRUE(from) << shape << name;
      const std::string before = write_case(shown.player.stage().one);
      shown.drag(*from, {from->x + 14, from->y - 9});
      // Where one ball hides another, the nearer one moves.
      const bool is_refused = !shown.player.complaint().empty();
      EXPECT_TRUE(is_refused || write_case(shown.player.stage().one) != before) << shape << name;
      shown.press_key("r");
    }
  }
}

TEST_F(Window, TheMouseElsewhereTurnsTheViewAndTheCaseStays) {
  const std::string before = stage_json(shown.player.stage());
  const Point tip = *shown.window.seen("tip");
  const Point free = shown.window.to_window({60, 330});
  shown.drag(free, {free.x + 60, free.y + 20});
  EXPECT_EQ(stage_json(shown.player.stage()), before);
  const Point turned = *shown.window.seen("tip");
  EXPECT_GT(std::hypot(turned.x - tip.x, turned.y - tip.y), 10);
  // The next step of the same view is seen from the same side; r looks anew.
  shown.press_key("r");
  EXPECT_NEAR(shown.window.seen("tip")->x, tip.x, 1);
}

TEST_F(Window, KeysMoveTheHandleThatHasTheFocusAndTurnAndNearTheView) {
  for (int i = 0; i < 3; ++i) shown.press_key("Tab");
  ASSERT_EQ(shown.player.focused_handle(), "origin");
  const Point from = *shown.window.seen("origin");
  shown.press_key("Right");
  EXPECT_NE(ray_of(shown.player).origin, ray_of(sphere_player()).origin);
  shown.press_key("r");
  for (int i = 0; i < 2; ++i) shown.press_key("Tab");
  ASSERT_EQ(shown.player.focus(), Focus::view);
  shown.press_key("Left");
  EXPECT_NE(shown.window.seen("origin")->x, from.x);
  const double apart = std::abs(shown.window.seen("tip")->x - shown.window.seen("origin")->x);
  shown.press_key("plus");
  EXPECT_GT(std::abs(shown.window.seen("tip")->x - shown.window.seen("origin")->x), 1.05 * apart);
}

TEST_F(Window, MovingThePointerWithNoButtonDownChangesNothing) {
  const std::string before = stage_json(shown.player.stage());
  const Point tip = *shown.window.seen("tip");
  shown.send(tip, vtkCommand::MouseMoveEvent);
  shown.send({tip.x, tip.y + 50}, vtkCommand::MouseMoveEvent);
  EXPECT_EQ(stage_json(shown.player.stage()), before);
}

TEST_F(Window, TheSlideKeepsItsProportionsInAWindowOfAnySize) {
  for (const auto& [width, height] : {std::pair{600, 900}, {1200, 400}, {160, 90}, {960, 540}}) {
    shown.window.window().SetSize(width, height);
    shown.window.repaint();
    const Point low = shown.window.to_window({0, slide_height});
    const Point high = shown.window.to_window({slide_width, 0});
    EXPECT_NEAR((high.x - low.x) / (high.y - low.y), slide_width / slide_height, 1e-9);
    EXPECT_GE(low.x, -1e-9);
    EXPECT_GE(low.y, -1e-9);
    EXPECT_LE(high.x, width + 1e-9);
    EXPECT_LE(high.y, height + 1e-9);
  }
  const Point second = shown.button("2");
  shown.press(second);
  shown.send(second, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_EQ(shown.player.step(), 1U);
}

TEST(WindowOfALesson, FiveTopicsHaveTheColoursOfTheirRolesInTheScene) {
  const OffscreenDisplay display("1680x1050x24");
  struct Substance {
    const char* topic;
    std::size_t step;
    Role role;
    double least, most;  ///< share of the scene
  };
  // What is seen of a surface in its tint, of a line or a mark in its colour.
  for (const auto& [topic, step, role, least, most] : {Substance{"sphere", 1, Role::surface, 0.1, 0.6},
                                                       {"slabs", 1, Role::surface, 0.1, 0.7},
                                                       {"cylinder", 1, Role::surface, 0.05, 0.6},
                                                       {"quadratic-two", 1, Role::edge, 0, 0.2},
                                                       {"moller-trumbore", 1, Role::surface, 0.03, 0.6}}) {
    Shown shown(Player(plays_of(topic)));
    shown.press_key(std::to_string(step + 1).c_str());
    const Screenshot shot(shown.window);
    const double share = shot.share_of(role, window_scene);
    EXPECT_GE(share, least) << topic;
    EXPECT_LE(share, most) << topic;
    EXPECT_GT(shot.ink(window_scene), 2000) << topic;
    EXPECT_EQ(shot.ink({0, 0, 20, 505}), 0) << topic;  // the margin
    // The title and the slider are there.
    EXPECT_GT(shot.ink({24, 10, 700, 30}), 300) << topic;
  }
}

TEST_F(Window, AnotherProgramsKeysAndMouseReachItThroughTheServer) {
  XClient user;
  ASSERT_TRUE(user.find_window());
  const auto on_screen = [&](const Point& p) {
    return std::pair{static_cast<int>(p.x), 540 - 1 - static_cast<int>(p.y)};
  };
  const auto [x, y] = on_screen(shown.bar_at(shown.player.t()));
  const auto [left, same] = on_screen(shown.bar_at(shown.player.stage().slider->from));
  user.press_key("Right");
  user.press_key("Right");
  user.press_button(x, y);
  user.move_pointer(left, same);
  shown.window.handle_events();
  EXPECT_EQ(shown.player.step(), 2U);
  EXPECT_NEAR(shown.player.t(), shown.player.stage().slider->from, 0.03);
  user.release_button(left, same);
  user.press_key("q");
  shown.window.run();  // comes back
}

TEST_F(Window, ClosingTheWindowEndsIt) {
  XClient user;
  ASSERT_TRUE(user.find_window());
  user.close_window();
  shown.window.run();
}

}  // namespace
}  // namespace rayproof::viz
#endif

#include "unit/vtk/screenshot.hpp"
#include "unit/vtk/shown_window.hpp"
#include "unit/vtk/x_client.hpp"
#include "viz/page/page.hpp"

namespace rayproof::viz {
namespace {

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

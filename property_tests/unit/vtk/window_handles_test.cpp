#include "unit/vtk/shown_window.hpp"
#include "viz/page/page.hpp"

namespace rayproof::viz {
namespace {

class HandlesInWindow : public Window {};

TEST_F(HandlesInWindow, EveryHandleIsDraggedByTheMouseAndAllIsComputedAgain) {
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

TEST_F(HandlesInWindow, TheBallStaysAtThePointerWhileItIsDragged) {
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

TEST_F(HandlesInWindow, HoweverManyEventsThereWereAFrameComputesTheCaseOnce) {
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

TEST_F(HandlesInWindow, TheMouseElsewhereTurnsTheViewAndTheCaseStays) {
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

TEST_F(HandlesInWindow, KeysMoveTheHandleThatHasTheFocusAndTurnAndNearTheView) {
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

}  // namespace
}  // namespace rayproof::viz

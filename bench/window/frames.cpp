/// \file
/// How long the walkthrough's window takes for a frame while a handle is dragged: every kind of handle of
/// every topic, moved by VTK's own events in a window of the default size on a virtual display.

#include <benchmark/benchmark.h>
#include <vtkCommand.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>

#include "viz/programs/plays_of.hpp"
#include "viz/vtk/offscreen_display.hpp"
#include "viz/vtk/window/stage_window.hpp"

namespace rayproof::viz {
namespace {

/// Of a handle's frames, the first of which load what the others find loaded.
constexpr int measured_frames = 12, first_frames = 3;

double processor_ms() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double wall_ms() {
  const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(since_start).count();
}

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// What the frames of a drag took.
struct Frames {
  std::vector<double> wall{}, processor{};
};

/// Moves the handle in a circle.
Frames drag(StageWindow& window, const Point& from) {
  Frames frames;
  const auto send = [&](const Point& at, unsigned long event) {
    window.interactor().SetEventInformation(static_cast<int>(std::lround(at.x)),
                                            static_cast<int>(std::lround(at.y)));
    window.interactor().InvokeEvent(event);
  };
  send(from, vtkCommand::MouseMoveEvent);
  send(from, vtkCommand::LeftButtonPressEvent);
  for (int i = 0; i < first_frames + measured_frames; ++i) {
    const double angle = 2 * std::numbers::pi * i / 12;
    const double wall = wall_ms(), processor = processor_ms();
    send({from.x + 20 * std::sin(angle), from.y + 20 * (1 - std::cos(angle))}, vtkCommand::MouseMoveEvent);
    window.handle_events();
    if (i < first_frames) continue;
    frames.wall.push_back(wall_ms() - wall);
    frames.processor.push_back(processor_ms() - processor);
  }
  send(from, vtkCommand::LeftButtonReleaseEvent);
  window.repaint();
  return frames;
}

/// In the last step with handles, which shows the items of those before it, too. A frame's time is that of
/// the topic's slowest handle, in the median of its frames.
void drag_every_handle(benchmark::State& state, const std::string& topic) {
  const OffscreenDisplay display("1680x1050x24");
  Player player(plays_of(topic));
  for (std::size_t step = player.stage().steps.size(); step-- > 0;) {
    player.go_to(step);
    if (!player.handles().empty()) break;
  }
  if (player.handles().empty()) return state.SkipWithError("nothing to drag");
  StageWindow window(player);
  for (auto _ : state) {
    double wall = 0, processor = 0;
    for (const Handle& handle : player.handles()) {
      const auto from = window.seen(handle.name);
      if (!from) continue;
      const Frames frames = drag(window, *from);
      wall = std::max(wall, median(frames.wall));
      processor = std::max(processor, median(frames.processor));
      player.press_key("r");
      window.repaint();
    }
    state.SetIterationTime(wall / 1e3);
    state.counters["processor_ms"] = processor;
    state.counters["handles"] = static_cast<double>(player.handles().size());
  }
}

const bool is_registered = [] {
  for (const Lesson& lesson : lessons()) {
    const std::string topic(lesson.name);
    benchmark::RegisterBenchmark(("window/" + topic).c_str(),
                                 [topic](benchmark::State& state) { drag_every_handle(state, topic); })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace rayproof::viz

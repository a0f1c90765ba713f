#include <algorithm>
#include <cmath>

#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/compose.hpp"
#include "viz/walkthrough/lesson.hpp"

namespace rayproof::viz {

/// For each number of a run a bar of its digits: what is kept, and what is lost.
Stage digits_stage(const Case& one, const ReportCase& report_on) {
  const CaseReport report = report_on(one, "sphere/textbook");
  Setting setting = plot_setting(report);
  setting.slider.reset();
  setting.bindings.clear();
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
  stage.steps.front().title = "Every number begins with all its digits";
  const NumbersByName n(*report.walk, report.walk->steps.size() - 1);
  if (std::abs(n.rounded("√D")) < 0.01 * std::abs(n.rounded("b")))
    stage.steps.back().digits = "√D is small beside b, so its error weighs little in t₀ and t₁.";
  stage.steps.push_back(difference_of_values(*report.walk, setting, one.precision));
  return stage;
}

}  // namespace rayproof::viz

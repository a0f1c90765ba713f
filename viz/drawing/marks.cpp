#include "viz/drawing/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viz/explain/answers.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {

std::vector<NamedMark> marks_of(const std::string& symbol, const Answer* exact, const Answer* claimed,
                                const std::function<WorldPoint(double)>& place) {
  std::vector<NamedMark> marks;
  for (const auto& [role, answer] : {std::pair{Role::exact, exact}, {Role::claimed, claimed}}) {
    const std::vector<double> values = values_of(answer);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (std::isfinite(values[i])) marks.push_back({role, symbol + subscript(i), place(values[i])});
    }
  }
  return marks;
}

std::optional<std::pair<WorldPoint, WorldPoint>> worst_pair(const Answer* exact, const Answer* claimed,
                                                            const std::function<WorldPoint(double)>& place) {
  const std::vector<double> truth = values_of(exact);
  const std::vector<double> claim = values_of(claimed);
  std::optional<std::pair<WorldPoint, WorldPoint>> worst;
  double most = 0;
  for (std::size_t i = 0; i < std::min(truth.size(), claim.size()); ++i) {
    if (!std::isfinite(truth[i]) || !std::isfinite(claim[i])) continue;
    // Halves, since the difference itself may overflow.
    const double relative = std::abs(claim[i] / 2 - truth[i] / 2) / std::abs(truth[i]);
    if (truth[i] == claim[i] || relative < most) continue;
    most = relative;
    worst = {place(truth[i]), place(claim[i])};
  }
  return worst;
}

void draw_marks(Picture& picture, const View& view, const std::vector<NamedMark>& marks) {
  for (const Role role : {Role::exact, Role::claimed}) {
    std::vector<Text> names;
    for (const NamedMark& mark : marks) {
      if (mark.role != role || !view.shows(mark.at)) continue;
      draw_mark(picture, view, role, role == Role::exact ? MarkShape::ring : MarkShape::cross, mark.at);
      Point at = view.to_pixels(mark.at);
      at.x = std::clamp(at.x, view.frame.left + 20, view.frame.right() - 20);
      if (role == Role::claimed) at.x += 10;  // beside what leads down from the line
      at.y += role == Role::exact ? -14 : 24;
      if (!names.empty() && at.x - names.back().at.x < 34) {
        names.back().text += ", " + mark.label;
      } else {
        names.push_back({role, at, mark.label, Anchor::middle, 15, true, true});
      }
    }
    for (Text& name : names) picture.elements.emplace_back(std::move(name));
  }
}

void draw_marks_beyond(Picture& picture, const View& view, const std::vector<NamedMark>& marks) {
  const double y =
      std::clamp(view.to_pixels({view.centre.x, 0}).y, view.frame.top, view.frame.bottom() - 40) + 26;
  for (const bool right : {false, true}) {
    std::string names;
    for (const NamedMark& mark : marks) {
      if (view.shows(mark.at) || (mark.at.x > view.centre.x) != right || mark.role != Role::claimed) continue;
      names += (names.empty() ? "" : ", ") + mark.label;
    }
    if (names.empty()) continue;
    const Point at{right ? view.frame.right() - 10 : view.frame.left + 10, y};
    picture.elements.emplace_back(Text{Role::claimed, at,
                                       fmt::format("{}× {}{}", right ? "" : "← ", names, right ? " →" : ""),
                                       right ? Anchor::end : Anchor::start, 14, true});
  }
}

}  // namespace rayproof::viz

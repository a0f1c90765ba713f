#include "viz/page/page.hpp"

#include <array>
#include <cctype>
#include <cmath>

#include "case/escape.hpp"
#include "case/json/ordered.hpp"
#include "viz/picture/picture.hpp"
#include "viz/scene/space.hpp"

namespace rayproof::viz {
namespace {

using Json = nlohmann::ordered_json;

double short_number(double x) { return std::round(x * 1e4) / 1e4; }

/// x, y and z of each point, in one list.
Json all_digits(const SpacePoints& points) {
  Json list = Json::array();
  for (const glm::dvec3& p : points) {
    for (int i = 0; i < 3; ++i) list.push_back(p[i]);
  }
  return list;
}
Json flat(SpacePoints points) {
  for (glm::dvec3& p : points) p = {short_number(p.x), short_number(p.y), short_number(p.z)};
  return all_digits(points);
}
Json flat(const glm::dvec3& p) { return flat(SpacePoints{p}); }
Json flat_each(const std::vector<SpacePoints>& lists) {
  return json_list(lists, [](const SpacePoints& points) { return flat(points); });
}

const char* name_of(Emphasis emphasis) {
  static constexpr std::array<const char*, 3> names{"scene", "dimmed", "bright"};
  return names.at(static_cast<std::size_t>(emphasis));
}

Json body_json(const SpaceBody& body) {
  static constexpr std::array<const char*, 4> marks{"dot", "ring", "cross", "diamond"};
  Json json{{"form", form_names.at(static_cast<std::size_t>(body.shown.item->form))},
            {"role", colour_of(shown_role(body.shown)).name},
            {"how", name_of(body.shown.emphasis)},
            {"radius", short_number(body.radius)}};
  if (body.is_mark()) json["mark"] = marks.at(static_cast<std::size_t>(mark_of(body.shown.item->role)));
  if (body.is_surface()) json["opacity"] = body.opacity;
  if (body.is_mark() || body.is_surface()) {
    // The axes of an ellipsoid are differences, and none of them may be rounded to 0.
    json["points"] = body.shown.item->form == Form::ellipsoid ? all_digits(body.points) : flat(body.points);
    if (!body.shown.item->faces.empty()) json["faces"] = body.shown.item->faces;
    if (!body.strips.empty()) json["strips"] = flat_each(body.strips);
    return json;
  }
  json["pieces"] = flat_each(body.pieces);
  if (body.head) {
    json["head"] = flat({body.head->base, body.head->tip});
    json["headRadius"] = short_number(body.head->radius);
  }
  return json;
}

/// A label as HTML: typeset, unless there are words in it.
std::string label_html(const std::string& label) {
  int letters = 0;
  for (const char c : label) {
    // An index may be a word.
    letters = c == '_' ? -20 : std::isalpha(static_cast<unsigned char>(c)) != 0 ? letters + 1 : 0;
    if (letters > 2) return html_text(label);
  }
  return math_ml(read_formula(label));
}

Json label_json(const SpaceLabel& label) {
  const StageItem& item = *label.shown.item;
  return {{"html", label_html(item.label)},
          {"role", colour_of(label_role(label.shown)).name},
          {"how", name_of(label.shown.emphasis)},
          {"points", flat(label.points)},
          {"atEnd", label.is_at_end},
          {"isText", item.form == Form::point && item.role == Role::text}};
}

Json floor_json(const SpaceFloor& floor) {
  const Json lines = json_list(
      floor.lines, [](const std::vector<double>& across) { return json_list(across, short_number); });
  return {{"axis", floor.axis},
          {"reach", floor_reach},
          {"ground", short_number(floor.ground)},
          {"grid", short_number(floor.grid)},
          {"shadows", short_number(floor.shadows)},
          {"lines", lines}};
}

Json step_json(const Stage& stage, std::size_t number) {
  const Space space = space_of(stage, number);
  const SpaceCamera& camera = space.camera;
  Json json{{"title", typeset(stage.steps[number].title)},
            {"eye", flat(camera.eye())},
            {"target", flat(camera.middle)},
            {"up", flat(camera.up)},
            {"near", camera.nearest()},
            {"far", camera.farthest()}};
  if (camera.is_flat) json["flat"] = true;
  if (camera.is_flat) json["half"] = camera.half;
  json["bodies"] = json_list(space.bodies, body_json);
  json["labels"] = json_list(space.labels, label_json);
  if (space.floor) json["floor"] = floor_json(*space.floor);
  if (stage.slider && !stage.steps[number].is_apart) {
    const glm::dvec3 origin = in_view(space.view, stage.slider->origin);
    json["runner"] = {{"size", runner_size * camera.unit()}};
    for (int i = 0; i < 3; ++i) json["runner"]["ray"].push_back(origin[i]);
    for (int i = 0; i < 3; ++i)
      json["runner"]["ray"].push_back(stage.slider->direction[i] / space.view.radius);
  }
  return json;
}

}  // namespace

std::string space_json(const Stage& stage) {
  Json json{{"angle", view_angle}};
  json["marks"] = {{"dot", mark_measures.dot},
                   {"ring", mark_measures.ring},
                   {"wire", mark_measures.wire},
                   {"cross", mark_measures.cross},
                   {"diamond", mark_measures.diamond}};
  json["steps"] = Json::array();
  for (std::size_t i = 0; i < stage.steps.size(); ++i) json["steps"].push_back(step_json(stage, i));
  return write_json(json);
}

}  // namespace rayproof::viz

#include "viz/page/page.hpp"

#include <array>
#include <cmath>

#include "case/json/ordered.hpp"
#include "case/writer.hpp"
#include "viz/picture/picture.hpp"
#include "viz/trace/numbers.hpp"

namespace rayproof::viz {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const glm::dvec3& p) { return {json_number(p.x), json_number(p.y), json_number(p.z)}; }

Json items(const std::vector<StageItem>& list) {
  static constexpr std::array<const char*, 3> patterns{"solid", "dashed", "dotted"};
  return json_list(list, [](const StageItem& item) {
    Json one{{"role", colour_of(item.role).name},
             {"form", form_names.at(static_cast<std::size_t>(item.form))}};
    if (!item.label.empty()) one["label"] = item.label;
    if (item.pattern != Pattern::solid) one["pattern"] = patterns.at(static_cast<std::size_t>(item.pattern));
    one["points"] = json_list(item.points, vector_json);
    if (!item.faces.empty()) one["faces"] = item.faces;
    return one;
  });
}

Json values(const std::vector<StageValue>& list, Precision precision) {
  const auto component = [&](const WalkValue& v) {
    return Json{{"value", json_number(v.value)},
                {"shown", shown(v.value, precision)},
                {"exact", v.exact},
                {"bits_lost", v.bits_lost}};
  };
  return json_list(list, [&](const StageValue& value) {
    return Json{{"name", value.name},
                {"formula", text_of(value.formula)},
                {"put_in", text_of(value.put_in)},
                {"components", json_list(value.components, component)}};
  });
}

Json steps(const Stage& stage) {
  return json_list(stage.steps, [&](const StageStep& step) {
    Json one{{"title", typeset(step.title)},
             {"words", step.words},
             {"caption", step.caption},
             {"digits", step.digits}};
    one["values"] = values(step.values, stage.precision);
    one["items"] = items(step.items);
    one["view"] = {{"centre", vector_json(step.view.centre)}, {"radius", json_number(step.view.radius)}};
    if (step.begins_anew) one["anew"] = true;
    if (step.is_apart) {
      one["magnification"] = json_number(step.magnification);
      one["scale"] = scale_in_words(enlargement(stage.steps.front(), step));
    }
    return one;
  });
}

Json slider(const StageSlider& slider) {
  const Json readouts = json_list(slider.readouts, [](const StageReadout& readout) {
    return Json{{"label", readout.label}, {"coefficients", json_list(readout.coefficients, json_number)}};
  });
  return {{"symbol", slider.symbol},
          {"origin", vector_json(slider.origin)},
          {"direction", vector_json(slider.direction)},
          {"from", json_number(slider.from)},
          {"to", json_number(slider.to)},
          {"start", json_number(slider.start)},
          {"shows_point", slider.shows_point},
          {"readouts", readouts}};
}

}  // namespace

std::string stage_json(const Stage& stage) {
  Json json{{"name", stage.name},
            {"title", stage.title},
            {"sentence", stage.sentence},
            {"method", stage.method},
            {"source", stage.source},
            {"conclusion", stage.conclusion},
            {"precision", name_of(stage.precision)},
            {"digits", stage.digits}};
  json["case"] = read_json(write_case(stage.one));
  json["scene"] = items(stage.scene);
  json["steps"] = steps(stage);
  if (stage.slider) json["slider"] = slider(*stage.slider);
  json["camera"] = {{"right", vector_json(stage.camera.right)},
                    {"up", vector_json(stage.camera.up)},
                    {"toward", vector_json(stage.camera.toward)},
                    {"flat", stage.camera.is_flat}};
  return write_json(json);
}

}  // namespace rayproof::viz

#include <algorithm>
#include <cmath>
#include <rayproof/formulas/largest_axis.hpp>

#include "viz/scene/items.hpp"
#include "viz/trace/numbers.hpp"
#include "viz/walkthrough/bindings.hpp"
#include "viz/walkthrough/setting.hpp"

namespace rayproof::viz {
namespace {

/// As the ray sees it: it is the z axis, and its own point is (0, 0).
Items sheared_scene(const NumbersByName& n) {
  Items items = triangle_items(n.vector("a"), n.vector("b"), n.vector("c"));
  items.push_back(point(Role::ray, {0, 0, 0}, "the ray"));
  return items;
}

/// The side of an edge on which the ray passes, as the kernel has its sign.
Binding side(const char* name, const char* first, const char* second) {
  return {name, [=](const NumbersByName& n) {
            const Role role = n.rounded(name) < 0 ? Role::claimed : Role::edge;
            return Items{segment(role, n.vector(first), n.vector(second), with_sign(name, n))};
          }};
}

Items depths(const NumbersByName& n) {
  Items items{point(Role::nearest, {0, 0, 0}, "z = " + rough(n["z"], 4))};
  for (const char* corner : {"a", "b", "c"}) {
    const glm::dvec3 p = n.vector(corner);
    items.push_back(point(Role::nearest, p, "z = " + rough(p.z, 4)));
  }
  return items;
}

/// The three triangles whose areas over the whole are the coordinates.
Items weights(const NumbersByName& n, const glm::dvec3& normal) {
  const auto flat = [&](const char* name) { return dropped(normal, n.input(name)); };
  const glm::dvec3 a = flat("a"), b = flat("b"), c = flat("c"), q = flat("q");
  const auto part = [&](Role role, const glm::dvec3& u, const glm::dvec3& v, const char* name) {
    const bool is_printed = name == std::string_view("β") && n.has("λ₂");
    if (is_printed) return polygon(role, {q, u, v}, "λ₂ = " + rough(n["λ₂"], 3));
    return polygon(role, {q, u, v}, n.has(name) ? name + (" = " + rough(n[name], 3)) : std::string(name));
  };
  Items items{part(Role::edge, b, c, "α"), part(Role::nearest, c, a, "β"), part(Role::normal, a, b, "γ")};
  for (const glm::dvec3& corner : {a, b, c}) items.push_back(segment(Role::edge, q, corner));
  return items;
}

}  // namespace

Items triangle_items(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  Items items = outlined(Role::surface, {a, b, c});
  append(items, {point(Role::surface, a, "a"), point(Role::surface, b, "b"), point(Role::surface, c, "c")});
  return items;
}

std::function<glm::dvec3(const glm::dvec3&)> flat_on(const StageCamera& camera) {
  return [=](const glm::dvec3& p) { return p.x * camera.right + p.y * camera.up; };
}

glm::dvec3 dropped(const glm::dvec3& n, const glm::dvec3& p) {
  const Vec2<double> flat = LargestAxisLast<double>(n).dropped(p);
  return {flat.x, flat.y, 0};
}

const StepSpace* space_of(const Setting& setting, const Walkthrough& walk, std::size_t index) {
  const StepSpace* found = nullptr;
  for (std::size_t i = 0; i <= index; ++i) {
    for (const StepSpace& space : setting.spaces)
      if (walk.steps[i].title.starts_with(space.first_step)) found = &space;
  }
  return found != nullptr && found->scene ? found : nullptr;
}

Setting in_space(Setting setting, const StepSpace& space) {
  setting.to_world = space.place;
  if (!space.bindings.empty()) setting.bindings = space.bindings;
  return setting;
}

std::vector<StepSpace> triangle_spaces(const Walkthrough& walk, const StageCamera& camera) {
  std::vector<StepSpace> spaces;
  bool is_projected = false;
  for (const WalkStep& step : walk.steps) {
    if (step.title.starts_with("Shear the vertices"))
      spaces.push_back({step.title,
                        "Drawn in the sheared space, looking back along the ray toward o.",
                        sheared_scene,
                        flat_on(camera),
                        {side("U", "b", "c"), side("V", "c", "a"), side("W", "a", "b"), {"z", depths}},
                        true});
    is_projected = is_projected || step.title.starts_with("Project along");
    if (!step.title.starts_with("Find the barycentric coordinates")) continue;
    const auto normal_of = [is_projected](const NumbersByName& n) {
      return is_projected ? n.vector("n") : glm::dvec3(0, 0, 1);
    };
    const auto scene = [=](const NumbersByName& n) {
      const auto flat = [&](const char* name) { return dropped(normal_of(n), n.input(name)); };
      Items items = triangle_items(flat("a"), flat("b"), flat("c"));
      items.push_back(point(Role::nearest, flat("q"), "q"));
      return items;
    };
    const Binding areas{"D", [=](const NumbersByName& n) { return weights(n, normal_of(n)); }};
    spaces.push_back({step.title, "Drawn in the projection.", scene, flat_on(camera), {areas}, true});
  }
  return spaces;
}

void show_in_space(StageStep& step, const StepSpace& space, const NumbersByName& n, const StageCamera& camera,
                   Items& earlier) {
  Items own;
  own.swap(step.items);
  for (StageItem item : space.scene(n)) {
    for (glm::dvec3& p : item.points) p = space.place(p);
    step.items.push_back(std::move(item));
  }
  append(step.items, earlier);
  append(step.items, own);
  for (StageItem& item : own) {
    item.role = Role::muted;
    earlier.push_back(std::move(item));
  }
  step.is_apart = true;
  step.is_other_space = !space.is_flat;
  step.magnification = space.magnification;
  step.view = view_of(extent_of(step.items, camera), camera);
  step.view.radius *= 1.05;
  step.words = space.words + (step.words.empty() ? "" : " ") + step.words;
  step.caption = space.words + " " + step.caption;
}

}  // namespace rayproof::viz

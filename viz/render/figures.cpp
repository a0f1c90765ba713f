/// \file
/// What every shape's figures are made by: the method's kernel inlined in the loop over the rays.
#include "viz/render/figures.hpp"

#include <rayproof/objects/bounds_of.hpp>
#include <rayproof/topics.hpp>

#include "subjects/reading.hpp"

namespace rayproof::render {
namespace {

template <class Topic, class T>
struct PlacedShape {
  decltype(Topic::template Problem<T>::shape) shape;
  std::optional<ObjectSpace<T>> space;
  ObjectIndex object;
};

/// Out of line: every method is compiled once, not once for each caller.
template <class Method, class Placed, class T>
[[gnu::noinline]] void meet_each(const Placed& figure, std::span<const Ray<T>> rays,
                                 std::span<Nearest<T>> nearest) {
  for (std::size_t i = 0; i < rays.size(); ++i)
    nearest[i].offer(rayproof::nearest<T>(rays[i], Method::roots(rays[i], figure.shape)), figure.object);
}

template <class Method, class Placed, class T>
void meet_figure(const Placed& figure, std::span<const Ray<T>> rays, std::span<Nearest<T>> nearest) {
  if (!figure.space) return meet_each<Method>(figure, rays, nearest);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if constexpr (takes_transforms<Method, T, decltype(figure.shape)>) {
      const auto roots = Method::roots_in_world(*figure.space, rays[i], figure.shape);
      nearest[i].offer(rayproof::nearest<T>(rays[i], roots), figure.object);
    } else {
      const Ray<T> in_object_space = to_object(*figure.space, rays[i]);
      meet_each<Method>(figure, std::span(&in_object_space, 1), nearest.subspan(i, 1));
    }
  }
}

template <class Method, class Topic, class T>
Figures<T> figures_by(const Members& members) {
  std::vector<PlacedShape<Topic, T>> figures;
  figures.reserve(members.objects.size());
  for (const ObjectIndex index : members.objects) {
    const Object& object = members.scene->objects[index];
    const RayQuestion question{{}, object.shape, object.transform};
    figures.push_back(
        {convert<T>(Reading<Topic>::shape(question)), Reading<Topic>::template space<T>(question), index});
  }
  return [figures = std::move(figures)](std::optional<std::size_t> only, std::span<const Ray<T>> rays,
                                        std::span<Nearest<T>> nearest) {
    if (only) return meet_figure<Method>(figures[*only], rays, nearest);
    for (const auto& figure : figures) meet_figure<Method>(figure, rays, nearest);
  };
}

template <class Topic, class T>
[[nodiscard]] Figures<T> make_figures(std::string_view method, const Members& members) {
  Figures<T> figures;
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    if (method == Method::name) figures = figures_by<Method, Topic, T>(members);
  });
  return figures;
}

template <class Topic>
[[nodiscard]] FigureKind figure_kind() {
  FigureKind kind{Topic::name, Topic::Plain::name};
  Topic::Methods::for_each(
      [&]<class Method>(std::type_identity<Method>) { kind.methods.emplace_back(Method::name); });
  kind.in_float = make_figures<Topic, float>;
  kind.in_double = make_figures<Topic, double>;
  kind.bounds = [](const Object& object) {
    const RayQuestion question{{}, object.shape, object.transform};
    return objects::bounds_of(Reading<Topic>::shape(question),
                              Reading<Topic>::template space<double>(question));
  };
  return kind;
}

}  // namespace

const std::vector<FigureKind>& figure_kinds() {
  static const std::vector<FigureKind> kinds = [] {
    std::vector<FigureKind> all;
    Topics::for_each([&]<class Topic>(std::type_identity<Topic>) {
      if constexpr (requires(typename Topic::template Problem<float> problem) { problem.shape; })
        all.push_back(figure_kind<Topic>());
    });
    return all;
  }();
  return kinds;
}

}  // namespace rayproof::render

/// \file
/// What every shape's figures are made by: the method's kernel inlined in the loop over the rays.
#include "viz/render/figures.hpp"

#include <rayproof/objects/bounds_of.hpp>
#include <rayproof/topics.hpp>

#include "subjects/reading.hpp"

namespace rayproof::render {
namespace {

template <class Topic, class Method, class T>
class MethodFigures final : public Figures<T> {
 public:
  explicit MethodFigures(const Members& members) {
    figures_.reserve(members.objects.size());
    for (const ObjectIndex index : members.objects) {
      const Object& object = members.scene->objects[index];
      const RayQuestion question{{}, object.shape, object.transform};
      figures_.push_back(
          {convert<T>(Reading<Topic>::shape(question)), Reading<Topic>::template space<T>(question), index});
    }
  }

  void meet_all(std::span<const Ray<T>> rays, std::span<Nearest<T>> nearest) const override {
    for (const PlacedShape& figure : figures_) {
      if (figure.space) {
        for (std::size_t i = 0; i < rays.size(); ++i) meet_placed(figure, rays[i], nearest[i]);
      } else {
        meet_each(figure, rays, nearest);
      }
    }
  }

  void meet(std::size_t figure, const Ray<T>& ray, Nearest<T>& nearest) const override {
    const PlacedShape& asked = figures_[figure];
    if (asked.space)
      meet_placed(asked, ray, nearest);
    else
      meet_each(asked, {&ray, 1}, {&nearest, 1});
  }

 private:
  struct PlacedShape {
    decltype(Topic::template Problem<T>::shape) shape;
    std::optional<ObjectSpace<T>> space;
    ObjectIndex object;
  };

  /// Out of line: every method is compiled once, not once for each caller.
  [[gnu::noinline]] static void meet_each(const PlacedShape& figure, std::span<const Ray<T>> rays,
                                          std::span<Nearest<T>> nearest) {
    for (std::size_t i = 0; i < rays.size(); ++i)
      nearest[i].offer(rayproof::nearest<T>(rays[i], Method::roots(rays[i], figure.shape)), figure.object);
  }

  static void meet_placed(const PlacedShape& figure, const Ray<T>& ray, Nearest<T>& nearest) {
    if constexpr (takes_transforms<Method, T, decltype(figure.shape)>) {
      const auto roots = Method::roots_in_world(*figure.space, ray, figure.shape);
      nearest.offer(rayproof::nearest<T>(ray, roots), figure.object);
    } else {
      const Ray<T> in_object_space = to_object(*figure.space, ray);
      meet_each(figure, {&in_object_space, 1}, {&nearest, 1});
    }
  }

  std::vector<PlacedShape> figures_{};
};

template <class Topic, class T>
[[nodiscard]] std::unique_ptr<Figures<T>> make_figures(std::string_view method, const Members& members) {
  std::unique_ptr<Figures<T>> figures;
  Topic::Methods::for_each([&]<class Method>(std::type_identity<Method>) {
    if (method == Method::name) figures = std::make_unique<MethodFigures<Topic, Method, T>>(members);
  });
  return figures;
}

/// What a topic's shape brings to a scene.
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

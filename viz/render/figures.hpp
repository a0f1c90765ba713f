#pragma once
/// \file
/// Figures of one shape, met by one method in one precision: the choice is made once a tile, not once a ray.

#include <memory>
#include <span>
#include <string_view>

#include "viz/render/hits.hpp"

namespace rayproof::render {

template <class T>
class Figures {
 public:
  Figures() = default;
  Figures(const Figures&) = delete;
  Figures& operator=(const Figures&) = delete;
  virtual ~Figures() = default;

  /// Intersects every figure with every ray; `nearest` has one element for each of them.
  virtual void meet_all(std::span<const Ray<T>> rays, std::span<Nearest<T>> nearest) const = 0;
  /// Intersects one figure with one ray.
  virtual void meet(std::size_t figure, const Ray<T>& ray, Nearest<T>& nearest) const = 0;
};

/// The objects of a scene that are of one shape.
struct Members {
  const RenderScene* scene;
  std::vector<ObjectIndex> objects;
};

/// The method of that name over the objects; null where the shape has none of that name.
template <class T>
using MakeFigures = std::unique_ptr<Figures<T>> (*)(std::string_view method, const Members& members);

/// What a shape brings to a scene.
struct FigureKind {
  std::string shape;                   ///< "sphere"
  std::string default_method;          ///< "centred": the topic's plain one
  std::vector<std::string> methods{};  ///< all that can render
  MakeFigures<float> in_float = nullptr;
  MakeFigures<double> in_double = nullptr;
  /// A box that holds an object of the shape; nothing for a shape without end, which every ray asks.
  std::optional<objects::Bounds> (*bounds)(const Object& object) = nullptr;

  template <class T>
  [[nodiscard]] MakeFigures<T> make() const {
    if constexpr (std::is_same_v<T, float>)
      return in_float;
    else
      return in_double;
  }
};

// Each in figures/NAME.cpp.
FigureKind plane_figures();
FigureKind triangle_figures();
FigureKind polygon_figures();
FigureKind sphere_figures();
FigureKind box_figures();
FigureKind parallelepiped_figures();
FigureKind cylinder_figures();

inline constexpr FigureKind (*figure_makers[])() = {
    plane_figures,           //
    triangle_figures,        //
    polygon_figures,         //
    sphere_figures,          //
    box_figures,             //
    parallelepiped_figures,  //
    cylinder_figures,        //
};

/// Every shape that a ray can meet, in the order of the registries.
[[nodiscard]] const std::vector<FigureKind>& figure_kinds();

}  // namespace rayproof::render

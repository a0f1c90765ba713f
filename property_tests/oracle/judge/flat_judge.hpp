#pragma once
/// \file
/// The judges' view of a plane: what plane, triangle and polygon share.

#include "oracle/geometry/flat.hpp"
#include "oracle/judge/judging.hpp"

namespace rayproof::oracle {

/// A flat figure: one hit at most, where the line meets the plane within the figure.
class FlatFigure : public Figure {
 public:
  /// `size` bounds the length of the plane's normal as the figure's numbers give it, `position` the distance
  /// of those numbers from the origin of coordinates.
  FlatFigure(const RayQuestion& question, const FlatEquation& plane, Scaled size, Scaled position)
      : question_(question),
        ray_(question),
        meeting_(ray_, plane),
        sizes_(question, ray_),
        size_(size * abs(approximate(ray_.scale))),
        position_(position) {}

  [[nodiscard]] std::vector<ExactNumber> hits() const override;
  [[nodiscard]] Scaled residual(double t) const override;
  /// Of the ends of the interval; and of an open end, how near the ray is to being parallel.
  [[nodiscard]] Scaled margin() const override;

 protected:
  /// Whether the figure holds the point in which the line, not parallel, meets the plane.
  [[nodiscard]] virtual bool holds_meeting() const { return true; }

  [[nodiscard]] const ObjectRay<Ring>& ray() const { return ray_; }
  [[nodiscard]] const FlatMeeting& meeting() const { return meeting_; }
  [[nodiscard]] const RaySizes& sizes() const { return sizes_; }
  [[nodiscard]] const Scaled& size() const { return size_; }
  /// L(t) of the contracts.
  [[nodiscard]] Scaled reach(const Scaled& t) const {
    return sizes_.origin + position_ + abs(t) * sizes_.direction;
  }
  /// |normal·direction| / (N·|direction|): how near the ray is to being parallel.
  [[nodiscard]] Scaled steepness() const {
    return ratio(abs(approximate(meeting_.slope)), size_ * sizes_.direction);
  }

 private:
  const RayQuestion& question_;
  ObjectRay<Ring> ray_;
  FlatMeeting meeting_;
  RaySizes sizes_;
  Scaled size_, position_;
};

}  // namespace rayproof::oracle

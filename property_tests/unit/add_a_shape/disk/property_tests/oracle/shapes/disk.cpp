#include "oracle/shapes/disk.hpp"

#include "oracle/judge/flat_judge.hpp"

namespace rayproof::oracle {
namespace {

FlatEquation rim_plane(const Disk<double>& disk) {
  const auto normal = Vector<Ring>::from(disk.normal);
  return {normal, dot(normal, Vector<Ring>::from(disk.center))};
}

/// Where a line that is not parallel meets the disk's plane, seen from the centre: q, times slope and scale.
struct Offset {
  Vector<Ring> q;
  Ring weight;  ///< slope·scale

  Offset(const ObjectRay<Ring>& ray, const FlatMeeting& meeting, const Disk<double>& disk)
      : q(meeting.slope * (ray.origin - ray.scale * Vector<Ring>::from(disk.center)) +
          meeting.gap * ray.direction),
        weight(meeting.slope * ray.scale) {}

  /// (|q|² - r²) times the weight's square: its sign says whether the point is outside, on the rim or inside.
  [[nodiscard]] Ring beyond(double radius) const {
    const Ring reach = Ring(radius) * weight;
    return dot(q, q) - reach * reach;
  }
};

class DiskFigure final : public FlatFigure {
 public:
  DiskFigure(const RayQuestion& question, const Disk<double>& disk)
      : FlatFigure(question, rim_plane(disk), norm(disk.normal), norm(disk.center) + Scaled(disk.radius)),
        disk_(disk) {}

  [[nodiscard]] Scaled margin() const override {
    Scaled nearest = FlatFigure::margin();
    reduce(nearest, steepness());
    if (!meeting().is_parallel()) reduce(nearest, from_rim());
    return nearest;
  }

 protected:
  [[nodiscard]] bool holds_meeting() const override { return sign(offset().beyond(disk_.radius)) <= 0; }

 private:
  [[nodiscard]] Offset offset() const { return {ray(), meeting(), disk_}; }

  /// ||q| - r|·s / L(t), with s = steepness.
  [[nodiscard]] Scaled from_rim() const {
    const Offset met = offset();
    const Scaled weight = abs(approximate(met.weight));
    const Scaled sum = norm(met.q) + Scaled(disk_.radius) * weight;
    const Scaled distance = ratio(ratio(abs(approximate(met.beyond(disk_.radius))), sum), weight);
    return ratio(distance * steepness(), reach(meeting().t().estimate()));
  }

  const Disk<double>& disk_;
};

}  // namespace

RayAnswer answer(const RayQuestion& question, const Disk<double>& disk, Precision precision) {
  const ObjectRay<Ring> ray(question);
  const FlatEquation plane = rim_plane(disk);
  const FlatMeeting meeting(ray, plane);
  RayAnswer miss;
  if (meeting.is_parallel()) {
    miss.contact = meeting.parallel_contact();
    return miss;
  }
  const int side = sign(Offset(ray, meeting, disk).beyond(disk.radius));
  const Quotient t = meeting.t();
  if (side > 0 || !is_in_interval(t, question.ray)) return miss;
  return flat_answer(question, ray, plane.normal, t, side == 0 ? Contact::rim : Contact::crossing, precision);
}

Judgement judge(const RayQuestion& question, const Disk<double>& disk, Precision precision,
                const RayAnswer& claimed) {
  return judge_hits(question, DiskFigure(question, disk), precision, claimed);
}

}  // namespace rayproof::oracle

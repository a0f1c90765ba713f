#pragma once
/// \file
/// The camera of raycasting: one ray through each pixel of an image.

#include <numbers>
#include <rayproof/method/method.hpp>
#include <rayproof/ray.hpp>

#include <rayproof/rounding/as_written.hpp>

namespace rayproof {

/// An eye that looks at `center`, `up` pointing upwards in the image. The image plane lies at distance 1 from
/// the eye and is 2·half_width wide and 2·half_height high there: half_width is tan(fov_x/2) for the angle of
/// view fov_x, and half_height tan(fov_y/2) (`half_extent`). `center` is not the eye, and `up` not along the
/// line through both.
template <class T>
struct Camera {
  vec3<T> eye, center, up;
  T half_width, half_height;
};

/// tan(fov/2) of an angle of view in degrees, 0 < fov < 180; exactly 1 at 90 degrees.
[[nodiscard]] inline double half_extent(double fov_in_degrees) {
  return fov_in_degrees == 90 ? 1 : std::tan(fov_in_degrees * (std::numbers::pi / 360));
}

/// The camera's own right-handed axes, of unit length: u to the right, v upwards, w backwards, so that the
/// camera looks along -w.
template <class T>
struct CameraAxes {
  vec3<T> u, v, w;
};

/// The size of an image in pixels, whole numbers.
template <class T>
struct ImageSize {
  T width, height;
};

namespace camera {

/// In units of ε/sin(up, w), ε the unit roundoff.
inline constexpr Bound axes_error{.measured = 4.30, .promised = 8};

/// w = (eye - center)/|eye - center|, u = (up × w)/|up × w|, v = w × u.
///
/// Every component is within `axes_error` of the true one; NaN or infinite where `up` is along w, or a square
/// overflows. Source: R. Bán, "Számítógépes grafika: Raycasting", 2022.
template <class T>
[[nodiscard]] CameraAxes<T> axes(const Camera<T>& camera) {
  step<T>("Look along -w, from the eye to the centre",
          "w = (eye − center) / |eye − center| is the unit vector from the centre back to the eye.");
  const vec3<T> w = named("w", normalized<T>(camera.eye - camera.center));

  step<T>("Turn u to the right of both up and w",
          "u = up × w / |up × w| is a unit vector perpendicular to both: horizontal in the image.");
  const vec3<T> u = named("u", normalized<T>(cross(camera.up, w)));

  step<T>("Complete the right-handed axes by v",
          "v is perpendicular to u and w and points upwards in the image; it is a unit vector already.");
  const vec3<T> v = named("v", vec3<T>(cross(w, u)));
  return {u, v, w};
}

/// The ray from the eye through a point of the image, (i, j) pixels to the right of and below its top left
/// corner. It is not made a unit vector: t is 1 on the image plane, wherever the ray pierces it.
template <class T>
[[nodiscard]] constexpr Ray<T> ray_through(const Camera<T>& camera, const CameraAxes<T>& axes,
                                           const ImageSize<T>& image, const T& i, const T& j) {
  const T half_w = T(0.5) * image.width, half_h = T(0.5) * image.height;
  const T across = named("x", (i - half_w) / half_w);
  const T upwards = named("y", (half_h - j) / half_h);

  step<T>("Scale to the image plane at distance 1",
          "There the image is 2·half_w wide and 2·half_h high, so x and y from -1 to 1 are multiplied by "
          "half_w and half_h, the tangents of half the angles of view.");
  const T alpha = named("α", camera.half_width * across);
  const T beta = named("β", camera.half_height * upwards);

  step<T>("Shoot from the eye through that point",
          "d leads from the eye to that point, so t is 1 on the image plane.");
  return {camera.eye, named("d", vec3<T>(alpha * axes.u + beta * axes.v - axes.w))};
}

/// The ray through the *centre* of pixel (i, j), i to the right and j down from the top left, both from 0.
///
/// The grid is symmetric about the camera's axis bit for bit: the pixels i and width-1-i have α of the same
/// magnitude and opposite signs, and so for j. Given the rounded camera and axes, every component of the
/// direction is within `error`. Sizes up to 2^23 in float.
/// Source: R. Bán, "Számítógépes grafika: Raycasting", 2022, in its words ("through the centre of each
/// pixel"), not its formula.
struct PixelCentre {
  static constexpr const char* name = "pixel_centre";
  static constexpr const char* title = "through the centres of the pixels";
  static constexpr Source source = sources::ban;
  /// In units of ε·(1 + half_width + half_height).
  static constexpr Bound error{.measured = 1.29, .promised = 4};

  template <class T>
  [[nodiscard]] static constexpr Ray<T> ray(const Camera<T>& camera, const CameraAxes<T>& axes,
                                            const ImageSize<T>& image, const T& i, const T& j) {
    step<T>("Place the pixel's centre in the image",
            "x and y go from -1 to 1 over the image; the centre is half a pixel from the corner (i, j).");
    return ray_through<T>(camera, axes, image, i + T(0.5), j + T(0.5));
  }
};

/// The same **as printed** in the source: i - width/2 and height/2 - j, which is a pixel's top left corner
/// though the text says its centre.
///
/// Kept so that a property refutes it (unit/lib/camera_test.cpp): mirrored pixels do not see mirrored rays,
/// the whole image is off by half a pixel, to the left and upwards.
struct PrintedPixelCorner {
  static constexpr const char* name = "printed_pixel_corner";
  static constexpr const char* title = "as printed: through the corners of the pixels";
  static constexpr Source source = PixelCentre::source;

  template <class T>
  [[nodiscard]] static constexpr Ray<T> ray(const Camera<T>& camera, const CameraAxes<T>& axes,
                                            const ImageSize<T>& image, const T& i, const T& j) {
    step<T>("Place the pixel in the image as printed",
            "Without the half pixel this is the pixel's corner, not its centre.");
    return ray_through(camera, axes, image, i, j);
  }
};

}  // namespace camera
}  // namespace rayproof

#include <rayproof/rounding/as_before.hpp>

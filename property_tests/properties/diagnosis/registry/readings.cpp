/// \file
/// Faults in how the numbers of a case are read.

#include "properties/diagnosis/models/space/coordinates.hpp"
#include "properties/diagnosis/models/space/details_of_shapes.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

/// That all is 0 alone would be small lengths taken for 0.
Hypothesis whole_shape() {
  return shown_by(has_area_cut_off,
                  gives_to_all("whole-shape", with_shape_cut_off,
                               "the answer is right for the shape's numbers, and a point's, cut off to whole "
                               "ones: they are read as integers"));
}

/// That all is moved to 0 would be small lengths taken for 0.
template <int cells>
Hypothesis shape_grid() {
  return shown_by(
      has_number_on_grid<cells>,
      gives_to_most(kept(fmt::format("shape-grid-{}", cells)), off_boundary_read_as<shape_on_grid<cells>>,
                    kept(fmt::format(
                        "the answer is right for the shape's numbers rounded to 1/{}: they are kept in fixed "
                        "point, or moved to a grid",
                        cells))));
}

template <int... cells>
void add_grids(std::vector<Hypothesis>& all) {
  (all.push_back(shape_grid<cells>()), ...);
}

}  // namespace

std::vector<Hypothesis> models_of_readings() {
  using enum Vectors;
  std::vector<Hypothesis> all{
      gives("origin-ignored", read_as<without_origin>,
            "the answer is right for a ray from the origin of coordinates: the ray's origin is ignored"),
      gives("direction-as-origin", read_as<direction_as_origin>,
            "the answer is right for a ray from the point d: the direction stands where the origin belongs"),
      strictly(gives("origin-x-ignored", read_as<without_coordinate<0>>,
                     "the answer is right for a ray from x = 0: x of the ray's origin is ignored")),
      strictly(gives("origin-y-ignored", read_as<without_coordinate<1>>,
                     "the answer is right for a ray from y = 0: y of the ray's origin is ignored")),
      strictly(gives("origin-z-ignored", read_as<without_coordinate<2>>,
                     "the answer is right for a ray from z = 0: z of the ray's origin is ignored")),
      gives("origin-negated", read_as<negated<origin>>,
            "the answer is right for the opposite origin: a sign is wrong at the ray's origin"),
      gives("direction-from-shape", read_as<direction_from_shape>,
            "the shape's place is subtracted from the direction, too, as if it were a point"),
      gives("direction-as-target", read_as<direction_as_target>,
            "the answer is right where the direction is a point of the ray: d - o is taken for d"),
      gives("points-x-y", read_as<exchanged<points, 0, 1>>,
            "the answer is right with x and y of the shape's points exchanged"),
      gives("points-y-z", read_as<exchanged<points, 1, 2>>,
            "the answer is right with y and z of the shape's points exchanged"),
      gives("points-x-z", read_as<exchanged<points, 0, 2>>,
            "the answer is right with x and z of the shape's points exchanged"),
      gives("vectors-x-y", read_as<exchanged<directions, 0, 1>>,
            "the answer is right with x and y exchanged in the shape's normal, edges or u and v"),
      gives("vectors-y-z", read_as<exchanged<directions, 1, 2>>,
            "the answer is right with y and z exchanged in the shape's normal, edges or u and v"),
      gives("vectors-x-z", read_as<exchanged<directions, 0, 2>>,
            "the answer is right with x and z exchanged in the shape's normal, edges or u and v"),
      gives("origin-x-y", read_as<exchanged<origin, 0, 1>>,
            "the answer is right with x and y of the ray's origin exchanged"),
      gives("origin-y-z", read_as<exchanged<origin, 1, 2>>,
            "the answer is right with y and z of the ray's origin exchanged"),
      gives("origin-x-z", read_as<exchanged<origin, 0, 2>>,
            "the answer is right with x and z of the ray's origin exchanged"),
      gives("direction-x-y", read_as<exchanged<direction, 0, 1>>,
            "the answer is right with x and y of the direction exchanged"),
      gives("direction-y-z", read_as<exchanged<direction, 1, 2>>,
            "the answer is right with y and z of the direction exchanged"),
      gives("direction-x-z", read_as<exchanged<direction, 0, 2>>,
            "the answer is right with x and z of the direction exchanged"),
      gives("place-ignored", read_as<place_ignored>,
            "the answer is right for a shape with its first point, or corner, at the origin of coordinates: "
            "that point is not subtracted from the ray's origin"),
      strictly(gives("points-x-ignored", read_as<without<points, 0>>,
                     "the answer is right with x = 0 for the shape's points: their x is ignored")),
      strictly(gives("points-y-ignored", read_as<without<points, 1>>,
                     "the answer is right with y = 0 for the shape's points: their y is ignored")),
      strictly(gives("points-z-ignored", read_as<without<points, 2>>,
                     "the answer is right with z = 0 for the shape's points: their z is ignored")),
      gives("points-x-for-y", read_as<copied<points, 0, 1>>,
            "the answer is right with x of the shape's points in the place of y"),
      gives("points-x-for-z", read_as<copied<points, 0, 2>>,
            "the answer is right with x of the shape's points in the place of z"),
      gives("points-y-for-x", read_as<copied<points, 1, 0>>,
            "the answer is right with y of the shape's points in the place of x"),
      gives("points-y-for-z", read_as<copied<points, 1, 2>>,
            "the answer is right with y of the shape's points in the place of z"),
      gives("points-z-for-x", read_as<copied<points, 2, 0>>,
            "the answer is right with z of the shape's points in the place of x"),
      gives("points-z-for-y", read_as<copied<points, 2, 1>>,
            "the answer is right with z of the shape's points in the place of y"),
      gives("origin-x-for-y", read_as<copied<origin, 0, 1>>,
            "the answer is right with x of the ray's origin in the place of y"),
      gives("origin-x-for-z", read_as<copied<origin, 0, 2>>,
            "the answer is right with x of the ray's origin in the place of z"),
      gives("origin-y-for-x", read_as<copied<origin, 1, 0>>,
            "the answer is right with y of the ray's origin in the place of x"),
      gives("origin-y-for-z", read_as<copied<origin, 1, 2>>,
            "the answer is right with y of the ray's origin in the place of z"),
      gives("origin-z-for-x", read_as<copied<origin, 2, 0>>,
            "the answer is right with z of the ray's origin in the place of x"),
      gives("origin-z-for-y", read_as<copied<origin, 2, 1>>,
            "the answer is right with z of the ray's origin in the place of y"),
      gives("direction-x-for-y", read_as<copied<direction, 0, 1>>,
            "the answer is right with x of the direction in the place of y"),
      gives("direction-x-for-z", read_as<copied<direction, 0, 2>>,
            "the answer is right with x of the direction in the place of z"),
      gives("direction-y-for-x", read_as<copied<direction, 1, 0>>,
            "the answer is right with y of the direction in the place of x"),
      gives("direction-y-for-z", read_as<copied<direction, 1, 2>>,
            "the answer is right with y of the direction in the place of z"),
      gives("direction-z-for-x", read_as<copied<direction, 2, 0>>,
            "the answer is right with z of the direction in the place of x"),
      gives("direction-z-for-y", read_as<copied<direction, 2, 1>>,
            "the answer is right with z of the direction in the place of y"),
      gives_to_all("point-x-y", read_as<point_exchanged>,
                   "the answer is right with x and y of the point exchanged"),
      gives_to_all("whole-point", off_boundary_read_as<point_cut_off>,
                   "the answer is right for the point cut off to whole numbers: it is read as integers"),
      gives_to_all("grid-1", off_boundary_read_as<point_on_grid<1>>,
                   "the answer is right for the point rounded to whole numbers: it is moved to a grid"),
      gives_to_all("grid-10", off_boundary_read_as<point_on_grid<10>>,
                   "the answer is right for the point rounded to tenths: it is moved to a grid"),
      gives_to_all("grid-16", off_boundary_read_as<point_on_grid<16>>,
                   "the answer is right for the point rounded to sixteenths: it is moved to a grid"),
      gives_to_all("grid-100", off_boundary_read_as<point_on_grid<100>>,
                   "the answer is right for the point rounded to hundredths: it is moved to a grid"),
      gives_to_all("grid-256", off_boundary_read_as<point_on_grid<256>>,
                   "the answer is right for the point rounded to 1/256: it is moved to a grid"),
      gives_to_all("grid-1000", off_boundary_read_as<point_on_grid<1000>>,
                   "the answer is right for the point rounded to thousandths: it is moved to a grid"),
      gives_to_all(
          "whole-points", read_as<truncated<points>>,
          "the answer is right for the shape's points cut off to whole numbers: they are read as integers"),
      whole_shape(),
      of(OfSizes::type,
         gives(
             "shape-in-float", with_shape_in_float,
             "the answer is right for the shape's numbers, and a point's, rounded to floats, though the case "
             "is of float64",
             rounding)),
      gives_to_most(
          "shape-in-half", off_boundary_read_as<numbers_in_half>,
          "the answer is right for the shape's numbers rounded to 11 bits: they are kept as half floats"),
      gives_to_all(
          "whole-sizes", read_as<whole_sizes>,
          "the answer is right for radii, and a height, cut off to whole numbers: they are read as integers"),
      gives_to_all("whole-origin", read_as<truncated<origin>>,
                   "the answer is right for the origin cut off to whole numbers: it is read as integers"),
      gives_to_all("whole-direction", read_as<truncated<direction>>,
                   "the answer is right for the direction cut off to whole numbers: it is read as integers"),
      gives("exponents-dropped", read_as<without_exponents>,
            "the answer is right for numbers without their exponents: 1e-07 is read as 1"),
      gives_one_of("whole-numbers-in-32-bits", whole_numbers_in_32_bits,
                   "whole numbers beyond 2^31 are read as integers of 32 bits, which do not hold them"),
  };
  add_grids<10, 16, 64, 100, 256, 1000, 1024, 65536>(all);
  return all;
}

}  // namespace rayproof::diagnosis

/// \file
/// Faults in how the numbers of a case are read.

#include "properties/diagnosis/models/coordinates.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {

std::vector<Hypothesis> models_of_readings() {
  using enum Vectors;
  return {
      gives("origin-ignored", read_as<without_origin>,
            "the answer is right for a ray from the origin of coordinates: the ray's origin is ignored"),
      gives("origin-negated", read_as<negated<origin>>,
            "the answer is right for the opposite origin: a sign is wrong at the ray's origin"),
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
      gives_to_all(
          "whole-shape", read_as<truncated_shape>,
          "the answer is right for the shape's numbers cut off to whole ones: they are read as integers"),
      gives_to_all("whole-origin", read_as<truncated<origin>>,
                   "the answer is right for the origin cut off to whole numbers: it is read as integers"),
      gives_to_all("whole-direction", read_as<truncated<direction>>,
                   "the answer is right for the direction cut off to whole numbers: it is read as integers"),
  };
}

}  // namespace rayproof::diagnosis

#include "viz/stage/words.hpp"

#include <map>
#include <optional>

namespace rayproof::viz {
namespace {

using NumberOf = std::function<std::string(const std::string& name)>;

/// The sentence with a number in the place of each {name}; nothing where a name has none.
std::optional<std::string> with_numbers(std::string sentence, const NumberOf& number_of) {
  for (std::size_t open = sentence.find('{'); open != std::string::npos; open = sentence.find('{', open)) {
    const std::size_t close = sentence.find('}', open);
    const std::string number = number_of(sentence.substr(open + 1, close - open - 1));
    if (number.empty()) return std::nullopt;
    sentence.replace(open, close + 1 - open, number);
  }
  return sentence;
}

/// What a step that names nothing puts its numbers into: the first sentence whose names are all known.
std::string numbers_for(const std::string& title, const NumberOf& number_of) {
  static const std::multimap<std::string, std::string> all{
      {"Meet both planes of each axis", "Its ends: (min - o)·(1/d) = {min - o}·{1/d} and {max - o}·{1/d}."},
      {"Meet both planes of each axis", "Its ends: (min - o) / d = {min - o} / {d} and {max - o} / {d}."},
      {"Project along the normal's largest axis", "n = {n}."},
      {"Meet the planes of both ends", "They stand at z = 0 and z = {height}."},
  };
  const auto [first, last] = all.equal_range(title);
  for (auto one = first; one != last; ++one) {
    if (const auto sentence = with_numbers(one->second, number_of)) return " " + *sentence;
  }
  return "";
}

}  // namespace

std::string words_for(const std::string& title, const NumberOf& number_of) {
  static const std::map<std::string, std::string> all{
      {"Move the centre to the origin", "Only the way from the centre to the ray's start matters."},
      {"Find the ray point nearest the centre",
       "At t_c the way l from the centre stands at right angles to the ray."},
      {"Compare its distance with the radius", "If l is shorter than the radius, the ray comes inside."},
      {"Go half a chord to either side", "Hits lie h before and h after the nearest point."},
      {"Put the ray into the sphere's equation", "|o + t·d − C|² = r² is a quadratic equation in t."},
      {"Form the discriminant",
       "Its sign says how many roots there are; its digits are what is left of two large numbers."},
      {"Apply the quadratic formula", "One root on either side of −b/2a."},
      {"Apply the formula upside down", "The same two roots, with the sum in the denominator."},
      {"Add up b and √D where they have one sign",
       "Of the two branches take the one in which nothing cancels."},
      {"Take one root from q and the other from Viète",
       "The product of the roots is c/a: the small one follows from the large."},
      {"Put the ray into the plane's equation",
       "What the equation leaves at the origin, and what one direction changes of it."},
      {"Solve it for t", "So many directions bring the equation to 0."},
      {"Compare the way to the plane with the way the ray gains on it",
       "Both are measured along the normal."},
      {"Find a point and the normal of the plane",
       "Of an implicit plane, the point nearest the world's origin."},
      {"Form the determinant of u, v and the direction",
       "It is the volume the three span: 0 for a ray along the plane."},
      {"Put w in the place of each column in turn",
       "Cramer's rule: each unknown is a quotient of two volumes."},
      {"Ask whether the point lies in the triangle",
       "It does where both parameters are at least 0 and their sum is at most 1."},
      {"Form the normal of the triangle", "At right angles to both edges; twice the area long."},
      {"Project along the normal's largest axis",
       "Leave out the coordinate in which the normal is largest: the shadow keeps most of the area."},
      {"Find the barycentric coordinates in the projection",
       "Three areas over the whole: the hit is inside where none is negative."},
      {"Form the edges from a, and the direction across one of them",
       "p stands across the ray and e₂; with e₁ it spans the volume D."},
      {"Find u from the way between the origin and a", "How far along e₁, measured across e₂ and the ray."},
      {"Find v and t from the same way across the other edge", "How far along e₂, and along the ray."},
      {"Call z the axis along which the ray is longest",
       "Dividing by the longest component, the shear is never steep."},
      {"Shear the vertices so that the ray becomes the z axis",
       "Seen along the ray, the triangle is flat and the ray is the point 0."},
      {"Find the side on which the ray passes each edge",
       "Each edge function has its exact sign; three of one sign are a hit."},
      {"Weigh the depths of the vertices", "The edge functions are the weights of the opposite vertices."},
      {"Measure the planes from the ray's origin", "Six distances along the axes."},
      {"Meet both planes of each axis",
       "Each pair of planes is a slab: an interval of t, drawn beside the ray."},
      {"Keep the last entry and the first exit", "The ray is inside while it is within all of them."},
      {"Invert the direction, once for all boxes", "A multiplication in place of a division for each plane."},
      {"Move the far end two ulps on", "A little more than rounding can take away."},
      {"Take the normals of the faces", "Each is the cross product of the two edges of its face."},
      {"Meet each pair of faces", "Two planes with one normal are a slab."},
      {"Scale the ellipse to the unit circle", "Divided by its semi-axes, the side is a circle of radius 1."},
      {"Find the point nearest the axis", "As with the sphere, in the plane across the axis."},
      {"Meet the planes of both ends", "Between the two planes the ray is at the cylinder's height."},
      {"Keep the roots between both ends", "A root of the endless side counts only there."},
  };
  const auto found = all.find(title);
  if (found != all.end()) return found->second + numbers_for(title, number_of);
  return title.starts_with("Take the ray into the")
             ? "The inverse map goes over the ray; t is the same number in both spaces."
             : "";
}

}  // namespace rayproof::viz

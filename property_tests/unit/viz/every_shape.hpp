#pragma once
/// \file
/// One tame ray, and a shape of every type and form that it hits.

#include <string>
#include <vector>

#include "case/reader.hpp"

namespace rayproof::viz {

inline constexpr const char* ray_head =
    R"({"precision":"float32","ray":{"origin":[0.25,0.25,-5],"direction":[0,0,1]},)";

[[nodiscard]] inline Case with_shape(const std::string& shape) { return read_case(ray_head + shape + "}"); }

[[nodiscard]] inline const std::vector<std::string>& shapes() {
  static const std::vector<std::string> all{
      R"("shape":{"type":"plane","normal":[0,0.5,1],"d":-1})",
      R"("shape":{"type":"plane","point":[0,0,1],"normal":[0,0.5,1]})",
      R"("shape":{"type":"plane","point":[0,0,1],"u":[1,0,0],"v":[0,1,-0.5]})",
      R"("shape":{"type":"triangle","a":[0,0,0],"b":[1,0,0],"c":[0,1,0]})",
      R"("shape":{"type":"polygon","vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]})",
      R"("shape":{"type":"sphere","center":[0,0,0],"radius":1})",
      R"("shape":{"type":"box","min":[-1,-1,-1],"max":[1,1,1]})",
      R"("shape":{"type":"parallelepiped","corner":[-1,-1,0],"edges":[[3,0,0],[0,3,0],[0,0,1]]})",
      R"("shape":{"type":"cylinder","rx":1,"ry":2,"height":1,"capped":true})"};
  return all;
}

}  // namespace rayproof::viz

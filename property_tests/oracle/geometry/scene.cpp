#include "oracle/geometry/scene.hpp"

#include "oracle/numbers/exact.hpp"

namespace rayproof::oracle {

bool is_singular(const glm::dmat4& matrix) { return sign(InverseMap<Ring>(matrix).determinant) == 0; }

}  // namespace rayproof::oracle

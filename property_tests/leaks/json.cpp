
#include "case/json/ordered.hpp"
#include "leaks/text.hpp"

namespace rayproof::leaks {

std::string json_text(const ClosedMesh& mesh, const LeakSettings& settings, const Result& result) {
  nlohmann::ordered_json subjects = nlohmann::ordered_json::array();
  for (const Outcomes& one : result.outcomes) {
    nlohmann::ordered_json targets;
    for (std::size_t i = 0; i < target_count; ++i)
      targets[target_names.at(i)] = {
          {"rays", one.rays.at(i)}, {"leaks", one.leaks.at(i)}, {"double_hits", one.doubles.at(i)}};
    subjects.push_back({{"subject", one.subject->full_name()},
                        {"precision", name_of(one.precision)},
                        {"rays", one.total(one.rays)},
                        {"leaks", one.total(one.leaks)},
                        {"leaks_from_inside", one.leaks_from_inside},
                        {"double_hits", one.total(one.doubles)},
                        {"unsupported", one.unsupported},
                        {"failed", one.failed},
                        {"targets", targets}});
  }
  const nlohmann::ordered_json whole{{"mesh", mesh.name},
                                     {"triangles", mesh.triangles.size()},
                                     {"seed", settings.seed},
                                     {"rays", settings.rays},
                                     {"subjects", subjects}};
  return write_json(whole, 2) + "\n";
}

}  // namespace rayproof::leaks

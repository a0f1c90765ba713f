#include <algorithm>
#include <iterator>

#include "bench/peers/peer.hpp"

namespace rayproof::report {

std::vector<PeerRoutine> peers_of(const std::string& topic, Precision precision) {
  std::vector<PeerRoutine> all;
  for (const auto made_by : {
           glm_peers,
#ifdef RAYPROOF_VTK_PEERS
           vtk_peers,
#endif
#ifdef RAYPROOF_HAS_EMBREE
           embree_peers,
#endif
           cgal_peers,
       })
    std::ranges::copy_if(made_by(), std::back_inserter(all), [&](const PeerRoutine& one) {
      return one.subject.topic == topic && one.subject.precisions.front() == precision;
    });
  return all;
}

std::vector<Contender> peer_contenders(const std::string& topic, const std::vector<Case>& cases,
                                       Precision precision) {
  std::vector<Contender> all;
  for (const PeerRoutine& peer : peers_of(topic, precision))
    std::ranges::move(peer.contenders(peer.subject.name, cases), std::back_inserter(all));
  return all;
}

}  // namespace rayproof::report

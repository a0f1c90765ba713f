/// \file
/// Faults in how a hit or a miss is named: crossing, edge, vertex, tangent, parallel.

#include <fmt/format.h>

#include "properties/diagnosis/models/curved/small_discriminant.hpp"
#include "properties/diagnosis/models/hits/contacts.hpp"
#include "properties/diagnosis/registry/lines.hpp"

namespace rayproof::diagnosis {
namespace {

Hypothesis of_contact(std::string_view name, Predict predict, std::string_view sentence) {
  return gives(name, predict, sentence, boundary, Aspect::contact);
}

template <int power>
Hypothesis edge_called_near() {
  return of_contact(
      kept(fmt::format("edge-called-near-1e{}", power)), called_by_weights<power>,
      kept(fmt::format("a hit is called edge, or vertex, where a barycentric coordinate is below "
                       "about 1e{}: a tolerance",
                       power)));
}

template <int power>
Hypothesis tangent_called_near() {
  return of_contact(
      kept(fmt::format("tangent-called-near-1e{}", power)), called_tangent_below<power>,
      kept(fmt::format("a hit is called tangent where the discriminant D is below about 1e{}: an "
                       "absolute tolerance on D",
                       power)));
}

}  // namespace

std::vector<Hypothesis> models_of_contacts() {
  return {
      of_contact("vertex-called-edge", called<Contact::vertex, Contact::edge>,
                 "a hit at a vertex is called edge"),
      of_contact("edge-called-vertex", called<Contact::edge, Contact::vertex>,
                 "a hit on an edge is called vertex"),
      edge_called_near<-9>(),
      edge_called_near<-8>(),
      edge_called_near<-7>(),
      edge_called_near<-6>(),
      edge_called_near<-5>(),
      edge_called_near<-4>(),
      edge_called_near<-3>(),
      edge_called_near<-2>(),
      edge_called_near<-1>(),
      tangent_called_near<-9>(),
      tangent_called_near<-8>(),
      tangent_called_near<-7>(),
      tangent_called_near<-6>(),
      tangent_called_near<-5>(),
      tangent_called_near<-4>(),
      tangent_called_near<-3>(),
      tangent_called_near<-2>(),
      tangent_called_near<-1>(),
      of_contact("crossing-called-edge", called<Contact::crossing, Contact::edge>,
                 "a hit inside the shape, far from its edges, is called edge"),
      gives("contact-parallel", in_surface_is_parallel, "a ray inside the plane is called parallel", gross,
            Aspect::contact),
      gives("contacts-exchanged", reasons_exchanged,
            "a ray inside the plane is called parallel, and one parallel to it is said to be inside: the two "
            "are exchanged",
            gross, Aspect::contact),
      following("asked-again",
                gives("no-reason", no_reason, "it does not say why the ray misses", gross, Aspect::contact)),
  };
}

}  // namespace rayproof::diagnosis

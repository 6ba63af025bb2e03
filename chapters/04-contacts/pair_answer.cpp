#include "chapters/04-contacts/pair_answer.hpp"

#include <nlohmann/json.hpp>

#include "chapters/04-contacts/parts.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {
namespace {

using Json = nlohmann::ordered_json;

Json vector(const Vec3& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

const char* state_of(const Separation& s) {
  const char* const names[] = {"separated", "touching", "penetrating"};
  return names[int(contact_of(s))];
}

Json contacts_of(const PlacedPair& pair, const Separation& s) {
  const auto& [a, b] = pair;
  const Manifold manifold = contact_manifold(a.shape, a.pose, b.shape, b.pose, s);
  Json contacts = Json::array();
  for (std::size_t i = 0; i < std::size_t(manifold.count); ++i)
    contacts.push_back({{"position", vector(manifold.points[i].position)},
                        {"depth", double(manifold.points[i].depth)}});
  return contacts;
}

}  // namespace

Json answer_to(const PlacedPair& pair, const PairMethod& method) {
  const auto& [a, b] = pair;
  const Separation s = method.query(a.shape, a.pose, b.shape, b.pose);
  Json answer;
  if (s.reason == Reason::no_answer || s.reason == Reason::out_of_range) {
    for (const char* name : {"state", "signed_distance", "normal", "witness_A",
                             "witness_B", "error", "contacts"})
      answer[name] = nullptr;
  } else {
    answer = {{"state", state_of(s)},
              {"signed_distance", double(s.distance)},
              {"normal", vector(s.normal)},
              {"witness_A", vector(s.on_a)},
              {"witness_B", vector(s.on_b)},
              {"error", double(s.error)},
              {"contacts", contacts_of(pair, s)}};
  }
  answer["iterations"] = s.iterations;
  answer["reason"] = name_of(s.reason);
  return answer;
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04

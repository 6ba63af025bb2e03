#include "chapters/04-contacts/pair_job.hpp"

#include <type_traits>

#include <nlohmann/json.hpp>

#include "chapters/04-contacts/pair_answer.hpp"
#include "chapters/04-contacts/parts.hpp"
#include "common/chapter/interrupt.hpp"

namespace timestep::inline TIMESTEP_PRECISION::chapter_04 {

std::string answer_pairs(const std::filesystem::path& file, const std::string& method) {
  using Json = nlohmann::ordered_json;
  Json answers = Json::array();
  for (const PairCase& one : read_pair_file(file)) {
    throw_if_interrupted();
    Json answer{{"id", one.id}};
    answer.update(answer_to(one.pair, method_named(method)));
    answers.push_back(std::move(answer));
  }
  const Json json{{"chapter", "04-contacts"},
                  {"pairs", file.string()},
                  {"method", method},
                  {"precision", std::is_same_v<Real, float> ? "single" : "double"},
                  {"cases", std::move(answers)}};

  // Invalid UTF-8, as a file's name may hold, is replaced rather than thrown at
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace timestep::inline TIMESTEP_PRECISION::chapter_04

#include "study/exit_code.hpp"

#include <exception>
#include <new>

#include "common/chapter/console.hpp"
#include "common/chapter/interrupt.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep::study {

int code_of(const std::string& program, const std::function<int()>& work,
            const std::string& interrupted) {
  constexpr int k_failed = 1, k_wrong_input = 2, k_interrupted = 130;
  const auto say = [&](const std::string& what, int code) {
    print_note(program, what);
    return code;
  };
  try {
    return work();
  } catch (const InputError& error) {
    return say(error.what(), k_wrong_input);
  } catch (const Interrupted&) {
    return say(interrupted, k_interrupted);
  } catch (const std::bad_alloc&) {
    return say("there is not enough memory", k_failed);
  } catch (const std::exception& error) {
    return say(error.what(), k_failed);
  }
}

}  // namespace timestep::study

#include <new>

#include "common/chapter/console.hpp"
#include "common/chapter/file_job.hpp"
#include "common/chapter/file_run.hpp"
#include "common/chapter/interrupt.hpp"
#include "common/chapter/listing.hpp"
#include "common/chapter/options.hpp"
#include "common/chapter/scene.hpp"
#include "common/chapter/window_app.hpp"
#include "common/graphics/input_error.hpp"
#include "common/graphics/window.hpp"

namespace timestep {
namespace {

void run(const Chapter& chapter, int argc, const char* const* argv) {
  const Options options = parse_options(chapter.name, argc, argv, chapter.file_jobs);
  if (options.answer) return print_out(*options.answer);
  if (options.list) {
    return print_out(options.json ? list_json(chapter) : list_text(chapter));
  }

  if (options.job != nullptr) return run_file_job(chapter, options);

  const Plan plan = make_plan(chapter, options.choice);
  const bool asks_for_files = options.results || options.frames;
  const bool automatic = options.mode == Mode::automatic && !asks_for_files;
  const bool display = automatic && Window::display_available();
  if (options.mode == Mode::window || display) return run_window(chapter, options);

  const bool pictures = options.mode != Mode::headless;
  run_to_files(plan, options, pictures,
               automatic ? "no display; going on as --offscreen" : "");
}

}  // namespace

int run_chapter(const Chapter& chapter, int argc, const char* const* argv) {
  constexpr int k_failed = 1, k_wrong_input = 2, k_interrupted = 130;
  const auto say = [&](const char* what, int code) {
    print_note(chapter.name, what);
    return code;
  };
  keep_standard_streams();
  try {
    run(chapter, argc, argv);
    return 0;
  } catch (const InputError& error) {
    return say(error.what(), k_wrong_input);
  } catch (const Interrupted& error) {
    return say(error.what(), k_interrupted);
  } catch (const std::bad_alloc&) {
    return say("there is not enough memory", k_failed);
  } catch (const std::exception& error) {
    return say(error.what(), k_failed);
  }
}

}  // namespace timestep

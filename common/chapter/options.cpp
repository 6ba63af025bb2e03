#include "common/chapter/options.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/chapter/names.hpp"
#include "common/chapter/numbers.hpp"
#include "common/graphics/input_error.hpp"

namespace timestep {
namespace {

constexpr const char* k_version = "Timestep 0.1";

/// Values as typed, before they are checked.
struct Typed {
  bool window = false, offscreen = false, headless = false, no_movie = false;
  std::vector<std::string> methods, settings;
  std::optional<std::string> out, frames, size, fps, window_frames;
  std::vector<std::optional<std::string>> job_files;  ///< of each job
};

void add_mode_options(CLI::App& app, Options& options, Typed& typed) {
  app.add_flag("--window", typed.window, "insist on a window; fail without a display");
  app.add_flag("--offscreen", typed.offscreen,
               "write pictures, movie, tables, numbers");
  app.add_flag("--headless", typed.headless, "numbers only; touches no graphics");
  app.add_flag("--list", options.list, "show scenes, methods, parameters and presets");
  app.add_flag("--json", options.json, "with --list: for programs");
}

void add_choice_options(CLI::App& app, Choice& choice, Typed& typed) {
  app.add_option("--scene", choice.scene, "what to simulate")->type_name("NAME");
  app.add_option("--method", typed.methods, "one or several, or `all`, drawn overlaid")
      ->type_name("NAME,...")
      ->allow_extra_args(false);
  app.add_option("--precision", choice.precision, "single or double (default)")
      ->type_name("WORD");
  app.add_option("--dt", choice.dt, "time step in seconds: 0.01 or 1/60")
      ->type_name("S");
  app.add_option("--duration", choice.duration, "simulated time in seconds")
      ->type_name("S");
  app.add_option("--preset", choice.preset, "parameters from the real world")
      ->type_name("NAME");
  app.add_option("--set", typed.settings, "one parameter; repeat for more")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--mesh", choice.mesh, "OBJ or glTF file, for scenes that take one")
      ->type_name("FILE");
  app.add_flag("--fix-winding", choice.fix_winding,
               "with --mesh: turn a mesh that is inside out");
}

void add_output_options(CLI::App& app, Options& options, Typed& typed,
                        const std::string& program) {
  app.add_option("--out", typed.out, "folder to write to (default out/" + program + ")")
      ->type_name("DIR");
  app.add_option("--results", options.results, "where the results go; - prints them")
      ->type_name("FILE");
  app.add_option("--frames", typed.frames, "also write N evenly spaced pictures")
      ->type_name("N");
  app.add_flag("--no-movie", typed.no_movie, "skip movie.mp4");
  app.add_option("--size", typed.size, "picture or window (default 1280x720)")
      ->type_name("WxH");
  app.add_option("--fps", typed.fps, "the movie's pictures a second (default 30)")
      ->type_name("N");
  app.add_option("--window-frames", typed.window_frames,
                 "close the window after N frames")
      ->type_name("N");
}

void add_job_options(CLI::App& app, std::span<const FileJob> jobs, Typed& typed) {
  typed.job_files.resize(jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i)
    app.add_option("--" + jobs[i].option, typed.job_files[i], jobs[i].summary)
        ->type_name("FILE");
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    names.push_back("--" + option->get_lnames().at(0));
  }
  return names;
}

std::vector<std::string> split_at_commas(const std::vector<std::string>& lists) {
  std::vector<std::string> parts;
  for (const std::string& list : lists) {
    std::size_t begin = 0, comma = 0;
    while ((comma = list.find(',', begin)) != std::string::npos) {
      parts.push_back(list.substr(begin, comma - begin));
      begin = comma + 1;
    }
    parts.push_back(list.substr(begin));
  }
  return parts;
}

std::pair<std::string, std::string> split_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw InputError(fmt::format("--set {}: must be NAME=VALUE", text));
  }
  return {text.substr(0, equals), text.substr(equals + 1)};
}

int parse_count(const char* option, const std::string& text, int minimum, int maximum) {
  const std::optional<int> value = parse_integer(text, minimum, maximum);
  if (!value) {
    throw InputError(fmt::format("{} {}: must be a whole number from {} to {}", option,
                                 text, minimum, maximum));
  }
  return *value;
}

glm::ivec2 parse_size(const std::string& text) {
  constexpr int k_smallest = 64, k_largest = 8192;
  const std::size_t x = text.find('x');
  if (x != std::string::npos) {
    const auto width = parse_integer(text.substr(0, x), k_smallest, k_largest);
    const auto height = parse_integer(text.substr(x + 1), k_smallest, k_largest);
    if (width && height) return {*width, *height};
  }
  throw InputError(
      fmt::format("--size {}: must be WIDTHxHEIGHT, each from {} to {} pixels", text,
                  k_smallest, k_largest));
}

Mode choose_mode(const Typed& typed) {
  if (typed.window + typed.offscreen + typed.headless > 1) {
    throw InputError(
        "--window, --offscreen and --headless exclude each other; give one");
  }
  if (typed.window) return Mode::window;
  if (typed.offscreen) return Mode::offscreen;
  return typed.headless ? Mode::headless : Mode::automatic;
}

/// Fills in what was typed, now that its form is known to be right.
void interpret(Options& options, const Typed& typed) {
  options.mode = choose_mode(typed);
  options.movie = !typed.no_movie;
  options.choice.methods = split_at_commas(typed.methods);
  for (const std::string& text : typed.settings) {
    options.choice.settings.push_back(split_setting(text));
  }

  if (typed.out) options.out = *typed.out;
  if (typed.frames) options.frames = parse_count("--frames", *typed.frames, 1, 9999);
  if (typed.size) options.size = parse_size(*typed.size);
  if (typed.fps) options.fps = parse_count("--fps", *typed.fps, 1, 240);
  if (typed.window_frames) {
    options.window_frames =
        parse_count("--window-frames", *typed.window_frames, 1, 1000000000);
  }
}

void refuse_contradictions(const Options& options) {
  const bool window = options.mode == Mode::window;
  if (options.json && !options.list)
    throw InputError("--json: only --list prints JSON");
  if (options.out && options.out->empty()) {
    throw InputError("--out: the folder's name is empty");
  }
  if (options.results && options.results->empty()) {
    throw InputError("--results: the file's name is empty");
  }
  if (options.frames && (window || options.mode == Mode::headless)) {
    throw InputError("--frames: only --offscreen writes pictures");
  }
  if (options.results && window) {
    throw InputError(
        "--results: a window writes no files; use --offscreen or --headless");
  }
}

/// Sets the job that was asked for, with which few other options go.
void choose_job(Options& options, const Typed& typed, std::span<const FileJob> jobs,
                const CLI::App& app) {
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (!typed.job_files[i]) continue;
    options.job = &jobs[i];
    options.job_file = *typed.job_files[i];
  }
  if (options.job == nullptr) return;

  using namespace std::string_view_literals;
  constexpr std::array k_going{"method"sv, "precision"sv, "results"sv, "out"sv,
                               "headless"sv};
  const std::string& name = options.job->option;
  for (const CLI::Option* option : app.get_options()) {
    const std::string& other = option->get_lnames().at(0);
    if (option->count() > 0 && other != name && !std::ranges::count(k_going, other))
      throw InputError(fmt::format("--{}: does not go with --{}", name, other));
  }
  if (options.job_file.empty())
    throw InputError(fmt::format("--{}: the file's name is empty", name));
}

/// CLI11's error as one line in our words: a value is missing, or there is one too
/// many.
std::string explain(const CLI::ParseError& error) {
  const std::string text = error.what();
  if (error.get_name() != "ArgumentMismatch") return text.substr(0, text.find('\n'));
  const std::string option = text.substr(0, text.find(':'));
  const bool missing = text.find("missing") != std::string::npos;
  return option + (missing ? ": needs a value" : ": is given more than once");
}

}  // namespace

Options parse_options(const std::string& program, int argc, const char* const* argv,
                      std::span<const FileJob> jobs) {
  Options options;
  Typed typed;
  CLI::App app{"Timestep, " + program + ". Without a mode: a window; off-screen where "
               "there is\nno display or where --results or --frames ask for files.",
               program};
  app.get_formatter()->column_width(28);
  app.set_version_flag("--version", program + ", " + k_version, "show the version");
  app.allow_extras();
  add_mode_options(app, options, typed);
  add_choice_options(app, options.choice, typed);
  add_output_options(app, options, typed, program);
  add_job_options(app, jobs, typed);

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    options.answer = app.help();
    return options;
  } catch (const CLI::CallForVersion&) {
    options.answer = app.version() + "\n";
    return options;
  } catch (const CLI::ParseError& error) {
    throw InputError(explain(error));
  }
  if (!app.remaining().empty()) {
    throw InputError(
        unknown_name("option", app.remaining().front(), option_names(app)));
  }
  choose_job(options, typed, jobs, app);
  interpret(options, typed);
  refuse_contradictions(options);
  return options;
}

}  // namespace timestep

#include "study/options.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "common/chapter/names.hpp"
#include "common/chapter/numbers.hpp"
#include "common/graphics/input_error.hpp"
#include "study/problem.hpp"

namespace timestep::study {
namespace {

/// Values as typed, before they are checked.
struct Typed {
  std::string out, shard, repeats;
  std::vector<std::string> merge;
  bool no_times = false;
};

void add_options(CLI::App& app, Options& options, Typed& typed) {
  app.get_formatter()->column_width(28);
  app.allow_extras();
  app.add_option("SCENE", options.names, "what to study; all without one");
  app.add_flag("--quick", options.quick, "a part that takes less than a minute");
  app.add_option("--out", typed.out, "folder to write to (default out/study)")
      ->type_name("DIR");
  app.add_option("--shard", typed.shard, "compute part I of N alone: 1/4")
      ->type_name("I/N");
  app.add_option("--merge", typed.merge, "join journals into --out; compute nothing")
      ->type_name("DIR...");
  app.add_flag("--partial", options.partial, "with --merge: even if some are missing");
  app.add_option("--repeats", typed.repeats, "least number of timed runs (default 3)")
      ->type_name("N");
  app.add_flag("--no-times", typed.no_times, "errors and exact costs alone");
  app.add_flag("--list", options.list, "say what would be measured");
  app.add_flag("--json", options.json, "with --list: for programs");
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    if (!option->get_lnames().empty())
      names.push_back("--" + option->get_lnames().front());
  return names;
}

/// An unknown option is left over, or taken for a name.
void refuse_unknown_options(const CLI::App& app,
                            const std::vector<std::string>& names) {
  std::vector<std::string> words = app.remaining();
  words.insert(words.end(), names.begin(), names.end());
  for (const std::string& word : words)
    if (word.starts_with("-"))
      throw InputError(unknown_name("option", word, option_names(app)));
}

void choose_shard(Options& options, const std::string& text) {
  constexpr int k_most = 100000;
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const auto shards = parse_integer(text.substr(slash + 1), 1, k_most);
    const auto shard = parse_integer(text.substr(0, slash), 1, shards.value_or(1));
    if (shard && shards) {
      options.shard = *shard;
      options.shards = *shards;
      options.is_shard = true;
      return;
    }
  }
  throw InputError(fmt::format("--shard {}: must be I/N with I from 1 to N", text));
}

void interpret(Options& options, const CLI::App& app, const Typed& typed) {
  constexpr int k_most_repeats = 1000;
  options.times = !typed.no_times;
  options.merge.assign(typed.merge.begin(), typed.merge.end());
  if (app.count("--out") > 0) options.out = typed.out;
  if (options.out.empty()) throw InputError("--out: the folder's name is empty");
  if (app.count("--shard") > 0) choose_shard(options, typed.shard);
  if (app.count("--repeats") > 0) {
    const auto repeats = parse_integer(typed.repeats, 1, k_most_repeats);
    if (!repeats)
      throw InputError(fmt::format("--repeats {}: must be a whole number from 1 to {}",
                                   typed.repeats, k_most_repeats));
    options.repeats = *repeats;
  }
}

void refuse_contradictions(const Options& options) {
  if (options.list && (options.is_shard || !options.merge.empty()))
    throw InputError("--list: computes and merges nothing, so no --shard or --merge");
  if (options.json && !options.list)
    throw InputError("--json: only --list prints JSON");
  if (options.partial && options.merge.empty())
    throw InputError("--partial: only --merge can leave out what is missing");
  if (options.is_shard && !options.merge.empty())
    throw InputError(
        "--shard and --merge exclude each other: shards are computed "
        "first, then merged");
}

}  // namespace

Options parse_options(const std::string& program, int argc, const char* const* argv) {
  Options options;
  Typed typed;
  CLI::App app{
      "Timestep's study: what every setting of every scene errs and costs. "
      "Goes on\nwhere it stopped.",
      program};
  add_options(app, options, typed);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    options.answer = app.help();
    return options;
  } catch (const CLI::ParseError& error) {
    const std::string text = error.what();
    throw InputError(text.substr(0, text.find('\n')));
  }
  refuse_unknown_options(app, options.names);
  interpret(options, app, typed);
  refuse_contradictions(options);
  chosen_problems(options.names);  // throws for an unknown one
  return options;
}

}  // namespace timestep::study

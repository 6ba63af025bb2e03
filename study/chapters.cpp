#include "study/chapters.hpp"

#include <algorithm>

#include "chapters/01-particles/scenes.hpp"
#include "chapters/02-verlet/scenes.hpp"
#include "chapters/03-rigid-bodies/scenes.hpp"
#include "chapters/04-contacts/scenes.hpp"
#include "chapters/05-penetration/scenes.hpp"
#include "chapters/06-impulses/scenes.hpp"

namespace timestep::study {
namespace {

Chapter chapter(const char* name, std::vector<Scene> single,
                std::vector<Scene> twice_as_long) {
  return {.name = name,
          .title = name,
          .single_precision = std::move(single),
          .double_precision = std::move(twice_as_long)};
}

std::map<std::string, Chapter> all_chapters() {
  namespace s = single_precision;
  namespace d = double_precision;
  std::map<std::string, Chapter> all;
  const auto add = [&](const char* name, std::vector<Scene> in_single,
                       std::vector<Scene> in_double) {
    all[name] = chapter(name, std::move(in_single), std::move(in_double));
  };
  add("01-particles", s::chapter_01::scenes(), d::chapter_01::scenes());
  add("02-verlet", s::chapter_02::scenes(), d::chapter_02::scenes());
  add("03-rigid-bodies", s::chapter_03::scenes(), d::chapter_03::scenes());
  add("04-contacts", s::chapter_04::scenes(), d::chapter_04::scenes());
  add("05-penetration", s::chapter_05::scenes(), d::chapter_05::scenes());
  add("06-impulses", s::chapter_06::scenes(), d::chapter_06::scenes());
  return all;
}

}  // namespace

const Chapter& chapter_named(const std::string& name) {
  static const std::map<std::string, Chapter> all = all_chapters();
  return all.at(name);
}

const Scene& scene_of(const Problem& problem) {
  const std::vector<Scene>& scenes = chapter_named(problem.chapter).double_precision;
  const auto found = std::ranges::find(scenes, problem.scene, &Scene::name);
  if (found == scenes.end())
    throw std::out_of_range("there is no scene " + problem.scene);
  return *found;
}

}  // namespace timestep::study

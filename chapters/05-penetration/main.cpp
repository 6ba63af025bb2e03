#include "chapters/05-penetration/scenes.hpp"

int main(int argc, char** argv) {
  const timestep::Chapter chapter{
      .name = "05-penetration",
      .title = "Penetration",
      .single_precision = timestep::single_precision::chapter_05::scenes(),
      .double_precision = timestep::double_precision::chapter_05::scenes(),
  };
  return timestep::run_chapter(chapter, argc, argv);
}

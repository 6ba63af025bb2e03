#include "chapters/02-verlet/scenes.hpp"

int main(int argc, char** argv) {
  const timestep::Chapter chapter{
      .name = "02-verlet",
      .title = "The Verlet comparison",
      .single_precision = timestep::single_precision::chapter_02::scenes(),
      .double_precision = timestep::double_precision::chapter_02::scenes(),
  };
  return timestep::run_chapter(chapter, argc, argv);
}

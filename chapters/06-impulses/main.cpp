#include "chapters/06-impulses/scenes.hpp"

int main(int argc, char** argv) {
  const timestep::Chapter chapter{
      .name = "06-impulses",
      .title = "Impulses",
      .single_precision = timestep::single_precision::chapter_06::scenes(),
      .double_precision = timestep::double_precision::chapter_06::scenes(),
  };
  return timestep::run_chapter(chapter, argc, argv);
}

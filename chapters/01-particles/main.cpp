#include "chapters/01-particles/scenes.hpp"

int main(int argc, char** argv) {
  const timestep::Chapter chapter{
      .name = "01-particles",
      .title = "Particles and Euler",
      .single_precision = timestep::single_precision::chapter_01::scenes(),
      .double_precision = timestep::double_precision::chapter_01::scenes(),
  };
  return timestep::run_chapter(chapter, argc, argv);
}

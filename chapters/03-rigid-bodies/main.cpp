#include "chapters/03-rigid-bodies/scenes.hpp"

int main(int argc, char** argv) {
  const timestep::Chapter chapter{
      .name = "03-rigid-bodies",
      .title = "Rigid bodies and torque",
      .single_precision = timestep::single_precision::chapter_03::scenes(),
      .double_precision = timestep::double_precision::chapter_03::scenes(),
  };
  return timestep::run_chapter(chapter, argc, argv);
}

#include "chapters/07-trade/scenes.hpp"

int main(int argc, char** argv) {
  const timestep::Chapter chapter{
      .name = "07-trade",
      .title = "The trade",
      .single_precision = timestep::single_precision::chapter_07::scenes(),
      .double_precision = timestep::double_precision::chapter_07::scenes(),
  };
  return timestep::run_chapter(chapter, argc, argv);
}

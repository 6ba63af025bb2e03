#include "chapters/04-contacts/pair_job.hpp"
#include "chapters/04-contacts/scenes.hpp"

int main(int argc, char** argv) {
  const timestep::Chapter chapter{
      .name = "04-contacts",
      .title = "Contacts",
      .single_precision = timestep::single_precision::chapter_04::scenes(),
      .double_precision = timestep::double_precision::chapter_04::scenes(),
      .file_jobs = {{
          .option = "pairs",
          .summary = "answer a JSON file of pairs of convex shapes",
          .methods = timestep::double_precision::chapter_04::all_choices(),
          .single_precision = timestep::single_precision::chapter_04::answer_pairs,
          .double_precision = timestep::double_precision::chapter_04::answer_pairs,
      }},
  };
  return timestep::run_chapter(chapter, argc, argv);
}

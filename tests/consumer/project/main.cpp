// What someone who embeds Limn writes: a mesh in, a painting, the refined mesh out.
#include <iostream>

#include "limn/mesh/import.h"
#include "limn/painting/paint_rule.h"
#include "limn/subdivision/label_subdivision.h"

int main() {
  const char* cube =
      "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  const auto mesh = limn::import_obj(cube, "cube").value().mesh;
  limn::FaceDepths depths(mesh->face_count());
  const auto rule = limn::parse_paint_rule("faces=1:=3").value();
  if (const auto painted = limn::apply_paint_rule(*mesh, rule, {}, depths); !painted) {
    std::cerr << to_string(painted.error()) << '\n';
    return 1;
  }
  limn::IgnoreProgress progress;
  const auto labels = limn::legal_labels(*mesh, depths.values(), {}, progress).value().labels;
  const auto refined = limn::refine(*mesh, labels, {}, {}, progress).value();
  std::cout << refined.face_count() << " faces, " << refined.vertex_count() << " vertices\n";
}

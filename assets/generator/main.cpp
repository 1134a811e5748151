// limn_generate_meshes FOLDER: writes the bundled meshes as OBJ files into FOLDER.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>

#include <fmt/core.h>

#include "families.h"
#include "obj_text.h"

namespace {

using namespace limn::generator;

struct Recipe {
  std::string_view file;
  std::string_view what;
  limn::PolygonSoup (*make)();
};

constexpr Recipe kRecipes[] = {
    {"creature.obj", "A small dragon of quads, closed and symmetric in x.", creature},
    {"teapot.obj", "The Utah teapot as quads, sampled from Martin Newell's Bezier patches.",
     utah_teapot},
    {"cube.obj", "A cube of 6 squares.", cube},
    {"cube_triangulated.obj", "A cube of 12 triangles, cut unsymmetrically.", cube_triangulated},
    {"icosahedron.obj", "An icosahedron of 20 triangles.", icosahedron},
    {"sphere.obj", "A sphere of 32 triangles, an octahedron cut finer.", sphere},
    {"mixed.obj", "A rhombicosidodecahedron: triangles, squares and pentagons.",
     rhombicosidodecahedron},
    {"grid.obj", "An open, gently waved sheet of quads.", wavy_grid},
    {"torus_open.obj", "A torus of quads with a window cut into it.", torus_with_window},
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: limn_generate_meshes FOLDER\n");
    return 2;
  }
  for (const Recipe& recipe : kRecipes) {
    const std::filesystem::path path = std::filesystem::path(argv[1]) / recipe.file;
    std::ofstream file(path, std::ios::binary);
    file << obj_text(recipe.make(), recipe.what);
    file.close();
    if (!file) {
      fmt::print(stderr, "limn_generate_meshes: cannot write {}\n", path.string());
      return 1;
    }
  }
  return 0;
}

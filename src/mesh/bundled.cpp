// The texts come out of assets/meshes by way of limn_embed; names and descriptions are given here,
// and a file that is not described here is not offered.
#include "limn/mesh/bundled.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "embedded/meshes.h"
#include "limn/contract.h"
#include "limn/mesh/import.h"

namespace limn {
namespace {

struct Entry {
  std::string_view name;
  std::string_view description;
};

constexpr std::array kEntries = {
    Entry{"creature",
          "A small dragon of quads: eyes, ears and toes to paint, smooth flanks to leave."},
    Entry{"teapot", "The Utah teapot as quads, in four open pieces."},
    Entry{"cube", "A cube of 6 squares: where every subdivision scheme is tried first."},
    Entry{"cube_triangulated",
          "A cube of 12 triangles, cut in no symmetric way, which subdivision shows."},
    Entry{"icosahedron", "An icosahedron of 20 triangles, for comparison with a sphere."},
    Entry{"sphere",
          "A coarse sphere of 32 triangles, for courses: subdivided, how round does it get?"},
    Entry{"mixed", "A rhombicosidodecahedron: triangles, squares and pentagons in one mesh."},
    Entry{"grid", "An open, gently waved sheet of quads with corners and a boundary."},
    Entry{"torus_open", "A torus of quads with a window cut into it."},
};

std::string_view embedded_text(std::string_view name) {
  const std::string file_name = std::string(name) + ".obj";
  const std::span<const embedded::meshes::EmbeddedFile> files = embedded::meshes::files();
  const auto found = std::ranges::find(files, file_name, &embedded::meshes::EmbeddedFile::name);
  LIMN_EXPECTS(found != files.end());
  return found->text;
}

std::array<BundledMesh, kEntries.size()> make_list() {
  std::array<BundledMesh, kEntries.size()> list;
  std::ranges::transform(kEntries, list.begin(), [](const Entry& entry) {
    return BundledMesh{entry.name, embedded_text(entry.name), entry.description};
  });
  return list;
}

}  // namespace

std::span<const BundledMesh> bundled_meshes() {
  static const std::array<BundledMesh, kEntries.size()> list = make_list();
  return list;
}

Result<ImportedMesh> load_bundled_mesh(std::string_view name) {
  const std::span<const BundledMesh> list = bundled_meshes();
  const auto found = std::ranges::find(list, name, &BundledMesh::name);
  if (found == list.end()) {
    std::array<std::string_view, kEntries.size()> names;
    std::ranges::transform(list, names.begin(), &BundledMesh::name);
    return fail(ErrorKind::kUsage, fmt::format("There is no bundled mesh \"{}\". There are: {}.",
                                               name, fmt::join(names, ", ")));
  }
  return import_obj(found->obj_text, std::string(name));
}

}  // namespace limn

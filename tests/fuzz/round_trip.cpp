// STL has no vertices of its own, so there it is what is written of the second mesh that has to be
// what was written of the first.
#include "round_trip.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "limn/mesh/export.h"
#include "limn/mesh/import.h"
#include "limn/subdivision/settings.h"
#include "support/mesh_difference.h"

namespace limn::fuzz {
namespace {

[[noreturn]] void give_up(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

/// As a document holds them.
std::vector<std::uint8_t> depths_of(const ImportedMesh& imported) {
  std::vector<std::uint8_t> depths;
  for (const std::uint32_t depth : imported.depths) {
    depths.push_back(static_cast<std::uint8_t>(std::min<std::uint32_t>(depth, kMaxDepth)));
  }
  return depths;
}

std::string written(MeshFormat format, const ImportedMesh& imported) {
  const std::vector<std::uint8_t> depths = depths_of(imported);
  std::ostringstream out;
  write_mesh(out, format, *imported.mesh, {.depths = depths});
  return out.str();
}

ImportedMesh read_again(const std::string& bytes, MeshFormat format) {
  Result<ImportedMesh> again = import_bytes(bytes, format, "written");
  if (!again) {
    give_up("what was written is refused: " + to_string(again.error()) + "\n" + bytes);
  }
  return *std::move(again);
}

bool loses(MeshFormat format, const ControlMesh& mesh, const std::string& what) {
  for (const std::string& phrase : lost_in(format, mesh)) {
    if (phrase.find(what) != std::string::npos) {
      return true;
    }
  }
  return false;
}

/// Any mesh can be cut into triangles.
void check_triangles(const ImportedMesh& imported) {
  const std::string first = written(MeshFormat::kStl, imported);
  if (const auto soup = read_soup(first, MeshFormat::kStl, "written"); !soup) {
    give_up("what was written is no STL: " + to_string(soup.error()));
  }
}

}  // namespace

void check_round_trip(MeshFormat format, const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const Result<ImportedMesh> imported = import_bytes(bytes, format, "fuzz");
  if (!imported) {
    if (imported.error().message.empty() || imported.error().path != "fuzz") {
      give_up("an error without a message or path");
    }
    return;
  }
  check_triangles(*imported);
  if (format == MeshFormat::kStl) {
    return;
  }
  const ImportedMesh again = read_again(written(format, *imported), format);
  const test::Compared compared{.sharpness = format != MeshFormat::kOff,
                                .uvs = !loses(format, *imported->mesh, "texture"),
                                .names = format == MeshFormat::kObj};
  if (const std::string found = test::difference(*imported->mesh, *again.mesh, compared);
      !found.empty()) {
    give_up(found + "\n" + written(format, *imported));
  }
  if (format != MeshFormat::kOff && depths_of(again) != depths_of(*imported)) {
    give_up("depths differ\n" + written(format, *imported));
  }
  if (again.report.is_mended() != (again.report.count(MendKind::kLooseVertex) > 0)) {
    give_up("what was written had to be mended:\n" + again.report.sentences().front() + '\n' +
            written(format, *imported));
  }
}

}  // namespace limn::fuzz

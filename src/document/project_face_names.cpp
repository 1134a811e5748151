#include "project_face_names.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "limn/mesh/flat_topology.h"

namespace limn {
namespace {

/// A way in which faces are sorted, and where it stands.
struct Layer {
  std::string_view names_key;
  std::string_view faces_key;
  FaceNames FaceNaming::*layer;
  TextList MeshLists::*names;
  ChoiceList MeshLists::*faces;
};

constexpr std::array<Layer, 3> kLayers{{
    {"object_names", "face_objects", &FaceNaming::objects, &MeshLists::object_names,
     &MeshLists::face_objects},
    {"group_names", "face_groups", &FaceNaming::groups, &MeshLists::group_names,
     &MeshLists::face_groups},
    {"material_names", "face_materials", &FaceNaming::materials, &MeshLists::material_names,
     &MeshLists::face_materials},
}};

void write_texts(JsonWriter& writer, std::string_view key, const std::vector<std::string>& texts) {
  writer.add(fmt::format(",\n    \"{}\": ", key));
  writer.add_list(texts, ", ", [](const std::string& text) { return json_bytes(text); });
}

}  // namespace

void write_face_names(JsonWriter& writer, const FaceNaming& names) {
  for (const Layer& kind : kLayers) {
    const FaceNames& layer = names.*kind.layer;
    if (layer.empty()) {
      continue;
    }
    write_texts(writer, kind.names_key, layer.names);
    writer.add(fmt::format(",\n    \"{}\": ", kind.faces_key));
    writer.add_list(layer.of_faces, ", ", [](std::uint32_t name) {
      return name == kNone ? std::string("-1") : fmt::format_int(name).str();
    });
  }
  if (!names.material_libraries.empty()) {
    write_texts(writer, "material_libraries", names.material_libraries);
  }
}

void check_face_names(FieldReader& fields, const std::string& path, const MeshLists& lists) {
  const std::size_t face_count = lists.faces.offsets.size() - 1;
  for (const Layer& kind : kLayers) {
    const TextList& names = lists.*kind.names;
    const ChoiceList& faces = lists.*kind.faces;
    if (!names.is_there && !faces.is_there) {
      continue;
    }
    const std::string where = fmt::format("{}/{}", path, kind.faces_key);
    fields.expect_long_list(fmt::format("{}/{}", path, kind.names_key), names.is_there);
    fields.expect_long_list(where, faces.is_there);
    if (faces.choices.size() != face_count) {
      fields.complain(
          where, fmt::format("has {} entries for {} faces.", faces.choices.size(), face_count));
    }
    const auto beyond = std::ranges::find_if(faces.choices, [&](std::uint32_t name) {
      return name != kNone && name >= names.texts.size();
    });
    if (beyond != faces.choices.end()) {
      fields.complain(
          fmt::format("{}/{}", where, beyond - faces.choices.begin()),
          fmt::format("there is no name {}; there are {}.", *beyond, names.texts.size()));
    }
  }
}

FaceNaming face_names_of(MeshLists& lists) {
  FaceNaming names;
  for (const Layer& kind : kLayers) {
    names.*
        kind.layer = {std::move((lists.*kind.names).texts), std::move((lists.*kind.faces).choices)};
  }
  names.material_libraries = std::move(lists.material_libraries.texts);
  return names;
}

}  // namespace limn

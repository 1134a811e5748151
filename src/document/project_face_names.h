#pragma once

#include <string>

#include "field_reader.h"
#include "json_lists.h"
#include "json_writer.h"
#include "limn/mesh/face_names.h"

// How a mesh's faces are called, in a project file.
namespace limn {

void write_face_names(JsonWriter& writer, const FaceNaming& names);

/// Complains of names that do not fit the faces.
void check_face_names(FieldReader& fields, const std::string& path, const MeshLists& lists);

/// Of lists that `check_face_names` had no complaint about.
[[nodiscard]] FaceNaming face_names_of(MeshLists& lists);

}  // namespace limn

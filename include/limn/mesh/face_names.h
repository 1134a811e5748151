#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace limn {

/// Faces by name, such as the materials of an OBJ file.
struct FaceNames {
  std::vector<std::string> names;
  std::vector<std::uint32_t> of_faces;  ///< One index into `names` per face, kNone for none; or
                                        ///< empty: no face has a name.

  [[nodiscard]] bool empty() const noexcept { return of_faces.empty(); }
  [[nodiscard]] bool operator==(const FaceNames&) const = default;
};

/// How a file sorts its faces. Limn does not read meaning into it and hands it on.
struct FaceNaming {
  FaceNames objects;
  FaceNames groups;  ///< A face in several groups has their names joined by spaces.
  FaceNames materials;
  std::vector<std::string> material_libraries;  ///< As the file names them; never opened.

  [[nodiscard]] bool empty() const noexcept {
    return objects.empty() && groups.empty() && materials.empty() && material_libraries.empty();
  }
  [[nodiscard]] bool operator==(const FaceNaming&) const = default;
};

/// The names of faces that were made of others: face i of the result is called as face `sources[i]`
/// is.
[[nodiscard]] FaceNaming names_by_source(const FaceNaming& names,
                                         std::span<const std::uint32_t> sources);

}  // namespace limn

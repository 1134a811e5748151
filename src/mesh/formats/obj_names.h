#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "limn/mesh/face_names.h"

namespace limn::detail {

/// One layer of names that hold for the faces after them, as it is read.
class NameLayer {
 public:
  /// Faces from here on are called this; an empty name is none.
  void set(const std::string& name);
  /// Face `face`, which comes after all before, is called by the name that holds.
  void add_face(std::size_t face);
  /// The names that faces have, in the order of their first faces, for so many faces in all.
  [[nodiscard]] FaceNames take(std::size_t faces);
  /// How many names no face has.
  [[nodiscard]] std::size_t unused() const noexcept { return numbers_.size() - used_.size(); }

 private:
  std::map<std::string, std::uint32_t> numbers_;  ///< Of the names; kNone before a face has it.
  std::map<std::string, std::uint32_t>::iterator current_ = numbers_.end();
  std::vector<std::string> used_;
  std::vector<std::uint32_t> of_faces_;
};

}  // namespace limn::detail

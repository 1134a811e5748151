#include "mesh/formats/obj_names.h"

#include <utility>

#include "limn/mesh/flat_topology.h"

namespace limn::detail {

void NameLayer::set(const std::string& name) {
  current_ = name.empty() ? numbers_.end() : numbers_.try_emplace(name, kNone).first;
}

void NameLayer::add_face(std::size_t face) {
  if (current_ == numbers_.end()) {
    return;
  }
  if (current_->second == kNone) {
    current_->second = static_cast<std::uint32_t>(used_.size());
    used_.push_back(current_->first);
  }
  of_faces_.resize(face, kNone);
  of_faces_.push_back(current_->second);
}

FaceNames NameLayer::take(std::size_t faces) {
  if (!of_faces_.empty()) {
    of_faces_.resize(faces, kNone);
  }
  return {std::move(used_), std::move(of_faces_)};
}

}  // namespace limn::detail

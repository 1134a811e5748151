// Depths are one byte a face; shaders read them four to a word, so the buffer is padded to words.
#include "render/surface/face_paint.h"

#include <algorithm>

#include "limn/contract.h"

namespace limn::render {
namespace {

constexpr std::size_t kBits = 32;

/// The range of indices from the lowest to the highest of some.
struct IndexRange {
  std::size_t first = static_cast<std::size_t>(-1);
  std::size_t last = 0;

  void include(std::size_t index) {
    first = std::min(first, index);
    last = std::max(last, index);
  }
  [[nodiscard]] bool empty() const { return first > last; }
};

}  // namespace

FaceSetBuffer::FaceSetBuffer(std::string_view label) : bits_(gl::Buffer::create(label)) {}

void FaceSetBuffer::reset(std::size_t face_count) {
  words_.assign(face_count / kBits + 1, 0);
  members_.clear();
  bits_.upload(words_);
}

void FaceSetBuffer::assign(std::span<const std::uint32_t> faces) {
  if (faces.empty() && members_.empty()) {
    return;
  }
  IndexRange changed;
  for (const std::uint32_t face : members_) {
    words_[face / kBits] = 0;
    changed.include(face / kBits);
  }
  members_.assign(faces.begin(), faces.end());
  for (const std::uint32_t face : members_) {
    LIMN_EXPECTS(face / kBits < words_.size());
    words_[face / kBits] |= 1U << (face % kBits);
    changed.include(face / kBits);
  }
  bits_.write(changed.first * sizeof(std::uint32_t),
              std::span<const std::uint32_t>(words_).subspan(changed.first,
                                                             changed.last - changed.first + 1));
}

FacePaint::FacePaint()
    : depths_(gl::Buffer::create("face depths")),
      highlighted_("highlighted faces"),
      illegal_("illegal faces") {}

void FacePaint::reset(std::span<const std::uint8_t> depths) {
  face_count_ = depths.size();
  depths_.resize((depths.size() / 4 + 1) * 4);
  depths_.write(0, depths);
  highlighted_.reset(face_count_);
  illegal_.reset(face_count_);
}

void FacePaint::set_depths(std::span<const std::uint8_t> depths) {
  LIMN_EXPECTS(depths.size() == face_count_);
  depths_.write(0, depths);
}

void FacePaint::set_depths(std::size_t first, std::span<const std::uint8_t> depths) {
  LIMN_EXPECTS(first <= face_count_ && depths.size() <= face_count_ - first);
  depths_.write(first, depths);
}

void FacePaint::update_depths(std::span<const DepthEdit> edits,
                              std::span<const std::uint8_t> depths) {
  LIMN_EXPECTS(depths.size() == face_count_);
  IndexRange faces;
  for (const DepthEdit& edit : edits) {
    faces.include(edit.face);
  }
  if (!faces.empty()) {
    set_depths(faces.first, depths.subspan(faces.first, faces.last - faces.first + 1));
  }
}

void FacePaint::bind() const {
  depths_.bind_storage(4);
  highlighted_.bind_storage(6);
  illegal_.bind_storage(7);
}

}  // namespace limn::render

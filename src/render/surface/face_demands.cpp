// Shaders read four bytes to a word, so the buffer is padded to words.
#include "render/surface/face_demands.h"

namespace limn::render {

FaceDemands::FaceDemands() : bytes_(gl::Buffer::create("face demands")) {}

void FaceDemands::upload(std::span<const std::uint8_t> of_drawn_faces) {
  count_ = of_drawn_faces.size();
  bytes_.resize((count_ / 4 + 1) * 4);
  bytes_.write(0, of_drawn_faces);
}

}  // namespace limn::render

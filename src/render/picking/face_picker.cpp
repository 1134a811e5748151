// Two numbers stand for a face here: its place in the drawn surface (plus 1) in the image, and its
// control face everywhere else. The surface's face records lead from one to the other, on the CPU
// for the pixels of a brush or lasso and in a compute shader for the whole image.
#include "render/picking/face_picker.h"

#include <algorithm>
#include <bit>
#include <span>

#include "render/picking/seen.h"
#include "render/shader_library.h"

namespace limn::render {
namespace {

constexpr std::size_t kBitsInWord = 32;
// As in shaders/visible_faces.comp.glsl.
constexpr unsigned kGroupWidth = 32;
constexpr unsigned kGroupHeight = 4;
constexpr GLuint kVisibleSlot = 9;
// As in shaders/control_faces.comp.glsl.
constexpr unsigned kLookUpGroup = 64;
constexpr GLuint kAskedSlot = 8;
constexpr GLuint kAnswerSlot = 9;

unsigned groups_over(int pixels, unsigned group) {
  return (static_cast<unsigned>(pixels) + group - 1) / group;
}

/// The rectangle with a pixel more on every side that the image has one.
PixelRect grown(const PixelRect& rect, FramebufferSize size) {
  const int left = std::max(rect.x - 1, 0);
  const int top = std::max(rect.y - 1, 0);
  return {left, top, std::min(rect.x + rect.width + 1, size.width) - left,
          std::min(rect.y + rect.height + 1, size.height) - top};
}

}  // namespace

FacePicker::FacePicker()
    : draw_ids_(load_program("face_id.vert.glsl", "face_id.frag.glsl")),
      look_up_(load_compute_program("control_faces.comp.glsl")),
      gather_visible_(load_compute_program("visible_faces.comp.glsl")),
      visible_bits_(gl::Buffer::create("visible faces")),
      asked_(gl::Buffer::create("faces asked about")),
      answers_(gl::Buffer::create("their control faces")) {}

void FacePicker::look_up_control_faces(const SurfaceBuffers& surface) {
  controls_.resize(drawn_.size());
  if (const auto control_faces = surface.face_control_faces(); !control_faces.empty()) {
    std::ranges::transform(drawn_, controls_.begin(),
                           [&](std::uint32_t face) { return control_faces[face]; });
    return;
  }
  if (drawn_.empty()) {
    return;
  }
  asked_.upload(drawn_);
  answers_.resize(drawn_.size() * sizeof(std::uint32_t));
  look_up_.use();
  surface.bind_face_records();
  asked_.bind_storage(kAskedSlot);
  answers_.bind_storage(kAnswerSlot);
  glDispatchCompute(groups_over(static_cast<int>(drawn_.size()), kLookUpGroup), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  answers_.read_bytes(0, std::as_writable_bytes(std::span(controls_)));
}

bool FacePicker::update(const PickScene& scene) {
  const Key key{scene.surface.upload_id(), clip_from_local(scene.camera, scene.surface.origin()),
                scene.camera.size};
  const bool is_something = !key.size.is_empty() && scene.surface.face_count() > 0;
  if (key == key_) {
    return is_something;
  }
  key_ = Key();  // In case of an exception below.
  image_.resize(key.size);
  if (is_something) {
    image_.begin();
    draw_ids_.use();
    draw_ids_.set(0, key.clip_from_local);
    draw_ids_.set(1, eye_from_local(scene.camera, scene.surface.origin()));
    scene.surface.draw();
    ++draw_count_;
  }
  key_ = key;
  return is_something;
}

std::optional<PickedFace> FacePicker::pick(const PickScene& scene, FramebufferPoint point) {
  const FramebufferSize size = scene.camera.size;
  const bool is_inside =
      point.x >= 0.0 && point.y >= 0.0 && point.x < size.width && point.y < size.height;
  if (!is_inside || !update(scene)) {
    return std::nullopt;
  }
  const int x = static_cast<int>(point.x);
  const int y = static_cast<int>(point.y);
  std::uint32_t id = 0;
  image_.read({x, y, 1, 1}, std::span(&id, 1));
  if (id == 0) {
    return std::nullopt;
  }
  PickedFace picked;
  picked.drawn_face = drawn_face_of(id);
  drawn_.assign(1, picked.drawn_face);
  look_up_control_faces(scene.surface);
  picked.control_face = controls_.front();
  picked.view_depth = view_depth_from_buffer(scene.camera, image_.read_depth(x, y));
  picked.position = world_at(scene.camera, point, picked.view_depth);
  return picked;
}

void FacePicker::gather_drawn(const PickScene& scene, const ScreenRegion& region) {
  drawn_.clear();
  const PixelRect covered = region.pixel_rect(scene.camera.size);
  if (covered.is_empty() || !update(scene)) {
    return;
  }
  // One pixel more all around: whether a pixel counts depends on its neighbours.
  const PixelRect rect = grown(covered, scene.camera.size);
  pixels_.resize(rect.area());
  image_.read(rect, pixels_);
  for (int y = covered.y; y < covered.y + covered.height; ++y) {
    const int row = y - rect.y;
    const std::uint32_t* ids =
        pixels_.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(rect.width);
    region.covered_spans(y, spans_);
    for (const PixelSpan& span : spans_) {
      const int first = std::max(span.first, covered.x) - rect.x;
      const int last = std::min(span.last, covered.x + covered.width) - rect.x;
      std::uint32_t previous = 0;
      for (int column = first; column < last; ++column) {
        const std::uint32_t id = ids[column];
        if (id == previous || !counts_as_seen(pixels_, rect.width, rect.height, column, row)) {
          continue;
        }
        previous = id;
        drawn_.push_back(drawn_face_of(id));
      }
    }
  }
}

std::vector<std::uint32_t> FacePicker::drawn_faces_in(const PickScene& scene,
                                                      const ScreenRegion& region) {
  gather_drawn(scene, region);
  std::vector<std::uint32_t> met = drawn_;
  std::ranges::sort(met);
  met.erase(std::unique(met.begin(), met.end()), met.end());
  return met;
}

std::vector<std::uint32_t> FacePicker::faces_in(const PickScene& scene,
                                                const ScreenRegion& region) {
  std::vector<std::uint32_t> met;
  gather_drawn(scene, region);
  if (drawn_.empty()) {
    return met;
  }
  look_up_control_faces(scene.surface);
  if (last_met_.size() != scene.surface.control_face_count() || ++question_count_ == 0) {
    last_met_.assign(scene.surface.control_face_count(), 0);
    question_count_ = 1;
  }
  for (const std::uint32_t face : controls_) {
    if (last_met_[face] != question_count_) {
      last_met_[face] = question_count_;
      met.push_back(face);
    }
  }
  return met;
}

std::vector<std::uint32_t> FacePicker::visible_faces(const PickScene& scene) {
  std::vector<std::uint32_t> visible;
  if (!update(scene)) {
    return visible;
  }
  const std::size_t words = scene.surface.control_face_count() / kBitsInWord + 1;
  visible_bits_.resize(words * sizeof(std::uint32_t));
  visible_bits_.clear();

  gather_visible_.use();
  image_.texture().bind(0);
  scene.surface.bind_face_records();
  visible_bits_.bind_storage(kVisibleSlot);
  glDispatchCompute(groups_over(image_.size().width, kGroupWidth),
                    groups_over(image_.size().height, kGroupHeight), 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);

  const std::vector<std::uint32_t> bits = visible_bits_.read<std::uint32_t>();
  for (std::size_t word = 0; word < words; ++word) {
    for (std::uint32_t rest = bits[word]; rest != 0; rest &= rest - 1) {
      visible.push_back(static_cast<std::uint32_t>(
          word * kBitsInWord + static_cast<std::size_t>(std::countr_zero(rest))));
    }
  }
  return visible;
}

}  // namespace limn::render

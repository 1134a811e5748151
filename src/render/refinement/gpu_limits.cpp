#include "render/refinement/gpu_limits.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>
#include <glad/gl.h>

#include "render/environment_error.h"

namespace limn::render {
namespace {

constexpr GLint kMostSlots = 16;  ///< As in the shaders.

GLint limit_of(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Something whose size the driver limits.
struct Sized {
  std::uint64_t bytes;
  const char* what;
};

Result<void> require_sizes(std::initializer_list<Sized> all) {
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  for (const auto& [bytes, what] : all) {
    if (bytes > static_cast<std::uint64_t>(most)) {
      return fail(ErrorKind::kEnvironment,
                  fmt::format("The refinement is too large for this graphics driver: {} take {} "
                              "MB, and GL_MAX_SHADER_STORAGE_BLOCK_SIZE is {} MB. Refine on the "
                              "CPU instead, or to fewer faces.",
                              what, bytes >> 20U, most >> 20U));
    }
  }
  return {};
}

Result<void> require_items(std::uint64_t items) {
  const auto width = static_cast<std::uint64_t>(kMostGroupsInRow);
  const std::uint64_t most = std::min(width * width * kGroupSize, std::uint64_t{0xFFFFFFFF});
  if (items > most) {
    return fail(ErrorKind::kEnvironment,
                fmt::format("The refinement is too large for a GPU: it takes {} invocations, and "
                            "GL_MAX_COMPUTE_WORK_GROUP_COUNT allows {}. Refine on the CPU instead, "
                            "or to fewer faces.",
                            items, most));
  }
  return {};
}

}  // namespace

void require_slots() {
  for (const auto& [name, text] :
       {std::pair<GLenum, const char*>(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS,
                                       "GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS"),
        std::pair<GLenum, const char*>(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS,
                                       "GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS")}) {
    if (const GLint most = limit_of(name); most < kMostSlots) {
      throw EnvironmentError(
          fmt::format("This graphics driver cannot refine: {} is {}, and {} are needed. Refine on "
                      "the CPU instead.",
                      text, most, kMostSlots));
    }
  }
}

std::uint64_t point_bytes(const FlatPlan& plan) {
  return (plan.points.size() + kPiecePoints * plan.piece_count) * sizeof(glm::vec3);
}

Result<void> require_room(const FlatPlan& plan) {
  std::uint64_t most_nodes = 0;
  std::uint64_t most_items =
      kPiecePoints * std::max<std::uint64_t>(4 * plan.specials.size(), plan.sharp_sides.size()
                                                                           << plan.greatest_label);
  for (std::size_t label = 0; label < kNodeKinds; ++label) {
    // As many invocations as it has quads, or vertices around.
    const std::uint64_t each = std::max(std::uint64_t{1} << 2 * label, std::uint64_t{4} << label);
    most_nodes = std::max(most_nodes, label == 0 ? 0 : plan.node_counts[label]);
    most_items = std::max(most_items, plan.node_counts[label] * each);
  }
  if (Result<void> room = require_items(most_items); !room) {
    return room;
  }
  return require_sizes(
      {{plan.points.size() * sizeof(glm::vec3), "the points around control faces"},
       {plan.roots.size() * sizeof(FlatNode), "control faces"},
       {plan.roots.size() * kNodeKinds * sizeof(std::uint32_t), "the numbers of control faces"},
       {plan.ring_points.size() * sizeof(glm::vec3), "the rings of irregular vertices"},
       {plan.shares.size() * sizeof(float), "creases"},
       {most_nodes * sizeof(FlatNode), "uniform faces"},
       {plan.resting_quads.size() * sizeof(FlatQuad), "faces that stay"},
       {plan.vertex_count * sizeof(glm::vec3), "its vertices"},
       {plan.quad_count * sizeof(std::array<std::uint32_t, 4>), "its faces"}});
}

}  // namespace limn::render

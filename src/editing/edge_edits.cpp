#include "limn/editing/edge_edits.h"

#include <string_view>

#include <fmt/format.h>

#include "editing/surgery.h"
#include "limn/contract.h"

namespace limn {
namespace {

tl::unexpected<Error> refuse(const ControlMesh& mesh, std::uint32_t edge, std::string_view what,
                             std::string_view reason) {
  const auto [from, to] = mesh.topology().edge_vertices[edge];
  return fail(
      ErrorKind::kFailed,
      fmt::format("The edge between vertices {} and {} cannot be {}: {}.", from, to, what, reason));
}

}  // namespace

Result<std::shared_ptr<const ControlMesh>> split_edge(const ControlMesh& mesh, std::uint32_t edge) {
  LIMN_EXPECTS(edge < mesh.edge_count());
  const std::uint32_t corner = mesh.topology().edge_corners[edge][0];
  Surgery surgery(mesh);
  if (const auto reason = surgery.why_not_split(corner)) {
    return refuse(mesh, edge, "split", *reason);
  }
  surgery.split(corner);
  return surgery.finish();
}

Result<std::shared_ptr<const ControlMesh>> flip_edge(const ControlMesh& mesh, std::uint32_t edge) {
  LIMN_EXPECTS(edge < mesh.edge_count());
  const std::uint32_t corner = mesh.topology().edge_corners[edge][0];
  Surgery surgery(mesh);
  if (const auto reason = surgery.why_not_flip(corner)) {
    return refuse(mesh, edge, "flipped", *reason);
  }
  surgery.flip(corner);
  return surgery.finish();
}

}  // namespace limn

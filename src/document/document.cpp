#include "limn/document/document.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace limn {
namespace {

/// The high half numbers the document, the low half counts its changes.
std::uint64_t first_revision() noexcept {
  static std::atomic<std::uint64_t> documents{0};
  return ++documents << 32U;
}

}  // namespace

int deepest_painting(const Document& document) noexcept {
  int deepest = document.depths.deepest();
  if (document.settings.scheme == RefinementScheme::kCatmullClark) {
    for (const FineDemand& demand : document.demands.all()) {
      deepest = std::max<int>(deepest, demand.depth);
    }
  }
  return deepest;
}

std::optional<SchemeSettings> shown_scheme(const Document& document) noexcept {
  std::optional<SchemeSettings> scheme = document.scheme;
  if (scheme) {
    scheme->corners = document.settings.corners;
  }
  return scheme;
}

Document make_document(ImportedMesh mesh, std::string name, std::filesystem::path mesh_path) {
  LIMN_EXPECTS(mesh.mesh != nullptr);
  Document document;
  document.depths = FaceDepths(mesh.mesh->face_count());
  LIMN_EXPECTS(mesh.depths.empty() || mesh.depths.size() == mesh.mesh->face_count());
  for (std::size_t f = 0; f < mesh.depths.size(); ++f) {
    constexpr auto deepest = static_cast<std::uint32_t>(kMaxDepth);
    mesh.report.add(MendKind::kCappedDepth, mesh.depths[f] > deepest ? 1 : 0);
    document.depths.set(f, static_cast<int>(std::min(mesh.depths[f], deepest)));
  }
  document.control = mesh.mesh;
  document.settings.corners = mesh.mesh->attributes().corners.value_or(document.settings.corners);
  document.opened = std::move(mesh.mesh);
  document.name = std::move(name);
  document.mesh_path = std::move(mesh_path);
  document.import_report = std::move(mesh.report);
  const std::uint64_t revision = first_revision();
  document.revisions = {revision, revision, revision};
  return document;
}

}  // namespace limn

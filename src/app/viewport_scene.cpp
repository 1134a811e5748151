// Each part is uploaded when the revision it was made from is no longer the session's. The drawn
// image is kept: panels can be drawn over it again and again without touching the mesh.
#include "app/viewport_scene.h"

#include <utility>

#include "app/session.h"
#include "limn/mesh/refined_mesh.h"

namespace limn::app {
namespace {

constexpr float kRingWidth = 1.5F;

render::DrawSettings draw_settings(const ui::DisplaySettings& display, double scale) {
  render::DrawSettings settings;
  settings.shading = display.smooth ? render::Shading::kSmooth : render::Shading::kFlat;
  settings.theme =
      display.theme == ui::Theme::kLight ? render::Theme::kLight : render::Theme::kDark;
  settings.is_lit = display.light;
  settings.has_wireframe = display.wireframe;
  settings.shows_illegal_faces = display.illegal_marks;
  settings.scale = static_cast<float>(scale);
  return settings;
}

/// Dots on the illegal vertices alone.
std::vector<render::Marker> illegal_markers(const ControlMesh& mesh,
                                            std::span<const std::uint32_t> vertices) {
  std::vector<render::Marker> markers;
  markers.reserve(vertices.size());
  for (const std::uint32_t vertex : vertices) {
    markers.push_back({glm::vec3(mesh.positions()[vertex] - mesh.bounds().centre()),
                       render::MarkerStyle::kIllegal, 0});
  }
  return markers;
}

}  // namespace

Result<void> ViewportScene::sync(const Session& session) {
  const Document& document = session.document();
  const LiveRefinement& refinement = session.refinement();
  const bool is_same_surface =
      control_mesh_ != nullptr && &control_mesh_->topology() == &document.control->topology();
  if (control_mesh_ != document.control) {
    control_creases_.upload(render::crease_lines(*document.control));
    ++content_;
  }
  if (!is_same_surface) {
    auto uploaded = control_.upload(render::make_surface(*document.control), ++control_revision_);
    if (!uploaded) {
      return uploaded;
    }
    paint_.reset(document.depths.values());
    depths_revision_ = document.revisions.depths;
    label_key_.reset();
    ++content_;
  } else if (depths_revision_ != document.revisions.depths) {
    paint_.set_depths(document.depths.values());
    depths_revision_ = document.revisions.depths;
    ++content_;
  }
  control_mesh_ = document.control;
  if (refined_revision_ != refinement.refined_revision()) {
    const JobResult* result = refinement.refined();
    has_refined_ = false;
    refined_revision_ = refinement.refined_revision();
    ++content_;
    if (result != nullptr) {
      auto uploaded = refined_.upload(*result->surface, refinement.refined_revision() + 1);
      if (!uploaded) {
        return uploaded;
      }
      refined_creases_.upload(render::crease_lines(*result->refinement->mesh, refined_.origin()));
      has_refined_ = true;
    }
  }
  sync_labels(session);
  return {};
}

void ViewportScene::sync_labels(const Session& session) {
  const Document& document = session.document();
  const LiveRefinement& refinement = session.refinement();
  const ui::DisplaySettings& display = session.display();
  const bool is_on_refined = has_refined_ && session.shows_refined();
  const LabelKey key{refinement.labels_revision(),
                     is_on_refined ? refinement.refined_revision() : 0,
                     display.labels,
                     display.illegal_marks,
                     document.stage.is_legalised,
                     is_on_refined};
  if (label_key_ == key) {
    return;
  }
  label_key_ = key;
  ++content_;
  const DerivedLabels* labels = refinement.labels();
  std::vector<render::Marker> markers;
  std::span<const std::uint32_t> illegal_faces;
  if (labels != nullptr) {
    const ControlMesh& mesh = *document.control;
    std::span<const std::uint32_t> illegal;
    if (key.shows_illegal && !key.is_legalised) {
      illegal = labels->illegal_vertices;
      illegal_faces = labels->illegal_faces;
    }
    if (key.shows_labels) {
      markers = key.is_legalised
                    ? render::label_markers(mesh, labels->legal.labels, {}, labels->raised_vertices)
                    : render::label_markers(mesh, labels->painted, illegal, {});
    } else {
      markers = illegal_markers(mesh, illegal);
    }
    if (is_on_refined && markers.size() == mesh.vertex_count()) {
      // The refined mesh begins with the control mesh's vertices, moved.
      const RefinedMesh& refined = *refinement.refined()->refinement->mesh;
      for (std::size_t v = 0; v < markers.size(); ++v) {
        markers[v].position = glm::vec3(refined.position(v) - refined_.origin());
      }
    }
  }
  paint_.set_illegal(illegal_faces);
  markers_.upload(markers, ++marker_revision_);
}

render::Camera ViewportScene::camera(const Session& session, render::FramebufferSize size) {
  return render::make_camera(session.view(), session.document().control->bounds(), size);
}

const render::SurfaceBuffers& ViewportScene::surface(const Session& session) const {
  return has_refined_ && session.shows_refined() ? refined_ : control_;
}

void ViewportScene::draw(const Session& session, render::FramebufferSize size,
                         const ViewportLook& look) {
  const bool shows_refined = has_refined_ && session.shows_refined();
  Shown wanted{session.view(),    size,
               session.display(), look.scale,
               shows_refined,     content_,
               look.ring,         {look.highlighted.begin(), look.highlighted.end()}};
  if (shown_ == wanted) {
    return;
  }
  if (!shown_ || shown_->highlighted != wanted.highlighted || shown_->content != wanted.content) {
    paint_.set_highlighted(look.highlighted);
  }
  target_.resize({size.width, size.height});
  render::Scene scene;
  scene.surface = shows_refined ? &refined_ : &control_;
  scene.paint = &paint_;
  scene.cage = shows_refined && session.display().show == ui::ShowMode::kBoth ? &control_ : nullptr;
  if (session.display().creases) {
    scene.creases = shows_refined ? &refined_creases_ : &control_creases_;
    scene.cage_creases = scene.cage != nullptr ? &control_creases_ : nullptr;
  }
  scene.markers = markers_.count() > 0 ? &markers_ : nullptr;
  if (look.ring) {
    scene.ring = render::OverlayRing{{look.ring->centre.x, look.ring->centre.y},
                                     static_cast<float>(look.ring->radius),
                                     kRingWidth * static_cast<float>(look.scale)};
  }
  renderer_.draw(target_, camera(session, size), scene,
                 draw_settings(session.display(), look.scale));
  shown_ = std::move(wanted);
}

std::optional<render::PickedFace> ViewportScene::pick(const Session& session,
                                                      render::FramebufferSize size,
                                                      render::FramebufferPoint point) {
  const render::Camera seen = camera(session, size);
  return picker_.pick({surface(session), seen}, point);
}

std::vector<std::uint32_t> ViewportScene::brush(const Session& session,
                                                render::FramebufferSize size,
                                                const render::BrushCapsule& capsule) {
  const render::Camera seen = camera(session, size);
  return picker_.brush({surface(session), seen}, capsule);
}

std::vector<std::uint32_t> ViewportScene::visible_faces(const Session& session,
                                                        render::FramebufferSize size) {
  const render::Camera seen = camera(session, size);
  return picker_.visible_faces({surface(session), seen});
}

}  // namespace limn::app

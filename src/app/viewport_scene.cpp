// Each part is uploaded when the revision it was made from is no longer the session's. The drawn
// image is kept: panels can be drawn over it again and again without touching the mesh.
#include "app/viewport_scene.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/session.h"
#include "limn/mesh/refined_mesh.h"
#include "render/surface/face_order.h"

namespace limn::app {
namespace {

constexpr float kRingWidth = 1.5F;
constexpr float kEdgeWidth = 4.0F;
constexpr float kOutlineWidth = 1.5F;
constexpr float kOutlineRim = 3.5F;

// One list of names, seen from two rooms.
static_assert(static_cast<int>(ui::Tint::kDepth) == static_cast<int>(render::FaceColour::kDepth));
static_assert(static_cast<int>(ui::Tint::kLevel) == static_cast<int>(render::FaceColour::kLevel));
static_assert(static_cast<int>(ui::Tint::kNone) == static_cast<int>(render::FaceColour::kPlain));
static_assert(static_cast<int>(ui::Tint::kDistance) ==
              static_cast<int>(render::FaceColour::kDistance));
static_assert(static_cast<int>(ui::Material::kShiny) == static_cast<int>(render::Material::kShiny));

render::DrawSettings draw_settings(const ui::DisplaySettings& display, double scale) {
  render::DrawSettings settings;
  settings.shading = display.smooth ? render::Shading::kSmooth : render::Shading::kFlat;
  settings.theme =
      display.theme == ui::Theme::kLight ? render::Theme::kLight : render::Theme::kDark;
  settings.is_lit = display.light;
  settings.has_wireframe = display.wireframe;
  settings.has_faces = display.faces;
  settings.colour = static_cast<render::FaceColour>(display.tint);
  settings.material = static_cast<render::Material>(display.material);
  settings.has_numbers = display.numbers;
  settings.shows_illegal_faces = display.illegal_marks;
  settings.scale = static_cast<float>(scale);
  return settings;
}

/// Whether the control mesh's edges lie over the refined mesh: to be seen, or to be aimed at.
bool has_cage(const Session& session) {
  return session.display().show == ui::ShowMode::kBoth || ui::picks_edges(session.brush().tool);
}

/// An edge as a line on the screen; nothing where it runs before the near plane.
std::optional<render::OverlaySegment> edge_segment(const ControlMesh& mesh, std::uint32_t edge,
                                                   const render::Camera& camera, double scale) {
  const auto& ends = mesh.topology().edge_vertices[edge];
  const auto from = render::project(camera, mesh.positions()[ends[0]]);
  const auto to = render::project(camera, mesh.positions()[ends[1]]);
  if (!from || !to) {
    return std::nullopt;
  }
  render::OverlaySegment segment;
  segment.from = {from->point.x, from->point.y};
  segment.to = {to->point.x, to->point.y};
  segment.width = kEdgeWidth * static_cast<float>(scale);
  return segment;
}

/// An outline with a dark rim, to be seen on every colour.
std::vector<render::OverlaySegment> outline_segments(const Outline& outline, double scale) {
  std::vector<render::OverlaySegment> segments;
  const std::size_t corners = outline.points.size();
  if (corners < 2) {
    return segments;
  }
  const std::size_t sides = outline.is_closed ? corners : corners - 1;
  for (const bool is_rim : {true, false}) {
    for (std::size_t i = 0; i < sides; ++i) {
      const render::FramebufferPoint& from = outline.points[i];
      const render::FramebufferPoint& to = outline.points[i + 1 == corners ? 0 : i + 1];
      render::OverlaySegment& segment = segments.emplace_back();
      segment.from = {from.x, from.y};
      segment.to = {to.x, to.y};
      segment.width = (is_rim ? kOutlineRim : kOutlineWidth) * static_cast<float>(scale);
      if (is_rim) {
        segment.colour = {0, 0, 0};
      }
    }
  }
  return segments;
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
  if (auto synced = sync_refined(refinement, refined_); !synced) {
    return synced;
  }
  sync_numbers(session.display(), refinement, refined_);
  if (session.is_split()) {
    if (auto synced = sync_refined(session.second(), second_); !synced) {
      return synced;
    }
    sync_numbers(session.display(), session.second(), second_);
  }
  sync_labels(session);
  sync_distances(session);
  if (session.display().valences) {
    const auto mesh_of = [](bool is_shown, const LiveRefinement& shown) {
      return is_shown ? shown.refined()->mesh.get() : nullptr;
    };
    sync_dots(session.valences(), *document.control, mesh_of(session.shows_refined(), refinement),
              valences_);
    if (session.is_split()) {
      sync_dots(session.second_valences(), *document.control,
                mesh_of(session.shows_second_refined(), session.second()), second_valences_);
    }
  }
  return {};
}

Result<void> ViewportScene::sync_refined(const LiveRefinement& refinement, Refined& refined) {
  if (refined.revision == refinement.refined_revision()) {
    return {};
  }
  refined.is_there = false;
  refined.source = nullptr;
  refined.revision = refinement.refined_revision();
  ++content_;
  if (const JobResult* result = refinement.refined(); result != nullptr) {
    auto uploaded = refined.surface.upload(*result->surface, *refined.revision + 1);
    if (!uploaded) {
      return uploaded;
    }
    refined.creases.upload(render::crease_lines(*result->mesh, refined.surface.origin()));
    refined.demands.upload(result->surface->face_demands);
    refined.lit.reset(result->surface->face_count());
    refined.source = refinement.shared_refined();
    refined.is_there = true;
    refined.has_numbered = false;
  }
  return {};
}

void ViewportScene::sync_numbers(const ui::DisplaySettings& display,
                                 const LiveRefinement& refinement, Refined& refined) {
  const bool are_wanted = display.numbers && display.tint != ui::Tint::kLevel;
  if (are_wanted && refined.is_there && !refined.has_numbered) {
    refined.numbered.upload(render::middle_faces(*refinement.refined()->surface));
    refined.has_numbered = true;
    ++content_;
  }
}

ViewportScene::Distances::Source ViewportScene::distance_source(const Session& session) const {
  return {session.distance().revision(), refined_.revision.value_or(0),
          session.document().revisions.control, refined_.is_there && session.shows_refined()};
}

void ViewportScene::sync_distances(const Session& session) {
  const DistanceJob& job = session.distance();
  const Distances::Source source = distance_source(session);
  if (session.display().tint != ui::Tint::kDistance || distances_.source == source) {
    return;
  }
  distances_.source = source;
  distances_.are_there = false;
  ++content_;
  const auto upload = [&](const auto& mesh) {
    if (const LimitDistance* distance = job.distance(&mesh); distance != nullptr) {
      distances_.faces.upload(mesh, distance->of_faces, distance->greatest());
      distances_.are_there = true;
    }
  };
  if (source.is_of_refined) {
    upload(*session.refinement().refined()->mesh);
  } else {
    upload(*session.document().control);
  }
}

void ViewportScene::leave_out_refined(const Session& session) {
  refined_.revision = session.refinement().refined_revision();
  refined_.is_there = false;
  second_.revision = session.second().refined_revision();
  second_.is_there = false;
  ++content_;
}

void ViewportScene::sync_dots(const ShownValences& valences, const ControlMesh& control,
                              const RefinedMesh* refined, Dots& dots) {
  if (dots.revision == valences.revision()) {
    return;
  }
  dots.revision = valences.revision();
  ++content_;
  const glm::dvec3& origin = control_.origin();
  dots.markers.upload(refined != nullptr
                          ? render::valence_markers(*refined, valences.vertices(), origin)
                          : render::valence_markers(control, valences.vertices(), origin),
                      *dots.revision);
}

void ViewportScene::sync_labels(const Session& session) {
  const Document& document = session.document();
  const LiveRefinement& refinement = session.refinement();
  const ui::DisplaySettings& display = session.display();
  const bool is_on_refined = refined_.is_there && session.shows_refined();
  const LegalisationStepper& steps = session.steps();
  const LabelKey key{refinement.labels_revision(),
                     steps.moment() != nullptr ? steps.revision() : 0,
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
  if (const LegalisationStepper::Moment* moment = steps.moment(); moment != nullptr) {
    illegal_faces = moment->illegal_faces;
    markers =
        render::step_markers(*document.control, steps.labels(),
                             {moment->illegal_vertices, moment->raised_vertices, moment->candidates,
                              moment->falling, steps.status().order, display.labels});
  } else if (labels != nullptr) {
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
      const RefinedMesh& refined = *refinement.refined()->mesh;
      for (std::size_t v = 0; v < markers.size(); ++v) {
        markers[v].position = glm::vec3(refined.position(v) - refined_.surface.origin());
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
  return refined_.is_there && session.shows_refined() ? refined_.surface : control_;
}

render::Scene ViewportScene::scene_of(const Session& session, const Refined* refined,
                                      const Dots& dots) const {
  render::Scene scene;
  scene.surface = refined != nullptr ? &refined->surface : &control_;
  scene.paint = &paint_;
  scene.cage = refined != nullptr && has_cage(session) ? &control_ : nullptr;
  if (session.display().creases) {
    scene.creases = refined != nullptr ? &refined->creases : &control_creases_;
    scene.cage_creases = scene.cage != nullptr ? &control_creases_ : nullptr;
  }
  if (refined != nullptr && session.display().tint != ui::Tint::kLevel) {
    scene.numbered = &refined->numbered;
  }
  if (refined != nullptr && refined->demands.count() > 0) {
    scene.demands = &refined->demands;
  }
  if (session.display().valences && dots.markers.count() > 0) {
    scene.valences = &dots.markers;
  }
  return scene;
}

void ViewportScene::draw(const Session& session, render::FramebufferSize size,
                         const ViewportLook& look) {
  const bool shows_refined = refined_.is_there && session.shows_refined();
  const bool shows_second = second_.is_there && session.shows_second_refined();
  Shown wanted{session.view(),    size,
               session.display(), look.scale,
               shows_refined,     shows_second,
               content_,          look.ring,
               look.outline,      {look.highlighted.begin(), look.highlighted.end()},
               look.edge,         has_cage(session)};
  if (look.lit != nullptr && shows_refined && look.lit->refined == refined_.source) {
    wanted.lit = look.lit->faces;
  }
  if (shown_ == wanted) {
    return;
  }
  if (!shown_ || shown_->highlighted != wanted.highlighted || shown_->content != wanted.content) {
    paint_.set_highlighted(look.highlighted);
  }
  if (wanted.lit && (!shown_ || shown_->lit != wanted.lit || shown_->content != wanted.content)) {
    const JobResult& source = *refined_.source;
    refined_.lit.assign(render::drawn_faces(*source.surface, *source.mesh, *wanted.lit));
  }
  const render::Camera seen = camera(session, size);
  render::DrawSettings settings = draw_settings(session.display(), look.scale);
  settings.shows_illegal_faces |= session.steps().moment() != nullptr;
  if (session.is_split()) {
    second_target_.resize({size.width, size.height});
    renderer_.draw(second_target_, seen,
                   scene_of(session, shows_second ? &second_ : nullptr, second_valences_),
                   settings);
  }
  target_.resize({size.width, size.height});
  render::Scene scene = scene_of(session, shows_refined ? &refined_ : nullptr, valences_);
  if (distances_.are_there && distances_.source == distance_source(session)) {
    scene.distances = &distances_.faces;
  }
  scene.lit = wanted.lit ? &refined_.lit : nullptr;
  scene.markers = markers_.count() > 0 ? &markers_ : nullptr;
  if (look.ring) {
    scene.ring = render::OverlayRing{{look.ring->centre.x, look.ring->centre.y},
                                     static_cast<float>(look.ring->radius),
                                     kRingWidth * static_cast<float>(look.scale)};
  }
  std::vector<render::OverlaySegment> segments = outline_segments(look.outline, look.scale);
  if (look.edge) {
    if (const auto segment =
            edge_segment(*session.document().control, *look.edge, seen, look.scale)) {
      segments.push_back(*segment);
    }
  }
  scene.segments = segments;
  renderer_.draw(target_, seen, scene, settings);
  shown_ = std::move(wanted);
}

std::optional<render::PickedFace> ViewportScene::pick(const Session& session,
                                                      render::FramebufferSize size,
                                                      render::FramebufferPoint point) {
  const render::Camera seen = camera(session, size);
  return picker_.pick({surface(session), seen}, point);
}

std::vector<std::uint32_t> ViewportScene::faces_in(const Session& session,
                                                   render::FramebufferSize size,
                                                   const render::ScreenRegion& region,
                                                   Reach reach) {
  const render::Camera seen = camera(session, size);
  std::vector<std::uint32_t> visible = picker_.faces_in({surface(session), seen}, region);
  if (reach == Reach::kVisible) {
    return visible;
  }
  const auto& control = session.document().control;
  std::vector<std::uint32_t> faces =
      refined_.is_there && session.shows_refined()
          ? through_picker_.faces_in(session.refinement().refined()->mesh, control->face_count(),
                                     seen, region)
          : through_picker_.faces_in(control, seen, region);
  // A face that is not flat may show a little beyond the outline of its corners.
  std::ranges::sort(visible);
  std::vector<std::uint32_t> all;
  std::ranges::set_union(faces, visible, std::back_inserter(all));
  return all;
}

ShownFaces ViewportScene::shown_faces_in(const Session& session, render::FramebufferSize size,
                                         const render::ScreenRegion& region, Reach reach) {
  if (!refined_.is_there || !session.shows_refined() || !has_fine_faces(*refined_.source)) {
    ShownFaces shown{nullptr, faces_in(session, size, region, reach)};
    std::ranges::sort(shown.faces);
    return shown;
  }
  const render::Camera seen = camera(session, size);
  const JobResult& source = *refined_.source;
  std::vector<std::uint32_t> faces = render::refined_faces(
      *source.surface, *source.mesh, picker_.drawn_faces_in({refined_.surface, seen}, region));
  if (reach == Reach::kThrough) {
    std::vector<std::uint32_t> all;
    std::ranges::set_union(through_picker_.refined_faces_in(source.mesh, seen, region), faces,
                           std::back_inserter(all));
    faces = std::move(all);
  }
  return {refined_.source, std::move(faces)};
}

std::vector<std::uint32_t> ViewportScene::visible_faces(const Session& session,
                                                        render::FramebufferSize size) {
  const render::Camera seen = camera(session, size);
  return picker_.visible_faces({surface(session), seen});
}

}  // namespace limn::app

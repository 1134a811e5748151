#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/paint_tools/paint_tools.h"
#include "app/paint_tools/shown_faces.h"
#include "app/viewport_frame.h"
#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "render/camera.h"
#include "render/mesh_renderer.h"
#include "render/picking/face_picker.h"
#include "render/picking/through_picker.h"
#include "render/render_target.h"
#include "render/surface/crease_lines.h"
#include "render/surface/face_demands.h"
#include "render/surface/face_distances.h"
#include "render/surface/face_paint.h"
#include "render/surface/markers.h"
#include "render/surface/surface_buffers.h"
#include "ui/model.h"

namespace limn::app {

class LiveRefinement;
class Session;
class ShownValences;

/// What a viewport needs beside the session to be drawn.
struct ViewportLook {
  std::optional<BrushRing> ring;
  Outline outline;
  std::span<const std::uint32_t> highlighted;  ///< Control faces.
  std::optional<std::uint32_t> edge;           ///< A control edge that lights up.
  double scale = 1.0;                          ///< Pixels per unit of the interface.
  const ShownFaces* lit = nullptr;  ///< Light up in place of `highlighted`, if they are shown.
};

/// A session's meshes on the GPU: uploads what has changed since last time, draws when something
/// that shows has changed, and answers what is under the mouse.
class ViewportScene {
 public:
  /// Needs a current context. Throws render::EnvironmentError.
  ViewportScene() = default;

  /// Uploads whatever of the session's document and refinement is new.
  /// Errors: kEnvironment where the graphics memory or driver cannot hold it; what was there stays.
  [[nodiscard]] Result<void> sync(const Session& session);
  /// Draws the control mesh instead of the refined meshes there are now, until there are others:
  /// the graphics card does not hold them.
  void leave_out_refined(const Session& session);

  /// The camera of the session's view for an image of this size.
  [[nodiscard]] static render::Camera camera(const Session& session, render::FramebufferSize size);

  /// Draws into an image of its own of this size, unless that is what it shows already; where the
  /// viewport is split, into one of that size for each half.
  void draw(const Session& session, render::FramebufferSize size, const ViewportLook& look);
  /// Copies the image into a framebuffer (0: the window's), its lower left corner at this pixel.
  void present(glm::ivec2 lower_left, GLuint framebuffer = 0) const {
    target_.resolve_to(framebuffer, lower_left);
  }
  /// The same with that of the second half.
  void present_second(glm::ivec2 lower_left, GLuint framebuffer = 0) const {
    second_target_.resolve_to(framebuffer, lower_left);
  }

  /// The image that was drawn last; of the first half where there are two.
  [[nodiscard]] render::Image picture() const { return target_.read(); }

  [[nodiscard]] std::optional<render::PickedFace> pick(const Session& session,
                                                       render::FramebufferSize size,
                                                       render::FramebufferPoint point);
  [[nodiscard]] std::vector<std::uint32_t> faces_in(const Session& session,
                                                    render::FramebufferSize size,
                                                    const render::ScreenRegion& region,
                                                    Reach reach);
  /// Faces of what `sync` has uploaded.
  [[nodiscard]] ShownFaces shown_faces_in(const Session& session, render::FramebufferSize size,
                                          const render::ScreenRegion& region, Reach reach);
  [[nodiscard]] std::vector<std::uint32_t> visible_faces(const Session& session,
                                                         render::FramebufferSize size);

 private:
  /// Everything the drawn image depends on.
  struct Shown {
    ViewState view;
    render::FramebufferSize size;
    ui::DisplaySettings display;
    double scale = 0.0;
    bool shows_refined = false;
    bool shows_second_refined = false;
    std::uint64_t content = 0;
    std::optional<BrushRing> ring;
    Outline outline;
    std::vector<std::uint32_t> highlighted;
    std::optional<std::uint32_t> edge;
    bool has_cage = false;
    std::optional<std::vector<std::uint32_t>> lit{};  ///< Faces of the refined mesh.

    [[nodiscard]] bool operator==(const Shown&) const = default;
  };

  /// A refined mesh, and what was last uploaded of it.
  struct Refined {
    render::SurfaceBuffers surface;
    render::CreaseBuffers creases;
    render::NumberedFaces numbered;
    render::FaceDemands demands;
    render::FaceSetBuffer lit{"lit faces"};
    std::shared_ptr<const JobResult> source;
    std::optional<std::uint64_t> revision;
    bool is_there = false;
    bool has_numbered = false;  ///< `numbered` is of what is there.
  };
  /// How far the faces of the mesh shown are from the limit surface.
  struct Distances {
    /// Revisions of the job and of either mesh, and for which of the two they are.
    struct Source {
      std::uint64_t job = 0;
      std::uint64_t refined = 0;
      std::uint64_t control = 0;
      bool is_of_refined = false;

      [[nodiscard]] bool operator==(const Source&) const = default;
    };
    render::FaceDistances faces;
    Source source;
    bool are_there = false;
  };
  [[nodiscard]] Distances::Source distance_source(const Session& session) const;
  /// Irregular vertices of what is shown.
  struct Dots {
    render::MarkerBuffers markers;
    std::optional<std::uint64_t> revision;
  };

  [[nodiscard]] Result<void> sync_refined(const LiveRefinement& refinement, Refined& refined);
  /// Which faces hold a number, once numbers are to be seen.
  void sync_numbers(const ui::DisplaySettings& display, const LiveRefinement& refinement,
                    Refined& refined);
  void sync_labels(const Session& session);
  void sync_distances(const Session& session);
  void sync_dots(const ShownValences& valences, const ControlMesh& control,
                 const RefinedMesh* refined, Dots& dots);
  /// What both halves have in common.
  [[nodiscard]] render::Scene scene_of(const Session& session, const Refined* refined,
                                       const Dots& dots) const;
  [[nodiscard]] const render::SurfaceBuffers& surface(const Session& session) const;

  render::SurfaceBuffers control_;
  Refined refined_;
  Refined second_;
  Distances distances_;
  render::CreaseBuffers control_creases_;
  render::FacePaint paint_;
  render::MarkerBuffers markers_;
  Dots valences_;
  Dots second_valences_;
  render::MeshRenderer renderer_;
  render::FacePicker picker_;
  render::ThroughPicker through_picker_;
  render::RenderTarget target_;
  render::RenderTarget second_target_;

  std::shared_ptr<const ControlMesh> control_mesh_;  ///< What `control_` holds.
  std::uint64_t control_revision_ = 0;               ///< Ours: counts uploads.
  std::optional<std::uint64_t> depths_revision_;

  struct LabelKey {
    std::uint64_t labels = 0;
    std::uint64_t step = 0;
    std::uint64_t refined = 0;
    bool shows_labels = false;
    bool shows_illegal = false;
    bool is_legalised = false;
    bool is_on_refined = false;
    [[nodiscard]] bool operator==(const LabelKey&) const = default;
  };
  std::optional<LabelKey> label_key_;
  std::uint64_t marker_revision_ = 0;

  std::uint64_t content_ = 0;  ///< Counts all uploads.
  std::optional<Shown> shown_;
};

}  // namespace limn::app

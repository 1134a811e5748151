#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "limn/mesh/control_mesh.h"
#include "limn/mesh/refined_mesh.h"
#include "limn/painting/valence_palette.h"
#include "limn/subdivision/labels.h"
#include "limn/subdivision/legalisation_trace.h"
#include "render/gl/buffer.h"
#include "render/gl/vertex_array.h"

namespace limn::render {

/// What a marker looks like; the numbers are those of shaders/markers.frag.glsl.
enum class MarkerStyle : std::uint8_t {
  kLabel = 0,       ///< A dot in the number's depth colour with the number in it; 0 is a small dot.
  kIllegal = 1,     ///< A magenta dot.
  kRelabelled = 2,  ///< An amber dot with the number in it.
  kFaceNumber = 3,  ///< The number alone, in ink that is read on its depth colour.
  /// The first of kValenceBands styles: a dot in the band's colour with the number in it.
  kValence = 4,
  // The next ones are pills with the marker's text.
  kCandidate = 8,  ///< A magenta one: might be raised next.
  kPicked = 9,     ///< An amber one with a ring: is raised next.
};

/// What is written in a pill.
enum class MarkerText : std::uint8_t {
  kPair = 0,      ///< "number / second".
  kDecimal = 1,   ///< "number.second", second being a single digit.
  kNegative = 2,  ///< The same with a minus before it.
  kBecomes = 3,   ///< "number > second".
};

/// A dot or number at a point of a surface.
struct Marker {
  glm::vec3 position{0.0F};  ///< Relative to the surface's origin.
  MarkerStyle style = MarkerStyle::kLabel;
  std::uint8_t number = 0;  ///< 0..99.
  std::uint8_t second = 0;  ///< Of a pill, 0..99.
  MarkerText text = MarkerText::kPair;
};

/// What is to be seen of a legalisation before its next step: a dot or pill for every vertex that
/// matters. Spans hold vertices of the mesh; the first candidate is the one picked.
struct StepMarkers {
  std::span<const std::uint32_t> illegal;
  std::span<const std::uint32_t> raised;
  std::span<const LegalisationCandidate> candidates;
  std::span<const std::uint32_t> falling;  ///< Set back to 0 next.
  LegalisationMethod order = LegalisationMethod::kGreedy;
  bool shows_labels = false;  ///< Those of all other vertices as well.
};
[[nodiscard]] std::vector<Marker> step_markers(const ControlMesh& mesh, const VertexLabels& labels,
                                               const StepMarkers& step);

/// What the labels of a control mesh look like: a dot a vertex. Vertices of `illegal` are magenta;
/// those of `raised` are amber.
[[nodiscard]] std::vector<Marker> label_markers(const ControlMesh& mesh, const VertexLabels& labels,
                                                std::span<const std::uint32_t> illegal,
                                                std::span<const std::uint32_t> raised);

/// The depth of every painted control face, as a number at its centroid.
[[nodiscard]] std::vector<Marker> depth_markers(const ControlMesh& mesh,
                                                std::span<const std::uint8_t> depths);

/// Dots with the valence of irregular vertices of a mesh (control or refined), relative to
/// `origin`.
[[nodiscard]] std::vector<Marker> valence_markers(const ControlMesh& mesh,
                                                  std::span<const IrregularVertex> vertices,
                                                  const glm::dvec3& origin);
[[nodiscard]] std::vector<Marker> valence_markers(const RefinedMesh& mesh,
                                                  std::span<const IrregularVertex> vertices,
                                                  const glm::dvec3& origin);

/// Markers on the GPU. Upload where they change, never a frame.
class MarkerBuffers {
 public:
  /// Needs a current context.
  MarkerBuffers();

  /// Replaces the markers and remembers `revision`, a number of the caller's choosing, not 0.
  void upload(std::span<const Marker> markers, std::uint64_t revision);
  [[nodiscard]] bool has(std::uint64_t revision) const noexcept { return revision_ == revision; }
  [[nodiscard]] std::size_t count() const noexcept { return count_; }

  /// Binds slot 8 and draws six vertices a marker with the program in use.
  void draw() const;

 private:
  gl::VertexArray no_attributes_;
  gl::Buffer records_;
  std::size_t count_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace limn::render

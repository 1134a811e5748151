#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/mesh/creases.h"
#include "limn/subdivision/settings.h"

namespace limn {

/// The uniform subdivision schemes: every face of the mesh is subdivided at every level.
enum class Scheme : std::uint8_t {
  kLinear,        ///< Split at the midpoints of edges; no smoothing, or averaging by centroids.
  kCatmullClark,  ///< Catmull & Clark 1978.
  kLoop,          ///< Loop 1987, with his weights or Warren's.
  kButterfly,     ///< Modified butterfly: Zorin, Schroeder & Sweldens 1996.
  kKobbelt,       ///< Interpolating on quads: Kobbelt 1996.
  kSqrt3,         ///< Kobbelt 2000.
  kDooSabin,      ///< Doo & Sabin 1978.
  kMidedge,       ///< The simplest scheme: Peters & Reif 1997.
  kBiquartic,     ///< Degree 4 by repeated averaging: Zorin & Schroeder 2001.
};

inline constexpr std::size_t kSchemeCount = static_cast<std::size_t>(Scheme::kBiquartic) + 1;

/// Which faces a scheme takes.
enum class FaceKinds : std::uint8_t { kAny, kTriangles, kQuads };

/// What a person should know of a scheme before choosing it.
struct SchemeInfo {
  Scheme scheme;
  std::string_view name;   ///< On the command line: "catmull-clark".
  std::string_view title;  ///< In menus: "Catmull-Clark".
  FaceKinds takes;
  bool interpolates;            ///< Old vertices stay where they are.
  bool splits_vertices;         ///< Dual: faces take the place of vertices. Others split faces.
  std::string_view makes;       ///< What becomes of a face: "n quads of an n-gon".
  std::string_view continuity;  ///< Of the limit surface: "C2, C1 at extraordinary vertices".
  std::string_view boundary;    ///< The rule there, and at creases.
  std::string_view source;      ///< Authors and year.
};

/// All of them, in the order of `Scheme`.
[[nodiscard]] std::span<const SchemeInfo, kSchemeCount> schemes() noexcept;
[[nodiscard]] const SchemeInfo& scheme_info(Scheme scheme) noexcept;
/// By its name on the command line; nothing where no scheme has it.
[[nodiscard]] std::optional<Scheme> scheme_named(std::string_view name) noexcept;

/// A scheme with its choices.
struct SchemeSettings {
  Scheme scheme = Scheme::kCatmullClark;
  LoopWeights weights = LoopWeights::kOriginal;  ///< kLoop.
  bool averages = false;  ///< kLinear: then every vertex becomes the mean of the centroids of the
                          ///< faces around it (Warren & Schaefer 2004).
  CornerRule corners = CornerRule::kSharp;

  [[nodiscard]] bool operator==(const SchemeSettings&) const = default;
};

/// Whether a scheme can take a mesh. Errors: kFailed, naming the first face that it cannot take and
/// what would make the mesh fit (`make_fit`, subdivision/schemes/uniform.h).
[[nodiscard]] Result<void> check_fits(const ControlMesh& mesh, Scheme scheme);

}  // namespace limn

#include "limn/subdivision/schemes/scheme.h"

#include <algorithm>

#include <fmt/format.h>

namespace limn {
namespace {

constexpr std::string_view kSplineBoundary =
    "cubic B-spline, corners of one face sharp or smooth; creases alike, semi-sharp";
constexpr std::string_view kFourPointBoundary =
    "four-point curve, through its vertices; creases alike";

constexpr std::array<SchemeInfo, kSchemeCount> kSchemes{{
    {Scheme::kLinear, "linear", "Linear", FaceKinds::kAny, true, false, "n quads of an n-gon",
     "C0; with averaging C2, C1 at extraordinary vertices",
     "straight; with averaging cubic B-spline, creases alike, semi-sharp",
     "split at midpoints; averaging by Warren & Schaefer 2004"},
    {Scheme::kCatmullClark, "catmull-clark", "Catmull-Clark", FaceKinds::kAny, false, false,
     "n quads of an n-gon", "C2, C1 at extraordinary vertices", kSplineBoundary,
     "Catmull & Clark 1978; creases by DeRose, Kass & Truong 1998"},
    {Scheme::kLoop, "loop", "Loop", FaceKinds::kTriangles, false, false,
     "4 triangles of a triangle", "C2, C1 at extraordinary vertices", kSplineBoundary,
     "Loop 1987; other weights by Warren 1995"},
    {Scheme::kButterfly, "butterfly", "Modified butterfly", FaceKinds::kTriangles, true, false,
     "4 triangles of a triangle", "C1", kFourPointBoundary,
     "Zorin, Schroeder & Sweldens 1996, after Dyn, Gregory & Levin 1990"},
    {Scheme::kKobbelt, "kobbelt", "Kobbelt's interpolating", FaceKinds::kQuads, true, false,
     "4 quads of a quad", "C1", kFourPointBoundary, "Kobbelt 1996"},
    {Scheme::kSqrt3, "sqrt3", "Sqrt(3)", FaceKinds::kTriangles, false, false,
     "3 triangles of a triangle", "C2, C1 at extraordinary vertices",
     "cubic B-spline, cut in three every second step; corners of one face sharp or smooth; creases "
     "are smoothed",
     "Kobbelt 2000"},
    {Scheme::kDooSabin, "doo-sabin", "Doo-Sabin", FaceKinds::kAny, false, true,
     "an n-gon of an n-gon, a quad of an edge, a k-gon of a vertex with k faces", "C1",
     "quadratic B-spline, corners of one face sharp or smooth; creases are smoothed",
     "Doo & Sabin 1978"},
    {Scheme::kMidedge, "midedge", "Midedge", FaceKinds::kAny, false, true,
     "an n-gon of an n-gon, a k-gon of a vertex with k faces", "C1",
     "quadratic B-spline, cut every second step; corners of one face sharp or smooth; creases are "
     "smoothed",
     "Peters & Reif 1997"},
    {Scheme::kBiquartic, "biquartic", "Biquartic", FaceKinds::kAny, false, true,
     "an n-gon of an n-gon, a quad of an edge, a k-gon of a vertex with k faces",
     "C3, C1 at extraordinary faces",
     "quartic B-spline, corners of one face sharp or smooth; creases are smoothed",
     "by repeated averaging, Zorin & Schroeder 2001"},
}};

/// Sides of the faces a scheme takes.
std::size_t sides_of(FaceKinds kinds) {
  return kinds == FaceKinds::kTriangles ? 3 : 4;
}

/// Two triangles on the same three vertices, back to back: their children would share edges four by
/// four. kNone where there are none.
std::uint32_t face_back_to_back(const ControlMesh& mesh) {
  const FlatTopology& flat = mesh.topology();
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const std::uint32_t first = flat.face_offsets[f];
    const auto beyond = [&](std::uint32_t i) {
      const std::uint32_t twin = flat.corner_twins[first + i];
      return twin == kNone ? kNone : flat.corner_faces[twin];
    };
    if (beyond(0) != kNone && beyond(0) == beyond(1) && beyond(0) == beyond(2)) {
      return f;
    }
  }
  return kNone;
}

}  // namespace

std::span<const SchemeInfo, kSchemeCount> schemes() noexcept {
  return kSchemes;
}

const SchemeInfo& scheme_info(Scheme scheme) noexcept {
  return kSchemes[static_cast<std::size_t>(scheme)];
}

std::optional<Scheme> scheme_named(std::string_view name) noexcept {
  const auto found = std::ranges::find(kSchemes, name, &SchemeInfo::name);
  return found == kSchemes.end() ? std::nullopt : std::optional(found->scheme);
}

Result<void> check_fits(const ControlMesh& mesh, Scheme scheme) {
  const SchemeInfo& info = scheme_info(scheme);
  if (info.takes == FaceKinds::kAny) {
    return {};
  }
  const bool wants_triangles = info.takes == FaceKinds::kTriangles;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() != sides_of(info.takes)) {
      return fail(
          ErrorKind::kFailed,
          fmt::format("{} takes {} only, and face {} has {} sides. {} first.", info.title,
                      wants_triangles ? "triangles" : "quads", f, mesh.face(f).size(),
                      wants_triangles ? "Triangulate the mesh" : "Make one Catmull-Clark step"));
    }
  }
  if (wants_triangles) {
    if (const std::uint32_t f = face_back_to_back(mesh); f != kNone) {
      return fail(
          ErrorKind::kFailed,
          fmt::format("Face {} lies back to back with another on the same three vertices; {} "
                      "cannot subdivide such a pair. Delete one of them.",
                      f, info.title));
    }
  }
  return {};
}

}  // namespace limn

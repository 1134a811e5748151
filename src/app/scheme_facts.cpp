#include "app/scheme_facts.h"

#include <algorithm>
#include <utility>

namespace limn::app {
namespace {

/// What helps where the faces are not of the kind that a scheme takes.
std::optional<Fitting> fitting_of(const ControlMesh& mesh, Scheme scheme) {
  const FaceKinds kinds = scheme_info(scheme).takes;
  const std::size_t sides = kinds == FaceKinds::kTriangles ? 3 : 4;
  for (std::size_t f = 0; kinds != FaceKinds::kAny && f < mesh.face_count(); ++f) {
    if (mesh.face(f).size() != sides) {
      return fitting_for(kinds);
    }
  }
  return std::nullopt;
}

}  // namespace

void SchemeFacts::update(const std::shared_ptr<const ControlMesh>& mesh,
                         const std::optional<SchemeSettings>& scheme) {
  if (mesh_ == mesh && scheme_ == scheme) {
    return;
  }
  mesh_ = mesh;
  scheme_ = scheme;
  misfit_.reset();
  counts_.clear();
  if (!scheme) {
    return;
  }
  if (auto fits = check_fits(*mesh, scheme->scheme); !fits) {
    misfit_ = ui::SchemeMisfit{std::move(fits.error().message), fitting_of(*mesh, scheme->scheme)};
  } else {
    counts_ = predict_scheme(*mesh, *scheme, kMostSchemeLevels);
  }
}

void ShownLevels::update(const std::shared_ptr<const ControlMesh>& control,
                         const std::shared_ptr<const RefinedMesh>& refined) {
  if (control_ == control && refined_ == refined) {
    return;
  }
  control_ = control;
  refined_ = refined;
  counts_ = {};
  if (refined == nullptr) {
    counts_[0] = control->face_count();
    return;
  }
  for (const std::uint8_t level : refined->face_levels) {
    ++counts_[std::min<std::size_t>(level, counts_.size() - 1)];
  }
}

void ShownValences::update(const std::shared_ptr<const ControlMesh>& control,
                           const std::shared_ptr<const RefinedMesh>& refined) {
  if (control_ == control && refined_ == refined) {
    return;
  }
  control_ = control;
  refined_ = refined;
  vertices_ = refined != nullptr ? irregular_vertices(*refined) : irregular_vertices(*control);
  counts_ = count_valences(vertices_);
  ++revision_;
}

}  // namespace limn::app

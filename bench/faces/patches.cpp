// Patch tables of every level are evaluated at the same places of the control mesh's faces as that
// of the deepest level, which stands for the limit.
#include "faces/patches.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include <opensubdiv/far/patchMap.h>
#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <glm/geometric.hpp>

#include "limn/contract.h"

namespace limn::bench {
namespace {

using namespace OpenSubdiv;  // NOLINT(google-build-using-namespace): its version namespace.
using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;

constexpr int kDeepest = 9;
/// Places looked at across a face (a quad of Ptex), in either direction.
constexpr int kPlaces = 9;

/// A position the way OpenSubdiv wants it.
struct Position {
  glm::dvec3 value{0.0};

  // NOLINTBEGIN(readability-identifier-naming): OpenSubdiv's names.
  void Clear() { value = glm::dvec3(0.0); }
  void AddWithWeight(const Position& p, double weight) { value += weight * p.value; }
  // NOLINTEND(readability-identifier-naming)
};

std::unique_ptr<Far::TopologyRefiner> base_level(const Subject& subject) {
  const ControlMesh& mesh = *subject.mesh;
  std::vector<int> sides;
  std::vector<Far::Index> vertices;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    sides.push_back(static_cast<int>(face.size()));
    vertices.insert(vertices.end(), face.begin(), face.end());
  }
  const std::vector<float>& crease_weights = mesh.creases().edge_sharpness;
  std::vector<Far::Index> crease_ends;
  for (std::size_t e = 0; e < crease_weights.size(); ++e) {
    for (const std::uint32_t end : mesh.topology().edge_vertices[e]) {
      crease_ends.push_back(static_cast<Far::Index>(end));
    }
  }
  const std::vector<float>& corner_weights = mesh.creases().vertex_sharpness;
  std::vector<Far::Index> corner_vertices(corner_weights.size());
  std::iota(corner_vertices.begin(), corner_vertices.end(), 0);

  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.vertex_count());
  descriptor.numFaces = static_cast<int>(mesh.face_count());
  descriptor.numVertsPerFace = sides.data();
  descriptor.vertIndicesPerFace = vertices.data();
  descriptor.numCreases = static_cast<int>(crease_weights.size());
  descriptor.creaseVertexIndexPairs = crease_ends.data();
  descriptor.creaseWeights = crease_weights.data();
  descriptor.numCorners = static_cast<int>(corner_weights.size());
  descriptor.cornerVertexIndices = corner_vertices.data();
  descriptor.cornerWeights = corner_weights.data();

  Sdc::Options options;
  options.SetCreasingMethod(mesh.creases().method == CreasingMethod::kChaikin
                                ? Sdc::Options::CREASE_CHAIKIN
                                : Sdc::Options::CREASE_UNIFORM);
  options.SetVtxBoundaryInterpolation(subject.settings.corners == CornerRule::kSharp
                                          ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                          : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  std::unique_ptr<Far::TopologyRefiner> refiner(
      Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_CATMARK, options)));
  LIMN_EXPECTS(refiner != nullptr);
  return refiner;
}

/// The patches of a level of isolation and their control points.
class PatchSurface {
 public:
  PatchSurface(const Subject& subject, const Far::TopologyRefiner& base, int isolation);

  [[nodiscard]] std::uint64_t count() const {
    return static_cast<std::uint64_t>(table_->GetNumPatchesTotal());
  }
  [[nodiscard]] glm::dvec3 at(int face, double u, double v) const;

 private:
  std::unique_ptr<Far::PatchTable> table_;
  std::unique_ptr<Far::PatchMap> map_;
  std::vector<Position> points_;
};

PatchSurface::PatchSurface(const Subject& subject, const Far::TopologyRefiner& base,
                           int isolation) {
  const std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(base));
  Far::PatchTableFactory::Options options(static_cast<unsigned>(isolation));
  options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
  options.useInfSharpPatch = true;
  options.generateLegacySharpCornerPatches = false;
  options.SetPatchPrecision<double>();
  refiner->RefineAdaptive(options.GetRefineAdaptiveOptions());
  table_.reset(Far::PatchTableFactory::Create(*refiner, options));
  map_ = std::make_unique<Far::PatchMap>(*table_);

  const auto refined = static_cast<std::size_t>(refiner->GetNumVerticesTotal());
  points_.resize(refined + static_cast<std::size_t>(table_->GetNumLocalPoints()));
  const auto control = subject.mesh->positions();
  for (std::size_t v = 0; v < control.size(); ++v) {
    points_[v].value = control[v];
  }
  const Far::PrimvarRefinerReal<double> primvars(*refiner);
  Position* from = points_.data();
  for (int level = 1; level <= refiner->GetMaxLevel(); ++level) {
    Position* to = from + refiner->GetLevel(level - 1).GetNumVertices();
    primvars.Interpolate(level, from, to);
    from = to;
  }
  if (table_->GetNumLocalPoints() > 0) {
    table_->GetLocalPointStencilTable<double>()->UpdateValues(points_.data(),
                                                              points_.data() + refined);
  }
}

glm::dvec3 PatchSurface::at(int face, double u, double v) const {
  const Far::PatchTable::PatchHandle* const patch = map_->FindPatch(face, u, v);
  LIMN_EXPECTS(patch != nullptr);
  std::array<double, 20> weights{};
  table_->EvaluateBasis(*patch, u, v, weights.data());
  const Far::ConstIndexArray vertices = table_->GetPatchVertices(*patch);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < vertices.size(); ++i) {
    sum +=
        weights[static_cast<std::size_t>(i)] * points_[static_cast<std::size_t>(vertices[i])].value;
  }
  return sum;
}

}  // namespace

std::vector<Patches> isolate_patches(const Subject& subject, double target) {
  const std::unique_ptr<Far::TopologyRefiner> base = base_level(subject);
  const int faces = Far::PtexIndices(*base).GetNumFaces();
  const auto for_each_place = [&](const auto& visit) {
    for (int f = 0; f < faces; ++f) {
      for (int y = 0; y < kPlaces; ++y) {
        for (int x = 0; x < kPlaces; ++x) {
          visit(f, (x + 0.5) / kPlaces, (y + 0.5) / kPlaces);
        }
      }
    }
  };
  std::vector<glm::dvec3> limit;
  const PatchSurface deepest(subject, *base, kDeepest);
  for_each_place([&](int f, double u, double v) { limit.push_back(deepest.at(f, u, v)); });

  std::vector<Patches> found;
  for (int isolation = 1; isolation <= kDeepest; ++isolation) {
    const PatchSurface surface(subject, *base, isolation);
    double greatest = 0.0;
    std::size_t i = 0;
    for_each_place([&](int f, double u, double v) {
      greatest = std::max(greatest, glm::distance(surface.at(f, u, v), limit[i++]));
    });
    found.push_back({isolation, surface.count(), greatest / subject.mesh->bounds().diagonal()});
    if (found.back().greatest <= target) {
      break;
    }
  }
  return found;
}

}  // namespace limn::bench

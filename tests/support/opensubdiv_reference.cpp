#include "support/opensubdiv_reference.h"

#include <algorithm>
#include <numeric>

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <glm/geometric.hpp>

#include "limn/contract.h"

namespace limn::test {
namespace {

using namespace OpenSubdiv;  // NOLINT(google-build-using-namespace): its version namespace.

/// A point the way PrimvarRefiner wants it.
template <class Vector>
struct Primvar {
  Vector value{0.0};

  // NOLINTBEGIN(readability-identifier-naming): OpenSubdiv's names.
  void Clear() { value = Vector(0.0); }
  void AddWithWeight(const Primvar& other, double weight) { value += weight * other.value; }
  // NOLINTEND(readability-identifier-naming)
};

template <class Vector>
std::vector<Primvar<Vector>> primvars(std::span<const Vector> values) {
  std::vector<Primvar<Vector>> all;
  all.reserve(values.size());
  for (const Vector& value : values) {
    all.push_back({value});
  }
  return all;
}

template <class Vector>
std::vector<Vector> values(const std::vector<Primvar<Vector>>& primvars) {
  std::vector<Vector> all;
  all.reserve(primvars.size());
  for (const Primvar<Vector>& primvar : primvars) {
    all.push_back(primvar.value);
  }
  return all;
}

std::vector<std::uint32_t> to_vector(const Far::ConstIndexArray& indices) {
  std::vector<std::uint32_t> values;
  for (int i = 0; i < indices.size(); ++i) {
    values.push_back(static_cast<std::uint32_t>(indices[i]));
  }
  return values;
}

/// A control mesh as Far wants to be told of it; the arrays must stay where they are.
struct Description {
  std::vector<int> sides;
  std::vector<Far::Index> vertices;
  std::vector<Far::Index> crease_ends;
  std::vector<float> crease_weights;
  std::vector<Far::Index> corner_vertices;
  std::vector<float> corner_weights;
  std::vector<Far::Index> corner_values;
  Far::TopologyDescriptor::FVarChannel channel;
  Far::TopologyDescriptor descriptor;

  explicit Description(const ControlMesh& mesh);
  Description(const Description&) = delete;
  Description& operator=(const Description&) = delete;
  ~Description() = default;
};

Description::Description(const ControlMesh& mesh) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    sides.push_back(static_cast<int>(face.size()));
    vertices.insert(vertices.end(), face.begin(), face.end());
  }
  descriptor.numVertices = static_cast<int>(mesh.vertex_count());
  descriptor.numFaces = static_cast<int>(mesh.face_count());
  descriptor.numVertsPerFace = sides.data();
  descriptor.vertIndicesPerFace = vertices.data();

  crease_weights = mesh.creases().edge_sharpness;
  for (std::size_t e = 0; e < crease_weights.size(); ++e) {
    for (const std::uint32_t end : mesh.topology().edge_vertices[e]) {
      crease_ends.push_back(static_cast<Far::Index>(end));
    }
  }
  descriptor.numCreases = static_cast<int>(crease_weights.size());
  descriptor.creaseVertexIndexPairs = crease_ends.data();
  descriptor.creaseWeights = crease_weights.data();

  corner_weights = mesh.creases().vertex_sharpness;
  corner_vertices.resize(corner_weights.size());
  std::iota(corner_vertices.begin(), corner_vertices.end(), 0);
  descriptor.numCorners = static_cast<int>(corner_weights.size());
  descriptor.cornerVertexIndices = corner_vertices.data();
  descriptor.cornerWeights = corner_weights.data();

  if (!mesh.texture().empty()) {
    corner_values.assign(mesh.texture().corner_values.begin(), mesh.texture().corner_values.end());
    channel.numValues = static_cast<int>(mesh.texture().values.size());
    channel.valueIndices = corner_values.data();
    descriptor.numFVarChannels = 1;
    descriptor.fvarChannels = &channel;
  }
}

Sdc::Options options_of(CreasingMethod creasing, CornerRule corners, TextureRule texture) {
  Sdc::Options options;
  options.SetCreasingMethod(creasing == CreasingMethod::kChaikin ? Sdc::Options::CREASE_CHAIKIN
                                                                 : Sdc::Options::CREASE_UNIFORM);
  options.SetVtxBoundaryInterpolation(corners == CornerRule::kSharp
                                          ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                          : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  options.SetFVarLinearInterpolation(texture == TextureRule::kLinear
                                         ? Sdc::Options::FVAR_LINEAR_ALL
                                         : Sdc::Options::FVAR_LINEAR_BOUNDARIES);
  return options;
}

Sdc::SchemeType type_of(ReferenceScheme scheme) {
  switch (scheme) {
    case ReferenceScheme::kCatmullClark:
      break;
    case ReferenceScheme::kLoop:
      return Sdc::SCHEME_LOOP;
    case ReferenceScheme::kBilinear:
      return Sdc::SCHEME_BILINEAR;
  }
  return Sdc::SCHEME_CATMARK;
}

}  // namespace

struct UniformHierarchy::Implementation {
  std::unique_ptr<Far::TopologyRefiner> refiner;

  [[nodiscard]] Far::TopologyLevel level(int k) const { return refiner->GetLevel(k); }
};

UniformHierarchy::UniformHierarchy(const ControlMesh& mesh, int levels, CornerRule corners,
                                   TextureRule texture, ReferenceScheme scheme)
    : implementation_(std::make_unique<Implementation>()) {
  const Description description(mesh);
  const Sdc::Options options = options_of(mesh.creases().method, corners, texture);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  implementation_->refiner.reset(
      Factory::Create(description.descriptor, Factory::Options(type_of(scheme), options)));
  LIMN_EXPECTS(implementation_->refiner != nullptr);
  Far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;
  implementation_->refiner->RefineUniform(uniform);
}

UniformHierarchy::~UniformHierarchy() = default;

int UniformHierarchy::levels() const {
  return implementation_->refiner->GetMaxLevel();
}

std::vector<std::vector<glm::dvec3>> UniformHierarchy::positions(
    std::span<const glm::dvec3> control) const {
  const Far::PrimvarRefinerReal<double> refiner(*implementation_->refiner);
  std::vector<std::vector<glm::dvec3>> all{{control.begin(), control.end()}};
  auto from = primvars(control);
  for (int level = 1; level <= levels(); ++level) {
    std::vector<Primvar<glm::dvec3>> to(vertex_count(level));
    refiner.Interpolate(level, from, to);
    all.push_back(values(to));
    from = std::move(to);
  }
  return all;
}

ReferenceLimits UniformHierarchy::limits(std::span<const glm::dvec3> control) const {
  const auto all = positions(control);
  const auto last = primvars(std::span<const glm::dvec3>(all.back()));
  std::vector<Primvar<glm::dvec3>> limit(last.size());
  std::vector<Primvar<glm::dvec3>> tangent(last.size());
  std::vector<Primvar<glm::dvec3>> other(last.size());
  const Far::PrimvarRefinerReal<double> refiner(*implementation_->refiner);
  refiner.Limit(last, limit, tangent, other);
  ReferenceLimits limits{values(limit), {}};
  for (std::size_t v = 0; v < last.size(); ++v) {
    limits.normals.push_back(glm::normalize(glm::cross(tangent[v].value, other[v].value)));
  }
  return limits;
}

std::vector<std::vector<glm::dvec2>> UniformHierarchy::uvs(
    std::span<const glm::dvec2> control) const {
  const Far::PrimvarRefinerReal<double> refiner(*implementation_->refiner);
  std::vector<std::vector<glm::dvec2>> all{{control.begin(), control.end()}};
  auto from = primvars(control);
  for (int level = 1; level <= levels(); ++level) {
    const int count = implementation_->level(level).GetNumFVarValues();
    std::vector<Primvar<glm::dvec2>> to(static_cast<std::size_t>(count));
    refiner.InterpolateFaceVarying(level, from, to);
    all.push_back(values(to));
    from = std::move(to);
  }
  return all;
}

std::vector<std::uint32_t> UniformHierarchy::face_uvs(int level, std::uint32_t face) const {
  return to_vector(implementation_->level(level).GetFaceFVarValues(static_cast<int>(face)));
}

std::uint32_t UniformHierarchy::vertex_count(int level) const {
  return static_cast<std::uint32_t>(implementation_->level(level).GetNumVertices());
}

std::uint32_t UniformHierarchy::edge_count(int level) const {
  return static_cast<std::uint32_t>(implementation_->level(level).GetNumEdges());
}

std::uint32_t UniformHierarchy::face_count(int level) const {
  return static_cast<std::uint32_t>(implementation_->level(level).GetNumFaces());
}

std::vector<std::uint32_t> UniformHierarchy::face_vertices(int level, std::uint32_t face) const {
  return to_vector(implementation_->level(level).GetFaceVertices(static_cast<int>(face)));
}

std::vector<std::uint32_t> UniformHierarchy::face_edges(int level, std::uint32_t face) const {
  return to_vector(implementation_->level(level).GetFaceEdges(static_cast<int>(face)));
}

std::array<std::uint32_t, 2> UniformHierarchy::edge_vertices(int level, std::uint32_t edge) const {
  const auto ends = implementation_->level(level).GetEdgeVertices(static_cast<int>(edge));
  return {static_cast<std::uint32_t>(ends[0]), static_cast<std::uint32_t>(ends[1])};
}

std::vector<std::uint32_t> UniformHierarchy::vertex_edges(int level, std::uint32_t vertex) const {
  return to_vector(implementation_->level(level).GetVertexEdges(static_cast<int>(vertex)));
}

std::vector<std::uint32_t> UniformHierarchy::vertex_faces(int level, std::uint32_t vertex) const {
  return to_vector(implementation_->level(level).GetVertexFaces(static_cast<int>(vertex)));
}

float UniformHierarchy::edge_sharpness(int level, std::uint32_t edge) const {
  return implementation_->level(level).GetEdgeSharpness(static_cast<int>(edge));
}

float UniformHierarchy::vertex_sharpness(int level, std::uint32_t vertex) const {
  return implementation_->level(level).GetVertexSharpness(static_cast<int>(vertex));
}

std::vector<std::uint32_t> UniformHierarchy::child_faces(int level, std::uint32_t face) const {
  return to_vector(implementation_->level(level).GetFaceChildFaces(static_cast<int>(face)));
}

std::uint32_t UniformHierarchy::child_of_face(int level, std::uint32_t face) const {
  return static_cast<std::uint32_t>(
      implementation_->level(level).GetFaceChildVertex(static_cast<int>(face)));
}

std::uint32_t UniformHierarchy::child_of_edge(int level, std::uint32_t edge) const {
  return static_cast<std::uint32_t>(
      implementation_->level(level).GetEdgeChildVertex(static_cast<int>(edge)));
}

std::uint32_t UniformHierarchy::child_of_vertex(int level, std::uint32_t vertex) const {
  return static_cast<std::uint32_t>(
      implementation_->level(level).GetVertexChildVertex(static_cast<int>(vertex)));
}

ReferenceMesh reference_refinement(const UniformHierarchy& hierarchy, const VertexLabels& labels,
                                   int levels, const LevelLabels* given) {
  ReferenceMesh mesh;
  std::vector<int> label(labels.begin(), labels.end());
  std::vector<std::uint32_t> identity(labels.size());  // Into mesh.vertices, or kNone.
  for (std::uint32_t v = 0; v < labels.size(); ++v) {
    mesh.vertices.push_back({0, v});
    identity[v] = v;
  }
  struct Active {
    std::uint32_t face;
    std::uint32_t control_face;
  };
  std::vector<Active> active;
  for (std::uint32_t f = 0; f < hierarchy.face_count(0); ++f) {
    active.push_back({f, f});
  }

  for (int k = 0; !active.empty(); ++k) {
    const auto emit = [&](const std::vector<std::uint32_t>& vertices, int level,
                          std::uint32_t control_face,
                          const std::vector<std::uint32_t>& identities) {
      ReferenceMesh::Face face{{}, level, control_face};
      for (const std::uint32_t v : vertices) {
        LIMN_EXPECTS(identities[v] != kNone);
        face.vertices.push_back(identities[v]);
      }
      mesh.faces.push_back(std::move(face));
    };
    const auto is_positive = [&](std::uint32_t v) { return label[v] > 0; };
    if (k == levels || std::ranges::none_of(label, [](int l) { return l > 0; })) {
      for (const Active& here : active) {
        emit(hierarchy.face_vertices(k, here.face), k, here.control_face, identity);
      }
      break;
    }

    std::vector<int> next_label(hierarchy.vertex_count(k + 1), 0);
    std::vector<std::uint32_t> next_identity(hierarchy.vertex_count(k + 1), kNone);
    std::vector<char> moves(label.size(), 0);
    for (std::uint32_t e = 0; e < hierarchy.edge_count(k); ++e) {
      const auto [a, b] = hierarchy.edge_vertices(k, e);
      if (is_positive(a) || is_positive(b)) {
        moves[a] = moves[b] = 1;
        const std::uint32_t child = hierarchy.child_of_edge(k, e);
        next_label[child] = std::max(0, std::min(label[a], label[b]) - 1);
        next_identity[child] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back({k + 1, child});
      }
    }
    for (std::uint32_t v = 0; v < label.size(); ++v) {
      const std::uint32_t child = hierarchy.child_of_vertex(k, v);
      next_label[child] = std::max(0, label[v] - 1);
      next_identity[child] = identity[v];
      if (moves[v] != 0) {
        LIMN_EXPECTS(identity[v] != kNone);
        mesh.vertices[identity[v]] = {k + 1, child};
      }
    }

    std::vector<Active> next_active;
    for (const Active& here : active) {
      const auto v = hierarchy.face_vertices(k, here.face);
      const auto e = hierarchy.face_edges(k, here.face);
      const std::size_t n = v.size();
      const auto positive = static_cast<std::size_t>(std::ranges::count_if(v, is_positive));
      if (positive == 0) {
        emit(v, k, here.control_face, identity);
        continue;
      }
      const std::uint32_t centre = hierarchy.child_of_face(k, here.face);
      next_identity[centre] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back({k + 1, centre});
      const auto children = hierarchy.child_faces(k, here.face);
      if (positive == 1 && n == 4) {
        const auto at = static_cast<std::size_t>(std::ranges::find_if(v, is_positive) - v.begin());
        next_active.push_back({children[at], here.control_face});
        const std::uint32_t e5 = hierarchy.child_of_edge(k, e[at]);
        const std::uint32_t e8 = hierarchy.child_of_edge(k, e[(at + 3) % 4]);
        const std::uint32_t v2 = hierarchy.child_of_vertex(k, v[(at + 1) % 4]);
        const std::uint32_t v3 = hierarchy.child_of_vertex(k, v[(at + 2) % 4]);
        const std::uint32_t v4 = hierarchy.child_of_vertex(k, v[(at + 3) % 4]);
        emit({e5, v2, v3, centre}, k + 1, here.control_face, next_identity);
        emit({e8, centre, v3, v4}, k + 1, here.control_face, next_identity);
        continue;
      }
      if (n == 4) {
        LIMN_EXPECTS(positive > 2 || is_positive(v[0]) == is_positive(v[2]));
      } else {
        LIMN_EXPECTS(positive == n);
      }
      int least = 0;
      for (const std::uint32_t edge : e) {
        const int at_edge = next_label[hierarchy.child_of_edge(k, edge)];
        if (at_edge > 0 && (least == 0 || at_edge < least)) {
          least = at_edge;
        }
      }
      next_label[centre] = least;
      for (const std::uint32_t child : children) {
        next_active.push_back({child, here.control_face});
      }
    }
    for (std::size_t v = 0; given != nullptr && v < next_label.size(); ++v) {
      next_label[v] = std::min<int>((*given)[static_cast<std::size_t>(k) + 1][v], levels - k - 1);
    }
    active = std::move(next_active);
    label = std::move(next_label);
    identity = std::move(next_identity);
  }
  return mesh;
}

}  // namespace limn::test

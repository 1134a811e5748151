#pragma once

#include <functional>
#include <string>
#include <vector>

#include "limn/subdivision/label_subdivision.h"
#include "support/opensubdiv_reference.h"

namespace limn::test {

/// How a refinement compares with the reference.
struct Exactness {
  std::string difference;  ///< Empty where faces, levels and control faces are the reference's.
  std::size_t off = 0;     ///< Vertices further than 1e-6 of the diagonal from P_k.
  double greatest_deviation = 0.0;  ///< Over all vertices, in diagonals.
};

/// Refines a mesh and compares vertex by vertex and face by face.
///
/// Which refined vertex is which of the reference is found on a mesh of the same connectivity whose
/// control vertices lie at random, so that no two vertices coincide; there all must match to 1e-6
/// as well. Positions of the mesh itself are then compared by number.
class UniformReference {
 public:
  /// `mesh` must outlive this; `levels` is the deepest level that will be compared.
  UniformReference(const ControlMesh& mesh, int levels, CornerRule corners);

  [[nodiscard]] Exactness compare(const VertexLabels& labels, const SubdivisionSettings& settings,
                                  int levels) const;
  /// With labels of finer levels, as the library has them and vertex by vertex.
  [[nodiscard]] Exactness compare_fine(const VertexLabels& labels, const FineLabels* fine,
                                       const LevelLabels& given,
                                       const SubdivisionSettings& settings, int levels) const;

  /// The same with a deliberate error in the refined mesh, to show that the comparison sees it.
  [[nodiscard]] Exactness compare_faulty(const VertexLabels& labels,
                                         const SubdivisionSettings& settings, int levels,
                                         const std::function<void(RefinedMesh&)>& fault) const;

  /// Which vertex of the hierarchy each refined vertex is. None where they cannot be told apart.
  [[nodiscard]] std::vector<ReferenceMesh::Vertex> references(const VertexLabels& labels,
                                                              const SubdivisionSettings& settings,
                                                              int levels) const;
  [[nodiscard]] std::vector<ReferenceMesh::Vertex> references_fine(
      const VertexLabels& labels, const FineLabels* fine, const LevelLabels& given,
      const SubdivisionSettings& settings, int levels) const;
  [[nodiscard]] const UniformHierarchy& hierarchy() const noexcept { return hierarchy_; }
  /// `[level][vertex]`.
  [[nodiscard]] const std::vector<std::vector<glm::dvec3>>& positions() const noexcept {
    return uniform_;
  }

 private:
  struct Case {
    const VertexLabels* labels;
    const FineLabels* fine;
    const LevelLabels* given;
    const SubdivisionSettings* settings;
    int levels;
  };
  [[nodiscard]] std::vector<ReferenceMesh::Vertex> references(const Case& at) const;
  [[nodiscard]] Exactness compare(const Case& at,
                                  const std::function<void(RefinedMesh&)>& fault) const;

  const ControlMesh* mesh_;
  ControlMesh scattered_;
  UniformHierarchy hierarchy_;
  std::vector<std::vector<glm::dvec3>> uniform_;
  std::vector<std::vector<glm::dvec3>> uniform_scattered_;
};

/// Everything else that holds of every refinement; empty if it does, else the first breach: cracks,
/// boundary, quads, level differences, prediction, control vertices, illegal faces.
[[nodiscard]] std::string first_breach(const ControlMesh& mesh, const VertexLabels& labels,
                                       const SubdivisionSettings& settings, int levels,
                                       const FineLabels* fine = nullptr);

}  // namespace limn::test

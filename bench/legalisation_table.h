#pragma once

#include <cstdint>
#include <ostream>

#include "limn/mesh/control_mesh.h"
#include "limn/subdivision/labels.h"

namespace limn::bench {

/// A closed grid of n by n quads in the shape of a torus. n >= 3.
[[nodiscard]] ControlMesh torus(std::uint32_t n);

/// Labels of a mesh on which that part of the faces, drawn at random, is painted to depth 3. The
/// same seed gives the same faces everywhere. Non-quads rise where painted.
[[nodiscard]] VertexLabels random_labels(const ControlMesh& mesh, double part, std::uint32_t seed);

/// Writes the tables of docs/legalisation.md: relabels and faces of the refined mesh by the greedy,
/// by look-ahead, and at the optimum where that can be had. False if look-ahead ever made more
/// faces than the greedy.
bool write_legalisation_tables(std::ostream& out);

}  // namespace limn::bench

#pragma once

#include <cstdint>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/labels.h"

namespace limn {

/// One choice of the greedy: the vertex it raised from 0 to 1, and why that one.
struct LegalisationStep {
  std::uint32_t vertex = kNone;
  std::uint32_t valence = 0;  ///< Illegal neighbours along mesh edges when it was chosen.
  std::uint32_t cost = 0;     ///< Quads around it that had exactly three zero labels.
};

/// Legal labels and the choices that led to them.
///
/// Only choices are steps. Under kWherePainted a choice at a corner of a non-quad face also raises
/// that face's other zeros to 1, and these have no LegalisationStep. A step-by-step display starts
/// from the labels that went in and shows for each step
///   labels[step.vertex] = 1;
///   labels = apply_non_quad_rule(mesh, std::move(labels), rule);   // kWherePainted only
/// Whatever else became positive was raised along with step.vertex; after the last step `labels`
/// are those below.
struct Legalisation {
  VertexLabels labels;                  ///< No face is illegal under these.
  std::vector<LegalisationStep> steps;  ///< The choices, in order.
};

/// Removes every illegal vertex in the paper's greedy order, in time that is linear in the mesh for
/// bounded valence (algorithm: Yong & Cheng 2005, section on illegal vertices).
///
/// While there are illegal vertices: the candidates are the illegal vertices adjacent to an illegal
/// vertex of valence 1, or all illegal ones where no valence is 1; the candidate with the highest
/// valence, then the lowest cost, then the lowest index becomes 1.
/// Neighbours are the other ends of the mesh edges at a vertex; faces that are no quads count
/// neither as illegal nor towards the cost. `labels` come from `apply_non_quad_rule` with the same
/// `rule`. Under kWherePainted a relabelled vertex also raises the zeros of the non-quad faces
/// around it. Under kUniformFirstStep on a mesh with non-quads every face splits in the first step,
/// so there is nothing to do. Errors: kCancelled.
[[nodiscard]] Result<Legalisation> legalise_greedy(const ControlMesh& mesh, VertexLabels labels,
                                                   NonQuadRule rule, Progress& progress);

}  // namespace limn

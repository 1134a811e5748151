#pragma once

#include <cstdint>
#include <vector>

#include "limn/error.h"
#include "limn/mesh/control_mesh.h"
#include "limn/progress.h"
#include "limn/subdivision/labels.h"

namespace limn {

/// One choice: a vertex raised from 0 to 1, or one of those set back to 0, and why.
struct LegalisationStep {
  std::uint32_t vertex = kNone;
  std::uint32_t valence = 0;  ///< Greedy: illegal neighbours along mesh edges when it was chosen.
  std::uint32_t cost = 0;     ///< Greedy: quads around it that had exactly three zero labels.
  std::uint8_t label = 1;  ///< What it became: 1, or 0 if look-ahead found it needless after all.
  bool is_joint = false;   ///< Takes effect only together with the step that follows.
  float score = 0.0F;      ///< Look-ahead: the score it was chosen for.
};

/// Legal labels and the choices that led to them.
///
/// Only choices are steps. Under kWherePainted raising a corner of a non-quad face also raises that
/// face's other zeros to 1, and these have no step. A step-by-step display starts from the labels
/// that went in and does for each step
///   labels[step.vertex] = step.label;
///   if (step.label > 0) labels = apply_non_quad_rule(mesh, std::move(labels), rule);
/// (the second line under kWherePainted only). Whatever else became positive was raised along with
/// step.vertex. Resets follow all raises, and several that go together are joint: between them a
/// face may be illegal that was not before. After the last step `labels` are those below.
struct Legalisation {
  VertexLabels labels;                  ///< No face is illegal under these.
  std::vector<LegalisationStep> steps;  ///< The choices, in order.
  /// Whose order the raises follow: look-ahead gives the greedy's where these are better.
  LegalisationMethod order = LegalisationMethod::kGreedy;
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

/// Removes every illegal vertex with fewer relabels and fewer faces than the greedy, in time that
/// is linear in the mesh for bounded valence. A quad with two opposite positive labels is legal: it
/// splits into four.
///
/// While there are quads with two neighbouring positive labels, that one of their zero vertices
/// becomes 1 which has the highest score: quads mended less quads made illegal, plus 0.6 of what
/// the best further relabel in a quad beside it would mend, less 1 for every face it adds to the
/// refined mesh. Then every relabelled vertex, and every two in one quad, whose quads stay legal
/// without them become 0 again.
/// The refined mesh never has more faces than with `legalise_greedy`: where the greedy's labels are
/// better, the result is these, less the relabels that are needless. Arguments, non-quad faces and
/// errors as above.
[[nodiscard]] Result<Legalisation> legalise_look_ahead(const ControlMesh& mesh, VertexLabels labels,
                                                       NonQuadRule rule, Progress& progress);

}  // namespace limn

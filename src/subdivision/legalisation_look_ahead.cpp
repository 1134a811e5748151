// A relabel changes the quads around it, through them what a relabel of their corners would mend,
// and through that the scores of these corners' neighbours: some 25 vertices on a grid, and only
// their scores are computed again. Candidates wait in one stack for each score; an entry counts
// while its vertex still has that score. The latest entry is taken first, so that a region is
// finished before the next is begun, which is both better and nearer in memory.
//
// Vertices of very many quads are scored by themselves alone and not looked ahead to, which keeps
// a step's work bounded.
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "limn/contract.h"
#include "limn/subdivision/legalisation.h"
#include "subdivision/legalisation_greedy.h"
#include "subdivision/legalisation_resets.h"
#include "subdivision/legality_problem.h"
#include "subdivision/look_ahead_score.h"
#include "subdivision/parallel_ranges.h"

namespace limn {
namespace {

constexpr const char* kLookAheadStage = "Removing illegal vertices, looking ahead";

/// Parts of the whole: the relabels, their resets, and the race with the greedy.
constexpr double kRelabelled = 0.6;
constexpr double kTakenBack = 0.8;

/// Shows the greedy's progress as the last part.
class RacePart final : public Progress {
 public:
  explicit RacePart(Progress& whole) : whole_(whole) {}
  [[nodiscard]] bool report(double fraction, std::string_view) override {
    return whole_.report(kTakenBack + (1.0 - kTakenBack) * fraction, kLookAheadStage);
  }

 private:
  Progress& whole_;
};

class LookAhead {
 public:
  /// `masks` are those of the labels; they are kept up to date.
  LookAhead(const LegalityProblem& problem, const VertexLabels& labels, std::span<QuadMask> masks)
      : problem_(&problem), masks_(masks), variables_(problem.variable_count()) {
    for (std::uint32_t v = 0; v < labels.size(); ++v) {
      variables_[problem.variable_of(v)].is_zero = labels[v] == 0;
    }
    parallel_ranges(0, variables_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
      for (auto u = static_cast<std::uint32_t>(begin); u < end; ++u) {
        Variable& variable = variables_[u];
        variable.is_small = problem.quads_around(u) <= kMostQuadsLookedAhead;
        if (variable.is_zero) {
          variable.faces = static_cast<std::int32_t>(problem.polygon_faces(u));
          problem.for_each_quad(
              u, [&](std::uint32_t q, unsigned bits) { count(variable, masks[q], bits, +1); });
        }
      }
    });
    // The stacks give back what went in last: the lowest first.
    for (auto u = static_cast<std::uint32_t>(variables_.size()); u-- > 0;) {
      illegal_count_ += is_candidate(variables_[u]) ? 1 : 0;
      queue(u);
    }
  }

  /// Candidates left.
  [[nodiscard]] std::size_t illegal_count() const { return illegal_count_; }

  /// Raises the best candidate, if any is left: the variable and its score in fifths.
  [[nodiscard]] std::optional<std::pair<std::uint32_t, std::int32_t>> raise_best() {
    for (; highest_ > 0; --highest_) {
      std::vector<std::uint32_t>& stack = stacks_[highest_];
      while (!stack.empty()) {
        const std::uint32_t u = stack.back();
        stack.pop_back();
        if (is_candidate(variables_[u]) && variables_[u].stack == highest_) {
          const std::int32_t score = score_of(u);
          raise(u);
          return std::pair(u, score);
        }
      }
    }
    return std::nullopt;
  }

 private:
  struct Variable {
    std::int32_t mended = 0;  ///< Illegal quads fewer if it rises.
    std::int32_t faces = 0;   ///< Faces more if it rises.
    std::uint32_t illegal_quads = 0;
    std::uint16_t stack = 0;  ///< Where it waits; 0 is nowhere.
    std::uint8_t next = 0;    ///< Its place in `next_`, from 1; 0 if it has none.
    bool is_zero : 1 = false;
    bool is_small : 1 = false;    ///< Of few enough quads for looking ahead.
    bool is_changed : 1 = false;  ///< Is in `changed_`.
    bool is_remended : 1 = false;
  };
  static_assert(sizeof(Variable) == 16);

  /// A further relabel and what it would mend.
  struct Next {
    std::uint32_t variable = 0;
    std::int32_t mended = 0;
  };

  /// Scores beyond -kStacks * 3 / 4 and kStacks / 4 are worst and best all alike.
  static constexpr std::int32_t kStacks = 1024;

  static constexpr std::size_t kGrain = std::size_t{1} << 12;

  [[nodiscard]] static bool is_candidate(const Variable& variable) {
    return variable.is_zero && variable.illegal_quads > 0;
  }
  /// Adds (+1) or takes back (-1) what a quad means to a variable at its corners `bits`.
  static void count(Variable& variable, unsigned mask, unsigned bits, std::int32_t sign) {
    variable.mended += sign * mended(mask, bits);
    variable.faces += sign * (faces_of(mask | bits) - faces_of(mask));
    variable.illegal_quads += is_illegal_mask(mask) ? static_cast<std::uint32_t>(sign) : 0U;
  }

  [[nodiscard]] std::int32_t score_of(std::uint32_t u) {
    const Variable& variable = variables_[u];
    const std::int32_t score = kOneMended * variable.mended + kOneFaceAdded * variable.faces;
    return variable.is_small ? score + kOneMendedNext * most_mended_next(u) : score;
  }

  /// What the best further relabel in a quad around u would mend once u has risen; not below 0.
  [[nodiscard]] std::int32_t most_mended_next(std::uint32_t u) {
    next_.clear();
    problem_->for_each_quad(u, [&](std::uint32_t q, unsigned bits) {
      const unsigned mask = masks_[q];
      problem_->for_each_variable(q, [&](std::uint32_t w, unsigned others) {
        Variable& variable = variables_[w];
        if (w == u || !variable.is_zero || !variable.is_small) {
          return;
        }
        if (variable.next == 0) {
          next_.push_back({w, variable.mended});
          variable.next = static_cast<std::uint8_t>(next_.size());
        }
        next_[variable.next - 1U].mended += mended(mask | bits, others) - mended(mask, others);
      });
    });
    std::int32_t most = 0;
    for (const Next& next : next_) {
      most = std::max(most, next.mended);
      variables_[next.variable].next = 0;
    }
    return most;
  }

  /// Puts u where its score belongs.
  void queue(std::uint32_t u) {
    Variable& variable = variables_[u];
    if (!is_candidate(variable)) {
      variable.stack = 0;
      return;
    }
    const auto stack =
        static_cast<std::uint16_t>(std::clamp(score_of(u) + kStacks * 3 / 4, 1, kStacks - 1));
    if (stack != variable.stack) {
      variable.stack = stack;
      stacks_[stack].push_back(u);
      highest_ = std::max<std::size_t>(highest_, stack);
    }
  }

  void mark(std::uint32_t u) {
    if (!variables_[u].is_changed) {
      variables_[u].is_changed = true;
      changed_.push_back(u);
    }
  }

  void raise(std::uint32_t u) {
    variables_[u].is_zero = false;
    --illegal_count_;
    problem_->for_each_quad(u, [&](std::uint32_t q, unsigned bits) {
      const unsigned before = masks_[q];
      const unsigned after = before | bits;
      masks_[q] = static_cast<QuadMask>(after);
      problem_->for_each_variable(q, [&](std::uint32_t w, unsigned others) {
        Variable& variable = variables_[w];
        if (variable.is_zero) {
          const bool was_candidate = is_candidate(variable);
          const std::int32_t before_mended = variable.mended;
          count(variable, before, others, -1);
          count(variable, after, others, +1);
          illegal_count_ += static_cast<std::size_t>(is_candidate(variable)) -
                            static_cast<std::size_t>(was_candidate);
          variable.is_remended = variable.is_remended || variable.mended != before_mended;
          mark(w);
        }
      });
    });
    // Whoever could look ahead to one of these scores differently, too.
    const std::size_t corners = changed_.size();
    for (std::size_t i = 0; i < corners; ++i) {
      const Variable& corner = variables_[changed_[i]];
      if (corner.is_small && corner.is_remended) {
        problem_->for_each_quad(changed_[i], [&](std::uint32_t q, unsigned) {
          for (const std::uint32_t w : problem_->quad(q)) {
            if (is_candidate(variables_[w])) {
              mark(w);
            }
          }
        });
      }
    }
    for (const std::uint32_t w : changed_) {
      variables_[w].is_changed = false;
      variables_[w].is_remended = false;
      queue(w);
    }
    changed_.clear();
  }

  const LegalityProblem* problem_;
  std::span<QuadMask> masks_;
  LargeArray<Variable> variables_;
  std::array<std::vector<std::uint32_t>, kStacks> stacks_;
  std::size_t highest_ = 0;
  std::vector<std::uint32_t> changed_;
  std::vector<Next> next_;
  std::size_t illegal_count_ = 0;
};

/// Faces that what `legal` raised adds to the refined mesh; with the masks of the painted labels
/// and of its own.
std::uint64_t faces_added(const LegalityProblem& problem, std::span<const QuadMask> before,
                          std::span<const QuadMask> after, const Legalisation& legal) {
  std::int64_t added = 0;
  for (std::size_t q = 0; q < before.size(); ++q) {
    added += faces_of(after[q]) - faces_of(before[q]);
  }
  for (const LegalisationStep& step : legal.steps) {  // One choice a variable, taken back or not.
    if (step.label > 0 && legal.labels[step.vertex] > 0) {
      added += problem.polygon_faces(problem.variable_of(step.vertex));
    }
  }
  return static_cast<std::uint64_t>(added);
}

}  // namespace

Result<Legalisation> legalise_look_ahead(const ControlMesh& mesh, VertexLabels labels, NonQuadRule,
                                         Progress& progress) {
  LIMN_EXPECTS(labels.size() == mesh.vertex_count());
  constexpr std::size_t kStepsBetweenReports = 2048;
  const auto cancelled = [] { return fail(ErrorKind::kCancelled, "Legalising was cancelled."); };
  if (!progress.report(0.0, kLookAheadStage)) {
    return cancelled();
  }

  const LegalityProblem problem(mesh);
  Legalisation result{labels, {}, LegalisationMethod::kLookAhead};
  const LargeArray<QuadMask> painted = problem.masks(labels);
  LargeArray<QuadMask> masks = painted;
  LookAhead look_ahead(problem, labels, masks);
  double reached = 0.0;
  while (const auto raised = look_ahead.raise_best()) {
    const auto [variable, score] = *raised;
    std::uint32_t chosen = kNone;
    problem.for_each_vertex(variable, [&](std::uint32_t v) {
      result.labels[v] = 1;
      chosen = std::min(chosen, v);
    });
    result.steps.push_back({.vertex = chosen, .score = static_cast<float>(score) / kScoreUnit});
    if (result.steps.size() % kStepsBetweenReports == 0) {
      const auto made = static_cast<double>(result.steps.size());
      reached = std::max(reached, made / (made + static_cast<double>(look_ahead.illegal_count())));
      if (!progress.report(kRelabelled * reached, kLookAheadStage)) {
        return cancelled();
      }
    }
  }
  const auto goes_on = [&] { return progress.report(kRelabelled, kLookAheadStage); };
  if (!take_back_needless(problem, masks, result, goes_on)) {
    return cancelled();
  }

  // The greedy's labels are legal as well: where they are better, they are the answer.
  RacePart race(progress);
  const std::uint64_t added = faces_added(problem, painted, masks, result);
  Result<std::optional<Legalisation>> greedy = greedy_below(mesh, std::move(labels), added, race);
  if (!greedy) {
    return tl::unexpected(std::move(greedy.error()));
  }
  if (*greedy) {
    result = **std::move(greedy);
    masks = problem.masks(result.labels);
    if (!take_back_needless(problem, masks, result,
                            [&] { return progress.report(1.0, kLookAheadStage); })) {
      return cancelled();
    }
  }
  if (!progress.report(1.0, kLookAheadStage)) {
    return cancelled();
  }
  return result;
}

}  // namespace limn

// Every raised variable knows how many quads block it: those that would be illegal without it. A
// reset changes the counts of the variables it shares quads with, and only these are tried again:
// first whatever nothing blocks, then pairs whose only blocks are in the quads they share. A
// variable is reset at most once, so the whole is linear.
#include "subdivision/legalisation_resets.h"

#include <span>
#include <utility>
#include <vector>

namespace limn {
namespace {

class Resets {
 public:
  Resets(const LegalityProblem& problem, std::span<QuadMask> masks, Legalisation& result)
      : problem_(&problem),
        result_(&result),
        masks_(masks),
        is_raised_(problem.variable_count(), 0),
        is_waiting_(problem.variable_count(), 0),
        blocks_(problem.variable_count(), 0) {
    for (const LegalisationStep& step : result.steps) {
      const std::uint32_t variable = problem.variable_of(step.vertex);
      is_raised_[variable] = 1;
      wait(variable);
    }
    for (const std::uint32_t variable : waiting_) {
      problem.for_each_quad(variable, [&](std::uint32_t q, unsigned bits) {
        blocks_[variable] += is_illegal_mask(masks_[q] & ~bits) ? 1U : 0U;
      });
    }
  }

  [[nodiscard]] bool take_back(const std::function<bool()>& goes_on) {
    constexpr std::size_t kTriesBetweenQuestions = 8192;
    std::vector<std::uint32_t> blocked;
    for (std::size_t tries = 1; !waiting_.empty() || !blocked.empty(); ++tries) {
      if (tries % kTriesBetweenQuestions == 0 && !goes_on()) {
        return false;
      }
      if (waiting_.empty()) {
        take_back_pair(blocked.back());
        blocked.pop_back();
        continue;
      }
      const std::uint32_t variable = waiting_.back();
      waiting_.pop_back();
      is_waiting_[variable] = 0;
      if (is_raised_[variable] == 0) {
        continue;
      }
      if (blocks_[variable] == 0) {
        reset(variable);
        record(variable, false);
      } else {
        blocked.push_back(variable);
      }
    }
    return true;
  }

 private:
  /// Beyond, a variable waits for its neighbours to seek it.
  static constexpr std::size_t kMostQuads = 32;

  void wait(std::uint32_t variable) {
    if (is_raised_[variable] != 0 && is_waiting_[variable] == 0) {
      is_waiting_[variable] = 1;
      waiting_.push_back(variable);
    }
  }

  void take_back_pair(std::uint32_t a) {
    if (is_raised_[a] == 0 || problem_->quads_around(a) > kMostQuads) {
      return;
    }
    // A partner stands in every quad that blocks a, so in the first.
    std::uint32_t blocking = kNone;
    problem_->for_each_quad(a, [&](std::uint32_t q, unsigned bits) {
      blocking = blocking == kNone && is_illegal_mask(masks_[q] & ~bits) ? q : blocking;
    });
    std::uint32_t partner = kNone;
    problem_->for_each_variable(blocking, [&](std::uint32_t b, unsigned) {
      if (partner == kNone && b != a && is_raised_[b] != 0 && can_go_together(a, b)) {
        partner = b;
      }
    });
    if (partner != kNone) {
      reset(a);
      reset(partner);
      record(a, true);
      record(partner, false);
    }
  }

  [[nodiscard]] bool can_go_together(std::uint32_t a, std::uint32_t b) const {
    std::uint32_t shared_blocks_of_a = 0;
    std::uint32_t shared_blocks_of_b = 0;
    bool is_legal = true;
    problem_->for_each_quad(a, [&](std::uint32_t q, unsigned bits) {
      const unsigned others = problem_->bits_in(q, b);
      if (others != 0) {
        const unsigned mask = masks_[q];
        shared_blocks_of_a += is_illegal_mask(mask & ~bits) ? 1U : 0U;
        shared_blocks_of_b += is_illegal_mask(mask & ~others) ? 1U : 0U;
        is_legal = is_legal && !is_illegal_mask(mask & ~bits & ~others);
      }
    });
    return is_legal && shared_blocks_of_a == blocks_[a] && shared_blocks_of_b == blocks_[b];
  }

  void reset(std::uint32_t variable) {
    is_raised_[variable] = 0;
    problem_->for_each_quad(variable, [&](std::uint32_t q, unsigned bits) {
      const unsigned before = masks_[q];
      const unsigned after = before & ~bits;
      masks_[q] = static_cast<QuadMask>(after);
      problem_->for_each_variable(q, [&](std::uint32_t other, unsigned others) {
        if (is_raised_[other] != 0) {
          blocks_[other] += is_illegal_mask(after & ~others) ? 1U : 0U;
          blocks_[other] -= is_illegal_mask(before & ~others) ? 1U : 0U;
          wait(other);
        }
      });
    });
  }

  void record(std::uint32_t variable, bool has_more) {
    const std::size_t first = result_->steps.size();
    problem_->for_each_vertex(variable, [&](std::uint32_t v) {
      result_->labels[v] = 0;
      result_->steps.push_back({.vertex = v, .label = 0, .is_joint = true});
    });
    if (first < result_->steps.size()) {
      result_->steps.back().is_joint = has_more;
    }
  }

  const LegalityProblem* problem_;
  Legalisation* result_;
  std::span<QuadMask> masks_;
  std::vector<std::uint8_t> is_raised_;
  std::vector<std::uint8_t> is_waiting_;
  std::vector<std::uint32_t> blocks_;  ///< Quads that would be illegal without a raised variable.
  std::vector<std::uint32_t> waiting_;
};

}  // namespace

bool take_back_needless(const LegalityProblem& problem, LargeArray<QuadMask>& masks,
                        Legalisation& result, const std::function<bool()>& goes_on) {
  return Resets(problem, masks, result).take_back(goes_on);
}

}  // namespace limn

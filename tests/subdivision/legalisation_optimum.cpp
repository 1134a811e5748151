// Vertices that non-quad faces tie together are one variable. A face is a factor: a table of what
// it costs for each choice of its variables. A variable is eliminated by adding up the factors it
// is in and keeping, for each choice of the others, the better of its two values; the order takes
// the variable with the fewest others first. Walking the order backwards gives the labels.
#include "legalisation_optimum.h"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "limn/contract.h"
#include "limn/mesh/build.h"
#include "limn/subdivision/prediction.h"

namespace limn::test {
namespace {

/// More than any mesh here costs, and a sum of a few still fits.
constexpr std::uint32_t kNever = 1U << 28U;

struct Factor {
  std::vector<std::uint32_t> variables;  ///< Ascending.
  std::vector<std::uint32_t> costs;      ///< Bit i of an index is the value of variables[i].
};

/// Faces that become of a quad with these labels; asked of the program as a mesh of one face.
std::uint64_t faces_of_quad(const std::array<std::uint8_t, 4>& labels) {
  static const std::shared_ptr<const ControlMesh> quad = [] {
    PolygonSoup soup;
    soup.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}};
    soup.add_face(std::array{0U, 1U, 2U, 3U});
    const Result<ImportedMesh> built = build_control_mesh(soup);
    LIMN_EXPECTS(built.has_value());
    return built->mesh;
  }();
  VertexLabels at(4);
  for (std::size_t i = 0; i < 4; ++i) {
    at[quad->face(0)[i]] = labels[i];
  }
  return predict_refinement(*quad, at).faces;
}

/// Moves the bits of a number to other places, ten bits at a time.
class BitScatter {
 public:
  /// Bit from[i] becomes bit i.
  explicit BitScatter(const std::vector<std::size_t>& from) {
    for (std::uint32_t piece = 0; piece < kPieces; ++piece) {
      for (std::uint32_t value = 0; value < kValues; ++value) {
        std::uint32_t& moved = tables_[piece][value];
        moved = 0;
        for (std::size_t i = 0; i < from.size(); ++i) {
          if (from[i] / 10 == piece && (value >> (from[i] % 10) & 1U) != 0) {
            moved |= 1U << i;
          }
        }
      }
    }
  }
  [[nodiscard]] std::uint32_t of(std::uint32_t bits) const {
    return tables_[0][bits % kValues] | tables_[1][bits / kValues % kValues] |
           tables_[2][bits / kValues / kValues];
  }

 private:
  static constexpr std::uint32_t kPieces = 3;
  static constexpr std::uint32_t kValues = 1024;
  std::array<std::array<std::uint32_t, kValues>, kPieces> tables_;
};

class Elimination {
 public:
  explicit Elimination(std::size_t variables)
      : values_(variables, 0), factors_of_(variables), neighbours_(variables) {}

  void add(Factor factor) {
    const auto index = static_cast<std::uint32_t>(factors_.size());
    for (const std::uint32_t a : factor.variables) {
      factors_of_[a].insert(index);
      for (const std::uint32_t b : factor.variables) {
        if (a != b) {
          neighbours_[a].insert(b);
        }
      }
    }
    factors_.push_back(std::move(factor));
  }

  /// False if it would take too large a table.
  [[nodiscard]] bool solve(std::size_t most_width) {
    std::set<std::pair<std::size_t, std::uint32_t>> waiting;
    for (std::uint32_t v = 0; v < values_.size(); ++v) {
      waiting.emplace(neighbours_[v].size(), v);
    }
    std::vector<Choice> choices;
    while (!waiting.empty()) {
      const auto [width, v] = *waiting.begin();
      if (width > most_width) {
        return false;
      }
      waiting.erase(waiting.begin());
      for (const std::uint32_t w : neighbours_[v]) {
        waiting.erase({neighbours_[w].size(), w});
        neighbours_[w].erase(v);
        neighbours_[w].insert(neighbours_[v].begin(), neighbours_[v].end());
        neighbours_[w].erase(w);
        waiting.emplace(neighbours_[w].size(), w);
      }
      choices.push_back(eliminate(v));
    }
    for (auto choice = choices.rbegin(); choice != choices.rend(); ++choice) {
      std::size_t index = 0;
      for (std::size_t i = 0; i < choice->others.size(); ++i) {
        index |= static_cast<std::size_t>(values_[choice->others[i]]) << i;
      }
      values_[choice->variable] = choice->is_one[index] ? 1 : 0;
    }
    return true;
  }

  [[nodiscard]] const std::vector<std::uint8_t>& values() const { return values_; }

 private:
  /// What a variable becomes, given the ones that are eliminated after it.
  struct Choice {
    std::uint32_t variable = 0;
    std::vector<std::uint32_t> others;
    std::vector<bool> is_one;
  };

  Choice eliminate(std::uint32_t v) {
    Choice choice{v, {neighbours_[v].begin(), neighbours_[v].end()}, {}};
    const auto width = choice.others.size();
    const std::uint32_t size = 1U << width;
    std::array<std::vector<std::uint32_t>, 2> costs;
    costs.fill(std::vector<std::uint32_t>(size, 0));
    const std::set<std::uint32_t> gone = factors_of_[v];
    for (const std::uint32_t index : gone) {
      const Factor& factor = factors_[index];
      std::vector<std::size_t> places;
      for (const std::uint32_t w : factor.variables) {
        const auto at = std::ranges::lower_bound(choice.others, w);
        places.push_back(w == v ? width : static_cast<std::size_t>(at - choice.others.begin()));
      }
      const BitScatter scatter(places);
      for (std::uint32_t value = 0; value < 2; ++value) {
        for (std::uint32_t bits = 0; bits < size; ++bits) {
          std::uint32_t& cost = costs[value][bits];
          cost = std::min(kNever, cost + factor.costs[scatter.of(bits | value << width)]);
        }
      }
      for (const std::uint32_t w : factor.variables) {
        factors_of_[w].erase(index);
      }
    }
    for (const std::uint32_t index : gone) {
      factors_[index] = {};
    }
    choice.is_one.resize(size);
    for (std::uint32_t bits = 0; bits < size; ++bits) {
      choice.is_one[bits] = costs[1][bits] < costs[0][bits];
      costs[0][bits] = std::min(costs[0][bits], costs[1][bits]);
    }
    const auto index = static_cast<std::uint32_t>(factors_.size());
    for (const std::uint32_t w : choice.others) {
      factors_of_[w].insert(index);
    }
    factors_.push_back({choice.others, std::move(costs[0])});
    return choice;
  }

  std::vector<std::uint8_t> values_;
  std::vector<Factor> factors_;
  std::vector<std::set<std::uint32_t>> factors_of_;
  std::vector<std::set<std::uint32_t>> neighbours_;
};

/// The variable of every zero vertex; vertices that have to rise together share one.
std::vector<std::uint32_t> variables_of(const ControlMesh& mesh, const VertexLabels& labels,
                                        NonQuadRule rule) {
  std::vector<std::uint32_t> parent(labels.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) {
      v = parent[v];
    }
    return v;
  };
  if (rule == NonQuadRule::kWherePainted) {
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      for (std::size_t i = 1; face.size() != 4 && i < face.size(); ++i) {
        parent[root(face[i])] = root(face[0]);
      }
    }
  }
  std::vector<std::uint32_t> variables(labels.size(), kNone);
  std::vector<std::uint32_t> number(labels.size(), kNone);
  std::uint32_t count = 0;
  for (std::uint32_t v = 0; v < labels.size(); ++v) {
    if (labels[v] == 0) {
      std::uint32_t& own = number[root(v)];
      own = own == kNone ? count++ : own;
      variables[v] = own;
    }
  }
  return variables;
}

/// What a face costs for every choice of its variables.
Factor factor_of_face(std::span<const std::uint32_t> face, const VertexLabels& labels,
                      const std::vector<std::uint32_t>& variables, LegalisationGoal goal) {
  Factor factor;
  for (const std::uint32_t v : face) {
    if (variables[v] != kNone) {
      factor.variables.push_back(variables[v]);
    }
  }
  std::ranges::sort(factor.variables);
  factor.variables.erase(std::unique(factor.variables.begin(), factor.variables.end()),
                         factor.variables.end());
  for (std::uint32_t bits = 0; bits < 1U << factor.variables.size(); ++bits) {
    std::vector<std::uint8_t> at;
    for (const std::uint32_t v : face) {
      const auto place = std::ranges::find(factor.variables, variables[v]);
      const auto bit = place - factor.variables.begin();
      at.push_back(variables[v] == kNone ? labels[v] : static_cast<std::uint8_t>(bits >> bit & 1U));
    }
    std::uint64_t cost = 0;
    if (face.size() == 4) {
      if (quad_pattern(at[0], at[1], at[2], at[3]) == FacePattern::kIllegal) {
        cost = kNever;
      } else if (goal == LegalisationGoal::kFaces) {
        cost = faces_of_quad({at[0], at[1], at[2], at[3]});
      }
    } else if (goal == LegalisationGoal::kFaces && bits != 0) {
      cost = face.size();  // All its corners are one variable: it splits, or it stays.
    }
    factor.costs.push_back(static_cast<std::uint32_t>(cost));
  }
  return factor;
}

}  // namespace

std::optional<OptimalLegalisation> optimal_legalisation(const ControlMesh& mesh,
                                                        const VertexLabels& labels,
                                                        NonQuadRule rule, LegalisationGoal goal,
                                                        std::size_t most_width) {
  LIMN_EXPECTS(most_width < 30);
  const std::vector<std::uint32_t> variables = variables_of(mesh, labels, rule);
  std::uint32_t count = 0;
  for (const std::uint32_t variable : variables) {
    count = variable == kNone ? count : std::max(count, variable + 1);
  }
  Elimination elimination(count);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    Factor factor = factor_of_face(mesh.face(f), labels, variables, goal);
    if (!factor.variables.empty()) {
      elimination.add(std::move(factor));
    }
  }
  if (goal == LegalisationGoal::kRelabels) {
    for (const std::uint32_t variable : variables) {
      if (variable != kNone) {
        elimination.add({{variable}, {0, 1}});
      }
    }
  }
  if (!elimination.solve(most_width)) {
    return std::nullopt;
  }
  OptimalLegalisation best{labels, 0, 0};
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (variables[v] != kNone && elimination.values()[variables[v]] != 0) {
      best.labels[v] = 1;
      ++best.relabels;
    }
  }
  best.faces = predict_refinement(mesh, best.labels).faces;
  return best;
}

}  // namespace limn::test

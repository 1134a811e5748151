// Points are sorted by the cell of a grid they lie in; the nearest one is sought in the cells that
// a search radius of half a cell reaches, which are at most eight.
#include "agreement.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace limn::bench {
namespace {

class Grid {
 public:
  Grid(std::span<const glm::vec3> points, const glm::dvec3& low, double cell)
      : low_(low), cell_(cell) {
    for (const glm::vec3& point : points) {
      entries_.emplace_back(key(cell_of(glm::dvec3(point))), point);
    }
    std::ranges::sort(entries_, {}, &Entry::first);
  }

  /// The distance to the nearest point, infinite beyond half a cell.
  [[nodiscard]] double distance(const glm::dvec3& point) const {
    const double reach = cell_ / 2;
    const glm::i64vec3 first = cell_of(point - reach);
    const glm::i64vec3 last = cell_of(point + reach);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::int64_t x = first.x; x <= last.x; ++x) {
      for (std::int64_t y = first.y; y <= last.y; ++y) {
        for (std::int64_t z = first.z; z <= last.z; ++z) {
          const std::int64_t cell = key({x, y, z});
          for (auto entry = std::ranges::lower_bound(entries_, cell, {}, &Entry::first);
               entry != entries_.end() && entry->first == cell; ++entry) {
            nearest = std::min(nearest, glm::distance(point, glm::dvec3(entry->second)));
          }
        }
      }
    }
    return nearest <= reach ? nearest : std::numeric_limits<double>::infinity();
  }

 private:
  using Entry = std::pair<std::int64_t, glm::vec3>;

  [[nodiscard]] glm::i64vec3 cell_of(const glm::dvec3& point) const {
    return glm::i64vec3(glm::floor((point - low_) / cell_));
  }
  [[nodiscard]] static std::int64_t key(const glm::i64vec3& cell) {
    constexpr std::int64_t kSide = 1 << 20;
    return (cell.x * kSide + cell.y) * kSide + cell.z;
  }

  glm::dvec3 low_;
  double cell_;
  std::vector<Entry> entries_;
};

}  // namespace

double largest_distance(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (const glm::vec3& point : a) {
    low = glm::min(low, glm::dvec3(point));
    high = glm::max(high, glm::dvec3(point));
  }
  const double cell = glm::distance(low, high) / 500.0;
  double largest = 0.0;
  for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
    const Grid grid(to, low, cell);
    for (const glm::vec3& point : from) {
      largest = std::max(largest, grid.distance(glm::dvec3(point)));
    }
  }
  return largest;
}

}  // namespace limn::bench

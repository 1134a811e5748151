#include "subdivision/schemes/averaging.h"

#include "subdivision/parallel_ranges.h"
#include "subdivision/schemes/sharp_stencils.h"

namespace limn {
namespace {

constexpr std::size_t kAveragingGrain = 8192;

Point centroid(const LevelMesh& mesh, std::size_t f) {
  const std::uint32_t first = mesh.faces.first(f);
  const std::uint32_t last = mesh.faces.first(f + 1);
  Point sum{};
  for (std::uint32_t h = first; h < last; ++h) {
    sum += mesh.points[mesh.start(h)];
  }
  return sum / static_cast<double>(last - first);
}

class Averaging {
 public:
  Averaging(const LevelMesh& from, CornerRule corners, const LevelMesh& to, const PointSink& sink)
      : from_(&from), corners_(corners), to_(&to), sink_(&sink) {
    // Centroids of the quads of the split mesh, one per half-edge.
    quads_.resize(from.half_edge_count());
    parallel_ranges(0, from.faces.count(), kAveragingGrain,
                    [this](std::size_t begin, std::size_t end) {
                      for (std::size_t f = begin; f < end; ++f) {
                        average_face(f);
                      }
                    });
  }

  void place_vertices() const {
    each(from_->vertex_count(), [this](std::uint32_t v) {
      const SharpVertex vertex(*from_, *to_, corners_, v);
      sink_->put(v, vertex.moved([&] {
        Point sum{};
        double count = 0.0;
        (void)from_->around(v, [&](std::uint32_t h) {
          sum += quads_[h];
          count += 1.0;
        });
        return sum / count;
      }));
    });
  }

  void place_edges() const {
    const std::size_t old = from_->vertex_count();
    each(from_->half_edge_count(), [this, old](std::uint32_t h) {
      if (!from_->is_first(h)) {
        return;
      }
      const double share = sharp_share(*from_, *to_, h);
      Point point = 0.5 * (from_->points[from_->start(h)] + from_->points[from_->end(h)]);
      if (share != 1.0) {
        const std::uint32_t twin = from_->twins[h];
        const Point mean =
            0.25 * (quads_[h] + quads_[from_->next(h)] + quads_[twin] + quads_[from_->next(twin)]);
        point = share * point + (1.0 - share) * mean;
      }
      sink_->put(old + from_->edges[h], point);
    });
  }

 private:
  template <class Body>
  static void each(std::size_t count, const Body& body) {
    parallel_ranges(0, count, kAveragingGrain, [&](std::size_t begin, std::size_t end) {
      for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
        body(i);
      }
    });
  }

  /// Its quads' centroids, and what its middle becomes: their mean.
  void average_face(std::size_t f) {
    const LevelMesh& from = *from_;
    const std::uint32_t first = from.faces.first(f);
    const std::uint32_t last = from.faces.first(f + 1);
    const Point middle = centroid(from, f);
    const auto point = [&from](std::uint32_t h) { return from.points[from.start(h)]; };
    Point sum{};
    std::uint32_t before = last - 1;
    for (std::uint32_t h = first; h < last; before = h++) {
      const std::uint32_t after = h + 1 == last ? first : h + 1;
      quads_[h] = 0.25 * (2.0 * point(h) + 0.5 * (point(before) + point(after)) + middle);
      sum += quads_[h];
    }
    sink_->put(from.vertex_count() + from.edge_count + f, sum / static_cast<double>(last - first));
  }

  const LevelMesh* from_;
  CornerRule corners_;
  const LevelMesh* to_;
  const PointSink* sink_;
  LargeArray<Point> quads_;
};

}  // namespace

void place_averaged_points(const LevelMesh& from, CornerRule corners, const LevelMesh& to,
                           const PointSink& sink) {
  const Averaging averaging(from, corners, to, sink);
  averaging.place_vertices();
  averaging.place_edges();
}

}  // namespace limn

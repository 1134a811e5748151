// The same input gives the same bytes for any number of threads.
#include <cstring>
#include <vector>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "limn/subdivision/label_subdivision.h"
#include "support/shapes.h"

namespace limn {
namespace {

template <class T>
bool same_bytes(const T& a, const T& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0);
}

TEST(Threads, DoNotChangeOneByte) {
  test::Random random(41);
  const auto mesh = test::control_mesh(
      test::jittered(test::with_mixed_faces(test::grid_soup(50, 40), random), 0.1, random));
  for (const NonQuadRule rule : {NonQuadRule::kUniformFirstStep, NonQuadRule::kWherePainted}) {
    SubdivisionSettings settings;
    settings.non_quads = rule;
    IgnoreProgress progress;
    const auto legal =
        legal_labels(*mesh, test::random_depths(*mesh, 0.1, 3, random), settings, progress);
    ASSERT_TRUE(legal);
    const auto refined_by = [&](int threads) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
      tbb::task_arena arena(threads);
      return arena.execute(
          [&] { return refine(*mesh, legal->labels, settings, {}, progress).value(); });
    };
    const RefinedMesh alone = refined_by(1);
    ASSERT_GT(alone.face_count(), 20000u);
    for (const int threads : {2, 7, 16, 2}) {
      const RefinedMesh together = refined_by(threads);
      EXPECT_TRUE(same_bytes(alone.positions, together.positions));
      EXPECT_TRUE(same_bytes(alone.vertex_levels, together.vertex_levels));
      EXPECT_TRUE(same_bytes(alone.quads, together.quads));
      EXPECT_TRUE(same_bytes(alone.polygon_offsets, together.polygon_offsets));
      EXPECT_TRUE(same_bytes(alone.polygon_vertices, together.polygon_vertices));
      EXPECT_TRUE(same_bytes(alone.face_control_faces, together.face_control_faces));
      EXPECT_TRUE(same_bytes(alone.face_levels, together.face_levels));
    }
  }
}

}  // namespace
}  // namespace limn

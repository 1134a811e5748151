// Memory that runs out at any one allocation: document and undo history stay as they were.
#include <algorithm>
#include <functional>
#include <memory>
#include <new>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "limn/document/commands.h"
#include "limn/document/history.h"
#include "limn/document/project_file.h"
#include "limn/document/refinement.h"
#include "limn/painting/stroke.h"
#include "support/attribute_shapes.h"
#include "support/counting_allocator.h"
#include "support/effort.h"
#include "support/shapes.h"

namespace limn {
namespace {

/// OpenMesh 9 cannot destroy a mesh in whose making one of its property objects, or its name,
/// could not be allocated: a null pointer stays in its list. So where half-edge meshes are made
/// only what is larger than that runs out; their arrays are.
constexpr std::size_t kLargerThanProperties = 512;

/// Lets `work` run out of memory at its first allocation, at its second and so on, until it has
/// enough. After each failure `check` looks at what is left.
void run_out_at_every_allocation(const std::function<void()>& work,
                                 const std::function<void()>& check, std::size_t smallest = 0) {
  const long step = test::effort() < 1.0 ? 3 : 1;
  for (long allowed = 0;; allowed += step) {
    bool is_done = true;
    test::allow_allocations(allowed, smallest);
    try {
      work();
    } catch (const std::bad_alloc&) {
      is_done = false;
    } catch (...) {
      test::allow_allocations(test::kUnlimitedAllocations);
      throw;
    }
    test::allow_allocations(test::kUnlimitedAllocations);
    if (is_done) {
      EXPECT_GT(allowed, 0);
      return;
    }
    check();
    if (testing::Test::HasFailure()) {
      ADD_FAILURE() << "after " << allowed << " allocations";
      return;
    }
    ASSERT_LT(allowed, 200000);
  }
}

struct Work {
  Document document;
  History history;

  Work() {
    test::Random random(4);
    const auto mesh = test::with_random_charts(
        *test::with_random_creases(*test::control_mesh(test::torus_soup(16, 12)), 0.3, 0.2, random),
        3, random);
    document = make_document({mesh, {}}, "torus");
    history.execute(document, paint_command({{3, 0, 2}, {4, 0, 1}}, "paint"));
    history.mark_saved();
    history.execute(document, stage_command({true, 2}, "stage"));
    history.execute(document, paint_command({{7, 0, 1}}, "paint more"));
    history.undo(document);
  }
  /// Of everything about both that a person could tell.
  [[nodiscard]] std::size_t state() const {
    std::ostringstream text;
    write_project(text, document, std::nullopt);
    text << document.control.get() << document.opened.get() << ' ' << document.revisions.control
         << ' ' << document.revisions.depths << ' ' << document.revisions.stage << ' '
         << history.bytes() << history.undo_name() << '|' << history.redo_name()
         << history.is_modified();
    return std::hash<std::string>()(text.str());
  }
};

void expect_untouched(const std::function<void(Work&)>& change, std::size_t smallest = 0) {
  Work work;
  const std::size_t before = work.state();
  run_out_at_every_allocation([&] { change(work); }, [&] { EXPECT_EQ(work.state(), before); },
                              smallest);
  EXPECT_NE(work.state(), before);
  // And it can be undone and done again without harm.
  work.history.undo(work.document);
  work.history.redo(work.document);
  EXPECT_EQ(work.document.depths.size(), work.document.control->face_count());
}

TEST(OutOfMemory, CommandsLeaveDocumentAndHistory) {
  const auto cube = test::cube();
  const auto torus = test::control_mesh(test::torus_soup(16, 12));
  const std::vector<std::function<std::unique_ptr<Command>(const Document&)>> commands = {
      [](const Document&) {
        return paint_command({{1, 0, 5}, {2, 0, 5}}, "a rather long name");
      },
      [](const Document&) {
        return stage_command({false, 1}, "one level, and a long name");
      },
      [](const Document& document) {
        SubdivisionSettings settings = document.settings;
        settings.points = SurfacePoints::kLimit;
        return settings_command(settings);
      },
      [](const Document&) {
        return scheme_command(SchemeSettings{}, {false, 1}, "a scheme");
      },
      [](const Document& document) { return crease_command(document, ClearCreases{}); },
      [&](const Document&) { return replace_control_command(cube, "replace"); },
      [&](const Document& document) {
        return reattach_command(
            transfer_painting(*document.control, document.depths.values(), torus));
      },
      [](const Document&) { return revert_command(); },
  };
  for (const auto& make : commands) {
    expect_untouched([&](Work& work) { work.history.execute(work.document, make(work.document)); });
  }
}

TEST(OutOfMemory, FittingLeavesDocumentAndHistory) {
  expect_untouched(
      [](Work& work) {
        work.history.execute(work.document, fit_command(work.document, Fitting::kTriangulate));
      },
      kLargerThanProperties);
}

TEST(OutOfMemory, EdgeEditsLeaveDocumentAndHistory) {
  for (const bool splits : {true, false}) {
    Work work;
    work.history.execute(work.document, fit_command(work.document, Fitting::kTriangulate));
    std::uint32_t edge = 0;
    while (!flip_edge_command(work.document, edge)) {
      ++edge;  // Not every edge can be.
    }
    const std::size_t before = work.state();
    run_out_at_every_allocation(
        [&] {
          auto edit = splits ? split_edge_command(work.document, edge)
                             : flip_edge_command(work.document, edge);
          work.history.execute(work.document, std::move(edit).value());
        },
        [&] { EXPECT_EQ(work.state(), before); }, kLargerThanProperties);
    EXPECT_NE(work.state(), before);
  }
}

TEST(OutOfMemory, UndoAndRedoEitherHappenOrDoNot) {
  expect_untouched([](Work& work) {
    work.history.execute(work.document, revert_command());
    work.history.undo(work.document);
    work.history.redo(work.document);
  });
}

TEST(OutOfMemory, AStrokeCanBeTakenBack) {
  Work work;
  const std::size_t before = work.state();
  const std::vector<std::uint32_t> faces{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  run_out_at_every_allocation(
      [&] {
        Stroke stroke(work.document.depths, DepthChange::add(1));
        try {
          for (const std::uint32_t face : faces) {
            stroke.touch(work.document.depths, std::span(&face, 1));
          }
          work.history.record(
              paint_command({stroke.edits().begin(), stroke.edits().end()}, "paint"));
        } catch (const std::bad_alloc&) {
          revert_edits(work.document.depths, stroke.edits());
          throw;
        }
      },
      [&] { EXPECT_EQ(work.state(), before); });
}

TEST(OutOfMemory, ProjectsAndRefinementsComeToNothing) {
  Work work;
  const std::size_t before = work.state();
  std::ostringstream text;
  write_project(text, work.document, ViewState{});
  run_out_at_every_allocation([&] { (void)parse_project(text.str(), "project").value(); },
                              [&] { EXPECT_EQ(work.state(), before); }, kLargerThanProperties);
  run_out_at_every_allocation(
      [&] {
        IgnoreProgress progress;
        const auto labels = derive_labels(*work.document.control, work.document.depths.values(),
                                          work.document.settings, progress);
        (void)derive_refinement(*work.document.control, labels.value(),
                                {work.document.settings, kAllLevels}, progress)
            .value();
      },
      [&] { EXPECT_EQ(work.state(), before); }, kLargerThanProperties);
}

}  // namespace
}  // namespace limn

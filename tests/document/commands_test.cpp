#include "limn/document/commands.h"

#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/document/history.h"
#include "limn/mesh/bundled.h"
#include "limn/painting/stroke.h"

namespace limn {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

using Mesh = std::shared_ptr<const ControlMesh>;

Mesh bundled(std::string_view name) {
  return load_bundled_mesh(name).value().mesh;
}

Document open(std::string_view name) {
  return make_document(load_bundled_mesh(name).value(), std::string(name));
}

/// What undo must give back: all of a document but its revisions.
struct State {
  Mesh control;
  Mesh opened;
  FaceDepths depths;
  FineDemands demands;
  SubdivisionSettings settings;
  std::optional<SchemeSettings> scheme;
  Stage stage;

  [[nodiscard]] bool operator==(const State&) const = default;
};

State state_of(const Document& document) {
  return {document.control,  document.opened, document.depths, document.demands,
          document.settings, document.scheme, document.stage};
}

/// Which revisions differ: control, depths, stage.
std::vector<bool> counted(const Revisions& before, const Revisions& after) {
  return {before.control != after.control, before.depths != after.depths,
          before.stage != after.stage};
}

/// Applies, reverts and applies again; checks states and that exactly `expected` revisions count up
/// each time.
void expect_undoable(Document& document, Command& command, const std::vector<bool>& expected) {
  const State before = state_of(document);
  Revisions revisions = document.revisions;
  const auto expect_counted = [&] {
    EXPECT_EQ(counted(revisions, document.revisions), expected);
    EXPECT_GE(document.revisions.control, revisions.control);
    EXPECT_GE(document.revisions.depths, revisions.depths);
    EXPECT_GE(document.revisions.stage, revisions.stage);
    revisions = document.revisions;
  };
  command.apply(document);
  expect_counted();
  const State after = state_of(document);
  EXPECT_NE(before, after);
  command.revert(document);
  expect_counted();
  EXPECT_EQ(state_of(document), before);
  command.apply(document);
  expect_counted();
  EXPECT_EQ(state_of(document), after);
}

std::unique_ptr<Command> paint(const Document& document, std::vector<std::uint32_t> faces,
                               DepthChange change) {
  return paint_command(plan_edits(document.depths, faces, change), "paint");
}

TEST(MakeDocument, StartsUnpaintedAtTheControlMesh) {
  const Document document = make_document(load_bundled_mesh("cube").value(), "cube", "cube.obj");
  EXPECT_EQ(document.control->face_count(), 6U);
  EXPECT_EQ(document.opened, document.control);
  EXPECT_THAT(document.depths.values(), ElementsAre(0, 0, 0, 0, 0, 0));
  EXPECT_EQ(document.stage, Stage{});
  EXPECT_EQ(document.settings, SubdivisionSettings{});
  EXPECT_EQ(document.name, "cube");
  EXPECT_EQ(document.mesh_path, "cube.obj");
  EXPECT_TRUE(document.project_path.empty());
}

TEST(MakeDocument, NoTwoDocumentsShareARevision) {
  Document first = open("cube");
  const Document second = open("cube");
  for (int i = 0; i < 1000; ++i) {
    ++first.revisions.depths;
    ASSERT_NE(first.revisions.depths, second.revisions.depths);
  }
  EXPECT_THAT(counted(first.revisions, second.revisions), Each(true));
  EXPECT_THAT(counted(Revisions{}, second.revisions), Each(true));
}

TEST(PaintCommand, ChangesDepthsAlone) {
  Document document = open("cube");
  const auto command = paint(document, {1, 4}, DepthChange::set(3));
  expect_undoable(document, *command, {false, true, false});
  EXPECT_THAT(document.depths.values(), ElementsAre(0, 3, 0, 0, 3, 0));
  EXPECT_EQ(command->name(), "paint");
}

TEST(PaintCommand, KeepsTheStageSoThatTheViewFollows) {
  Document document = open("cube");
  stage_command({true, kAllLevels}, "subdivide")->apply(document);
  paint(document, {2}, DepthChange::add(1))->apply(document);
  EXPECT_EQ(document.stage, (Stage{true, kAllLevels}));
  EXPECT_EQ(document.control, document.opened);
}

TEST(PaintCommand, ThatChangesNothingCountsNothing) {
  Document document = open("cube");
  const Revisions before = document.revisions;
  paint(document, {2}, DepthChange::add(-1))->apply(document);
  EXPECT_THAT(counted(before, document.revisions), Each(false));
}

TEST(PaintCommand, WeighsItsEdits) {
  std::vector<DepthEdit> edits(1000);
  for (std::uint32_t f = 0; f < 1000; ++f) {
    edits[f] = {f, 0, 1};
  }
  edits.reserve(100000);
  const std::size_t none = paint_command({}, "p")->bytes();
  EXPECT_EQ(paint_command(std::move(edits), "p")->bytes(), none + 1000 * sizeof(DepthEdit));
}

TEST(StageCommand, ChangesTheStageAlone) {
  Document document = open("cube");
  paint(document, {0}, DepthChange::set(4))->apply(document);
  const auto command = stage_command({true, kAllLevels}, "subdivide");
  expect_undoable(document, *command, {false, false, true});
  EXPECT_EQ(document.stage, (Stage{true, kAllLevels}));
  EXPECT_THAT(document.depths.values(), ElementsAre(4, 0, 0, 0, 0, 0));
}

TEST(SettingsCommand, ChangesTheSettingsAlone) {
  Document document = open("mixed");
  const SubdivisionSettings other{.non_quads = NonQuadRule::kWherePainted,
                                  .legalisation = LegalisationMethod::kGreedy,
                                  .corners = CornerRule::kSmooth};
  const auto command = settings_command(other);
  expect_undoable(document, *command, {false, false, true});
  EXPECT_EQ(document.settings, other);
}

/// The document's mesh with all edges sharp.
Mesh creased(const Document& document, float sharpness) {
  MeshAttributes attributes = document.control->attributes();
  attributes.creases.edge_sharpness.assign(document.control->edge_count(), sharpness);
  return std::make_shared<const ControlMesh>(document.control->with_attributes(attributes));
}

TEST(AttributesCommand, KeepsDepthsAndStage) {
  Document document = open("cube");
  paint(document, {0, 5}, DepthChange::set(4))->apply(document);
  stage_command({true, 2}, "step")->apply(document);
  const Mesh sharp = creased(document, 2.0f);
  const auto command = attributes_command(sharp, "crease 12 edges");
  expect_undoable(document, *command, {true, false, false});
  EXPECT_EQ(document.control, sharp);
  EXPECT_THAT(document.depths.values(), ElementsAre(4, 0, 0, 0, 0, 4));
  EXPECT_EQ(document.stage, (Stage{true, 2}));
  EXPECT_EQ(command->name(), "crease 12 edges");
  const auto nothing = attributes_command(sharp, "nothing");
  const Revisions before = document.revisions;
  nothing->apply(document);
  EXPECT_EQ(document.control, sharp);
  EXPECT_EQ(counted(before, document.revisions), (std::vector<bool>{false, false, false}));
}

TEST(AttributesCommand, WeighsAttributesAloneWhileTheSurfaceIsShared) {
  Document document = open("creature");
  const std::size_t sharpness_bytes = document.control->edge_count() * sizeof(float);
  const auto command = attributes_command(creased(document, 2.0f), "crease");
  EXPECT_GT(command->bytes(), sharpness_bytes);
  EXPECT_LT(command->bytes(), sharpness_bytes + 1000);
  command->apply(document);  // What it holds now is the opened mesh.
  EXPECT_LT(command->bytes(), 1000U);
  const auto second = attributes_command(creased(document, 3.0f), "crease");
  second->apply(document);
  EXPECT_GT(second->bytes(), sharpness_bytes);
  EXPECT_LT(second->bytes(), sharpness_bytes + 1000);
  // Another mesh: the creased one shares its surface with the opened one.
  const auto third = replace_control_command(bundled("grid"), "apply");
  third->apply(document);
  EXPECT_LT(third->bytes(), sharpness_bytes + document.opened->face_count() + 1000);
  revert_command()->apply(document);
  EXPECT_TRUE(document.control->creases().edge_sharpness.empty());
}

TEST(ReplaceControlCommand, StartsTheNewMeshUnpainted) {
  Document document = open("cube");
  paint(document, {0, 5}, DepthChange::set(4))->apply(document);
  stage_command({true, 2}, "step")->apply(document);
  const Mesh grid = bundled("grid");
  const auto command = replace_control_command(grid, "apply");
  expect_undoable(document, *command, {true, true, true});
  EXPECT_EQ(document.control, grid);
  EXPECT_EQ(document.opened->face_count(), 6U);
  EXPECT_EQ(document.depths, FaceDepths(grid->face_count()));
  EXPECT_EQ(document.stage, Stage{});
}

TEST(ReplaceControlCommand, WeighsTheMeshThatItAloneKeeps) {
  Document document = open("cube");
  const Mesh grid = bundled("grid");
  const auto command = replace_control_command(grid, "apply");
  const std::size_t holding_grid = command->bytes();
  EXPECT_GT(holding_grid, grid->positions().size_bytes() + grid->face_count());
  command->apply(document);  // Now it holds the cube, but that is the document's anyway.
  EXPECT_LT(command->bytes(), 1000U);
  command->revert(document);
  EXPECT_EQ(command->bytes(), holding_grid);
  command->apply(document);

  const auto second = replace_control_command(bundled("torus_open"), "apply");
  second->apply(document);  // This one holds the grid, which nobody else does.
  EXPECT_EQ(second->bytes(), holding_grid);
}

TEST(RevertCommand, GoesBackToTheOpenedMesh) {
  Document document = open("cube");
  const Mesh cube = document.control;
  replace_control_command(bundled("grid"), "apply")->apply(document);
  paint(document, {100}, DepthChange::set(4))->apply(document);
  stage_command({true, 2}, "step")->apply(document);
  const auto command = revert_command();
  expect_undoable(document, *command, {true, true, true});
  EXPECT_EQ(document.control, cube);
  EXPECT_EQ(document.depths, FaceDepths(6));
  EXPECT_EQ(document.stage, Stage{});
}

TEST(RevertCommand, ClearsThePaintingOfAMeshThatIsStillTheOpenedOne) {
  Document document = open("cube");
  paint(document, {1}, DepthChange::set(4))->apply(document);
  const auto command = revert_command();
  expect_undoable(document, *command, {false, true, false});
  EXPECT_EQ(document.depths, FaceDepths(6));
}

TEST(Document, UndoAfterSubdividingGivesBackPaintAndMesh) {
  Document document = open("cube");
  const Mesh cube = document.control;
  History history;
  history.execute(document, paint(document, {0}, DepthChange::set(5)));
  history.execute(document, stage_command({true, 0}, "remove illegal vertices"));
  history.execute(document, stage_command({true, kAllLevels}, "subdivide"));
  EXPECT_EQ(document.control, cube);
  EXPECT_THAT(document.depths.values(), ElementsAre(5, 0, 0, 0, 0, 0));
  history.undo(document);
  history.undo(document);
  EXPECT_EQ(document.control, cube);
  EXPECT_EQ(document.stage, Stage{});
  EXPECT_THAT(document.depths.values(), ElementsAre(5, 0, 0, 0, 0, 0));
  history.undo(document);
  EXPECT_THAT(document.depths.values(), Each(0));
}

TEST(Document, UndoAfterApplyGivesBackPaintAndMesh) {
  Document document = open("cube");
  History history;
  history.execute(document, paint(document, {0}, DepthChange::set(5)));
  const State painted = state_of(document);
  history.execute(document, replace_control_command(bundled("grid"), "apply"));
  history.execute(document, paint(document, {143}, DepthChange::set(2)));
  history.undo(document);
  history.undo(document);
  EXPECT_EQ(state_of(document), painted);
}

TEST(Document, AStrokePaintedLiveIsOneStep) {
  Document document = open("cube");
  History history;
  Stroke stroke(document.depths, DepthChange::add(1));
  stroke.touch(document.depths, std::vector<std::uint32_t>{0, 1});
  stroke.touch(document.depths, std::vector<std::uint32_t>{1, 2});
  history.record(paint_command({stroke.edits().begin(), stroke.edits().end()}, "paint 3 faces"));
  EXPECT_THAT(document.depths.values(), ElementsAre(1, 1, 1, 0, 0, 0));
  history.undo(document);
  EXPECT_THAT(document.depths.values(), Each(0));
  history.redo(document);
  EXPECT_THAT(document.depths.values(), ElementsAre(1, 1, 1, 0, 0, 0));
}

class RandomCommands {
 public:
  explicit RandomCommands(std::uint32_t seed) : random_(seed) {}

  std::size_t below(std::size_t n) { return random_() % n; }

  std::unique_ptr<Command> next(const Document& document) {
    switch (below(9)) {
      case 8:
        return attributes_command(creased(document, static_cast<float>(below(3))), "crease");
      case 0:
        return stage_command({below(2) == 0, static_cast<int>(below(5))}, "stage");
      case 1:
        return settings_command(
            {.non_quads =
                 below(2) == 0 ? NonQuadRule::kUniformFirstStep : NonQuadRule::kWherePainted,
             .legalisation = LegalisationMethod::kGreedy,
             .corners = below(2) == 0 ? CornerRule::kSharp : CornerRule::kSmooth});
      case 2:
        return replace_control_command(meshes_[below(meshes_.size())], "apply");
      case 3:
        return below(2) == 0 ? revert_command() : paint_some(document);
      default:
        return paint_some(document);
    }
  }

 private:
  std::unique_ptr<Command> paint_some(const Document& document) {
    std::vector<std::uint32_t> faces(below(30));
    for (std::uint32_t& face : faces) {
      face = static_cast<std::uint32_t>(below(document.depths.size()));
    }
    const int amount = static_cast<int>(below(11));
    return paint(document, std::move(faces),
                 below(3) == 0 ? DepthChange::set(amount) : DepthChange::add(amount - 5));
  }

  std::mt19937 random_;
  std::vector<Mesh> meshes_{bundled("cube"), bundled("icosahedron"), bundled("mixed")};
};

/// Against a plain list of the states that were passed through.
void walk_at_random(std::uint32_t seed, int steps, std::size_t budget) {
  RandomCommands commands(seed);
  Document document = open("cube");
  History history(budget);
  std::vector<State> states{state_of(document)};
  std::size_t at = 0;
  for (int step = 0; step < steps; ++step) {
    const Revisions before = document.revisions;
    const State left = states[at];
    const std::size_t choice = commands.below(10);
    if (choice < 5) {
      history.execute(document, commands.next(document));
      states.resize(++at);
      states.push_back(state_of(document));
    } else if (choice < 8 && history.can_undo()) {
      history.undo(document);
      --at;
    } else if (history.can_redo()) {
      history.redo(document);
      ++at;
    }
    const State now = state_of(document);
    ASSERT_EQ(now, states.at(at)) << "step " << step;
    ASSERT_EQ(document.depths.size(), document.control->face_count());
    // Whoever looks at the revisions alone must not miss a change.
    ASSERT_TRUE(now.control == left.control || document.revisions.control > before.control);
    ASSERT_TRUE(now.depths == left.depths || document.revisions.depths > before.depths);
    ASSERT_TRUE((now.stage == left.stage && now.settings == left.settings) ||
                document.revisions.stage > before.stage);
    ASSERT_TRUE(history.bytes() <= budget || !history.can_undo() || !history.can_redo());
  }
}

TEST(Document, RandomCommandsAgreeWithAListOfStates) {
  walk_at_random(1, 6000, std::size_t{256} << 20U);
  for (std::uint32_t seed = 2; seed < 12 && !testing::Test::HasFatalFailure(); ++seed) {
    walk_at_random(seed, 300, 20000);
    walk_at_random(seed, 300, 1000);
  }
}

}  // namespace
}  // namespace limn

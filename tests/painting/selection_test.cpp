#include "limn/painting/selection.h"

#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/bundled.h"
#include "limn/mesh/import.h"

namespace limn {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Mesh = std::shared_ptr<const ControlMesh>;

Mesh bundled(std::string_view name) {
  return load_bundled_mesh(name).value().mesh;
}

Mesh from_obj(std::string_view text) {
  return import_obj(text, "test").value().mesh;
}

/// Two unit squares that share an edge; the second is folded up by a right angle, at this scale and
/// place.
Mesh fold(double scale, double offset) {
  const double points[6][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {1, 1, 1}};
  std::ostringstream text;
  text.precision(17);
  for (const auto& p : points) {
    text << "v " << p[0] * scale + offset << ' ' << p[1] * scale + offset << ' '
         << p[2] * scale + offset << '\n';
  }
  text << "f 1 2 3 4\nf 2 5 6 3\n";
  return from_obj(text.str());
}

PaintContext seeing(VisibleFaces visible) {
  PaintContext context;
  context.visible = std::move(visible);
  return context;
}

std::vector<std::uint32_t> selected(const Mesh& mesh, const Selection& selection) {
  return select_faces(*mesh, FaceDepths(mesh->face_count()), selection, {}).value();
}

TEST(DihedralAngles, CubeHasNinetyDegreesEverywhere) {
  EXPECT_THAT(face_dihedral_angles(*bundled("cube")), Each(::testing::DoubleNear(90.0, 1e-12)));
}

TEST(DihedralAngles, FlatGridHasNone) {
  const std::string flat =
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nf 1 2 5 4\nf 2 3 6 5\n";
  EXPECT_THAT(face_dihedral_angles(*from_obj(flat)), ElementsAre(0.0, 0.0));
}

TEST(DihedralAngles, IcosahedronHasThatOfTheTextbook) {
  // 180 degrees less acos(-sqrt(5) / 3), the angle inside the solid.
  EXPECT_THAT(face_dihedral_angles(*bundled("icosahedron")),
              Each(::testing::DoubleNear(41.810314895778596, 1e-4)));
}

TEST(DihedralAngles, AFaceWithBoundaryEdgesAloneHasNone) {
  EXPECT_THAT(face_dihedral_angles(*from_obj("v 0 0 0\nv 1 0 0\nv 1 1 3\nv 0 1 0\nf 1 2 3 4\n")),
              ElementsAre(0.0));
}

TEST(DihedralAngles, TakesTheLargestOverTheEdges) {
  // Three faces in a strip: a fold by 45 degrees, then one by 90.
  const Mesh strip = from_obj(
      "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 1\nv 2 1 1\nv 1 0 2\nv 1 1 2\n"
      "f 1 3 4 2\nf 3 5 6 4\nf 5 7 8 6\n");
  EXPECT_THAT(face_dihedral_angles(*strip),
              ElementsAre(::testing::DoubleNear(45, 1e-12), ::testing::DoubleNear(90, 1e-12),
                          ::testing::DoubleNear(90, 1e-12)));
}

TEST(DihedralAngles, NonPlanarPolygonsHaveANewellNormal) {
  // A saddle's Newell normal is +Z although no three of its corners give that; the flap stands up.
  const Mesh mesh = from_obj(
      "v 0 0 1\nv 1 0 -1\nv 1 1 1\nv 0 1 -1\nv 1 0 5\nv 1 1 7\n"
      "f 1 2 3 4\nf 3 2 5 6\n");
  EXPECT_THAT(face_dihedral_angles(*mesh), Each(::testing::DoubleNear(90, 1e-12)));
}

TEST(DihedralAngles, NeitherSizeNorPlaceMatter) {
  for (const double scale : {1e-150, 1e-9, 1.0, 1e12, 1e17}) {
    EXPECT_THAT(face_dihedral_angles(*fold(scale, 0.0)), Each(::testing::DoubleNear(90.0, 1e-9)))
        << scale;
  }
  EXPECT_THAT(face_dihedral_angles(*fold(1.0, 1e6)), Each(::testing::DoubleNear(90.0, 1e-6)));
}

TEST(DihedralAngles, AFaceWithoutAreaHasNoAngle) {
  const Mesh mesh = from_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 1 5\n");
  EXPECT_THAT(face_dihedral_angles(*mesh), ElementsAre(0.0, 0.0));
}

TEST(SelectFaces, All) {
  EXPECT_THAT(selected(bundled("cube"), SelectAll{}), ElementsAre(0, 1, 2, 3, 4, 5));
}

TEST(SelectFaces, DihedralIsStrictlyGreater) {
  const Mesh cube = bundled("cube");
  EXPECT_THAT(selected(cube, SelectDihedral{90.0}), IsEmpty());
  EXPECT_THAT(selected(cube, SelectDihedral{89.99}), SizeIs(6));
  EXPECT_THAT(selected(cube, SelectDihedral{180.0}), IsEmpty());
}

TEST(SelectFaces, RoundingDoesNotDecideAtTheThreshold) {
  // Coordinates that are no binary fractions: the angles come out a little beside 90 degrees.
  for (const double scale : {0.1, 1.0 / 3.0, 0.7, 123.456}) {
    EXPECT_THAT(selected(fold(scale, 0.1), SelectDihedral{90.0}), IsEmpty()) << scale;
    EXPECT_THAT(selected(fold(scale, 0.1), SelectDihedral{89.999}), SizeIs(2)) << scale;
  }
}

TEST(SelectFaces, RangesAreMergedAscending) {
  const Mesh cube = bundled("cube");
  EXPECT_THAT(selected(cube, SelectFaces{{{4, 5}, {0, 0}, {3, 4}, {0, 1}}}),
              ElementsAre(0, 1, 3, 4, 5));
  EXPECT_THAT(selected(cube, SelectFaces{{{0, 5}, {2, 3}}}), SizeIs(6));
  EXPECT_THAT(selected(cube, SelectFaces{}), IsEmpty());
}

TEST(SelectFaces, AFaceThatIsNotThereIsNamed) {
  const auto beyond = select_faces(*bundled("cube"), FaceDepths(6), SelectFaces{{{0, 6}}}, {});
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().kind, ErrorKind::kUsage);
  EXPECT_THAT(beyond.error().message, HasSubstr("no face 6"));
  EXPECT_THAT(beyond.error().message, HasSubstr("0 to 5"));
  EXPECT_FALSE(select_faces(*bundled("cube"), FaceDepths(6), SelectFaces{{{0, 0xFFFFFFFFU}}}, {}));
  EXPECT_FALSE(select_faces(*bundled("cube"), FaceDepths(6), SelectFaces{{{3, 2}}}, {}));
}

TEST(SelectFaces, VisibleAsksWhoCanDraw) {
  const Mesh cube = bundled("cube");
  const VisibleFaces front = [] { return std::vector<std::uint32_t>{1, 4}; };
  EXPECT_THAT(select_faces(*cube, FaceDepths(6), SelectVisible{}, seeing(front)).value(),
              ElementsAre(1, 4));

  const VisibleFaces broken = []() -> Result<std::vector<std::uint32_t>> {
    return fail(ErrorKind::kEnvironment, "no OpenGL");
  };
  const auto failed = select_faces(*cube, FaceDepths(6), SelectVisible{}, seeing(broken));
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().kind, ErrorKind::kEnvironment);

  const auto nobody = select_faces(*cube, FaceDepths(6), SelectVisible{}, {});
  ASSERT_FALSE(nobody);
  EXPECT_EQ(nobody.error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace limn

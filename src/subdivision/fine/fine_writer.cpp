// As patch.cpp does it for a node that is no grid, one node after the other: the points around a
// face give those of its next level, of which the vertices are written that the node owns, and the
// points around its children.
#include "subdivision/fine/fine_trees.h"
#include "subdivision/patch_around.h"
#include "subdivision/patch_gather.h"
#include "subdivision/root_nodes.h"

namespace limn {

class FineTrees::Writer {
 public:
  Writer(const FineTrees& trees, const Patch& patch, std::uint32_t face, std::uint32_t first_quad,
         const RefinedArrays& arrays)
      : trees_(&trees), patch_(&patch), face_(face), quad_(first_quad), arrays_(&arrays) {}

  /// Of a root of level 1: the corners that never move again.
  void write_resting_corners(std::uint32_t at) {
    const PatchGrid grid{{patch_->grid.data(), 4, 1}, 1, 0, 0, 15, 15};
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t v = trees_->forest_.node(at).vertices[i];
      if (trees_->owners_[v] == at && trees_->levels_[v] == 1) {
        const GridPlace& place = kRootCorners[i];
        put(v, grid, patch_->grid[4 * place.y + place.x + 5], place);
      }
    }
  }

  void write_root(std::uint32_t at, int level) {
    write(at, {{patch_->grid.data(), 4, 1}, level, 0, 0, 15, 15});
  }

 private:
  void put(std::uint32_t vertex, const PatchGrid& grid, const Point& point,
           const GridPlace& place) {
    const std::uint32_t number = trees_->numbers_[vertex];
    arrays_->put(number, point, grid.level);
    if (arrays_->takes_limits()) {
      arrays_->put_limit(number, limit_in_patch(*patch_, grid, place));
    }
  }
  void put_quad(const std::array<std::uint32_t, 4>& vertices, int level) {
    std::array<std::uint32_t, 4>& quad = arrays_->quads[quad_];
    for (std::size_t i = 0; i < 4; ++i) {
      quad[i] = trees_->numbers_[vertices[i]];
    }
    if (arrays_->face_control_faces != nullptr) {
      arrays_->face_control_faces[quad_] = face_;
      arrays_->face_levels[quad_] = static_cast<std::uint8_t>(level);
    }
    ++quad_;
  }

  void write(std::uint32_t at, const PatchGrid& here) {
    const ForestNode& node = trees_->forest_.node(at);
    if (node.children == kNoChildren) {
      put_quad(node.vertices, here.level);
      return;
    }
    const Around next(*patch_, here);
    const PatchGrid grid = next.grid();
    const auto put_owned = [&](std::uint32_t v, const GridPlace& place) {
      if (trees_->owners_[v] == at && trees_->levels_[v] == grid.level) {
        put(v, grid, next.at(place), place);
      }
    };
    for (std::uint32_t i = 0; i < 4; ++i) {
      put_owned(node.vertices[i], kCornersOfFour[i]);
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (const std::uint32_t child = node.child(i); child != kNone) {
        const std::array<std::uint32_t, 4>& vertices = trees_->forest_.node(child).vertices;
        put_owned(vertices[(i + 1) % 4], kMiddlesOfFour[i]);
        if (node.children != kAllChildren) {
          put_owned(vertices[(i + 3) % 4], kMiddlesOfFour[(i + 3) % 4]);
        }
        if (child == node.first_child) {
          put_owned(vertices[(i + 2) % 4], kCentreOfFour);
        }
      }
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
      if (const std::uint32_t child = node.child(i); child != kNone) {
        const auto sides = static_cast<std::uint8_t>(bit(i) | bit((i + 3) % 4));
        write(child, {next.child(i), grid.level, 2 * here.column + (i == 1 || i == 2 ? 1 : 0),
                      2 * here.row + (i >= 2 ? 1 : 0),
                      static_cast<std::uint8_t>(here.patch_corners & bit(i)),
                      static_cast<std::uint8_t>(here.patch_sides & sides)});
        if (node.children != kAllChildren) {
          write_coarse(node, trees_->forest_.node(child).vertices, grid.level);
        }
      }
    }
  }

  /// The two quads of a Y-element beside its child.
  void write_coarse(const ForestNode& node, const std::array<std::uint32_t, 4>& child, int level) {
    const std::size_t positive = node.children;
    const std::size_t after = (positive + 1) % 4;
    const std::size_t opposite = (positive + 2) % 4;
    const std::size_t before = (positive + 3) % 4;
    put_quad({child[after], node.vertices[after], node.vertices[opposite], child[opposite]}, level);
    put_quad({child[before], child[opposite], node.vertices[opposite], node.vertices[before]},
             level);
  }

  const FineTrees* trees_;
  const Patch* patch_;
  std::uint32_t face_;
  std::uint32_t quad_;
  const RefinedArrays* arrays_;
};

void FineTrees::write_face(const RefinementPlan& plan, std::uint32_t face, Patch& patch,
                           const RefinedArrays& arrays) const {
  const ForestRoot& root = forest_.root(forest_.root_of(face));
  Writer writer(*this, patch, face, plan.numbering->first_face(face), arrays);
  if (root.is_quad()) {
    gather_quad(plan.cage, *plan.rings, face, patch);
    writer.write_root(root.node, 0);
    return;
  }
  for (std::uint32_t i = 0; i < root.sides; ++i) {
    gather_polygon_corner(plan.cage, *plan.rings, face, plan.cage.first_corner(face) + i, patch);
    writer.write_resting_corners(root.child(i));
    writer.write_root(root.child(i), 1);
  }
}

}  // namespace limn

#include "scheme_shapes.h"

#include "limn/mesh/bundled.h"
#include "limn/subdivision/schemes/uniform.h"

namespace limn::test {

MeshPointer fitted(const MeshPointer& mesh, Scheme scheme) {
  return check_fits(*mesh, scheme) ? mesh : make_fit(*mesh, fitting_for(scheme_info(scheme).takes));
}

MeshPointer set_apart(const ControlMesh& mesh, double amount, Random& random) {
  PolygonSoup soup;
  soup.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    soup.add_face(mesh.face(f));
  }
  const MeshPointer moved =
      control_mesh(jittered(std::move(soup), amount * mesh.bounds().diagonal(), random));
  return std::make_shared<const ControlMesh>(moved->with_attributes(mesh.attributes()));
}

std::vector<NamedShape> scheme_shapes() {
  Random random(31);
  const auto made = [&random](const PolygonSoup& soup) {
    return set_apart(*control_mesh(soup), 0.02, random);
  };
  std::vector<NamedShape> shapes{
      {"cube", cube()},
      {"torus", made(torus_soup(7, 5))},
      {"poles of 3", made(trapezohedron_soup(3))},
      {"poles of 9", made(trapezohedron_soup(9))},
      {"prism of 5", made(prism_soup(5))},
      {"random quads", made(random_quads(torus_soup(4, 3), random))},
      {"mixed torus", made(with_mixed_faces(torus_soup(8, 6), random))},
      {"single quad", made(grid_soup(1, 1))},
      {"strip", made(grid_soup(4, 1))},
      {"grid", made(grid_soup(5, 4))},
      {"heptagon in ring", made(polygon_in_ring_soup(7))},
      {"holes", made(with_holes(torus_soup(9, 7), 8, random))},
      {"mixed grid", made(with_mixed_faces(grid_soup(6, 5), random))},
  };
  for (const char* name : {"icosahedron", "cube_triangulated", "teapot", "mixed", "torus_open"}) {
    shapes.push_back({name, load_bundled_mesh(name)->mesh});
  }
  return shapes;
}

std::vector<NamedShape> shapes_for(Scheme scheme) {
  std::vector<NamedShape> shapes = scheme_shapes();
  for (NamedShape& shape : shapes) {
    shape.mesh = fitted(shape.mesh, scheme);
  }
  return shapes;
}

std::vector<NamedShape> closed_shapes_for(Scheme scheme) {
  std::vector<NamedShape> shapes = shapes_for(scheme);
  std::erase_if(shapes, [](const NamedShape& shape) { return !shape.mesh->is_closed(); });
  return shapes;
}

RefinedMesh subdivided(const ControlMesh& mesh, const SchemeSettings& settings, int levels) {
  IgnoreProgress progress;
  return subdivide(mesh, settings, {.levels = levels}, progress).value();
}

std::vector<glm::dvec3> boundary_positions(const RefinedMesh& mesh) {
  const auto control = to_control_mesh(mesh);
  const FlatTopology& flat = control->topology();
  std::vector<glm::dvec3> positions;
  for (std::size_t v = 0; v < control->vertex_count(); ++v) {
    if (flat.corner_twins[flat.vertex_corners[flat.vertex_offsets[v]]] == kNone) {
      positions.push_back(control->positions()[v]);
    }
  }
  return positions;
}

}  // namespace limn::test

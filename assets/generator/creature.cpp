// A small, round dragon. One tube runs from the rump to the nose; everything else grows out of
// patches of its walls and of its two ends. Modelled standing on y = 0 and looking along z, then
// centred and scaled.
//
//   the tube's half cross-section, 4 columns by 6 rows; positions of the perimeter:
//
//        13 12 11 10
//       +--+--+--+--+ 9
//       |  |  |  |  | 8
//   x=0 |  |  |  |  | 7      (0..3 belly, 4..9 flank from below, 10..13 back towards the spine)
//       |  |  |  |  | 6
//       |  |  |  |  | 5
//       +--+--+--+--+ 4
//         0  1  2  3
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "extrusion.h"
#include "families.h"

namespace limn::generator {
namespace {

using glm::dvec3;

constexpr dvec3 kX{1.0, 0.0, 0.0};
constexpr std::size_t kSpinePosition = 13;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// A slice of the tube from rump to nose: its middle, half width and height, and how far its
/// forward direction points up.
struct Slice {
  double y, z, half_width, half_height, pitch_degrees;
};

constexpr std::array kTrunk = {
    Slice{0.72, -0.80, 0.23, 0.24, -2}, Slice{0.70, -0.67, 0.31, 0.31, -3},
    Slice{0.68, -0.47, 0.38, 0.37, -4}, Slice{0.67, -0.24, 0.405, 0.39, 0},
    Slice{0.68, 0.00, 0.39, 0.38, 6},   Slice{0.72, 0.22, 0.35, 0.35, 16},
    Slice{0.81, 0.40, 0.29, 0.29, 32},  Slice{0.92, 0.51, 0.26, 0.25, 36},
};
constexpr std::array kHead = {
    Slice{1.03, 0.59, 0.33, 0.29, 26}, Slice{1.11, 0.68, 0.44, 0.38, 14},
    Slice{1.14, 0.84, 0.50, 0.44, 6},  Slice{1.14, 1.01, 0.51, 0.45, 0},
    Slice{1.13, 1.16, 0.48, 0.43, -3}, Slice{1.12, 1.28, 0.40, 0.36, -5},
};

Section section_of(const Slice& slice) {
  const double pitch = radians(slice.pitch_degrees);
  Section section;
  section.centre = {0.0, slice.y, slice.z};
  section.across = slice.half_width * kX;
  section.along = slice.half_height * dvec3(0.0, std::cos(pitch), -std::sin(pitch));
  return section;
}

/// A slice of a limb that runs along `direction`: half its size along x (as far as the direction
/// allows) and across that.
Section limb_section(const dvec3& middle, const dvec3& direction, double half_x,
                     double half_other) {
  const dvec3 d = glm::normalize(direction);
  const dvec3 across = glm::normalize(kX - glm::dot(kX, d) * d);
  Section section;
  section.centre = middle;
  section.across = half_x * across;
  section.along = half_other * glm::cross(d, across);
  return section;
}

/// Everything the parts need of one another.
struct Creature {
  HalfMesh mesh;
  Patch face;  ///< The tube's front end.
  Patch rump;  ///< Its rear end, rows from top to bottom.
  Tube trunk;
};

Creature grow_trunk_and_head() {
  Creature creature;
  auto [front, back] = pillow(creature.mesh, 4, 6);
  // The rump first: the outline that both ends share is the tube's.
  Section rear = section_of(kTrunk.front());
  rear.along = -rear.along;
  rear.dome = 0.10;
  lay(creature.mesh, back, rear,
      {{0.0, 0.54, 0.72, 0.87, 1.0}, {-1.0, -0.76, -0.52, 0.0, 0.52, 0.76, 1.0}});
  lay(creature.mesh, front, section_of(kTrunk.front()), even_spacing(front));
  creature.trunk = begin_tube(front);
  for (const Slice& slice : std::span(kTrunk).subspan(1)) {
    grow(creature.mesh, front, creature.trunk, section_of(slice));
  }
  for (const Slice& slice : kHead) {
    grow(creature.mesh, front, creature.trunk, section_of(slice));
  }
  Section face = section_of(kHead.back());
  face.dome = 0.12;
  lay(creature.mesh, front, face,
      {{0.0, 0.20, 0.50, 0.82, 1.0}, {-1.0, -0.72, -0.40, -0.04, 0.36, 0.76, 1.0}});
  creature.face = front;
  creature.rump = back;
  return creature;
}

/// Three toes in front of a foot: the front walls of its last ring, one by one.
void grow_toes(HalfMesh& mesh, const Tube& leg, std::size_t ring) {
  constexpr std::size_t kFirstFrontWall = 5;
  for (std::size_t i = 0; i < 3; ++i) {
    Patch toe = side(mesh, leg, kFirstFrontWall + i, 1, ring, 1);
    const double spread = 0.03 * (1.0 - static_cast<double>(i));
    Tube tube = begin_tube(toe);
    extrude_by(mesh, toe, tube, {spread, 0.0, 0.075}, 0.95);
    extrude_by(mesh, toe, tube, {0.3 * spread, -0.006, 0.05}, 0.72);
  }
}

void grow_leg(Creature& creature, std::size_t first_ring, double z, double thigh) {
  HalfMesh& mesh = creature.mesh;
  Patch sole = side(mesh, creature.trunk, 1, 3, first_ring, 2);
  Tube leg = begin_tube(sole);
  const dvec3 down(0.0, -1.0, 0.0);
  const auto slice = [&](double x, double y, double dz, double half_x, double half_z) {
    grow(mesh, sole, leg, limb_section({x, y, z + dz}, down, half_x, half_z));
  };
  if (first_ring > 2) {
    // The chest is higher than the rump: one ring more, half the way down.
    extrude(mesh, sole, leg);
    const std::vector<dvec3> before = mesh.positions;
    lay(mesh, sole, limb_section({0.255, 0.265, z}, down, 0.155 * thigh, 0.165 * thigh),
        even_spacing(sole));
    for (const Index v : sole.vertices) {
      mesh.positions[v] = glm::mix(before[v], mesh.positions[v], 0.55);
    }
  }
  slice(0.255, 0.265, 0.0, 0.155 * thigh, 0.165 * thigh);
  slice(0.26, 0.185, 0.0, 0.145, 0.145);
  slice(0.26, 0.11, 0.01, 0.14, 0.14);
  slice(0.265, 0.015, 0.03, 0.16, 0.16);
  grow_toes(mesh, leg, leg.walls.size() - 1);
}

void grow_tail(Creature& creature) {
  HalfMesh& mesh = creature.mesh;
  Patch tip = part(creature.rump, 0, 1, 2, 2);
  Tube tail = begin_tube(tip);
  struct Joint {
    double y, z, half_width, half_height;
  };
  constexpr std::array kJoints = {
      Joint{0.685, -0.98, 0.125, 0.120}, Joint{0.62, -1.11, 0.118, 0.112},
      Joint{0.55, -1.23, 0.105, 0.100},  Joint{0.54, -1.39, 0.092, 0.088},
      Joint{0.60, -1.53, 0.082, 0.076},  Joint{0.72, -1.61, 0.074, 0.066},
      Joint{0.85, -1.62, 0.070, 0.060},  Joint{0.92, -1.60, 0.165, 0.066},
      Joint{1.02, -1.56, 0.175, 0.060},  Joint{1.16, -1.50, 0.075, 0.040},
  };
  for (std::size_t i = 0; i < kJoints.size(); ++i) {
    const Joint& here = kJoints[i];
    const Joint& before = kJoints[i == 0 ? 0 : i - 1];
    const Joint& after = kJoints[std::min(i + 1, kJoints.size() - 1)];
    const dvec3 direction(0.0, after.y - before.y, after.z - before.z);
    grow(mesh, tip, tail,
         limb_section({0.0, here.y, here.z}, direction, here.half_width, here.half_height));
  }
}

void grow_ear(Creature& creature) {
  HalfMesh& mesh = creature.mesh;
  Patch tip = side(mesh, creature.trunk, 10, 2, 9, 2);
  Tube ear = begin_tube(tip);
  struct Joint {
    double x, y, z, half_width, half_depth;
  };
  constexpr std::array kJoints = {
      Joint{0.34, 1.525, 0.87, 0.135, 0.085},
      Joint{0.42, 1.65, 0.86, 0.165, 0.070},
      Joint{0.51, 1.81, 0.84, 0.155, 0.055},
      Joint{0.59, 1.96, 0.81, 0.085, 0.040},
  };
  for (std::size_t i = 0; i < kJoints.size(); ++i) {
    const Joint& j = kJoints[i];
    // The patch's u runs towards the spine, so the ear's width is laid from outside to inside.
    Section section;
    section.centre = {j.x, j.y, j.z};
    section.across = j.half_width * glm::normalize(dvec3(-0.86, 0.46, 0.10));
    section.along = j.half_depth * dvec3(0.0, 0.0, 1.0);
    grow(mesh, tip, ear, section);
  }
  // The hollow: the walls that look forward.
  Patch hollow = side(mesh, ear, 4, 2, 0, 4);
  hollow = part(hollow, 0, 2, 1, 3);
  Tube rim = begin_tube(hollow);
  const dvec3 out = normal(mesh, hollow);
  extrude_by(mesh, hollow, rim, 0.0 * out, 0.72);
  extrude_by(mesh, hollow, rim, -0.05 * out, 0.8);
}

void grow_eye(Creature& creature) {
  HalfMesh& mesh = creature.mesh;
  Patch eye = part(creature.face, 1, 2, 3, 2);
  Tube rings = begin_tube(eye);
  const dvec3 out = normal(mesh, eye);
  const dvec3 across = glm::normalize(glm::cross(dvec3(0.0, 1.0, 0.0), out));
  const dvec3 along = glm::cross(out, across);
  const dvec3 middle = centre(mesh, eye);
  const auto ring = [&](double height, double radius, double dome) {
    Section section;
    section.centre = middle + height * out;
    section.across = radius * across;
    section.along = 1.12 * radius * along;
    section.dome = dome;
    grow(mesh, eye, rings, section);
  };
  ring(0.045, 0.130, 0.0);  // lid
  ring(0.045, 0.108, 0.0);  // its inner edge
  ring(0.000, 0.100, 0.0);  // socket
  ring(0.055, 0.090, 0.0);  // eyeball
  ring(0.100, 0.052, 0.015);
  ring(0.070, 0.042, 0.0);  // pupil
}

void grow_snout(Creature& creature) {
  HalfMesh& mesh = creature.mesh;
  Patch nose = part(creature.face, 0, 2, 0, 3);
  Tube snout = begin_tube(nose);
  Spacing spacing = even_spacing(nose);
  spacing.v = {-1.0, -0.52, -0.22, 1.0};
  Section section = section_of({0.935, 1.44, 0.245, 0.165, -4});
  grow(mesh, nose, snout, section, spacing);
  section = section_of({0.942, 1.545, 0.21, 0.160, -4});
  grow(mesh, nose, snout, section, spacing);
  section = section_of({0.937, 1.615, 0.13, 0.11, -4});
  section.dome = 0.03;
  grow(mesh, nose, snout, section, spacing);

  // A smile: the corners of the mouth go up.
  for (const std::size_t position : {3u, 4u}) {
    mesh.positions[snout.rings[1][position]].y += 0.06;
    mesh.positions[snout.rings[2][position]].y += 0.02;
  }

  // The mouth: the middle row of the front, and on along the sides.
  Patch mouth;
  mouth.columns = 4;
  mouth.rows = 1;
  mouth.mirror = MirrorSide::kFirstColumn;
  for (std::size_t row = 1; row <= 2; ++row) {
    for (std::size_t c = 0; c <= 2; ++c) {
      mouth.vertices.push_back(nose.vertex(c, row));
    }
    mouth.vertices.push_back(snout.rings[2][2 + row]);
    mouth.vertices.push_back(snout.rings[1][2 + row]);
  }
  mouth.faces = {nose.face(0, 1), nose.face(1, 1), snout.walls[2][3], snout.walls[1][3]};
  Tube lips = begin_tube(mouth);
  extrude(mesh, mouth, lips);
  // Inwards: the front goes back into the head, the corners towards the middle.
  for (std::size_t row = 0; row <= 1; ++row) {
    for (std::size_t c = 0; c <= mouth.columns; ++c) {
      dvec3& p = mesh.positions[mouth.vertex(c, row)];
      const dvec3 goal =
          c < mouth.columns ? dvec3(0.75 * p.x, 0.90, 1.35) : dvec3(0.55 * p.x, 0.92, p.z);
      p = glm::mix(p, goal, 0.3);
    }
  }

  Patch nostril = part(nose, 1, 1, 2, 1);
  Tube rim = begin_tube(nostril);
  const dvec3 out = normal(mesh, nostril);
  extrude_by(mesh, nostril, rim, 0.005 * out, 0.5);
  extrude_by(mesh, nostril, rim, -0.03 * out, 0.75);
}

void grow_plate(HalfMesh& mesh, Patch top, const dvec3& lean, double size) {
  Tube plate = begin_tube(top);
  dvec3 out = normal(mesh, top);
  out.x = 0.0;
  const dvec3 offset = size * (glm::normalize(out) + lean);
  extrude_by(mesh, top, plate, 0.5 * offset, 0.75);
  extrude_by(mesh, top, plate, 0.6 * offset, 0.45);
}

void grow_plates(Creature& creature) {
  for (const std::size_t ring : {1u, 3u, 5u}) {
    grow_plate(creature.mesh, side(creature.mesh, creature.trunk, kSpinePosition, 1, ring, 1),
               {0.0, 0.0, -0.4}, 0.15);
  }
}

}  // namespace

PolygonSoup creature() {
  Creature creature = grow_trunk_and_head();
  grow_leg(creature, 1, -0.46, 1.1);
  grow_leg(creature, 4, 0.22, 1.0);
  grow_tail(creature);
  grow_ear(creature);
  grow_eye(creature);
  grow_snout(creature);
  grow_plates(creature);
  PolygonSoup soup = mirrored(creature.mesh);
  dvec3 low(1e9);
  dvec3 high(-1e9);
  for (const dvec3& p : soup.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double scale = 2.0 / (high.z - low.z);
  for (dvec3& p : soup.positions) {
    p = scale * (p - dvec3(0.0, 0.5 * (low.y + high.y), 0.5 * (low.z + high.z)));
  }
  return soup;
}

}  // namespace limn::generator

// Blocks of faces are cut at the same time and put one after the other.
#include "comparison/cut_surface.h"

#include <algorithm>
#include <span>
#include <vector>

#include "mesh/ear_clipper.h"
#include "subdivision/sweep.h"

namespace limn {
namespace {

constexpr std::size_t kBlock = 1024;

template <class Scalar>
using Points = std::span<const glm::vec<3, Scalar>>;

/// What some faces become. Corners from the number of the mesh's vertices on are centroids of the
/// block.
struct CutBlock {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> faces;
  std::vector<glm::dvec3> centroids;
  std::size_t first_triangle = 0;
  std::size_t first_centroid = 0;
};

void cut_from_centroid(std::span<const std::uint32_t> face, std::span<const glm::dvec3> corners,
                       std::size_t vertices, CutBlock& block) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& corner : corners) {
    sum += corner;
  }
  const auto centre = static_cast<std::uint32_t>(vertices + block.centroids.size());
  block.centroids.push_back(sum / static_cast<double>(corners.size()));
  for (std::size_t i = 0; i < face.size(); ++i) {
    block.triangles.push_back({face[i], face[(i + 1) % face.size()], centre});
  }
}

template <class Mesh, class Scalar>
void cut_block(const Mesh& mesh, Points<Scalar> points, std::size_t begin, std::size_t end,
               CutBlock& block) {
  EarClipper clipper;
  std::vector<glm::dvec3> corners;
  for (std::size_t f = begin; f < end; ++f) {
    const std::span<const std::uint32_t> face = mesh.face(f);
    corners.clear();
    for (const std::uint32_t v : face) {
      corners.emplace_back(points[v]);
    }
    if (const auto* triangles = clipper.clip(corners); triangles != nullptr) {
      for (const EarClipper::Triangle& t : *triangles) {
        block.triangles.push_back({face[t[0]], face[t[1]], face[t[2]]});
      }
    } else {
      cut_from_centroid(face, corners, points.size(), block);
    }
    block.faces.resize(block.triangles.size(), static_cast<std::uint32_t>(f));
  }
}

template <class Mesh, class Scalar>
CutSurface<Scalar> cut(const Mesh& mesh, Points<Scalar> points, Sweep& sweep) {
  const std::size_t faces = mesh.face_count();
  std::vector<CutBlock> blocks((faces + kBlock - 1) / kBlock);
  sweep.ranges(blocks.size(), 64, 1, kBlock, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      cut_block(mesh, points, b * kBlock, std::min(faces, (b + 1) * kBlock), blocks[b]);
    }
  });
  if (sweep.is_cancelled()) {
    return {};
  }
  std::size_t triangles = 0;
  std::size_t centroids = 0;
  for (CutBlock& block : blocks) {
    block.first_triangle = triangles;
    block.first_centroid = centroids;
    triangles += block.triangles.size();
    centroids += block.centroids.size();
  }
  CutSurface<Scalar> result;
  result.points.resize(points.size() + centroids);
  std::ranges::copy(points, result.points.begin());
  result.triangles.resize(triangles);
  result.faces.resize(triangles);
  sweep.ranges(blocks.size(), 256, 1, kBlock / 4, [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b) {
      const CutBlock& block = blocks[b];
      for (std::size_t i = 0; i < block.centroids.size(); ++i) {
        result.points[points.size() + block.first_centroid + i] =
            glm::vec<3, Scalar>(block.centroids[i]);
      }
      for (std::size_t i = 0; i < block.triangles.size(); ++i) {
        std::array<std::uint32_t, 3> triangle = block.triangles[i];
        for (std::uint32_t& corner : triangle) {
          corner += corner < points.size() ? 0 : static_cast<std::uint32_t>(block.first_centroid);
        }
        result.triangles[block.first_triangle + i] = triangle;
        result.faces[block.first_triangle + i] = block.faces[i];
      }
    }
  });
  if (sweep.is_cancelled()) {
    return {};
  }
  return result;
}

}  // namespace

CutSurface<double> cut_surface(const ControlMesh& mesh, Sweep& sweep) {
  return cut<ControlMesh, double>(mesh, mesh.positions(), sweep);
}

CutSurface<float> cut_surface(const RefinedMesh& mesh, Sweep& sweep) {
  return cut<RefinedMesh, float>(mesh, mesh.positions, sweep);
}

}  // namespace limn

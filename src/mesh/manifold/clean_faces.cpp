// Duplicates are found by a hash of each face read from its lowest vertex on; faces of equal hashes
// are compared.
#include "mesh/manifold/clean_faces.h"

#include <algorithm>
#include <span>
#include <utility>

#include "limn/mesh/flat_topology.h"

namespace limn::detail {
namespace {

using Corners = std::span<const std::uint32_t>;

/// The vertices from the lowest on, one after the other.
template <class Visit>
void visit_from_lowest(Corners face, const Visit& visit) {
  const auto lowest = std::ranges::min_element(face);
  std::for_each(lowest, face.end(), visit);
  std::for_each(face.begin(), lowest, visit);
}

std::uint64_t hash_of(Corners face) {
  std::uint64_t hash = face.size();
  visit_from_lowest(face, [&](std::uint32_t v) {
    hash = (hash ^ v) * 0x9E3779B97F4A7C15ULL;  // An odd number near 2^64 over the golden ratio.
    hash ^= hash >> 29U;
  });
  return hash;
}

bool are_equal(Corners a, Corners b) {
  if (a.size() != b.size()) {
    return false;
  }
  const auto i = static_cast<std::size_t>(std::ranges::min_element(a) - a.begin());
  const auto j = static_cast<std::size_t>(std::ranges::min_element(b) - b.begin());
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[(i + k) % a.size()] != b[(j + k) % b.size()]) {
      return false;
    }
  }
  return true;
}

/// Marks every face that equals one before it.
std::vector<std::uint8_t> duplicates(const FaceArrays& faces) {
  struct Hashed {
    std::uint64_t hash;
    std::uint32_t face;
    auto operator<=>(const Hashed&) const = default;
  };
  const auto face = [&](std::uint32_t f) {
    return faces.vertices.subspan(faces.offsets[f], faces.offsets[f + 1] - faces.offsets[f]);
  };
  std::vector<Hashed> hashed(faces.face_count());
  for (std::uint32_t f = 0; f < hashed.size(); ++f) {
    hashed[f] = {hash_of(face(f)), f};
  }
  std::ranges::sort(hashed);
  std::vector<std::uint8_t> is_duplicate(faces.face_count(), 0);
  for (std::size_t i = 1; i < hashed.size(); ++i) {
    // Of equal hashes the faces rise, so a duplicate stands right after one of its kind, unless two
    // kinds share a hash; then those after the mixture stay, and are detached later.
    is_duplicate[hashed[i].face] = hashed[i].hash == hashed[i - 1].hash &&
                                   are_equal(face(hashed[i].face), face(hashed[i - 1].face));
  }
  return is_duplicate;
}

}  // namespace

CleanFaces clean_faces(const PolygonSoup& soup, MendLog& log) {
  CleanFaces clean;
  WorkingFaces& faces = clean.faces;
  faces.vertex_count = soup.positions.size();
  faces.offsets.reserve(soup.face_offsets.size());
  faces.vertices.reserve(soup.face_vertices.size());
  faces.uvs.reserve(soup.face_uvs.size());
  faces.sources.reserve(soup.face_count());
  std::vector<std::uint32_t> last_seen_in(faces.vertex_count, kNone);
  const bool has_uvs = !soup.face_uvs.empty();

  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    const std::size_t begin = faces.vertices.size();
    for (std::uint32_t c = soup.face_offsets[f]; c < soup.face_offsets[f + 1]; ++c) {
      const std::uint32_t v = soup.face_vertices[c];
      if (faces.vertices.size() == begin || faces.vertices.back() != v) {
        faces.vertices.push_back(v);
        if (has_uvs) {
          faces.uvs.push_back(soup.face_uvs[c]);
        }
      }
    }
    if (faces.vertices.size() > begin + 1 && faces.vertices.back() == faces.vertices[begin]) {
      faces.vertices.pop_back();
      if (has_uvs) {
        faces.uvs.pop_back();
      }
    }
    std::size_t distinct = 0;
    for (std::size_t c = begin; c < faces.vertices.size(); ++c) {
      distinct += std::exchange(last_seen_in[faces.vertices[c]], f) != f ? 1 : 0;
    }
    if (distinct < 3) {
      log.add_face(MendKind::kDegenerateFace, f);
      faces.vertices.resize(begin);
      if (has_uvs) {
        faces.uvs.resize(begin);
      }
      continue;
    }
    if (distinct < faces.vertices.size() - begin) {
      clean.pinched.push_back(static_cast<std::uint32_t>(faces.sources.size()));
    }
    const std::size_t corners = faces.vertices.size() - begin;
    for (std::size_t i = corners; i < soup.face(f).size(); ++i) {
      log.add_face(MendKind::kRepeatedCorner, f);
    }
    faces.offsets.push_back(static_cast<std::uint32_t>(faces.vertices.size()));
    faces.sources.push_back(f);
  }
  return clean;
}

bool drop_duplicates(CleanFaces& clean, MendLog& log) {
  const std::vector<std::uint8_t> is_duplicate = duplicates(clean.faces.arrays());
  if (!std::ranges::any_of(is_duplicate, [](std::uint8_t is) { return is != 0; })) {
    return false;
  }
  WorkingFaces& old = clean.faces;
  WorkingFaces kept;
  kept.vertex_count = old.vertex_count;
  std::vector<std::uint32_t> new_numbers(is_duplicate.size(), kNone);
  for (std::size_t f = 0; f < is_duplicate.size(); ++f) {
    if (is_duplicate[f] != 0) {
      log.add_face(MendKind::kDuplicateFace, old.sources[f]);
      continue;
    }
    new_numbers[f] = static_cast<std::uint32_t>(kept.sources.size());
    const auto begin = old.offsets[f];
    const auto end = old.offsets[f + 1];
    kept.vertices.insert(kept.vertices.end(), old.vertices.begin() + begin,
                         old.vertices.begin() + end);
    if (!old.uvs.empty()) {
      kept.uvs.insert(kept.uvs.end(), old.uvs.begin() + begin, old.uvs.begin() + end);
    }
    kept.offsets.push_back(static_cast<std::uint32_t>(kept.vertices.size()));
    kept.sources.push_back(old.sources[f]);
  }
  old = std::move(kept);
  std::erase_if(clean.pinched, [&](std::uint32_t f) { return new_numbers[f] == kNone; });
  for (std::uint32_t& f : clean.pinched) {
    f = new_numbers[f];
  }
  return true;
}

}  // namespace limn::detail

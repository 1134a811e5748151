// Faces come one after the other, and every vertex gathers its corners: a corner knows the vertex
// after it in its face and the one before.
//
//          before                     With four faces around v and the same four vertices after
//            |                        and before it, the star is closed: v is met on each of its
//            |  face                  edges once in each direction.
//            v------- next
//
// The faces come in runs, short enough that all about their vertices stays in the cache: neighbours
// in a refined mesh have numbers near each other, so most stars of a run are closed within it. Only
// the rim of what it covers stays open. For the mesh a star is closed if no other run has faces at
// its vertex. So all runs mark what they saw, and in the end a vertex counts that was closed and at
// no time open. A star that was closed twice leaves one mark; the number of marks gives it away,
// and then none counts.
#include "subdivision/closed_stars.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstring>

#include "limn/contract.h"
#include "limn/mesh/flat_topology.h"
#include "subdivision/lanes.h"

namespace limn {
namespace {

/// A run ends with the face that takes it to so many vertices; its table stays in a core's cache.
constexpr std::size_t kRunVertices = 8128;
/// Faces with more sides than that are not looked at.
constexpr std::size_t kMostSides = 64;

/// What there is to know about four places: their vertices, how many corners these have, the first
/// four corners, and room for some that are too many.
enum : std::size_t { kVertexRow, kCountRow, kCornerRow, kRows = kCornerRow + 6 };

constexpr std::uint32_t kPlaceBits = 16;
constexpr std::uint32_t kPlaceMask = 0xFFFF;
constexpr std::size_t kMostPlaces = std::bit_ceil(4 * (kRunVertices + kMostSides));
static_assert(kMostPlaces <= kPlaceMask);

/// Vertices whose marks one thread handles at a time.
constexpr std::size_t kMarkGrain = std::size_t{1} << 18;

void set_mark(std::uint8_t& mark) noexcept {
  std::atomic_ref(mark).store(1, std::memory_order_relaxed);
}

/// An entry of four places; as the result of a comparison, all bits are set where it is true.
using PlaceRow [[gnu::vector_size(16)]] = std::uint32_t;

PlaceRow load_row(const std::uint32_t* from) noexcept {
  PlaceRow four;
  std::memcpy(&four, from, sizeof(four));
  return four;
}

void store_row(const PlaceRow& four, std::uint32_t* to) noexcept {
  std::memcpy(to, &four, sizeof(four));
}

bool holds_for_all(const PlaceRow& truth) noexcept {
  using Two [[gnu::vector_size(16)]] = std::uint64_t;
  const Two halves = Two(truth);
  return (halves[0] & halves[1]) == ~std::uint64_t{0};
}

/// Which of the stars at four places from `number` on are closed.
PlaceRow closed_stars(std::uint32_t number, const PlaceRow& counts,
                      const std::array<PlaceRow, 4>& corners) noexcept {
  // Where there is no corner the places after and before are the same, and nobody else's. So a star
  // of three needs no treatment of its own.
  std::array<PlaceRow, 4> next;
  std::array<PlaceRow, 4> before;
  for (std::size_t i = 0; i < 4; ++i) {
    next[i] = corners[i] & kPlaceMask;
    before[i] = corners[i] >> kPlaceBits;
  }
  // If four different vertices come next, and each is one of the four that come before, these are
  // different too. An edge from the vertex to itself would be its own partner.
  const PlaceRow self = PlaceRow{0, 1, 2, 3} + number;
  PlaceRow is_wrong = counts > 4;
  for (std::size_t i = 0; i < 4; ++i) {
    is_wrong |= next[i] == self;
    for (std::size_t j = 0; j < i; ++j) {
      is_wrong |= next[i] == next[j];
    }
    is_wrong |= ~((next[i] == before[0]) | (next[i] == before[1]) | (next[i] == before[2]) |
                  (next[i] == before[3]));
  }
  return ~is_wrong;
}

constexpr std::uint32_t corner_between(std::uint32_t before, std::uint32_t next) noexcept {
  return next | before << kPlaceBits;
}

/// `entry` is the vertex's.
void add_corner(std::uint32_t* entry, std::uint32_t corner) noexcept {
  const std::uint32_t count = entry[4 * kCountRow]++;
  entry[4 * (kCornerRow + count % 4)] = corner;
}

void add_corners(std::uint32_t* entry, std::uint32_t first, std::uint32_t second) noexcept {
  const std::uint32_t count = entry[4 * kCountRow];
  entry[4 * kCountRow] = count + 2;
  std::uint32_t* const corners = entry + 4 * (kCornerRow + count % 4);
  corners[0] = first;
  corners[4] = second;
}

}  // namespace

/// A place's number, of 16 bits, and where its vertex stands in the table.
struct StarTable::Taken {
  std::uint32_t number;
  std::uint32_t* entry;
};

void StarTable::prepare(std::size_t vertices, std::uint32_t early_vertices) {
  const std::size_t in_run = std::min(vertices, kRunVertices + kMostSides);
  const std::size_t places = std::max<std::size_t>(std::bit_ceil(4 * in_run), 8);
  if (memory_.size() != places * kRows) {
    memory_.resize(places * kRows);
    std::ranges::fill(memory_, kNone);
    for (std::size_t i = 4 * kCountRow; i < memory_.size(); i += 4 * kRows) {
      std::fill_n(memory_.begin() + static_cast<std::ptrdiff_t>(i), 4, 0U);
    }
  }
  places_ = {memory_.data(), static_cast<std::uint32_t>(places / 2), early_vertices};
  used_ = 0;
}

std::size_t StarTable::mark(const RefinedMesh& mesh, std::size_t first_face, std::size_t last_face,
                            const StarMarks& marks) {
  std::size_t closed = 0;
  const std::size_t quads = mesh.quads.size();
  const Quad* quad = mesh.quads.data() + std::min(first_face, quads);
  const Quad* const last_quad = mesh.quads.data() + std::min(last_face, quads);
  while (quad != last_quad) {
    quad = add_quads(quad, last_quad);
    closed += finish_run(marks);
  }
  for (std::size_t f = std::max(first_face, quads); f < last_face; ++f) {
    add_polygon(mesh.face(f), marks);
    if (used_ >= kRunVertices) {
      closed += finish_run(marks);
    }
  }
  return closed + finish_run(marks);
}

/// Vertices near each other in number are at home near each other, without a gap.
inline std::uint32_t StarTable::Places::home_of(std::uint32_t vertex) const noexcept {
  return (vertex & (half - 1)) | (vertex < early_vertices ? half : 0);
}

inline std::uint32_t* StarTable::Places::entry(std::uint32_t place) const noexcept {
  return table + std::size_t{kRows} * (place & ~3U) + (place & 3U);
}

/// The place where a vertex is, or is from now on.
inline StarTable::Taken StarTable::place_of(std::uint32_t vertex, const Places& places,
                                            std::uint32_t& used) {
  Taken place{places.home_of(vertex), nullptr};
  place.entry = places.entry(place.number);
  if ((*place.entry != vertex) & (*place.entry != kNone)) {
    place.number = distant_place_of(vertex, places);
    place.entry = places.entry(place.number);
  }
  // Whether it is new cannot be foretold: nothing to branch on.
  used += *place.entry == kNone ? 1 : 0;
  *place.entry = vertex;
  return place;
}

std::uint32_t StarTable::distant_place_of(std::uint32_t vertex, const Places& places) {
  // First the same place in the other half; from there by steps of the vertex's own, since the next
  // place of all would have to be looked for behind a whole stretch of neighbours.
  const std::uint32_t step = (vertex * 0x9E3779B1u >> 15) | 1;
  std::uint32_t place = places.home_of(vertex) ^ places.half;
  for (;;) {
    const std::uint32_t there = *places.entry(place);
    if (there == vertex || there == kNone) {
      return place;
    }
    place = (place + step) & (2 * places.half - 1);
  }
}

/// Adds quads until the run is full or all are added; returns the next one.
///
///   d ----- c ----- .     Most quads go on where the one before ends. So corners b and c wait for
///   |       |       |     the next quad, and are often added together with its a and d.
///   a ----- b ----- .
const StarTable::Quad* StarTable::add_quads(const Quad* quad, const Quad* end) {
  const Places places = places_;
  std::uint32_t used = used_;
  while (quad != end && used < kRunVertices) {
    Taken a = place_of((*quad)[0], places, used);
    Taken b = place_of((*quad)[1], places, used);
    Taken c = place_of((*quad)[2], places, used);
    Taken d = place_of((*quad)[3], places, used);
    add_corner(a.entry, corner_between(d.number, b.number));
    add_corner(d.entry, corner_between(c.number, a.number));
    const Quad* next = quad + 1;
    for (; next != end && used < kRunVertices &&
           (((*next)[0] ^ (*quad)[1]) | ((*next)[3] ^ (*quad)[2])) == 0;
         ++next) {
      quad = next;
      const Taken next_b = place_of((*quad)[1], places, used);
      const Taken next_c = place_of((*quad)[2], places, used);
      add_corners(b.entry, corner_between(a.number, c.number),
                  corner_between(c.number, next_b.number));
      add_corners(c.entry, corner_between(b.number, d.number),
                  corner_between(next_c.number, b.number));
      a = b;
      d = c;
      b = next_b;
      c = next_c;
    }
    add_corner(b.entry, corner_between(a.number, c.number));
    add_corner(c.entry, corner_between(b.number, d.number));
    quad = next;
  }
  used_ = used;
  return quad;
}

void StarTable::add_polygon(std::span<const std::uint32_t> polygon, const StarMarks& marks) {
  const std::size_t n = polygon.size();
  if (n > kMostSides) {
    for (const std::uint32_t v : polygon) {
      LIMN_EXPECTS(v < marks.vertex_count);
      set_mark(marks.marks[v].is_open);
    }
    return;
  }
  std::array<Taken, kMostSides> places;
  for (std::size_t i = 0; i < n; ++i) {
    places[i] = place_of(polygon[i], places_, used_);
  }
  for (std::size_t i = 0; i < n; ++i) {
    add_corner(places[i].entry, corner_between(places[i == 0 ? n - 1 : i - 1].number,
                                               places[i + 1 == n ? 0 : i + 1].number));
  }
}

/// Marks the run's vertices, four places at a time, and empties the table.
std::size_t StarTable::finish_run(const StarMarks& marks) {
  // No vertex has the entry after the last.
  const auto nobody = static_cast<std::uint32_t>(marks.vertex_count);
  PlaceRow closed{};
  PlaceRow unknown{};
  for (std::uint32_t number = 0; number < 2 * places_.half; number += 4) {
    std::uint32_t* const block = places_.entry(number);
    const PlaceRow vertices = load_row(block + 4 * kVertexRow);
    if (holds_for_all(vertices == kNone)) {
      continue;
    }
    std::array<PlaceRow, 4> corners;
    for (std::uint32_t i = 0; i < 4; ++i) {
      corners[i] = load_row(block + 4 * (kCornerRow + i));
      store_row(PlaceRow{} - 1, block + 4 * (kCornerRow + i));
    }
    const PlaceRow is_closed = closed_stars(number, load_row(block + 4 * kCountRow), corners);
    store_row(PlaceRow{} - 1, block + 4 * kVertexRow);
    store_row(PlaceRow{}, block + 4 * kCountRow);
    for (std::size_t i = 0; i < 4; ++i) {
      StarMark& mark = marks.marks[vertices[i] < nobody ? vertices[i] : nobody];
      set_mark(is_closed[i] != 0 ? mark.is_closed : mark.is_open);
    }
    unknown |= (vertices >= nobody) & (vertices != kNone);
    closed -= is_closed;
  }
  LIMN_EXPECTS(holds_for_all(unknown == 0));
  used_ = 0;
  return closed[0] + closed[1] + closed[2] + closed[3];
}

void ClosedStars::find(const RefinedMesh& mesh, std::size_t early_vertices) {
  const std::size_t vertices = mesh.vertex_count();
  marks_.resize(vertices + 1);
  parallel_ranges(0, vertices, kMarkGrain, [&](std::size_t first, std::size_t last) {
    std::fill(marks_.data() + first, marks_.data() + last, StarMark{});
  });
  const Lanes lanes(mesh.face_count());
  lanes_.resize(std::max(lanes_.size(), lanes.count()));
  const StarMarks marks{marks_.data(), vertices};
  lanes.each([&](std::size_t i) {
    const std::size_t first = lanes.begin(i);
    const std::size_t last = lanes.end(i);
    lanes_[i].table.prepare(vertices, static_cast<std::uint32_t>(early_vertices));
    lanes_[i].closed = lanes_[i].table.mark(mesh, first, last, marks);
  });
  std::size_t stars = 0;
  for (std::size_t i = 0; i < lanes.count(); ++i) {
    stars += lanes_[i].closed;
  }
  combine(stars);
}

/// Leaves settled vertices alone marked as closed. So many stars were closed.
void ClosedStars::combine(std::size_t stars) {
  const std::size_t vertices = marks_.size() - 1;
  std::atomic<std::size_t> closed = 0;
  std::atomic<std::size_t> used = 0;
  parallel_ranges(0, vertices, kMarkGrain, [&](std::size_t first, std::size_t last) {
    std::size_t closed_here = 0;
    std::size_t used_here = 0;
    for (std::size_t v = first; v < last; ++v) {
      StarMark& mark = marks_[v];
      closed_here += mark.is_closed;
      used_here += mark.is_closed | mark.is_open;
      mark.is_closed = static_cast<std::uint8_t>(mark.is_closed & ~mark.is_open);
    }
    closed.fetch_add(closed_here, std::memory_order_relaxed);
    used.fetch_add(used_here, std::memory_order_relaxed);
  });
  unused_ = vertices - used;
  if (closed != stars) {
    std::ranges::fill(marks_, StarMark{});
  }
}

}  // namespace limn

// The kernel of the errors of bicubics, in single precision: some bicubics at a time. Each is moved
// to the origin and brought to a size of 1 first, so that squares neither overflow nor vanish.
#include "subdivision/bicubic_errors.h"
#include "subdivision/kernel_lanes.inl"

namespace limn {
namespace {

template <class Lanes>
inline Vectors<Lanes> scaled(const Vectors<Lanes>& v, const Lanes& by) {
  return {v.x * by, v.y * by, v.z * by};
}
template <class Lanes>
inline Lanes product_of(const Vectors<Lanes>& a, const Vectors<Lanes>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Lanes>
inline Vectors<Lanes> cross_of(const Vectors<Lanes>& a, const Vectors<Lanes>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Lanes>
inline Lanes size_of(const Lanes& x) {
  return greater(x, -x);
}

/// The control points of bicubics `first` and so on.
template <class Lanes>
struct ControlPoints {
  Vectors<Lanes> points[16];
  Lanes unit;  ///< The size they had; 0 where that is nothing.
};

inline void load_four(const BicubicBatch& batch, std::size_t first, std::size_t i,
                      Vectors<Four>& out) {
  const auto local = [&](std::size_t lane) {
    const StoredPoint(&points)[16] = batch.points[first + lane];
    return __builtin_convertvector(points[i] - points[5], Four);
  };
  transpose(local(0), local(1), local(2), local(3), out.x, out.y, out.z);
}

inline void load_lanes(const BicubicBatch& batch, std::size_t first, std::size_t i,
                       Vectors<Four>& out) {
  load_four(batch, first, i, out);
}
inline void load_lanes(const BicubicBatch& batch, std::size_t first, std::size_t i,
                       Vectors<Eight>& out) {
  Vectors<Four> low;
  Vectors<Four> high;
  load_four(batch, first, i, low);
  load_four(batch, first + 4, i, high);
  out = {joined(low.x, high.x), joined(low.y, high.y), joined(low.z, high.z)};
}

template <class Lanes>
inline void load_control_points(const BicubicBatch& batch, std::size_t first,
                                ControlPoints<Lanes>& out) {
  constexpr float kLeastUnit = 1e-37f;
  Lanes unit{};
  for (std::size_t i = 0; i < 16; ++i) {
    Vectors<Lanes>& point = out.points[i];
    load_lanes(batch, first, i, point);
    unit = greater(unit, greater(size_of(point.x), greater(size_of(point.y), size_of(point.z))));
  }
  const auto is_some = unit > kLeastUnit;
  const Lanes by = is_some ? 1.0f / (is_some ? unit : Lanes{} + 1.0f) : Lanes{};
  for (Vectors<Lanes>& point : out.points) {
    point = scaled(point, by);
  }
  out.unit = is_some ? unit : Lanes{};
}

/// The cubic B-spline of four control points at the start, in the middle and at the end of its
/// middle segment.
template <class Lanes>
struct Spline {
  const Lanes& a;
  const Lanes& b;
  const Lanes& c;
  const Lanes& d;

  template <std::size_t kPlace>
  [[nodiscard]] Lanes value() const {
    if constexpr (kPlace == 0) {
      return (a + b * 4.0f + c) * (1.0f / 6.0f);
    } else if constexpr (kPlace == 1) {
      return ((b + c) * 23.0f + a + d) * (1.0f / 48.0f);
    } else {
      return (b + c * 4.0f + d) * (1.0f / 6.0f);
    }
  }
  template <std::size_t kPlace>
  [[nodiscard]] Lanes first() const {
    if constexpr (kPlace == 0) {
      return (c - a) * 0.5f;
    } else if constexpr (kPlace == 1) {
      return ((c - b) * 5.0f + d - a) * 0.125f;
    } else {
      return (d - b) * 0.5f;
    }
  }
  template <std::size_t kPlace>
  [[nodiscard]] Lanes second() const {
    if constexpr (kPlace == 0) {
      return a - b * 2.0f + c;
    } else if constexpr (kPlace == 1) {
      return (a - b - c + d) * 0.5f;
    } else {
      return b - c * 2.0f + d;
    }
  }
};

/// `of` the spline through four points, coordinate by coordinate.
template <class Lanes, class Of>
inline Vectors<Lanes> along(const Vectors<Lanes>* p, const Of& of) {
  return {of(Spline<Lanes>{p[0].x, p[1].x, p[2].x, p[3].x}),
          of(Spline<Lanes>{p[0].y, p[1].y, p[2].y, p[3].y}),
          of(Spline<Lanes>{p[0].z, p[1].z, p[2].z, p[3].z})};
}

/// What splines are asked for at a place.
template <std::size_t kPlace>
struct At {
  static constexpr auto value = [](const auto& spline) { return spline.template value<kPlace>(); };
  static constexpr auto first = [](const auto& spline) { return spline.template first<kPlace>(); };
  static constexpr auto second = [](const auto& spline) {
    return spline.template second<kPlace>();
  };
};

/// Derivatives at one place along rows, of all four rows.
template <class Lanes>
struct ColumnDerivatives {
  Vectors<Lanes> values[4];
  Vectors<Lanes> firsts[4];
  Vectors<Lanes> seconds[4];
};

template <std::size_t kPlace, class Lanes>
inline void differentiate_rows(const ControlPoints<Lanes>& control, ColumnDerivatives<Lanes>& out) {
  for (std::size_t row = 0; row < 4; ++row) {
    const Vectors<Lanes>* points = control.points + 4 * row;
    out.values[row] = along(points, At<kPlace>::value);
    out.firsts[row] = along(points, At<kPlace>::first);
    out.seconds[row] = along(points, At<kPlace>::second);
  }
}

/// Derivatives at a place, u along rows and v along columns.
template <class Lanes>
struct Derivatives {
  Vectors<Lanes> u;
  Vectors<Lanes> v;
  Vectors<Lanes> uu;
  Vectors<Lanes> uv;
  Vectors<Lanes> vv;
};

template <std::size_t kPlace, class Lanes>
inline Derivatives<Lanes> differentiate_column(const ColumnDerivatives<Lanes>& column) {
  return {along(column.firsts, At<kPlace>::value), along(column.values, At<kPlace>::first),
          along(column.seconds, At<kPlace>::value), along(column.firsts, At<kPlace>::first),
          along(column.values, At<kPlace>::second)};
}

/// The greatest error of the plane through three points of a quadratic, between directions x and y
/// and their sum: eighths of what the quadratic bends along the sides or, where the triangle is
/// acute as the quadratic measures it, half the square of its circumradius.
template <class Lanes>
inline Lanes triangle_error(const Lanes& along_x, const Lanes& along_y, const Lanes& along_sum) {
  const Lanes a = size_of(along_x);
  const Lanes c = size_of(along_y);
  const Lanes s = size_of(along_sum);
  const Lanes longest = greater(a, greater(c, s));
  const Lanes mixed = (along_sum - along_x - along_y) * 0.5f;
  const Lanes determinant = along_x * along_y - mixed * mixed;
  const auto is_acute = (along_x * along_y > 0.0f) & (along_x * along_sum > 0.0f) &
                        (determinant > 0.0f) & (2.0f * longest < a + c + s);
  const Lanes by_radius = a * c * s / (8.0f * (is_acute ? determinant : Lanes{} + 1.0f));
  return is_acute ? by_radius : longest * 0.125f;
}

/// The greatest error of the two triangles that a unit quad is cut into, with second derivatives a,
/// c and the mixed one, b; `up` is the product of its first derivatives, `size` the sum of their
/// squares.
template <bool kAtLevel, class Lanes>
inline Lanes quad_error(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& up,
                        const Lanes& size) {
  constexpr float kAboutEqual = 0.1f;  // Then either diagonal may be the shorter one.
  const auto is_either = size_of(up) < kAboutEqual * size;
  const auto takes_up = is_either | (up < 0.0f);
  const auto takes_down = is_either | (up >= 0.0f);
  if constexpr (kAtLevel) {
    // Corners stand off the limit by a sixth of what the surface bends both ways; chords come back
    // from there, or go further where it bends the other way.
    const Lanes corner = (a + c) * (1.0f / 6.0f);
    const Lanes along_up = size_of(corner - (a + c + 2.0f * b) * 0.125f);
    const Lanes along_down = size_of(corner - (a + c - 2.0f * b) * 0.125f);
    const Lanes sides = greater(size_of(corner - a * 0.125f), size_of(corner - c * 0.125f));
    return greater(greater(size_of(corner), sides),
                   greater(takes_up ? along_up : Lanes{}, takes_down ? along_down : Lanes{}));
  } else {
    const Lanes along_up = triangle_error<Lanes>(a, c, a + c + 2.0f * b);
    const Lanes along_down = triangle_error<Lanes>(a, c, a + c - 2.0f * b);
    return greater(takes_up ? along_up : Lanes{}, takes_down ? along_down : Lanes{});
  }
}

/// What is left of a vector without its part along a normal.
template <class Lanes>
inline Lanes length_beside(const Vectors<Lanes>& v, const Lanes& along) {
  return root(greater(Lanes{}, square_of(v) - along * along));
}

/// The greatest error of chords along a curve with these derivatives: of what is at right angles to
/// it.
template <bool kAtLevel, class Lanes>
inline Lanes curve_error(const Vectors<Lanes>& first, const Vectors<Lanes>& second) {
  const Lanes square = square_of(first);
  const auto is_some = square > 0.0f;
  const Lanes part = product_of(first, second) / (is_some ? square : Lanes{} + 1.0f);
  const Vectors<Lanes> along = scaled(first, is_some ? part : Lanes{});
  const Vectors<Lanes> across{second.x - along.x, second.y - along.y, second.z - along.z};
  return root(square_of(across)) * (1.0f / (kAtLevel ? 6.0f : 8.0f));
}

template <std::size_t kCount, bool kAtLevel>
struct ErrorLanes {
  using Lanes = typename LanesOf<kCount>::Floats;
  using Ints = typename LanesOf<kCount>::Ints;

  explicit ErrorLanes(const std::uint8_t* curves) {
    for (std::size_t side = 0; side < 4; ++side) {
      for (std::size_t lane = 0; lane < kCount; ++lane) {
        are_curves[side][lane] = (curves[lane] >> side & 1) != 0 ? -1 : 0;
        has_curves |= are_curves[side][lane] != 0;
      }
    }
  }

  template <std::size_t kColumn, std::size_t kRow>
  void add(const Derivatives<Lanes>& d) {
    const Vectors<Lanes> cross = cross_of(d.u, d.v);
    const Lanes square = square_of(cross);
    const auto is_some = square > 0.0f;
    const Lanes by = 1.0f / root(is_some ? square : Lanes{} + 1.0f);
    const Vectors<Lanes> normal = scaled(cross, by);
    normals[3 * kRow + kColumn] = normal;
    const Lanes a = product_of(d.uu, normal);
    const Lanes b = product_of(d.uv, normal);
    const Lanes c = product_of(d.vv, normal);
    outwards = greater(outwards, quad_error<kAtLevel, Lanes>(a, b, c, product_of(d.u, d.v),
                                                             square_of(d.u) + square_of(d.v)));
    within = greater(within, (length_beside(d.uu, a) + length_beside(d.vv, c)) * (1.0f / 6.0f) +
                                 length_beside(d.uv, b) * 0.25f);
    if (has_curves) {
      if constexpr (kRow != 1) {
        add_curve(kRow, curve_error<kAtLevel, Lanes>(d.u, d.uu));
      }
      if constexpr (kColumn != 1) {
        add_curve(kColumn == 0 ? 3 : 1, curve_error<kAtLevel, Lanes>(d.v, d.vv));
      }
    }
  }

  void store_to(const Lanes& unit, std::size_t first, BicubicErrors& errors) const {
    const Vectors<Lanes>& middle = normals[4];
    Lanes sine{};  // Squared; of a small angle it is more exact than the cosine.
    Lanes cosine = Lanes{} + 1.0f;
    for (const Vectors<Lanes>& normal : normals) {
      sine = greater(sine, square_of(cross_of(normal, middle)));
      cosine = lesser(cosine, product_of(normal, middle));
    }
    const Lanes one = Lanes{} + 1.0f;
    store(cosine > 0.0f ? lesser(one, root(sine)) : one, errors.turn + first);
    store(outwards * unit, errors.outwards + first);
    store(within * unit, errors.within + first);
  }

 private:
  void add_curve(std::size_t side, const Lanes& error) {
    outwards = greater(outwards, are_curves[side] ? error : Lanes{});
  }

  Ints are_curves[4]{};
  bool has_curves = false;
  Vectors<Lanes> normals[9];
  Lanes outwards{};
  Lanes within{};
};

template <std::size_t kCount, bool kAtLevel>
void errors_of(const BicubicBatch& batch, std::size_t first, BicubicErrors& errors) {
  using Lanes = typename LanesOf<kCount>::Floats;
  ControlPoints<Lanes> control;
  load_control_points(batch, first, control);
  ErrorLanes<kCount, kAtLevel> sums(batch.curves + first);
  ColumnDerivatives<Lanes> column;
  differentiate_rows<0>(control, column);
  sums.template add<0, 0>(differentiate_column<0>(column));
  sums.template add<0, 1>(differentiate_column<1>(column));
  sums.template add<0, 2>(differentiate_column<2>(column));
  differentiate_rows<1>(control, column);
  sums.template add<1, 0>(differentiate_column<0>(column));
  sums.template add<1, 1>(differentiate_column<1>(column));
  sums.template add<1, 2>(differentiate_column<2>(column));
  differentiate_rows<2>(control, column);
  sums.template add<2, 0>(differentiate_column<0>(column));
  sums.template add<2, 1>(differentiate_column<1>(column));
  sums.template add<2, 2>(differentiate_column<2>(column));
  sums.store_to(control.unit, first, errors);
}

template <bool kAtLevel>
void bicubic_errors_of(const BicubicBatch& batch, BicubicErrors& errors) {
#ifdef __AVX__
  errors_of<8, kAtLevel>(batch, 0, errors);
#else
  errors_of<4, kAtLevel>(batch, 0, errors);
  errors_of<4, kAtLevel>(batch, 4, errors);
#endif
}

void bicubic_errors_here(const BicubicBatch& batch, bool at_level, BicubicErrors& errors) {
  at_level ? bicubic_errors_of<true>(batch, errors) : bicubic_errors_of<false>(batch, errors);
}

}  // namespace
}  // namespace limn

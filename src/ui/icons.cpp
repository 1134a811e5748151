// Icons are strokes on a grid of 20 x 20 about the centre, so they are sharp at any scale and need
// no files.

#include "ui/icons.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

namespace limn::ui {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

struct Pen {
  ImDrawList& list;
  ImVec2 centre;
  float grid;
  ImU32 colour;

  [[nodiscard]] ImVec2 at(float x, float y) const {
    return {centre.x + x * grid, centre.y + y * grid};
  }
  [[nodiscard]] float width() const { return std::max(1.0F, 1.6F * grid); }
  void stroke(std::initializer_list<ImVec2> points, bool is_closed = false) const {
    for (const ImVec2& p : points) {
      list.PathLineTo(at(p.x, p.y));
    }
    list.PathStroke(colour, is_closed ? ImDrawFlags_Closed : ImDrawFlags_None, width());
  }
  void circle(float x, float y, float radius) const {
    list.AddCircle(at(x, y), radius * grid, colour, 0, width());
  }
  /// Angles in turns, 0 to the right, growing clockwise on the screen.
  void arc(float x, float y, float radius, float from, float to) const {
    list.PathArcTo(at(x, y), radius * grid, from * 2.0F * kPi, to * 2.0F * kPi);
    list.PathStroke(colour, ImDrawFlags_None, width());
  }
  void triangle(ImVec2 a, ImVec2 b, ImVec2 c) const {
    list.AddTriangleFilled(at(a.x, a.y), at(b.x, b.y), at(c.x, c.y), colour);
  }
};

void bent_arrow(const Pen& pen, float side) {
  pen.stroke({{-6.0F * side, -2.5F},
              {3.0F * side, -2.5F},
              {5.6F * side, -1.4F},
              {6.8F * side, 1.2F},
              {5.6F * side, 3.9F},
              {3.0F * side, 5.0F},
              {-1.0F * side, 5.0F}});
  pen.stroke({{-2.6F * side, -6.2F}, {-6.4F * side, -2.5F}, {-2.6F * side, 1.2F}});
}

void orbit(const Pen& pen) {
  pen.arc(0.0F, 0.0F, 7.0F, 0.02F, 0.80F);
  pen.triangle({2.4F, -10.6F}, {8.4F, -6.4F}, {1.6F, -3.4F});
  pen.list.AddCircleFilled(pen.at(0.0F, 0.0F), 2.0F * pen.grid, pen.colour);
}

void dropper(const Pen& pen) {
  pen.stroke({{-6.6F, 6.6F}, {-5.9F, 3.6F}, {1.3F, -3.6F}, {3.6F, -1.3F}, {-3.6F, 5.9F}}, true);
  pen.stroke({{-0.6F, -5.0F}, {5.0F, 0.6F}});
  pen.stroke({{2.4F, -2.4F}, {4.6F, -6.2F}, {6.2F, -6.2F}, {6.2F, -4.6F}}, true);
}

/// Under its handle, with the level of what is in it.
void bucket(const Pen& pen) {
  pen.stroke({{-6.0F, -2.4F}, {6.0F, -2.4F}, {4.4F, 7.4F}, {-4.4F, 7.4F}}, true);
  pen.arc(0.0F, -2.4F, 5.0F, 0.5F, 1.0F);
  pen.stroke({{-5.4F, 1.6F}, {5.4F, 1.6F}});
}

/// Aslant, with a star before its tip.
void wand(const Pen& pen) {
  pen.stroke({{-7.0F, 7.0F}, {0.6F, -0.6F}});
  pen.stroke({{4.4F, -8.0F}, {4.4F, -1.6F}});
  pen.stroke({{1.2F, -4.8F}, {7.6F, -4.8F}});
  for (const ImVec2 spark : {ImVec2{-2.6F, -5.4F}, ImVec2{6.2F, 2.6F}}) {
    pen.list.AddCircleFilled(pen.at(spark.x, spark.y), 1.2F * pen.grid, pen.colour);
  }
}

/// In dashes.
void dashed_rectangle(const Pen& pen) {
  constexpr float kWide = 7.0F;
  constexpr float kHigh = 5.4F;
  for (const float side : {-1.0F, 1.0F}) {
    for (const float x : {-1.0F, 1.0F}) {
      pen.stroke({{kWide * x, kHigh * side}, {(kWide - 3.0F) * x, kHigh * side}});
      pen.stroke({{kWide * x, kHigh * side}, {kWide * x, (kHigh - 2.4F) * side}});
    }
    pen.stroke({{-1.7F, kHigh * side}, {1.7F, kHigh * side}});
    pen.stroke({{kWide * side, -1.0F}, {kWide * side, 1.0F}});
  }
}

/// A square of four, one of them of four again.
void fine(const Pen& pen) {
  pen.stroke({{-7.0F, -7.0F}, {7.0F, -7.0F}, {7.0F, 7.0F}, {-7.0F, 7.0F}}, true);
  pen.stroke({{-7.0F, 0.0F}, {7.0F, 0.0F}});
  pen.stroke({{0.0F, -7.0F}, {0.0F, 7.0F}});
  pen.stroke({{0.0F, -3.5F}, {7.0F, -3.5F}});
  pen.stroke({{3.5F, -7.0F}, {3.5F, 0.0F}});
}

/// A loop with the end of its rope.
void lasso(const Pen& pen) {
  constexpr int kSteps = 28;
  for (int i = 0; i < kSteps; ++i) {
    const float angle = 2.0F * kPi * static_cast<float>(i) / kSteps;
    pen.list.PathLineTo(pen.at(7.2F * std::cos(angle), -2.0F + 4.8F * std::sin(angle)));
  }
  pen.list.PathStroke(pen.colour, ImDrawFlags_Closed, pen.width());
  pen.circle(-4.2F, 3.4F, 1.5F);
  pen.stroke({{-4.8F, 4.9F}, {-3.6F, 6.6F}, {-5.2F, 8.2F}});
}

/// Two triangles with their common edge upright, and a dot in its middle.
void split_edge(const Pen& pen) {
  pen.stroke({{0.0F, -7.6F}, {7.4F, 0.0F}, {0.0F, 7.6F}, {-7.4F, 0.0F}}, true);
  pen.stroke({{0.0F, -7.6F}, {0.0F, 7.6F}});
  pen.list.AddCircleFilled(pen.at(0.0F, 0.0F), 2.6F * pen.grid, pen.colour);
}

/// Two triangles with their common edge lying, and where it was as dots.
void flip_edge(const Pen& pen) {
  pen.stroke({{0.0F, -7.6F}, {7.4F, 0.0F}, {0.0F, 7.6F}, {-7.4F, 0.0F}}, true);
  pen.stroke({{-7.4F, 0.0F}, {7.4F, 0.0F}});
  for (const float y : {-4.4F, 4.4F}) {
    pen.list.AddCircleFilled(pen.at(0.0F, y), 1.1F * pen.grid, pen.colour);
  }
}

void frame(const Pen& pen) {
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F}) {
      pen.stroke({{3.4F * x, 6.8F * y}, {6.8F * x, 6.8F * y}, {6.8F * x, 3.4F * y}});
    }
  }
  pen.circle(0.0F, 0.0F, 2.2F);
}

}  // namespace

void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour) {
  const Pen pen{list, centre, size / 20.0F, colour};
  switch (icon) {
    case Icon::kRing:
      pen.circle(0.0F, 0.0F, 7.0F);
      break;
    case Icon::kRingPlus:
      pen.circle(0.0F, 0.0F, 7.4F);
      pen.stroke({{-3.4F, 0.0F}, {3.4F, 0.0F}});
      pen.stroke({{0.0F, -3.4F}, {0.0F, 3.4F}});
      break;
    case Icon::kRingMinus:
      pen.circle(0.0F, 0.0F, 7.4F);
      pen.stroke({{-3.4F, 0.0F}, {3.4F, 0.0F}});
      break;
    case Icon::kBucket:
      bucket(pen);
      break;
    case Icon::kWand:
      wand(pen);
      break;
    case Icon::kRectangle:
      dashed_rectangle(pen);
      break;
    case Icon::kLasso:
      lasso(pen);
      break;
    case Icon::kFine:
      fine(pen);
      break;
    case Icon::kDropper:
      dropper(pen);
      break;
    case Icon::kOrbit:
      orbit(pen);
      break;
    case Icon::kSplitEdge:
      split_edge(pen);
      break;
    case Icon::kFlipEdge:
      flip_edge(pen);
      break;
    case Icon::kUndo:
      bent_arrow(pen, 1.0F);
      break;
    case Icon::kRedo:
      bent_arrow(pen, -1.0F);
      break;
    case Icon::kFrame:
      frame(pen);
      break;
    case Icon::kQuestion:
      pen.arc(0.0F, -2.8F, 3.4F, 0.48F, 1.14F);
      pen.stroke({{2.2F, -0.2F}, {0.0F, 1.6F}, {0.0F, 3.2F}});
      pen.list.AddCircleFilled(pen.at(0.0F, 6.4F), 1.2F * pen.grid, colour);
      break;
    case Icon::kFolder:
      pen.stroke({{-7.0F, 5.4F},
                  {-7.0F, -5.0F},
                  {-2.0F, -5.0F},
                  {0.0F, -3.0F},
                  {7.0F, -3.0F},
                  {7.0F, 5.4F}},
                 true);
      break;
    case Icon::kFile:
      pen.stroke({{-5.0F, -7.0F}, {1.6F, -7.0F}, {5.0F, -3.6F}, {5.0F, 7.0F}, {-5.0F, 7.0F}}, true);
      break;
    case Icon::kFolderUp:
      pen.stroke({{0.0F, 6.0F}, {0.0F, -6.0F}});
      pen.stroke({{-4.6F, -1.4F}, {0.0F, -6.0F}, {4.6F, -1.4F}});
      break;
  }
}

}  // namespace limn::ui

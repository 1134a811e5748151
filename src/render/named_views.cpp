// One table: name and angles of every view.

#include "render/named_views.h"

#include <array>
#include <string>

#include "render/navigation.h"

namespace limn::render {
namespace {

struct Row {
  NamedView view;
  std::string_view name;
  double yaw;
  double pitch;
};

/// The pitch of an isometric view is asin(1 / sqrt 3).
constexpr std::array<Row, 8> kRows{{
    {NamedView::kThreeQuarter, "three-quarter", 35.0, 20.0},
    {NamedView::kFront, "front", 0.0, 0.0},
    {NamedView::kBack, "back", 180.0, 0.0},
    {NamedView::kLeft, "left", -90.0, 0.0},
    {NamedView::kRight, "right", 90.0, 0.0},
    {NamedView::kTop, "top", 0.0, 90.0},
    {NamedView::kBottom, "bottom", 0.0, -90.0},
    {NamedView::kIso, "iso", 45.0, 35.26438968275465},
}};

const Row& row_of(NamedView view) {
  return kRows[static_cast<std::size_t>(view)];
}

}  // namespace

std::span<const NamedView> all_named_views() {
  static constexpr auto views = [] {
    std::array<NamedView, kRows.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = kRows[i].view;
    }
    return all;
  }();
  return views;
}

std::string_view view_name(NamedView view) {
  return row_of(view).name;
}

Result<NamedView> parse_view_name(std::string_view name) {
  std::string names;
  for (const Row& row : kRows) {
    if (row.name == name) {
      return row.view;
    }
    names += names.empty() ? "" : ", ";
    names += row.name;
  }
  return fail(ErrorKind::kUsage,
              "There is no view named \"" + std::string(name) + "\"; choose one of " + names + ".");
}

ViewState turn_to(const ViewState& view, NamedView direction) {
  ViewState turned = view;
  turned.yaw = row_of(direction).yaw;
  turned.pitch = row_of(direction).pitch;
  return turned;
}

ViewState named_view(NamedView direction, const Bounds& scene, double aspect) {
  return frame_bounds(turn_to(ViewState{}, direction), scene, aspect);
}

ViewState named_view(NamedView direction, std::span<const glm::dvec3> points, double aspect) {
  return frame_points(turn_to(ViewState{}, direction), points, aspect);
}

ViewState default_view(const Bounds& scene, double aspect) {
  return named_view(NamedView::kThreeQuarter, scene, aspect);
}

ViewState default_view(std::span<const glm::dvec3> points, double aspect) {
  return named_view(NamedView::kThreeQuarter, points, aspect);
}

}  // namespace limn::render

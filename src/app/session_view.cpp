// Display and camera: nothing here changes the document, so nothing here is undone.
#include <vector>

#include "app/session.h"
#include "render/named_views.h"
#include "render/navigation.h"

namespace limn::app {

using enum ui::ActionId;

namespace {

constexpr double kZoomStep = 1.25;

void set_or_flip(bool& setting, const ui::Action& action) {
  const auto* value = std::get_if<bool>(&action.value);
  setting = value != nullptr ? *value : !setting;
}

}  // namespace

bool Session::perform_display(const ui::Action& action) {
  switch (action.id) {
    case kShowControl:
      display_.show = ui::ShowMode::kControl;
      return true;
    case kShowRefined:
      display_.show = ui::ShowMode::kRefined;
      return true;
    case kShowBoth:
      display_.show = ui::ShowMode::kBoth;
      return true;
    case kToggleWireframe:
      set_or_flip(display_.wireframe, action);
      return true;
    case kToggleSmooth:
      set_or_flip(display_.smooth, action);
      return true;
    case kToggleLight:
      set_or_flip(display_.light, action);
      return true;
    case kToggleLabels:
      set_or_flip(display_.labels, action);
      return true;
    case kToggleIllegalMarks:
      set_or_flip(display_.illegal_marks, action);
      return true;
    case kToggleCreases:
      set_or_flip(display_.creases, action);
      return true;
    case kToggleFaces:
      set_or_flip(display_.faces, action);
      return true;
    case kToggleValences:
      set_or_flip(display_.valences, action);
      return true;
    case kToggleLive:
      set_or_flip(display_.live, action);
      return true;
    case kToggleNumbers:
      set_or_flip(display_.numbers, action);
      return true;
    case kTintDepth:
      display_.tint = ui::Tint::kDepth;
      return true;
    case kTintLevel:
      display_.tint = ui::Tint::kLevel;
      return true;
    case kTintNone:
      display_.tint = ui::Tint::kNone;
      return true;
    case kTintDistance:
      display_.tint = ui::Tint::kDistance;
      return true;
    case kMaterialStudio:
      return set_material(ui::Material::kStudio);
    case kMaterialClay:
      return set_material(ui::Material::kClay);
    case kMaterialDark:
      return set_material(ui::Material::kDark);
    case kMaterialShiny:
      return set_material(ui::Material::kShiny);
    case kThemeDark:
      display_.theme = ui::Theme::kDark;
      return true;
    case kThemeLight:
      display_.theme = ui::Theme::kLight;
      return true;
    default:
      return false;
  }
}

bool Session::set_material(ui::Material material) {
  display_.material = material;
  display_.light = true;  // Without light there is none to be seen.
  return true;
}

bool Session::shows_refined() const noexcept {
  return shown_levels() > 0 && steps_.moment() == nullptr &&
         display_.show != ui::ShowMode::kControl && refinement_.refined() != nullptr;
}

bool Session::perform_camera(const ui::Action& action) {
  const auto look_from = [this](render::NamedView direction) {
    camera_.glide_to(render::turn_to(camera_.goal(), direction), now_);
  };
  switch (action.id) {
    case kToggleOrthographic: {
      ViewState view = camera_.goal();
      set_or_flip(view.orthographic, action);
      camera_.set(view);
      return true;
    }
    case kFrameAll:
      camera_.glide_to(
          render::frame_points(camera_.goal(), document_.control->positions(), aspect_), now_);
      return true;
    case kFramePainted: {
      std::vector<std::uint32_t> painted;
      for (std::uint32_t face = 0; face < document_.depths.size(); ++face) {
        if (document_.depths[face] > 0) {
          painted.push_back(face);
        }
      }
      for (const FineDemand& demand : document_.demands.all()) {
        painted.push_back(demand.face.control_face);
      }
      if (painted.empty()) {
        toast(ui::Toast::Kind::kNote, "Nothing is painted yet.");
      } else {
        frame_faces(painted);
      }
      return true;
    }
    case kFrameHovered:
      if (hover_) {
        const std::uint32_t face = *hover_;
        frame_faces({&face, 1});
      } else {
        toast(ui::Toast::Kind::kNote, "Point at a face to frame it.");
      }
      return true;
    case kZoomIn:
      zoom(1.0 / kZoomStep);
      return true;
    case kZoomOut:
      zoom(kZoomStep);
      return true;
    case kViewFront:
      look_from(render::NamedView::kFront);
      return true;
    case kViewBack:
      look_from(render::NamedView::kBack);
      return true;
    case kViewLeft:
      look_from(render::NamedView::kLeft);
      return true;
    case kViewRight:
      look_from(render::NamedView::kRight);
      return true;
    case kViewTop:
      look_from(render::NamedView::kTop);
      return true;
    case kViewBottom:
      look_from(render::NamedView::kBottom);
      return true;
    case kViewIso:
      look_from(render::NamedView::kThreeQuarter);
      return true;
    default:
      return false;
  }
}

bool Session::perform_navigation(const ui::Action& action) {
  switch (action.id) {
    case kNavigationOriginal:
      navigation_.preset = ui::NavigationPreset::kOriginal;
      return true;
    case kNavigationMouseOnly:
      navigation_.preset = ui::NavigationPreset::kMouseOnly;
      return true;
    case kNavigationClassroom:
      navigation_.preset = ui::NavigationPreset::kClassroom;
      return true;
    case kToggleOrbitPivot:
      set_or_flip(navigation_.orbits_around_cursor, action);
      return true;
    default:
      return false;
  }
}

void Session::frame_faces(std::span<const std::uint32_t> faces) {
  const auto positions = document_.control->positions();
  std::vector<glm::dvec3> points;
  for (const std::uint32_t face : faces) {
    for (const std::uint32_t vertex : document_.control->face(face)) {
      points.push_back(positions[vertex]);
    }
  }
  camera_.glide_to(render::frame_points(camera_.goal(), points, aspect_), now_);
}

void Session::zoom(double factor) {
  camera_.glide_to(render::dolly(camera_.goal(), factor, document_.control->bounds()), now_);
}

void Session::set_view(const ViewState& view) {
  const ViewState& before = camera_.view();
  if (view.yaw != before.yaw || view.pitch != before.pitch) {
    learn(&ui::HintCard::has_orbited);
  }
  camera_.set(view);
}

void Session::set_aspect(double aspect) {
  if (!is_framed_) {
    camera_.set(render::default_view(document_.control->positions(), aspect));
    is_framed_ = true;
  }
  aspect_ = aspect;
}

}  // namespace limn::app

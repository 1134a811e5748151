#pragma once

#include <imgui.h>

#include <cstdint>

namespace limn::ui {

enum class Icon : std::uint8_t {
  kRing,
  kRingPlus,
  kRingMinus,
  kBucket,
  kWand,
  kRectangle,
  kLasso,
  kFine,
  kDropper,
  kOrbit,
  kSplitEdge,
  kFlipEdge,
  kUndo,
  kRedo,
  kFrame,
  kQuestion,
  kFolder,
  kFile,
  kFolderUp,
};

/// Draws the icon in a square of side `size` about `centre`, in lines that scale with it.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);

}  // namespace limn::ui

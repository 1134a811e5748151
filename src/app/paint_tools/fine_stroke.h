#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/paint_tools/shown_faces.h"
#include "limn/painting/depth_change.h"

namespace limn::app {

/// A stroke over faces of a refined mesh, from press to release. All of it goes by one mesh, that
/// of its first touch: whoever replaces the mesh shown waits until the stroke is over. It gathers
/// faces and changes nothing; what comes of them is worked out when it ends.
class FineStroke {
 public:
  FineStroke(DepthChange change, std::string name) : change_(change), name_(std::move(name)) {}

  /// Takes faces in; those of another mesh than the first touch's are passed over. Returns true
  /// where any is new.
  bool touch(const ShownFaces& shown);

  [[nodiscard]] DepthChange change() const noexcept { return change_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// All faces so far.
  [[nodiscard]] const ShownFaces& touched() const noexcept { return touched_; }

 private:
  DepthChange change_;
  std::string name_;
  bool has_mesh_ = false;
  ShownFaces touched_;
};

}  // namespace limn::app

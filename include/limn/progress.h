#pragma once

#include <string_view>

namespace limn {

/// How a long-running algorithm tells where it is and learns that it should stop.
///
/// Algorithms call `report` at least every few milliseconds of work, from the thread that called
/// them. An algorithm that is told to stop returns an Error of kind kCancelled and leaves its
/// arguments as they were.
class Progress {
 public:
  virtual ~Progress() = default;

  /// `fraction` runs from 0 to 1 and never falls within one stage; `stage` is a short phrase for
  /// people ("Refining level 3"). Returns false to ask the algorithm to stop.
  [[nodiscard]] virtual bool report(double fraction, std::string_view stage) = 0;
};

/// For callers who neither watch nor cancel.
class IgnoreProgress final : public Progress {
 public:
  [[nodiscard]] bool report(double, std::string_view) override { return true; }
};

}  // namespace limn

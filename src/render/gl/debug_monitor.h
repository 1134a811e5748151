#pragma once

#include <memory>
#include <string>
#include <vector>

namespace limn::render::gl {

/// Listens to the driver's debug messages of the context that is current when it is made, and keeps
/// those that tell of errors. Must not outlive that context's being current.
class DebugMonitor {
 public:
  DebugMonitor();
  ~DebugMonitor();
  DebugMonitor(const DebugMonitor&) = delete;
  DebugMonitor& operator=(const DebugMonitor&) = delete;

  /// The errors since the last call, in order.
  [[nodiscard]] std::vector<std::string> take_errors();
  /// Throws EnvironmentError listing the errors since the last call, if there are any.
  void require_no_errors();

 private:
  std::unique_ptr<std::vector<std::string>> errors_;  ///< The callback holds its address.
};

}  // namespace limn::render::gl

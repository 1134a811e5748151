#pragma once

#include <string>

namespace limn::render {

/// A library opened while the program runs, so that the program starts without it.
///
/// Never unloaded: drivers leave threads and thread-local destructors behind.
class SharedLibrary {
 public:
  /// Throws EnvironmentError naming the library, the loader's reason and the Debian package.
  SharedLibrary(const std::string& file, const std::string& package);

  /// Looks up a function and casts it to the pointer type Function. Throws EnvironmentError.
  template <class Function>
  [[nodiscard]] Function function(const char* name) const {
    return reinterpret_cast<Function>(symbol(name));
  }

 private:
  [[nodiscard]] void* symbol(const char* name) const;

  std::string file_;
  void* library_ = nullptr;
};

}  // namespace limn::render

#include "render/context/shared_library.h"

#include <dlfcn.h>

#include <fmt/format.h>

#include "render/environment_error.h"

namespace limn::render {

SharedLibrary::SharedLibrary(const std::string& file, const std::string& package)
    : file_(file), library_(dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL)) {
  if (library_ == nullptr) {
    throw EnvironmentError(fmt::format("{} could not be opened ({}). Install the package {}.", file,
                                       dlerror(), package));
  }
}

void* SharedLibrary::symbol(const char* name) const {
  void* found = dlsym(library_, name);
  if (found == nullptr) {
    throw EnvironmentError(fmt::format("{} has no function {}.", file_, name));
  }
  return found;
}

}  // namespace limn::render

// Displays are tried in this order, until one gives a context: EGL devices that are hardware,
// Mesa's surfaceless platform, EGL devices that are software. So a server with a GPU uses it, also
// where Mesa's software renderer is installed beside it.
#include "render/context/egl_context.h"

#include <array>
#include <string_view>
#include <vector>

// No X11 types are wanted from EGL's platform header.
#define EGL_NO_X11
#define EGL_NO_PLATFORM_SPECIFIC_TYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include "render/context/current.h"
#include "render/context/shared_library.h"
#include "render/environment_error.h"

namespace limn::render {

struct EglSurfacelessContext::Library {
  SharedLibrary file{"libEGL.so.1", "libegl1"};
  decltype(&eglGetError) get_error = file.function<decltype(&eglGetError)>("eglGetError");
  decltype(&eglQueryString) query_string =
      file.function<decltype(&eglQueryString)>("eglQueryString");
  decltype(&eglInitialize) initialize = file.function<decltype(&eglInitialize)>("eglInitialize");
  decltype(&eglBindAPI) bind_api = file.function<decltype(&eglBindAPI)>("eglBindAPI");
  decltype(&eglChooseConfig) choose_config =
      file.function<decltype(&eglChooseConfig)>("eglChooseConfig");
  decltype(&eglCreateContext) create_context =
      file.function<decltype(&eglCreateContext)>("eglCreateContext");
  decltype(&eglDestroyContext) destroy_context =
      file.function<decltype(&eglDestroyContext)>("eglDestroyContext");
  decltype(&eglMakeCurrent) make_current =
      file.function<decltype(&eglMakeCurrent)>("eglMakeCurrent");
  decltype(&eglGetProcAddress) get_proc_address =
      file.function<decltype(&eglGetProcAddress)>("eglGetProcAddress");

  // Extensions: null where missing.
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display =
      extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  PFNEGLQUERYDEVICESEXTPROC query_devices =
      extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  PFNEGLQUERYDEVICESTRINGEXTPROC query_device_string =
      extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");

 private:
  template <class Function>
  [[nodiscard]] Function extension(const char* name) const {
    return reinterpret_cast<Function>(get_proc_address(name));
  }
};

namespace {

bool has_word(const char* words, std::string_view word) {
  std::string_view rest = words == nullptr ? "" : words;
  while (!rest.empty()) {
    const std::size_t end = rest.find(' ');
    if (rest.substr(0, end) == word) {
      return true;
    }
    rest = end == std::string_view::npos ? "" : rest.substr(end + 1);
  }
  return false;
}

/// Displays that may work, best first.
template <class Library>
std::vector<EGLDisplay> candidate_displays(const Library& egl) {
  const char* extensions = egl.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (egl.get_platform_display == nullptr) {
    return {};
  }
  std::vector<EGLDisplay> hardware;
  std::vector<EGLDisplay> software;
  if (has_word(extensions, "EGL_EXT_platform_device") && egl.query_devices != nullptr &&
      egl.query_device_string != nullptr) {
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (egl.query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) ==
        EGL_TRUE) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const bool is_software = has_word(egl.query_device_string(devices[i], EGL_EXTENSIONS),
                                          "EGL_MESA_device_software");
        (is_software ? software : hardware)
            .push_back(egl.get_platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
      }
    }
  }
  std::vector<EGLDisplay> displays = std::move(hardware);
  if (has_word(extensions, "EGL_MESA_platform_surfaceless")) {
    displays.push_back(
        egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  displays.insert(displays.end(), software.begin(), software.end());
  return displays;
}

template <class Library>
EGLContext create_context(const Library& egl, EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || egl.initialize(display, nullptr, nullptr) != EGL_TRUE ||
      egl.bind_api(EGL_OPENGL_API) != EGL_TRUE) {
    return EGL_NO_CONTEXT;
  }
  const char* extensions = egl.query_string(display, EGL_EXTENSIONS);
  if (!has_word(extensions, "EGL_KHR_surfaceless_context")) {
    return EGL_NO_CONTEXT;
  }
  constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint count = 0;
  if (egl.choose_config(display, kConfig, &config, 1, &count) != EGL_TRUE || count == 0) {
    if (!has_word(extensions, "EGL_KHR_no_config_context")) {
      return EGL_NO_CONTEXT;
    }
    config = EGL_NO_CONFIG_KHR;
  }
  constexpr EGLint kContext[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
  return egl.create_context(display, config, EGL_NO_CONTEXT, kContext);
}

}  // namespace

const EglSurfacelessContext::Library& EglSurfacelessContext::library() {
  static const Library opened;
  return opened;
}

EglSurfacelessContext::EglSurfacelessContext() : egl_(library()) {
  for (EGLDisplay display : candidate_displays(egl_)) {
    context_ = create_context(egl_, display);
    if (context_ != EGL_NO_CONTEXT) {
      display_ = display;
      return;
    }
  }
  throw EnvironmentError(
      fmt::format("EGL cannot create an OpenGL 4.5 core context without a window (last error "
                  "{:#x}). Install a graphics driver or Mesa (package libegl-mesa0).",
                  egl_.get_error()));
}

EglSurfacelessContext::~EglSurfacelessContext() {
  if (is_current(this)) {
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    forget_current(this);
  }
  egl_.destroy_context(display_, context_);
  // The display stays initialised: it is shared by every context of the process.
}

void EglSurfacelessContext::make_current() {
  switch_current(this, [&egl = egl_, display = display_] {
    egl.make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  });
  if (egl_.bind_api(EGL_OPENGL_API) != EGL_TRUE ||
      egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
    forget_current(this);
    throw EnvironmentError(
        fmt::format("EGL cannot make its context current (error {:#x}).", egl_.get_error()));
  }
  set_info(load_gl(egl_.get_proc_address));
}

}  // namespace limn::render

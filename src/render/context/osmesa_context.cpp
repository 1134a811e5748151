// GL/osmesa.h includes GL/gl.h, which cannot stand beside glad's header, so the few constants and
// signatures of OSMesa's public interface are written down here.
#include "render/context/osmesa_context.h"

#include "render/context/current.h"
#include "render/context/shared_library.h"
#include "render/environment_error.h"

namespace limn::render {
namespace {

constexpr int kOsmesaFormat = 0x22;
constexpr int kOsmesaDepthBits = 0x30;
constexpr int kOsmesaStencilBits = 0x31;
constexpr int kOsmesaProfile = 0x33;
constexpr int kOsmesaCoreProfile = 0x34;
constexpr int kOsmesaContextMajor = 0x36;
constexpr int kOsmesaContextMinor = 0x37;
constexpr int kRgba = 0x1908;
constexpr unsigned kUnsignedByte = 0x1401;

}  // namespace

struct OsmesaContext::Library {
  SharedLibrary file{"libOSMesa.so.8", "libosmesa6"};
  void* (*create)(const int*, void*) =
      file.function<void* (*)(const int*, void*)>("OSMesaCreateContextAttribs");
  void (*destroy)(void*) = file.function<void (*)(void*)>("OSMesaDestroyContext");
  unsigned char (*make_current)(void*, void*, unsigned, int, int) =
      file.function<unsigned char (*)(void*, void*, unsigned, int, int)>("OSMesaMakeCurrent");
  GlLoader get_proc_address = file.function<GlLoader>("OSMesaGetProcAddress");
};

const OsmesaContext::Library& OsmesaContext::library() {
  static const Library opened;
  return opened;
}

OsmesaContext::OsmesaContext() {
  constexpr int kAttributes[] = {kOsmesaFormat,
                                 kRgba,
                                 kOsmesaDepthBits,
                                 0,
                                 kOsmesaStencilBits,
                                 0,
                                 kOsmesaProfile,
                                 kOsmesaCoreProfile,
                                 kOsmesaContextMajor,
                                 4,
                                 kOsmesaContextMinor,
                                 5,
                                 0};
  context_ = library().create(kAttributes, nullptr);
  if (context_ == nullptr) {
    throw EnvironmentError(
        "OSMesa cannot create an OpenGL 4.5 core context. Install Mesa 20 or newer (package "
        "libosmesa6).");
  }
}

OsmesaContext::~OsmesaContext() {
  if (is_current(this)) {
    library().make_current(nullptr, nullptr, kUnsignedByte, 0, 0);
    forget_current(this);
  }
  library().destroy(context_);
}

void OsmesaContext::make_current() {
  switch_current(this, [] { library().make_current(nullptr, nullptr, kUnsignedByte, 0, 0); });
  if (library().make_current(context_, pixel_, kUnsignedByte, 1, 1) == 0) {
    forget_current(this);
    throw EnvironmentError("OSMesa cannot make its context current.");
  }
  set_info(load_gl(library().get_proc_address));
}

}  // namespace limn::render

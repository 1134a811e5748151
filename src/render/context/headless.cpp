// Tries EGL first, since it may have a GPU behind it; keeps the reason of every failure.
#include <cstdlib>

#include <fmt/format.h>

#include "render/context/egl_context.h"
#include "render/context/gl_context.h"
#include "render/context/osmesa_context.h"
#include "render/environment_error.h"

namespace limn::render {
namespace {

HeadlessKind kind_from_environment() {
  const char* value = std::getenv("LIMN_HEADLESS");
  const std::string_view text = value == nullptr ? "" : value;
  if (text.empty() || text == "any") {
    return HeadlessKind::kAny;
  }
  if (text == "egl") {
    return HeadlessKind::kEgl;
  }
  if (text == "osmesa") {
    return HeadlessKind::kOsmesa;
  }
  throw EnvironmentError(fmt::format(
      "The environment variable LIMN_HEADLESS is \"{}\"; it may be egl, osmesa or any.", text));
}

template <class Context>
std::unique_ptr<GlContext> create_current() {
  auto context = std::make_unique<Context>();
  context->make_current();
  return context;
}

}  // namespace

std::unique_ptr<GlContext> create_headless_context(HeadlessKind kind) {
  if (kind == HeadlessKind::kAny) {
    kind = kind_from_environment();
  }
  if (kind == HeadlessKind::kEgl) {
    return create_current<EglSurfacelessContext>();
  }
  if (kind == HeadlessKind::kOsmesa) {
    return create_current<OsmesaContext>();
  }
  std::string egl_reason;
  try {
    return create_current<EglSurfacelessContext>();
  } catch (const EnvironmentError& error) {
    egl_reason = error.what();
  }
  try {
    return create_current<OsmesaContext>();
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(
        fmt::format("No way to draw without a display was found.\n  EGL: {}\n  OSMesa: {}",
                    egl_reason, error.what()));
  }
}

}  // namespace limn::render

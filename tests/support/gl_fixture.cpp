#include "support/gl_fixture.h"

namespace limn::test {

std::unique_ptr<render::GlContext> GlFixture::context;

void GlFixture::SetUpTestSuite() {
  context = render::create_headless_context(render::HeadlessKind::kOsmesa);
}

void GlFixture::TearDownTestSuite() {
  context.reset();
}

void GlFixture::SetUp() {
  ASSERT_NE(context, nullptr);
  context->make_current();
  monitor = std::make_unique<render::gl::DebugMonitor>();
}

void GlFixture::TearDown() {
  for (const std::string& error : monitor->take_errors()) {
    ADD_FAILURE() << "OpenGL: " << error;
  }
  monitor.reset();
}

}  // namespace limn::test

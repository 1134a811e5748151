#pragma once

#include <memory>

#include <gtest/gtest.h>

#include "render/context/gl_context.h"
#include "render/gl/debug_monitor.h"

namespace limn::test {

/// A test with a current OSMesa context, shared by the tests of a suite. Fails where OpenGL reports
/// an error in between. An absent context is a failure, never a skip.
class GlFixture : public testing::Test {
 protected:
  static void SetUpTestSuite();
  static void TearDownTestSuite();
  void SetUp() override;
  void TearDown() override;

  static std::unique_ptr<render::GlContext> context;
  std::unique_ptr<render::gl::DebugMonitor> monitor;
};

}  // namespace limn::test

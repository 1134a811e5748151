// A driver that is reset, or has no memory left.
#include <string>
#include <utility>

#include <glad/gl.h>
#include <gtest/gtest.h>

#include "app/desk.h"
#include "render/environment_error.h"

namespace limn::app {
namespace {

using enum ui::ActionId;

TEST(LostGraphics, EverythingIsDrawnAgainFromTheSession) {
  Desk desk({640.0, 480.0});
  desk.session().perform({kOpenBundled, std::string("mixed")});
  desk.session().perform(kRaiseAll);
  desk.session().perform(kCreaseDihedral);
  desk.session().perform(kSubdivide);
  desk.session().perform({kToggleLabels, true});
  const render::Image before = desk.picture();
  desk.lose_graphics();
  const render::Image after = desk.picture();
  EXPECT_EQ(before.size, after.size);
  EXPECT_EQ(before.rgba, after.rgba);
}

PFNGLNAMEDBUFFERDATAPROC real_buffer_data = nullptr;
PFNGLGETERRORPROC real_get_error = nullptr;
bool is_out_of_memory = false;

TEST(LostGraphics, WhatTheCardDoesNotHoldGivesWayToTheControlMesh) {
  Desk desk({640.0, 480.0});
  desk.session().perform({kToggleLive, false});
  desk.session().perform({kOpenBundled, std::string("cube")});
  desk.session().perform(kRaiseAll);
  static_cast<void>(desk.picture());
  desk.session().perform(kSubdivide);
  desk.session().finish_refinement();
  real_buffer_data = glad_glNamedBufferData;
  real_get_error = glad_glGetError;
  glad_glNamedBufferData = [](GLuint, GLsizeiptr, const void*, GLenum) { is_out_of_memory = true; };
  glad_glGetError = []() -> GLenum {
    return std::exchange(is_out_of_memory, false) ? GL_OUT_OF_MEMORY : GL_NO_ERROR;
  };
  EXPECT_THROW(static_cast<void>(desk.scene().sync(desk.session())), render::OutOfVideoMemory);
  glad_glNamedBufferData = real_buffer_data;
  glad_glGetError = real_get_error;
  desk.lose_graphics();
  desk.scene().leave_out_refined(desk.session());
  const render::Image without = desk.picture();
  EXPECT_TRUE(desk.session().shows_refined());

  // The next refinement is tried again.
  desk.session().perform(kRaiseAll);
  desk.session().perform(kUndo);
  const render::Image with = desk.picture();
  EXPECT_NE(with.rgba, without.rgba);
}

}  // namespace
}  // namespace limn::app

// Owners of OpenGL names without any context: nothing here may call OpenGL.
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "render/gl/buffer.h"
#include "render/gl/framebuffer.h"
#include "render/gl/handle.h"
#include "render/gl/shader_program.h"
#include "render/gl/texture.h"
#include "render/gl/vertex_array.h"

namespace limn::render::gl {
namespace {

std::vector<GLuint> deleted;
void note_deleted(GLuint id) {
  deleted.push_back(id);
}
using Noted = Handle<note_deleted>;

class GlOwner : public testing::Test {
 protected:
  void SetUp() override { deleted.clear(); }
};

TEST_F(GlOwner, DeletesItsNameOnce) {
  { const Noted handle(7); }
  EXPECT_EQ(deleted, std::vector<GLuint>{7});
}

TEST_F(GlOwner, EmptyDeletesNothing) {
  { const Noted handle; }
  EXPECT_TRUE(deleted.empty());
}

TEST_F(GlOwner, MoveConstructionLeavesTheSourceEmpty) {
  {
    Noted first(7);
    const Noted second(std::move(first));
    EXPECT_EQ(second.id(), 7U);
    EXPECT_EQ(first.id(), 0U);  // NOLINT(bugprone-use-after-move): that is what is tested
    EXPECT_FALSE(first);
  }
  EXPECT_EQ(deleted, std::vector<GLuint>{7});
}

TEST_F(GlOwner, MoveAssignmentDeletesWhatWasThere) {
  {
    Noted first(7);
    Noted second(8);
    second = std::move(first);
    EXPECT_EQ(deleted, std::vector<GLuint>{8});
    EXPECT_EQ(second.id(), 7U);
  }
  EXPECT_EQ(deleted, (std::vector<GLuint>{8, 7}));
}

TEST_F(GlOwner, AssignmentToItselfKeepsTheName) {
  Noted handle(7);
  Noted& same = handle;
  handle = std::move(same);
  EXPECT_EQ(handle.id(), 7U);
  EXPECT_TRUE(deleted.empty());
}

TEST_F(GlOwner, GrowthOfAVectorMovesNames) {
  {
    std::vector<Noted> handles;
    for (GLuint id = 1; id <= 20; ++id) {
      handles.emplace_back(id);
    }
    EXPECT_TRUE(deleted.empty());
  }
  EXPECT_EQ(deleted.size(), 20U);
}

template <class Owner>
constexpr bool is_move_only =
    std::is_nothrow_move_constructible_v<Owner>&& std::is_nothrow_move_assignable_v<Owner> &&
    !std::is_copy_constructible_v<Owner> && !std::is_copy_assignable_v<Owner> &&
    std::is_nothrow_default_constructible_v<Owner>;

TEST_F(GlOwner, EveryOwnerIsMoveOnlyAndEmptyByDefault) {
  static_assert(is_move_only<Buffer> && is_move_only<Texture> && is_move_only<Renderbuffer> &&
                is_move_only<Framebuffer> && is_move_only<VertexArray> &&
                is_move_only<ShaderProgram>);
  // A handle of one kind is not taken for another.
  static_assert(!std::is_convertible_v<Handle<delete_buffer>, Handle<delete_texture>>);
  EXPECT_FALSE(Buffer());
  EXPECT_FALSE(Texture());
  EXPECT_FALSE(Renderbuffer());
  EXPECT_FALSE(Framebuffer());
  EXPECT_FALSE(VertexArray());
  EXPECT_FALSE(ShaderProgram());
}

}  // namespace
}  // namespace limn::render::gl

// Draws hand-made ImGui frames into an off-screen framebuffer and reads single pixels back.
#include "app/imgui_renderer.h"

#include <memory>
#include <optional>

#include <gtest/gtest.h>
#include <imgui.h>

#include "render/context/gl_context.h"
#include "render/render_target.h"

namespace limn::app {
namespace {

constexpr int kWidth = 200;
constexpr int kHeight = 100;
constexpr ImU32 kRed = IM_COL32(255, 0, 0, 255);
constexpr ImU32 kGreen = IM_COL32(0, 255, 0, 255);
constexpr ImU32 kBlue = IM_COL32(0, 0, 255, 255);

class ImguiRendererTest : public testing::Test {
 protected:
  ImguiRendererTest() : context_(render::create_headless_context()) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.Fonts->AddFontDefault();
    renderer_.emplace();
    renderer_->set_atlas(*io.Fonts, 1);
  }
  ~ImguiRendererTest() override {
    renderer_.reset();
    ImGui::DestroyContext();
  }

  /// Draws what `fill` puts on ImGui's background list, over black.
  template <class Fill>
  render::Image draw(float density, Fill&& fill) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(kWidth, kHeight);
    io.DisplayFramebufferScale = ImVec2(density, density);
    io.DeltaTime = 1.0F / 60.0F;
    ImGui::NewFrame();
    fill(*ImGui::GetBackgroundDrawList());
    ImGui::Render();

    render::RenderTarget target;
    const auto pixels = [density](int units) {
      return static_cast<int>(static_cast<float>(units) * density);
    };
    target.resize({pixels(kWidth), pixels(kHeight)});
    target.bind();
    glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    renderer_->draw(*ImGui::GetDrawData());
    return target.read();
  }

  static ImU32 colour(const render::Image& image, int x, int y) {
    const std::uint8_t* p = image.pixel(x, y);
    return IM_COL32(p[0], p[1], p[2], 255);
  }

  std::unique_ptr<render::GlContext> context_;
  std::optional<ImguiRenderer> renderer_;
};

TEST_F(ImguiRendererTest, RectangleLandsOnItsPixels) {
  const render::Image image = draw(
      1.0F, [](ImDrawList& list) { list.AddRectFilled(ImVec2(10, 20), ImVec2(30, 25), kRed); });
  EXPECT_EQ(colour(image, 10, 20), kRed);
  EXPECT_EQ(colour(image, 29, 24), kRed);
  EXPECT_EQ(colour(image, 9, 20), IM_COL32_BLACK);
  EXPECT_EQ(colour(image, 30, 24), IM_COL32_BLACK);
  EXPECT_EQ(colour(image, 10, 19), IM_COL32_BLACK);
  EXPECT_EQ(colour(image, 29, 25), IM_COL32_BLACK);
}

TEST_F(ImguiRendererTest, DensityTwoDoublesPixelsAndClips) {
  const render::Image image = draw(2.0F, [](ImDrawList& list) {
    list.PushClipRect(ImVec2(0, 0), ImVec2(20, kHeight));
    list.AddRectFilled(ImVec2(10, 20), ImVec2(30, 25), kRed);
    list.PopClipRect();
  });
  EXPECT_EQ(colour(image, 20, 40), kRed);
  EXPECT_EQ(colour(image, 39, 49), kRed);
  EXPECT_EQ(colour(image, 19, 40), IM_COL32_BLACK);
  EXPECT_EQ(colour(image, 40, 45), IM_COL32_BLACK);
  EXPECT_EQ(colour(image, 25, 50), IM_COL32_BLACK);
}

TEST_F(ImguiRendererTest, ClipRectanglesOutsideTheWindowAreHarmless) {
  const render::Image image = draw(1.0F, [](ImDrawList& list) {
    list.PushClipRect(ImVec2(-50, -50), ImVec2(500, 500));
    list.AddRectFilled(ImVec2(-20, -20), ImVec2(400, 400), kGreen);
    list.PopClipRect();
    list.PushClipRect(ImVec2(300, 0), ImVec2(400, 50));
    list.AddRectFilled(ImVec2(0, 0), ImVec2(400, 400), kBlue);
    list.PopClipRect();
  });
  EXPECT_EQ(colour(image, 0, 0), kGreen);
  EXPECT_EQ(colour(image, kWidth - 1, kHeight - 1), kGreen);
}

TEST_F(ImguiRendererTest, BlendsOverWhatIsThere) {
  const render::Image image = draw(1.0F, [](ImDrawList& list) {
    list.AddRectFilled(ImVec2(0, 0), ImVec2(50, 50), kBlue);
    list.AddRectFilled(ImVec2(0, 0), ImVec2(50, 50), IM_COL32(255, 0, 0, 128));
  });
  const std::uint8_t* pixel = image.pixel(25, 25);
  EXPECT_NEAR(pixel[0], 128, 1);
  EXPECT_EQ(pixel[1], 0);
  EXPECT_NEAR(pixel[2], 127, 1);
}

TEST_F(ImguiRendererTest, TextIsDrawnFromTheAtlas) {
  const render::Image image =
      draw(1.0F, [](ImDrawList& list) { list.AddText(ImVec2(10, 10), IM_COL32_WHITE, "Limn"); });
  const ImVec2 size = ImGui::GetFont()->CalcTextSizeA(ImGui::GetFontSize(), FLT_MAX, 0.0F, "Limn");
  int lit_inside = 0;
  int lit_outside = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool is_inside = x >= 10 && x < 10 + static_cast<int>(size.x) + 1 && y >= 10 &&
                             y < 10 + static_cast<int>(size.y) + 1;
      (is_inside ? lit_inside : lit_outside) += *image.pixel(x, y) > 128 ? 1 : 0;
    }
  }
  EXPECT_GT(lit_inside, 20);
  EXPECT_EQ(lit_outside, 0);
}

TEST_F(ImguiRendererTest, ReachesVerticesBeyondSixteenBits) {
  constexpr int kRectangles = 20000;  // 80,000 vertices.
  const render::Image image = draw(1.0F, [](ImDrawList& list) {
    for (int i = 0; i < kRectangles; ++i) {
      list.AddRectFilled(ImVec2(0, 0), ImVec2(5, 5), kRed);
    }
    list.AddRectFilled(ImVec2(100, 50), ImVec2(110, 60), kGreen);
  });
  EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, 65536);
  EXPECT_EQ(colour(image, 2, 2), kRed);
  EXPECT_EQ(colour(image, 105, 55), kGreen);
  EXPECT_EQ(colour(image, 95, 55), IM_COL32_BLACK);
}

TEST_F(ImguiRendererTest, AtlasIsUploadedOncePerRevision) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  const ImTextureID first = atlas.TexID;
  renderer_->set_atlas(atlas, 1);
  EXPECT_EQ(atlas.TexID, first);
  atlas.ClearTexData();
  renderer_->set_atlas(atlas, 2);
  const render::Image image = draw(
      1.0F, [](ImDrawList& list) { list.AddRectFilled(ImVec2(10, 20), ImVec2(30, 25), kRed); });
  EXPECT_EQ(colour(image, 15, 22), kRed);
}

}  // namespace
}  // namespace limn::app

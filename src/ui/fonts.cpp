// ImGui sizes a font by its line height, designers by its em: the height handed over is the em
// times 1.2, the ratio of Inter and, nearly, of DejaVu Sans. Glyphs are rasterised at framebuffer
// density; `FontGlobalScale` undoes that for layout.

#include "ui/fonts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace limn::ui {
namespace {

constexpr float kLineHeightPerEm = 1.2F;

// Latin with extensions, Greek, Cyrillic (file names), and the signs the interface uses.
constexpr std::array<ImWchar, 15> kRanges{0x0020, 0x024F, 0x0370, 0x03FF, 0x0400,
                                          0x052F, 0x2010, 0x2027, 0x2030, 0x203A,
                                          0x2190, 0x2193, 0x2212, 0x2212, 0};

// A font that stb_truetype could take for one: it reads tables without bounds checks, so anything
// that does not begin like a font file is not shown to it.
bool is_font(const std::vector<std::byte>& bytes) {
  if (bytes.size() < 1024) {
    return false;
  }
  std::array<char, 4> tag{};
  std::memcpy(tag.data(), bytes.data(), tag.size());
  const std::string_view text(tag.data(), tag.size());
  return text == "OTTO" || text == "true" || text == std::string_view("\0\1\0\0", 4);
}

ImFont* add(ImFontAtlas& atlas, std::vector<std::byte>& bytes, float em, const Scale& scale) {
  const auto pixels = static_cast<float>(em * kLineHeightPerEm * scale.interface * scale.density);
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = false;
  if (is_font(bytes)) {
    return atlas.AddFontFromMemoryTTF(bytes.data(), static_cast<int>(bytes.size()),
                                      std::round(pixels), &config, kRanges.data());
  }
  ImFontConfig fallback;
  fallback.SizePixels = std::round(pixels / kLineHeightPerEm);
  return atlas.AddFontDefault(&fallback);
}

void make_figures_tabular(ImFont& font) {
  const auto is_figure = [](const ImFontGlyph& glyph) {
    return glyph.Codepoint >= '0' && glyph.Codepoint <= '9';
  };
  float widest = 0.0F;
  for (const ImFontGlyph& glyph : font.Glyphs) {
    if (is_figure(glyph)) {
      widest = std::max(widest, std::round(glyph.AdvanceX));
    }
  }
  for (ImFontGlyph& glyph : font.Glyphs) {
    if (is_figure(glyph)) {
      const float shift = std::round((widest - glyph.AdvanceX) / 2.0F);
      glyph.X0 += shift;
      glyph.X1 += shift;
      glyph.AdvanceX = widest;
    }
  }
  font.BuildLookupTable();
}

}  // namespace

std::span<const FontPaths> font_candidates() noexcept {
  static constexpr std::array<FontPaths, 4> kPaths{{
      {"/usr/share/fonts/opentype/inter/Inter-Regular.otf",
       "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf"},
      {"/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
       "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf"},
      {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
       "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"},
      {"/usr/share/fonts/TTF/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans-Bold.ttf"},
  }};
  return kPaths;
}

Fonts build_fonts(ImFontAtlas& atlas, FontFiles& files, const Scale& scale) {
  atlas.Clear();
  atlas.TexGlyphPadding = 1;
  Fonts fonts;
  fonts.body = add(atlas, files.regular, 15.0F, scale);
  fonts.body_strong = add(atlas, files.semi_bold, 15.0F, scale);
  fonts.small = add(atlas, files.regular, 13.0F, scale);
  fonts.head = add(atlas, files.semi_bold, 12.0F, scale);
  atlas.Build();
  for (ImFont* font : atlas.Fonts) {
    make_figures_tabular(*font);
  }
  return fonts;
}

}  // namespace limn::ui

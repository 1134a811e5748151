// Eight lines, always, deepest below: nothing moves while one paints. The last line stands for all
// depths that share the palette's last colour.

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/format.h"
#include "ui/panels.h"

namespace limn::ui {
namespace {

constexpr int kLines = 8;

struct Metrics {
  float padding, line, swatch, width;
};

Metrics metrics(const LegendLook& look) {
  const float u = look.unit;
  return {10.0F * u, 21.0F * u, 14.0F * u, 132.0F * u};
}

}  // namespace

WindowSize legend_size(const LegendLook& look) {
  const Metrics m = metrics(look);
  return {static_cast<double>(m.width), static_cast<double>(2.0F * m.padding + kLines * m.line)};
}

void draw_legend(ImDrawList& list, const LegendLook& look, const DepthCounts& counts,
                 ImVec2 origin) {
  const Metrics m = metrics(look);
  const WindowSize size = legend_size(look);
  ImFont* font = look.fonts.small;
  const float height = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const auto width_of = [&](const std::string& text) {
    return font->CalcTextSizeA(height, 1.0e6F, 0.0F, text.c_str()).x;
  };
  list.AddRectFilled(
      origin,
      {origin.x + static_cast<float>(size.width), origin.y + static_cast<float>(size.height)},
      look.colours.overlay, 6.0F * look.unit);
  for (int line = 0; line < kLines; ++line) {
    const bool is_last = line == kLines - 1;
    std::size_t count = counts[static_cast<std::size_t>(line)];
    for (std::size_t deeper = kLines; is_last && deeper < counts.size(); ++deeper) {
      count += counts[deeper];
    }
    const float top = origin.y + m.padding + static_cast<float>(line) * m.line;
    const float text_y = std::floor(top + (m.line - height) / 2.0F);
    const ImVec2 low{origin.x + m.padding, std::floor(top + (m.line - m.swatch) / 2.0F)};
    const ImVec2 high{low.x + m.swatch, low.y + m.swatch};
    list.AddRectFilled(low, high, swatch_colour(line), 3.0F * look.unit);
    const ImU32 ink = count > 0 ? look.colours.text : faded(look.colours.dim_text, 0.6F);
    const std::string name = std::to_string(line) + (is_last ? "+" : "");
    list.AddText(font, height, {high.x + 8.0F * look.unit, text_y}, ink, name.c_str());
    const std::string figure = grouped(count);
    const float right = origin.x + m.width - m.padding;
    list.AddText(font, height, {std::floor(right - width_of(figure)), text_y}, ink, figure.c_str());
  }
}

}  // namespace limn::ui

// Eight lines, always, deepest below: nothing moves while one paints. The last line stands for all
// depths that share the palette's last colour.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "limn/comparison/distance_palette.h"
#include "ui/format.h"
#include "ui/panels.h"

namespace limn::ui {
namespace {

constexpr int kLines = 8;

constexpr int kColumns = 4;  // Of the compact form, whose cells are so many design units wide.
constexpr int kRows = kLines / kColumns;
constexpr float kCell = 70.0F;

struct Metrics {
  float padding, line, swatch, width, chip;
};

Metrics metrics(const LegendLook& look) {
  const float u = look.unit;
  return {10.0F * u, 21.0F * u, 14.0F * u, 132.0F * u, 17.0F * u};
}

/// "3", and "7+" for the last.
std::string line_name(int line) {
  return std::to_string(line) + (line == kLines - 1 ? "+" : "");
}

std::size_t count_of_line(const LegendCounts& counts, int line) {
  std::size_t count = counts.depths[static_cast<std::size_t>(line)];
  for (std::size_t deeper = kLines; line == kLines - 1 && deeper < counts.depths.size(); ++deeper) {
    count += counts.depths[deeper];
  }
  return count;
}

float crease_legend_width(const LegendLook& look) {
  return 168.0F * look.unit;
}

constexpr int kDistanceLines = 5;

float distance_legend_width(const LegendLook& look) {
  return 196.0F * look.unit;
}

float valence_legend_width(const LegendLook& look) {
  return 196.0F * look.unit;
}

/// Draws the lines of one legend, from the upper left corner of the box on.
class Lines {
 public:
  Lines(ImDrawList& list, const LegendLook& look, ImVec2 origin, const WindowSize& size)
      : list_(list),
        look_(look),
        origin_(origin),
        metrics_(metrics(look)),
        width_(static_cast<float>(size.width)),
        height_(look.fonts.small->FontSize * ImGui::GetIO().FontGlobalScale) {
    list.AddRectFilled(origin, {origin.x + width_, origin.y + static_cast<float>(size.height)},
                       look.colours.overlay, 6.0F * look.unit);
  }

  /// Where the next line's swatch goes.
  struct Place {
    ImVec2 low;
    ImVec2 high;
  };
  [[nodiscard]] Place swatch() const {
    const float top = origin_.y + metrics_.padding + static_cast<float>(line_) * metrics_.line;
    const ImVec2 low{origin_.x + metrics_.padding,
                     std::floor(top + (metrics_.line - metrics_.swatch) / 2.0F)};
    return {low, {low.x + metrics_.swatch, low.y + metrics_.swatch}};
  }
  /// A line of text alone.
  void title(const char* text) {
    const float top = origin_.y + metrics_.padding + static_cast<float>(line_) * metrics_.line;
    list_.AddText(
        look_.fonts.small, height_,
        {origin_.x + metrics_.padding, std::floor(top + (metrics_.line - height_) / 2.0F)},
        look_.colours.dim_text, text);
    ++line_;
  }
  /// Two figures beside it; goes on to the next line.
  void figures(const std::string& name, const std::string& figure) {
    put(name, figure, look_.colours.text);
  }
  /// The text beside it; goes on to the next line.
  void text(const std::string& name, std::size_t count) {
    put(name, grouped(count), count > 0 ? look_.colours.text : faded(look_.colours.dim_text, 0.6F));
  }

 private:
  void put(const std::string& name, const std::string& figure, ImU32 ink) {
    const float top = origin_.y + metrics_.padding + static_cast<float>(line_) * metrics_.line;
    const float y = std::floor(top + (metrics_.line - height_) / 2.0F);
    ImFont* font = look_.fonts.small;
    list_.AddText(font, height_, {swatch().high.x + 8.0F * look_.unit, y}, ink, name.c_str());
    const float figure_width = font->CalcTextSizeA(height_, 1.0e6F, 0.0F, figure.c_str()).x;
    list_.AddText(font, height_,
                  {std::floor(origin_.x + width_ - metrics_.padding - figure_width), y}, ink,
                  figure.c_str());
    ++line_;
  }

  ImDrawList& list_;
  const LegendLook& look_;
  ImVec2 origin_;
  Metrics metrics_;
  float width_;
  float height_;
  int line_ = 0;
};

WindowSize size_of(const LegendLook& look, float width, int lines) {
  const Metrics m = metrics(look);
  return {static_cast<double>(width),
          static_cast<double>(2.0F * m.padding + static_cast<float>(lines) * m.line)};
}

}  // namespace

WindowSize compact_legend_size(const LegendLook& look) {
  const Metrics m = metrics(look);
  return {static_cast<double>(2.0F * m.padding + static_cast<float>(kColumns) * kCell * look.unit),
          static_cast<double>(2.0F * m.padding + static_cast<float>(kRows) * m.line)};
}

void draw_compact_legend(ImDrawList& list, const LegendLook& look, const LegendCounts& counts,
                         ImVec2 origin) {
  const Metrics m = metrics(look);
  const WindowSize size = compact_legend_size(look);
  list.AddRectFilled(
      origin,
      {origin.x + static_cast<float>(size.width), origin.y + static_cast<float>(size.height)},
      look.colours.overlay, 6.0F * look.unit);
  ImFont* font = look.fonts.small;
  const float height = font->FontSize * ImGui::GetIO().FontGlobalScale;
  const auto text_at = [&](float x, float y, ImU32 ink, const std::string& text) {
    list.AddText(font, height, {std::floor(x), std::floor(y)}, ink, text.c_str());
  };
  for (int line = 0; line < kLines; ++line) {
    const auto [whole, rest] = std::div(line, kColumns);
    const auto column = static_cast<float>(rest);
    const auto row = static_cast<float>(whole);
    const ImVec2 low{std::floor(origin.x + m.padding + column * kCell * look.unit),
                     std::floor(origin.y + m.padding + row * m.line + (m.line - m.chip) / 2.0F)};
    const ImVec2 high{low.x + m.chip * 1.25F, low.y + m.chip};
    list.AddRectFilled(low, high, swatch_colour(line), 3.0F * look.unit);
    const std::string name = line_name(line);
    const float name_width = font->CalcTextSizeA(height, 1.0e6F, 0.0F, name.c_str()).x;
    const float y = low.y + (m.chip - height) / 2.0F;
    text_at((low.x + high.x - name_width) / 2.0F, y, text_on_swatch(line), name);
    const std::size_t count = count_of_line(counts, line);
    text_at(high.x + 5.0F * look.unit, y,
            count > 0 ? look.colours.text : faded(look.colours.dim_text, 0.6F), grouped(count));
  }
}

WindowSize legend_size(const LegendLook& look, Tint tint) {
  return size_of(look, metrics(look).width, kLines + (tint == Tint::kLevel ? 1 : 0));
}

void draw_legend(ImDrawList& list, const LegendLook& look, const LegendCounts& counts,
                 ImVec2 origin) {
  Lines lines(list, look, origin, legend_size(look, counts.tint));
  if (counts.tint == Tint::kLevel) {
    lines.title("Faces by level");
  }
  for (int line = 0; line < kLines; ++line) {
    const auto [low, high] = lines.swatch();
    list.AddRectFilled(low, high, swatch_colour(line), 3.0F * look.unit);
    lines.text(line_name(line), count_of_line(counts, line));
  }
}

WindowSize distance_legend_size(const LegendLook& look) {
  return size_of(look, distance_legend_width(look), kDistanceLines + 1);
}

void draw_distance_legend(ImDrawList& list, const LegendLook& look, const DistanceFigures& figures,
                          ImVec2 origin) {
  Lines lines(list, look, origin, distance_legend_size(look));
  lines.title("Distance to the limit");
  const ImVec2 top = lines.swatch().low;
  ImVec2 foot = top;
  for (int line = 0; line < kDistanceLines; ++line) {
    foot.y = lines.swatch().high.y;
    const double part = 1.0 - static_cast<double>(line) / (kDistanceLines - 1);
    const double distance = part * figures.greatest();
    lines.figures(line + 1 < kDistanceLines ? distance_text(distance) : "0",
                  line + 1 < kDistanceLines ? diagonal_text(distance, figures.diagonal) : "0 %");
  }
  // A bar beside all lines, the greatest on top.
  const float width = metrics(look).swatch;
  constexpr int kPieces = 2 * (kDistanceLines - 1);
  const auto colour = [](int piece) {
    const Rgb at = distance_colour(1.0 - static_cast<double>(piece) / kPieces);
    return IM_COL32(at.red, at.green, at.blue, 0xFF);
  };
  for (int piece = 0; piece < kPieces; ++piece) {
    const auto y = [&](int i) {
      return std::floor(top.y + (foot.y - top.y) * static_cast<float>(i) / kPieces);
    };
    list.AddRectFilledMultiColor({top.x, y(piece)}, {top.x + width, y(piece + 1)}, colour(piece),
                                 colour(piece), colour(piece + 1), colour(piece + 1));
  }
}

bool has_creases(const CreaseCounts& counts) noexcept {
  return std::any_of(counts.begin(), counts.end(), [](std::size_t count) { return count > 0; });
}

WindowSize crease_legend_size(const LegendLook& look) {
  return size_of(look, crease_legend_width(look), static_cast<int>(kSharpnessBands) + 1);
}

void draw_crease_legend(ImDrawList& list, const LegendLook& look, const CreaseCounts& counts,
                        ImVec2 origin) {
  Lines lines(list, look, origin, crease_legend_size(look));
  lines.title("Crease sharpness");
  for (std::size_t band = 0; band < kSharpnessBands; ++band) {
    const auto [low, high] = lines.swatch();
    const Rgb colour = crease_palette()[band];
    const float middle = std::floor((low.y + high.y) / 2.0F);
    list.AddLine({low.x, middle}, {high.x, middle}, IM_COL32(0x12, 0x12, 0x14, 0xBF),
                 6.0F * look.unit);
    list.AddLine({low.x, middle}, {high.x, middle},
                 IM_COL32(colour.red, colour.green, colour.blue, 0xFF), 3.5F * look.unit);
    lines.text(sharpness_band_name(band), counts[band]);
  }
}

bool has_valences(const ValenceCounts& counts) noexcept {
  return std::any_of(counts.begin(), counts.end(), [](std::size_t count) { return count > 0; });
}

WindowSize valence_legend_size(const LegendLook& look) {
  return size_of(look, valence_legend_width(look), static_cast<int>(kValenceBands) + 1);
}

void draw_valence_legend(ImDrawList& list, const LegendLook& look, const ValenceCounts& counts,
                         ImVec2 origin) {
  Lines lines(list, look, origin, valence_legend_size(look));
  lines.title("Edges at a vertex");
  for (std::size_t band = 0; band < kValenceBands; ++band) {
    const auto [low, high] = lines.swatch();
    const Rgb colour = valence_palette()[band];
    list.AddCircleFilled({(low.x + high.x) / 2.0F, (low.y + high.y) / 2.0F}, 6.5F * look.unit,
                         IM_COL32(colour.red, colour.green, colour.blue, 0xFF));
    lines.text(valence_band_name(band), counts[band]);
  }
}

}  // namespace limn::ui

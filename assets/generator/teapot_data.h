#pragma once

#include <array>

#include <glm/vec3.hpp>

/// Martin Newell's teapot of 1975 in Jim Blinn's proportions: the control points of its 32 bicubic
/// Bezier patches, z up, as published with the data set (University of Utah).
///
/// Rim, body, lid and bottom are the same patch four times around the axis, so a row of such a
/// patch is told by three numbers; handle and spout are given on one side of the plane y = 0.
namespace limn::generator::teapot {

/// A row of control points of a patch around the axis: (radius, 0), (radius, tangent),
/// (tangent, radius), (0, radius) at this height.
struct Row {
  double radius, tangent, height;
};

/// Rows along a profile; every patch shares its last row with the first of the next one.
inline constexpr std::array kRim = {Row{1.4, 0.784, 2.4}, Row{1.3375, 0.749, 2.53125},
                                    Row{1.4375, 0.805, 2.53125}, Row{1.5, 0.84, 2.4}};
inline constexpr std::array kUpperBody = {Row{1.5, 0.84, 2.4}, Row{1.75, 0.98, 1.875},
                                          Row{2.0, 1.12, 1.35}, Row{2.0, 1.12, 0.9}};
inline constexpr std::array kLowerBody = {Row{2.0, 1.12, 0.9}, Row{2.0, 1.12, 0.45},
                                          Row{1.5, 0.84, 0.225}, Row{1.5, 0.84, 0.15}};
inline constexpr std::array kBottom = {Row{1.5, 0.84, 0.15}, Row{1.5, 0.84, 0.075},
                                       Row{1.425, 0.798, 0.0}, Row{0.0, 0.0, 0.0}};
inline constexpr std::array kKnob = {Row{0.0, 0.0, 3.15}, Row{0.8, 0.45, 3.15}, Row{0.0, 0.0, 2.85},
                                     Row{0.2, 0.112, 2.7}};
inline constexpr std::array kLid = {Row{0.2, 0.112, 2.7}, Row{0.4, 0.224, 2.55},
                                    Row{1.3, 0.728, 2.55}, Row{1.3, 0.728, 2.4}};

/// Rows of control points along handle and spout, from y = 0 over the near side back to y = 0.
using Arc = std::array<glm::dvec3, 4>;

inline constexpr std::array kHandle = {
    Arc{{{-1.6, 0, 2.025}, {-1.6, -0.3, 2.025}, {-1.5, -0.3, 2.25}, {-1.5, 0, 2.25}}},
    Arc{{{-2.3, 0, 2.025}, {-2.3, -0.3, 2.025}, {-2.5, -0.3, 2.25}, {-2.5, 0, 2.25}}},
    Arc{{{-2.7, 0, 2.025}, {-2.7, -0.3, 2.025}, {-3.0, -0.3, 2.25}, {-3.0, 0, 2.25}}},
    Arc{{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3.0, -0.3, 1.8}, {-3.0, 0, 1.8}}},
    Arc{{{-2.7, 0, 1.575}, {-2.7, -0.3, 1.575}, {-3.0, -0.3, 1.35}, {-3.0, 0, 1.35}}},
    Arc{{{-2.5, 0, 1.125}, {-2.5, -0.3, 1.125}, {-2.65, -0.3, 0.9375}, {-2.65, 0, 0.9375}}},
    Arc{{{-2.0, 0, 0.9}, {-2.0, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0, 0.6}}},
};

inline constexpr std::array kSpout = {
    Arc{{{1.7, 0, 1.425}, {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0, 0.6}}},
    Arc{{{2.6, 0, 1.425}, {2.6, -0.66, 1.425}, {3.1, -0.66, 0.825}, {3.1, 0, 0.825}}},
    Arc{{{2.3, 0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025}, {2.4, 0, 2.025}}},
    Arc{{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}},
    Arc{{{2.8, 0, 2.475}, {2.8, -0.25, 2.475}, {3.525, -0.25, 2.49375}, {3.525, 0, 2.49375}}},
    Arc{{{2.9, 0, 2.475}, {2.9, -0.15, 2.475}, {3.45, -0.15, 2.5125}, {3.45, 0, 2.5125}}},
    Arc{{{2.8, 0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0, 2.4}}},
};

}  // namespace limn::generator::teapot

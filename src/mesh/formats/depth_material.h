#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace limn::detail {

/// The material library that goes with the materials below.
inline constexpr std::string_view DepthLibrary = "limn_depths.mtl";

/// The depth that a material such as `depth_3` stands for; also `depth_3.001`, as programs call
/// the second material of a name.
[[nodiscard]] std::optional<std::uint32_t> depth_of_material(std::string_view name) noexcept;

}  // namespace limn::detail

#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

namespace limn {

/// The mesh files that Limn reads and writes.
enum class MeshFormat { kObj, kPly, kOff, kStl };

inline constexpr std::array MeshFormats{MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff,
                                        MeshFormat::kStl};

/// "OBJ"
[[nodiscard]] std::string_view name_of(MeshFormat format) noexcept;
/// ".obj"
[[nodiscard]] std::string_view ending_of(MeshFormat format) noexcept;
/// The format that the ending of a name stands for, in either case; nothing for other endings.
[[nodiscard]] std::optional<MeshFormat> format_by_ending(const std::filesystem::path& path);

}  // namespace limn

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "limn/error.h"

namespace limn::detail {

enum class PlyEncoding { kAscii, kLittleEndian, kBigEndian };

enum class PlyType {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64
};

[[nodiscard]] std::size_t size_of(PlyType type) noexcept;

struct PlyProperty {
  std::string_view name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< Of a list: the type of its length.
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::uint32_t line = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::kAscii;
  std::vector<PlyElement> elements;
  std::vector<std::string_view> remarks;  ///< What `obj_info` lines say.
  std::size_t size = 0;                   ///< Bytes up to the data.
  std::uint32_t lines = 0;
};

/// Reads a header; its words are views into `bytes`. What it announces is held against the number
/// of bytes that follow.
[[nodiscard]] Result<PlyHeader> read_ply_header(std::string_view bytes, const std::string& source);

}  // namespace limn::detail

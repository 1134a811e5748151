#pragma once

namespace limn {

/// The mesh files that Limn reads and writes.
enum class MeshFormat { kObj, kPly, kOff, kStl };

}  // namespace limn

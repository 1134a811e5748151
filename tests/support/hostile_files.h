#pragma once

#include <string>
#include <vector>

namespace limn::test {

/// A file made to do harm, or by accident.
struct HostileFile {
  std::string name;  ///< With the ending it comes with.
  std::string bytes;
  bool is_bad = true;  ///< Must be refused. Otherwise it may be read, if it gives a sound mesh.
};

/// Small sound files of every format and encoding, to cut and bend.
[[nodiscard]] std::vector<HostileFile> sound_files();

/// What is no mesh, counts that lie, numbers that are none, indices that point nowhere, texts
/// without end; a few hundred. `scale` 1 keeps the large ones below half a megabyte.
[[nodiscard]] std::vector<HostileFile> hostile_files(std::size_t scale = 1);

}  // namespace limn::test

// Whatever a file holds, the answer is a sound mesh or an error with a message, soon.
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/export.h"
#include "limn/mesh/import.h"
#include "mesh/mesh_checks.h"
#include "support/effort.h"
#include "support/hostile_files.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

using testing::IsEmpty;
using testing::StartsWith;

void expect_answer(const Result<ImportedMesh>& imported, const std::string& path) {
  if (imported) {
    EXPECT_THAT(test::faults_of(*imported->mesh), IsEmpty());
  } else {
    EXPECT_EQ(imported.error().kind, ErrorKind::kBadInput);
    EXPECT_THAT(to_string(imported.error()), StartsWith(path));
    EXPECT_FALSE(imported.error().message.empty());
  }
}

/// Whatever came in goes out in any format.
void expect_writable(const ControlMesh& mesh) {
  for (const MeshFormat format : MeshFormats) {
    std::ostringstream out;
    write_mesh(out, format, mesh);
    const auto soup = read_soup(out.str(), format, "written");
    EXPECT_TRUE(soup.has_value()) << name_of(format) << ": " << to_string(soup.error());
  }
}

TEST(HostileFiles, AreRefusedOrRead) {
  const std::vector<test::HostileFile> files = test::hostile_files();
  EXPECT_GE(files.size(), 150U);
  const test::ScratchFolder folder;
  for (const test::HostileFile& file : files) {
    SCOPED_TRACE(file.name);
    const std::filesystem::path path = folder.path() / file.name;
    test::write_file(path, file.bytes);
    const auto imported = import_mesh(path);
    expect_answer(imported, path.string());
    EXPECT_FALSE(imported.has_value() && file.is_bad);
    std::filesystem::remove(path);
  }
}

TEST(HostileFiles, SoundOnesAreRead) {
  for (const test::HostileFile& file : test::sound_files()) {
    SCOPED_TRACE(file.name);
    const auto imported = import_bytes(file.bytes, format_by_ending(file.name), file.name);
    ASSERT_TRUE(imported.has_value()) << to_string(imported.error());
    EXPECT_THAT(test::faults_of(*imported->mesh), IsEmpty());
    EXPECT_THAT(imported->report.sentences().size(), testing::Le(5U));
  }
}

/// The last word of a text, or the last byte of binary data, without which a file is not whole.
std::size_t last_part(const test::HostileFile& file) {
  const bool is_text = file.bytes.find('\0') == std::string::npos;
  const std::size_t end = file.bytes.find_last_not_of(" \r\n");
  return is_text ? file.bytes.find_last_of(" \r\n", end) : file.bytes.size() - 1;
}

TEST(HostileFiles, CutAnywhere) {
  for (const test::HostileFile& file : test::sound_files()) {
    // What ends an OBJ, a colour or one of two solids leaves something whole.
    const bool is_open_ended = file.name.ends_with(".obj") || file.name == "sound_rich.off" ||
                               file.name == "sound_two.stl";
    for (std::size_t size = 0; size < file.bytes.size(); ++size) {
      const auto imported =
          import_bytes(file.bytes.substr(0, size), format_by_ending(file.name), file.name);
      expect_answer(imported, file.name);
      EXPECT_FALSE(imported.has_value() && !is_open_ended && size <= last_part(file))
          << file.name << " cut to " << size;
    }
  }
}

TEST(HostileFiles, BentAnywhere) {
  std::mt19937 random(11);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  const std::vector<test::HostileFile> files = test::sound_files();
  const std::string alphabet = "0123456789-+./ \n\\#";
  std::size_t accepted = 0;
  const auto rounds = static_cast<std::size_t>(12000.0 * test::effort());
  for (std::size_t round = 0; round < rounds; ++round) {
    const test::HostileFile& file = files[round % files.size()];
    std::string bytes = file.bytes;
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
      switch (below(4)) {
        case 0:
          bytes[below(bytes.size())] = static_cast<char>(below(256));
          break;
        case 1:
          bytes[below(bytes.size())] = alphabet[below(alphabet.size())];
          break;
        case 2:
          bytes.insert(below(bytes.size()), bytes.substr(below(bytes.size()), below(12)));
          break;
        default:
          bytes.erase(below(bytes.size() - 1), below(6));
      }
    }
    const auto imported = import_bytes(bytes, format_by_ending(file.name), file.name);
    expect_answer(imported, file.name);
    if (imported) {
      ++accepted;
      expect_writable(*imported->mesh);
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << bytes;
  }
  EXPECT_GT(accepted, rounds / 20);
  EXPECT_LT(accepted, rounds * 19 / 20);
}

}  // namespace
}  // namespace limn

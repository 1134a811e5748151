// Files as the operating system has them.
#include <cstdio>
#include <filesystem>
#include <string>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limn/mesh/import.h"
#include "mesh/mesh_checks.h"
#include "support/scratch_folder.h"

namespace limn {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

class ImportMesh : public testing::Test {
 protected:
  fs::path write(const std::string& name, const std::string& text) const {
    test::write_file(folder_ / name, text);
    return folder_ / name;
  }
  /// The message of a path that must be refused; its error names the path.
  static std::string refusal(const fs::path& path) {
    const auto imported = import_mesh(path);
    if (imported.has_value()) {
      return "accepted";
    }
    EXPECT_EQ(imported.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(imported.error().path, path.string());
    return imported.error().message;
  }

  const test::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

TEST_F(ImportMesh, ReadsFilesWhateverTheCaseOfTheirEnding) {
  for (const char* name : {"a.obj", "b.OBJ", "c.d.Obj", "name with spaces \xC3\xA4.obj"}) {
    const auto imported = import_mesh(write(name, kTriangle));
    ASSERT_TRUE(imported.has_value()) << to_string(imported.error());
    EXPECT_EQ(imported->mesh->face_count(), 1U);
  }
  fs::create_symlink(folder_ / "a.obj", folder_ / "link.obj");
  EXPECT_TRUE(import_mesh(folder_ / "link.obj").has_value());
}

TEST_F(ImportMesh, ErrorsInTheTextNameThePathAndTheLine) {
  const fs::path path = write("bad.obj", kTriangle + "f 1 2 x\n");
  const auto imported = import_mesh(path);
  ASSERT_FALSE(imported.has_value());
  EXPECT_THAT(to_string(imported.error()), StartsWith(path.string() + ":5: \"x\" is not"));
}

TEST_F(ImportMesh, NeverOpensMaterials) {
  // Reading a pipe that nobody writes to would wait for ever.
  ASSERT_EQ(::mkfifo((folder_ / "pipe.mtl").c_str(), 0600), 0);
  EXPECT_TRUE(import_mesh(write("a.obj", "mtllib pipe.mtl\n" + kTriangle)).has_value());
}

TEST_F(ImportMesh, ReadsUtf16WithItsMark) {
  for (const bool is_big : {false, true}) {
    std::string wide = is_big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char16_t unit : std::u16string(u"# \u00E4 \u20AC \U0001F404 \n")) {
      wide += static_cast<char>(is_big ? unit >> 8 : unit & 255);
      wide += static_cast<char>(is_big ? unit & 255 : unit >> 8);
    }
    for (const char c : kTriangle + "o \n") {
      wide += is_big ? '\0' : c;
      wide += is_big ? c : '\0';
    }
    const auto imported = import_mesh(write("wide.obj", wide));
    ASSERT_TRUE(imported.has_value()) << to_string(imported.error());
    EXPECT_EQ(imported->mesh->face_count(), 1U);
    // Without the mark it is binary data, and cut off within a character it ends there.
    EXPECT_THAT(refusal(write("unmarked.obj", wide.substr(2))), HasSubstr("binary data"));
    EXPECT_TRUE(import_mesh(write("cut.obj", wide + '\xD8')).has_value());
  }
}

TEST_F(ImportMesh, TheContentSaysMoreThanTheEnding) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  const std::string stl =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
      "endloop\nendfacet\nendsolid\n";
  for (const std::string& text : {kTriangle, ply, off, stl}) {
    for (const char* name : {"a.obj", "a.PLY", "a.off", "a.Stl", "a.txt", "a", "a.limn"}) {
      const auto imported = import_mesh(write(name, text));
      ASSERT_TRUE(imported.has_value()) << to_string(imported.error());
      EXPECT_EQ(imported->mesh->face_count(), 1U);
      EXPECT_EQ(imported->mesh->positions()[1], glm::dvec3(1.0, 0.0, 0.0));
    }
  }
  EXPECT_EQ(refusal(write("notes.txt", "Dear diary,\n")),
            "Neither its name nor its content is that of a mesh; OBJ, PLY, OFF and STL files are "
            "read.");
}

TEST_F(ImportMesh, RefusesWhatCannotBeRead) {
  EXPECT_EQ(refusal(folder_ / "missing.obj"), "There is no such file.");
  EXPECT_EQ(refusal(""), "There is no such file.");
  fs::create_directory(folder_ / "folder.obj");
  EXPECT_THAT(refusal(folder_ / "folder.obj"), HasSubstr("is a folder"));
  EXPECT_THAT(refusal(folder_), HasSubstr("is a folder"));
  EXPECT_THAT(refusal(write("a.obj", kTriangle) / "b.obj"), HasSubstr("Not a directory"));
  EXPECT_THAT(refusal(folder_ / (std::string(5000, 'x') + ".obj")), HasSubstr("Cannot read"));
  fs::create_symlink("loop.obj", folder_ / "loop.obj");
  EXPECT_THAT(refusal(folder_ / "loop.obj"), HasSubstr("Cannot read"));
  if (::geteuid() != 0) {  // Nothing is unreadable for root.
    const fs::path secret = write("secret.obj", kTriangle);
    fs::permissions(secret, fs::perms::none);
    EXPECT_THAT(refusal(secret), HasSubstr("Permission denied"));
  }
}

TEST_F(ImportMesh, RefusesPipesDevicesAndSocketsAtOnce) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_THAT(refusal(folder_ / "pipe.obj"), HasSubstr("not a regular file"));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("not a regular file"));
  EXPECT_THAT(refusal("/dev/null"), HasSubstr("not a regular file"));
  fs::create_symlink("/dev/zero", folder_ / "zero.obj");
  EXPECT_THAT(refusal(folder_ / "zero.obj"), HasSubstr("not a regular file"));

  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", (folder_ / "socket.obj").c_str());
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_THAT(refusal(folder_ / "socket.obj"), HasSubstr("Cannot read"));
  ::close(socket);
}

TEST_F(ImportMesh, RefusesEmptyBinaryAndHugeFiles) {
  EXPECT_EQ(refusal(write("empty.obj", "")), "The file is empty.");
  EXPECT_THAT(refusal(write("binary.obj", std::string("\1\2ELF\0\1\2", 8))),
              HasSubstr("binary data"));
  const fs::path huge = write("huge.obj", kTriangle);
  if (::truncate(huge.c_str(), off_t{5} << 30) == 0) {  // Sparse: takes no room on the disk.
    EXPECT_EQ(refusal(huge), "The file has 5368709120 bytes; files of up to 4 GiB are read.");
  }
}

}  // namespace
}  // namespace limn

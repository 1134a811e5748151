#include "ui/format.h"

#include <gtest/gtest.h>

#include <limits>

namespace limn::ui {
namespace {

TEST(Format, CountsAreGroupedByThousands) {
  EXPECT_EQ(grouped(std::uint64_t{0}), "0");
  EXPECT_EQ(grouped(std::uint64_t{999}), "999");
  EXPECT_EQ(grouped(std::uint64_t{1000}), "1,000");
  EXPECT_EQ(grouped(std::uint64_t{1234567}), "1,234,567");
  EXPECT_EQ(grouped(std::numeric_limits<std::uint64_t>::max()), "18,446,744,073,709,551,615");
  EXPECT_EQ(grouped(-1024L), "-1,024");
  EXPECT_EQ(grouped(std::numeric_limits<long>::min()), "-9,223,372,036,854,775,808");
}

TEST(Format, NounsFollowTheirCount) {
  EXPECT_EQ(counted(1, "face"), "1 face");
  EXPECT_EQ(counted(0, "face"), "0 faces");
  EXPECT_EQ(counted(2, "vertex", "vertices"), "2 vertices");
}

TEST(Format, BytesHaveThreeFiguresAtMost) {
  EXPECT_EQ(bytes_text(812), "812 B");
  EXPECT_EQ(bytes_text(1000), "1.0 kB");
  EXPECT_EQ(bytes_text(1449999), "1.4 MB");
  EXPECT_EQ(bytes_text(999999), "1.0 MB");
  EXPECT_EQ(bytes_text(48'000'000'000), "48 GB");
  EXPECT_EQ(bytes_text(std::numeric_limits<std::uint64_t>::max()), "18 EB");
}

TEST(Format, SecondsAndPercent) {
  EXPECT_EQ(seconds_text(0.0000158), "16 µs");
  EXPECT_EQ(seconds_text(0.0000994), "99 µs");
  EXPECT_EQ(seconds_text(0.0001), "0.1 ms");
  EXPECT_EQ(seconds_text(0.0004), "0.4 ms");
  EXPECT_EQ(seconds_text(0.012), "12 ms");
  EXPECT_EQ(seconds_text(3.21), "3.2 s");
  EXPECT_EQ(seconds_text(0.9999), "1.0 s");
  EXPECT_EQ(percent_text(31, 100), "31 %");
  EXPECT_EQ(percent_text(0.4, 100), "0.4 %");
  EXPECT_EQ(percent_text(0, 100), "0 %");
  EXPECT_EQ(percent_text(3, 0), "–");
}

}  // namespace
}  // namespace limn::ui

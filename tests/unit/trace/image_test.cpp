#include "trace/image.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <filesystem>

#include "base/contract.hpp"
#include "support/scratch.hpp"

namespace lamina::trace {
namespace {

TEST(ImageTest, RoundsAndCutsOffColors) {
  Image image({2, 1});
  image.set(1, 0, {0.5, -1, 2});
  EXPECT_EQ(image.at(1, 0), (std::array<std::uint8_t, 3>{128, 0, 255}));
  EXPECT_EQ(image.at(0, 0), (std::array<std::uint8_t, 3>{0, 0, 0}));
}

TEST(ImageTest, ReadsBackAsItWasWritten) {
  Image image({3, 2});
  for (int i = 0; i < 6; ++i) {
    image.set(i % 3, i / 3, {i / 5.0, 1 - i / 5.0, 0.25});
  }
  const test::Scratch scratch;
  write_png(image, scratch.path("image.png"));

  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_file(&description, scratch.path("image.png").c_str()), 0);
  EXPECT_EQ(description.width, 3U);
  EXPECT_EQ(description.height, 2U);
  description.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(description));
  ASSERT_NE(png_image_finish_read(&description, nullptr, bytes.data(), 0, nullptr), 0);
  EXPECT_EQ(bytes, image.bytes());
}

TEST(ImageTest, AskingWhetherAFileCanBeWrittenLeavesIt) {
  const test::Scratch scratch;
  const std::string kept = scratch.write("kept.png", "old");
  require_writable(kept);
  EXPECT_EQ(std::filesystem::file_size(kept), 3U);
  require_writable(scratch.path("new.png"));
  EXPECT_FALSE(std::filesystem::exists(scratch.path("new.png")));
  EXPECT_THROW(require_writable("/nowhere/image.png"), base::InputError);
}

TEST(ImageTest, SaysWhereItCannotWrite) {
  try {
    write_png(Image({1, 1}), "/nowhere/image.png");
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/image.png"), std::string::npos);
  }
}

}  // namespace
}  // namespace lamina::trace

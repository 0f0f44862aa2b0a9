// Pictures: pixels in memory, and PNG files.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "trace/camera.hpp"

namespace lamina::trace {

/// Red, green and blue in 0 .. 1; more is cut off where a picture is made of it.
using Color = geometry::Vector3<double>;

/// 8 bits for each of red, green and blue, rows from the top.
class Image {
 public:
  explicit Image(const ImageSize& size)
      : size_(size), bytes_(3 * static_cast<std::size_t>(size.width) * size.height) {}

  [[nodiscard]] const ImageSize& size() const { return size_; }
  /// Three bytes for each pixel.
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  /// (0, 0) is at the top left.
  [[nodiscard]] std::array<std::uint8_t, 3> at(int x, int y) const;
  /// Cut off to 0 .. 1 and rounded to one of 256 equal steps, without gamma; NaN is black.
  void set(int x, int y, const Color& color);

  friend bool operator==(const Image& a, const Image& b) { return a.bytes_ == b.bytes_; }

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * size_.width + x);
  }

  ImageSize size_;
  std::vector<std::uint8_t> bytes_;
};

/// Throws base::InputError if no file can be written there. Leaves what is there as it is.
void require_writable(const std::string& path);

/// Writes a PNG file. Throws base::InputError if it cannot be written.
void write_png(const Image& image, const std::string& path);

}  // namespace lamina::trace

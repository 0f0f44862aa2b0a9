#include "trace/image.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "base/contract.hpp"

namespace lamina::trace {

std::array<std::uint8_t, 3> Image::at(int x, int y) const {
  const std::size_t first = offset(x, y);
  return {bytes_[first], bytes_[first + 1], bytes_[first + 2]};
}

void Image::set(int x, int y, const Color& color) {
  const auto byte = [](double part) {
    if (std::isnan(part)) {
      return std::uint8_t{0};
    }
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
  };
  const std::size_t first = offset(x, y);
  bytes_[first] = byte(color.x);
  bytes_[first + 1] = byte(color.y);
  bytes_[first + 2] = byte(color.z);
}

void require_writable(const std::string& path) {
  const bool existed = std::filesystem::exists(path);
  if (!std::ofstream(path, std::ios::app)) {
    throw base::InputError(
        fmt::format("picture '{}' cannot be written: {}", path, std::strerror(errno)));
  }
  if (!existed) {
    std::filesystem::remove(path);
  }
}

void write_png(const Image& image, const std::string& path) {
  png_image description{};
  description.version = PNG_IMAGE_VERSION;
  description.width = static_cast<png_uint_32>(image.size().width);
  description.height = static_cast<png_uint_32>(image.size().height);
  description.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&description, path.c_str(), 0, image.bytes().data(), 0, nullptr) ==
      0) {
    throw base::InputError(
        fmt::format("picture '{}' cannot be written: {}", path, description.message));
  }
}

}  // namespace lamina::trace

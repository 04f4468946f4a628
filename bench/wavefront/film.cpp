#include "film.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace wavefront {
namespace {

std::uint8_t to_srgb(float linear) {
  const float value = std::clamp(linear, 0.0f, 1.0f);
  const float encoded = value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(255 * encoded));
}

}  // namespace

void write_exr(const Image& image, const std::filesystem::path& path) {
  Imf::Header header(image.width, image.height);
  Imf::FrameBuffer buffer;
  const char* const names[] = {"R", "G", "B"};
  Image copy = image;  // the frame buffer wants writable memory
  for (int channel = 0; channel < 3; ++channel) {
    header.channels().insert(names[channel], Imf::Channel(Imf::FLOAT));
    buffer.insert(names[channel], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&copy.pixels[0][channel]), sizeof(Rgb),
                                             sizeof(Rgb) * static_cast<std::size_t>(image.width)));
  }
  Imf::OutputFile file(path.string().c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(image.height);
}

void write_png(const Image& image, const std::filesystem::path& path) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) bytes.push_back(to_srgb(pixel[channel]));
  if (!stbi_write_png(path.string().c_str(), image.width, image.height, 3, bytes.data(), 3 * image.width))
    throw std::runtime_error("cannot write " + path.string());
}

double mean_squared_error(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel)
      sum += std::pow(static_cast<double>(a.pixels[i][channel]) - static_cast<double>(b.pixels[i][channel]), 2);
  return sum / (3.0 * static_cast<double>(a.pixels.size()));
}

}  // namespace wavefront

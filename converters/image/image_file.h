// SPDX-License-Identifier: Apache-2.0
// Files of pixels: PNG, JPEG, TIFF, PNM and OpenEXR, through OpenCV. BMP and WebP are read as well.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "libstyle/image/image.h"

namespace libstyle {

// How finely a file tells samples apart. Integers stand for 0 .. 1 in an Image.
enum class SampleDepth : std::uint8_t { k8, k16, kFloat };

struct ImageFile {
  Image image;
  SampleDepth depth = SampleDepth::k8;
};

// Reads a picture, or stdin for "-"; what it is shows in its content. JPEGs that lie on their side
// are turned as their camera says. Colours that a file has multiplied by alpha, as all EXR do, are
// divided by it. Grey with alpha comes as red, green, blue and alpha from a PNG. Throws Error in
// one line when the file is missing, a folder, no picture, cut off, has over 2^28 pixels or over 4
// channels, holds samples that are no finite numbers, or is of a kind that would be misread: a TIFF
// of grey and alpha, or of signed integers.
ImageFile read_image(const std::string& name);

enum class ImageFormat : std::uint8_t { kPng, kJpeg, kTiff, kPnm, kExr };

// By the end of a file's name: .png, .jpg, .jpeg, .tif, .tiff, .pnm, .ppm, .pgm, .exr.
std::optional<ImageFormat> image_format(std::string_view file_name);

// The depth nearest to `wanted` that the format has: PNG and PNM 8 and 16, JPEG 8, TIFF all, EXR
// float.
SampleDepth fitting_depth(ImageFormat format, SampleDepth wanted);

// The bytes of a file, the same each time, at the depth fitting_depth() says. Integer samples are
// cut to 0 .. 1 and rounded; JPEG has a quality of 95. JPEG and PNM have no alpha and leave it out;
// grey with alpha is written as red, green, blue and alpha. Throws Error, which names no place,
// when the picture has no pixels, over 4 channels, or does not fit into the format.
std::string encode_image(const Image& image, ImageFormat format, SampleDepth depth);

}  // namespace libstyle

// SPDX-License-Identifier: Apache-2.0
#include "converters/svg/document_input.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "converters/common/files.h"
#include "converters/svg/svg_reader.h"
#include "libstyle/curves/reader.h"

namespace libstyle {
namespace {

// A source whose next bytes can be looked at before they are read.
class PeekableSource final : public ByteSource {
 public:
  explicit PeekableSource(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {}

  // The first character that is no white space; nothing at the end.
  std::optional<char> first_character() {
    constexpr std::string_view kSpace = " \t\r\n";
    while (true) {
      const auto at = ahead_.find_first_not_of(kSpace);
      if (at != std::string::npos) return ahead_[at];
      char bytes[4096];
      const std::size_t count = source_->read(bytes);
      if (count == 0) return std::nullopt;
      ahead_.append(bytes, count);
    }
  }

  std::size_t read(std::span<char> buffer) override {
    if (ahead_.empty()) return source_->read(buffer);
    const std::size_t count = std::min(buffer.size(), ahead_.size());
    std::memcpy(buffer.data(), ahead_.data(), count);
    ahead_.erase(0, count);
    return count;
  }

 private:
  std::unique_ptr<ByteSource> source_;
  std::string ahead_;
};

}  // namespace

class DocumentInput::Implementation {
 public:
  Implementation(const std::string& name, WarningHandler warn)
      : name_(name), warn_(std::move(warn)), source_(open_input(name)) {}

  bool read(Document& document) {
    if (!opened_) open();
    opened_ = true;
    if (reader_) return reader_->read(document);
    document = std::move(drawing_);
    drawing_ = {};
    return std::exchange(drawing_is_left_, false);
  }

 private:
  void open() {
    const auto first = source_.first_character();
    if (!first || *first == '{') {
      reader_.emplace(source_, display_name(name_));
      return;
    }
    const svg::SvgReadOptions options;
    drawing_ = svg::read_svg(read_all(source_, options.limits.xml.bytes, display_name(name_)),
                             display_name(name_), options, warn_);
    drawing_.header.name = document_name(name_);
    drawing_is_left_ = true;
  }

  const std::string name_;
  const WarningHandler warn_;
  PeekableSource source_;
  bool opened_ = false;
  std::optional<Reader> reader_;  // of curves
  Document drawing_;              // of SVG
  bool drawing_is_left_ = false;
};

DocumentInput::DocumentInput(const std::string& name, WarningHandler warn)
    : implementation_(std::make_unique<Implementation>(name, std::move(warn))) {}

DocumentInput::~DocumentInput() = default;

bool DocumentInput::read(Document& document) { return implementation_->read(document); }

}  // namespace libstyle

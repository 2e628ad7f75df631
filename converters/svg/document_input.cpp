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
  explicit Implementation(const std::string& name) : name_(name), source_(open_input(name)) {}

  bool take(TakenDocument& taken) {
    taken.input = name_;
    if (!opened_) return open(taken);
    return reader_ && reader_->read(taken.content.emplace<Document>());
  }

 private:
  bool open(TakenDocument& taken) {
    opened_ = true;
    const auto first = source_.first_character();
    if (!first || *first == '{') {
      reader_.emplace(source_, display_name(name_));
      return take(taken);
    }
    taken.content = read_all(source_, svg::SvgLimits().xml.bytes, display_name(name_));
    return true;
  }

  const std::string name_;
  PeekableSource source_;
  bool opened_ = false;
  std::optional<Reader> reader_;  // of curves
};

Document to_document(TakenDocument taken, const WarningHandler& warn) {
  if (auto* document = std::get_if<Document>(&taken.content)) return std::move(*document);
  Document drawing = svg::read_svg(std::move(std::get<std::string>(taken.content)),
                                   display_name(taken.input), {}, warn);
  drawing.header.name = document_name(taken.input);
  return drawing;
}

DocumentInput::DocumentInput(const std::string& name, WarningHandler warn)
    : implementation_(std::make_unique<Implementation>(name)), warn_(std::move(warn)) {}

DocumentInput::~DocumentInput() = default;

bool DocumentInput::take(TakenDocument& taken) { return implementation_->take(taken); }

bool DocumentInput::read(Document& document) {
  TakenDocument taken;
  const bool is_there = take(taken);
  document = is_there ? to_document(std::move(taken), warn_) : Document();
  return is_there;
}

bool DocumentInputs::take(TakenDocument& taken) {
  taken.number = ++number_;
  for (;;) {
    if (!input_) {
      if (opened_ == names_.size()) return false;
      const std::string& name = names_[opened_++];
      input_ = std::make_unique<DocumentInput>(name, WarningHandler());
      is_untouched_ = true;
    }
    const bool is_untouched = std::exchange(is_untouched_, false);
    if (input_->take(taken)) return true;
    input_.reset();
    if (is_untouched) {
      throw Error({display_name(taken.input)},
                  "holds no document; a document begins with a header line");
    }
  }
}

}  // namespace libstyle

// SPDX-License-Identifier: Apache-2.0
// Which groups and elements stand around a record: for programs that go through a document and open
// and close what they draw into.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "libstyle/curves/document.h"

namespace libstyle {

// The place in the document of the container of each record.
class Containers {
 public:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  explicit Containers(const Document& document);

  // The group or element that the record at `place` is in. kNone for the document itself, and for a
  // container that is not there or comes later, which a record cannot be in.
  std::size_t of(std::size_t place) const { return containers_[place]; }

 private:
  std::vector<std::size_t> containers_;
};

// The containers that are open. A list, not calls, so that the depth of a document costs no stack.
class Nesting {
 public:
  // Called with the place of a container as it is opened and closed.
  using Handler = std::function<void(std::size_t place)>;

  Nesting(const Containers& containers, Handler open, Handler close)
      : containers_(containers), open_handler_(std::move(open)), close_handler_(std::move(close)) {}

  // Closes and opens containers until `place` is the innermost; kNone closes all. A container whose
  // members do not stand together is opened again.
  void enter(std::size_t place);

 private:
  std::size_t innermost() const { return open_.empty() ? Containers::kNone : open_.back(); }

  const Containers& containers_;
  Handler open_handler_, close_handler_;
  std::vector<std::size_t> open_;
};

}  // namespace libstyle

// SPDX-License-Identifier: Apache-2.0
// Files packed by gzip, as those that end in .svgz are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace libstyle::svg {

// Whether the bytes begin as gzip does (RFC 1952).
bool is_gzip(std::string_view bytes);

// What was packed: all members, one after the other; zeros and other bytes behind the last are not
// looked at, as by gunzip. Throws Error naming `file` when they are damaged or cut off, or hold
// more than `limit` bytes; never takes more memory than twice that.
std::string gunzip(std::string_view packed, std::size_t limit, const std::string& file);

}  // namespace libstyle::svg

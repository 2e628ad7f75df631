// SPDX-License-Identifier: Apache-2.0
// What is thrown when data from outside cannot be used. A broken invariant of our own is an
// assertion, never one of these.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace libstyle {

// Where in an input something was found. `line` counts from 1; 0 means "the input as a whole".
struct Place {
  std::string file;
  std::size_t line = 0;
};

// Writes a place as "file:line: ", "file: " or "" for use before a message.
std::string to_prefix(const Place& place);

// Bad data or a failed run. what() is one line: place, what is wrong, what to do.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& message);
  Error(Place place, std::string message);

  const Place& place() const { return place_; }
  const std::string& message() const { return message_; }  // what() without the place

 private:
  Place place_;
  std::string message_;
};

// Does some work, and says of an Error in it where that was.
template <typename Work>
auto at_place(const Place& place, Work work) {
  try {
    return work();
  } catch (const Error& error) {
    throw Error(place, error.what());
  }
}

}  // namespace libstyle

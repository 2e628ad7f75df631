// SPDX-License-Identifier: Apache-2.0
// How long work tells how far it is.
#pragma once

#include <functional>

namespace libstyle {

// Receives the share that is done, rising from 0 to 1. May be called from any thread, one call at
// a time. An empty handler means that nobody listens.
using ProgressHandler = std::function<void(double done)>;

}  // namespace libstyle

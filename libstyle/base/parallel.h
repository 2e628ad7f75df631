// SPDX-License-Identifier: Apache-2.0
// Independent pieces of work on several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace libstyle {

// Calls work(i) once for each i in 0 .. count-1, on at most `threads` threads (0: one a core), in
// any order. Results belong into slot i of something sized beforehand, so that they do not depend
// on the number of threads. The exception of the lowest failing index is thrown on; work that has
// not begun by then may be left out.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& work);

}  // namespace libstyle

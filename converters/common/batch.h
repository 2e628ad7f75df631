// SPDX-License-Identifier: Apache-2.0
// Many documents in one run, none of which depends on another.
//
// A program says how the next one is read, what is done with it, and how it is finished, which is
// mostly to write it; run_batch() does the first and the last in the order of the documents and the
// second on several threads (libstyle/base/ordered_work.h). What is said about a document is said
// when its turn comes, so that stderr too is the same on any number of threads.
//
// An Error in any of the three is about that document alone. Without --keep-going it ends the run,
// after everything that comes before. With it, it is reported, the document is left out, and the
// run goes on. An OutputError, like everything that is no Error, always ends the run.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "converters/common/command.h"
#include "converters/common/files.h"
#include "libstyle/base/ordered_work.h"

namespace libstyle {

struct BatchSettings {
  bool keep_going = false;
  int threads = 0;  // 0: one a core
};

template <typename Item>
struct BatchStages {
  // Fills in the next item; false at the end. When it throws Error, it is asked for the one after.
  std::function<bool(Item&)> read;
  std::function<void(Item&, const WarningHandler&)> work;
  std::function<void(Item&)> finish;
};

template <typename Item>
void run_batch(const BatchSettings& settings, Session& session, const BatchStages<Item>& stages) {
  struct Entry {
    Item item;
    std::vector<Warning> warnings;
    std::optional<Error> error;

    void attempt(const std::function<void()>& stage) {
      if (error) return;
      try {
        stage();
      } catch (const OutputError&) {
        throw;
      } catch (const Error& caught) {
        error = caught;
      }
    }
  };
  const auto read = [&](Entry& entry) {
    bool is_there = true;
    entry.attempt([&] { is_there = stages.read(entry.item); });
    return is_there;
  };
  const auto work = [&](Entry& entry) {
    entry.attempt([&] {
      stages.work(entry.item, [&](const Warning& warning) { entry.warnings.push_back(warning); });
    });
  };
  const auto finish = [&](Entry& entry) {
    for (const Warning& warning : entry.warnings) session.warn(warning);
    entry.attempt([&] { stages.finish(entry.item); });
    if (!entry.error) return;
    if (!settings.keep_going) throw *entry.error;
    session.error(*entry.error);
  };
  run_in_order<Entry>(settings.threads, {read, work, finish});
}

}  // namespace libstyle

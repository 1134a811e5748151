#pragma once

#include <cstddef>

#ifdef __SANITIZE_THREAD__
#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

// Internal to this folder.
namespace limn {

/// Calls `body(first, last)` for disjoint ranges of about `grain` items or more that make up
/// begin..end, from several threads at once; returns when all are done.
template <class Body>
void parallel_ranges(std::size_t begin, std::size_t end, std::size_t grain, const Body& body) {
#ifdef __SANITIZE_THREAD__
  // The thread sanitizer cannot see how a oneTBB that was built without it hands work over, and a
  // suppression wide enough for that would hide races of the loops themselves. Plain threads need
  // none. What is no more than a grain has one thread with oneTBB as well.
  if (end - begin <= grain) {
    if (begin < end) {
      body(begin, end);
    }
    return;
  }
  std::atomic<std::size_t> next = begin;
  std::array<std::thread, 4> threads;
  for (std::thread& thread : threads) {
    thread = std::thread([&] {
      for (std::size_t first = next.fetch_add(grain); first < end; first = next.fetch_add(grain)) {
        body(first, std::min(end, first + grain));
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
#else
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(begin, end, grain),
      [&](const tbb::blocked_range<std::size_t>& range) { body(range.begin(), range.end()); });
#endif
}

}  // namespace limn

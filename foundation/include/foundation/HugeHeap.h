// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace foundation
{

/// Lets the heap of this process grow in pages of 2 MB, and keep what is freed: for a program that fills
/// hundreds of megabytes in seconds, where handing out pages of 4 kB one by one takes a third of the time.
/// Call it before the first thread is begun; it does nothing where the C library is another than glibc, the
/// system has no such pages or memory is limited.
/// Method: the heap is extended at once by a quarter of the machine's memory, up to 4 GB, as addresses alone;
/// memory is taken where something is written. All threads share that heap, and large blocks lie in it, too.
/// Source: glibc's manual, Memory Allocation Tunables, glibc.malloc.hugetlb; differs: a tunable stands in
/// the environment, which a program cannot set for itself.
inline void growHeapInHugePages()
{
#ifdef __GLIBC__
    constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30, kPageBytes = std::uint64_t{2} << 20;
    constexpr int kLargeBytes = 1 << 30, kMoreBytes = 64 << 20;
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY ||
        getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY)
        return;
    const auto memory = static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                        static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
    if (mallopt(M_TRIM_THRESHOLD, -1) == 0) return; // not glibc's malloc: a sanitizer's
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_TOP_PAD, kMoreBytes);
    const auto end = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
    const std::uintptr_t first = (end() + kPageBytes - 1) / kPageBytes * kPageBytes;
    mallopt(M_MMAP_MAX, 0); // the block lies in the heap, and its addresses stay there
    void* volatile block = std::malloc(static_cast<std::size_t>(std::min(memory / 4, kMostBytes)));
    std::free(block);
    constexpr int kDefaultMappings = 65536;
    mallopt(M_MMAP_MAX, kDefaultMappings);
    mallopt(M_MMAP_THRESHOLD, kLargeBytes);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): pages are counted as integers; the answer is of no use
    if (end() > first) (void)madvise(reinterpret_cast<void*>(first), end() - first, MADV_HUGEPAGE);
#endif
}

/// Gives back the addresses that growHeapInHugePages() took: for a child of fork() whose addresses are about
/// to be limited.
inline void shrinkHeap()
{
#ifdef __GLIBC__
    (void)malloc_trim(0);
#endif
}

} // namespace foundation

// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <string>

#include <foundation/HugeHeap.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace foundation
{
namespace
{

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif

/// Whether work returns true in a process of its own: heaps stay as they are made.
bool holdsInChild(const std::function<bool()>& work)
{
    const pid_t child = fork();
    if (child == 0) _exit(work() ? 0 : 1);
    int status = 1;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// The flags by which the system holds the memory around an address ("hg": huge pages are wished for).
std::string flagsAt(const void* place)
{
    std::ifstream maps("/proc/self/smaps");
    std::string line;
    bool isHere = false;
    while (std::getline(maps, line))
    {
        unsigned long long from = 0, to = 0;
        if (std::sscanf(line.c_str(), "%llx-%llx ", &from, &to) == 2)
            isHere = reinterpret_cast<std::uintptr_t>(place) >= from &&
                     reinterpret_cast<std::uintptr_t>(place) < to;
        else if (isHere && line.starts_with("VmFlags:"))
            return line + ' ';
    }
    return {};
}

/// Whether a block of 64 MB lies in the heap, where huge pages are wished for.
bool isLargeBlockInHugePages()
{
    constexpr std::size_t kBytes = std::size_t{64} << 20;
    const std::unique_ptr<char[]> block(new char[kBytes]);
    block[kBytes / 2] = 1;
    return flagsAt(block.get() + kBytes / 2).find(" hg ") != std::string::npos;
}

std::uintptr_t heapEnd()
{
    return reinterpret_cast<std::uintptr_t>(sbrk(0));
}

TEST(HugeHeap, HoldsLargeBlocksInHugePages)
{
    if (kIsSanitized) GTEST_SKIP() << "has a heap of its own";
    EXPECT_FALSE(holdsInChild(isLargeBlockInHugePages)); // as glibc does it
    EXPECT_TRUE(holdsInChild(
        []
        {
            growHeapInHugePages();
            return isLargeBlockInHugePages();
        }));
}

TEST(HugeHeap, TakesAddressesThatCanBeGivenBack)
{
    if (kIsSanitized) GTEST_SKIP() << "has a heap of its own";
    constexpr std::uintptr_t kSomeBytes = std::uintptr_t{256} << 20;
    EXPECT_TRUE(holdsInChild(
        []
        {
            const std::uintptr_t before = heapEnd();
            growHeapInHugePages();
            const std::uintptr_t grown = heapEnd();
            shrinkHeap();
            return grown > before + kSomeBytes && heapEnd() < before + kSomeBytes;
        }));
}

TEST(HugeHeap, LeavesTheHeapOfALimitedProcessAlone)
{
    EXPECT_TRUE(holdsInChild(
        []
        {
            const rlimit limit{std::uint64_t{1} << 40, std::uint64_t{1} << 40};
            if (setrlimit(RLIMIT_AS, &limit) != 0) return false;
            const std::uintptr_t before = heapEnd();
            growHeapInHugePages();
            return heapEnd() == before;
        }));
}

} // namespace
} // namespace foundation

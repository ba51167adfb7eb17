// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <new>

#include <foundation/Threads.h>
#include <gtest/gtest.h>

namespace
{

TEST(Threads, DoAllWork)
{
    std::atomic<int> sum{0};
    foundation::Threads threads;
    for (int i = 1; i <= 10; ++i)
        threads.run([&sum, i] { sum += i; });
    threads.join();
    EXPECT_EQ(sum, 55);
}

TEST(Threads, HandAnExceptionToTheOneThatWaits)
{
    std::atomic<int> done{0};
    foundation::Threads threads;
    for (int i = 0; i < 4; ++i)
        threads.run(
            [&done, i]
            {
                if (i == 1) throw std::bad_alloc();
                ++done;
            });
    EXPECT_THROW(threads.join(), std::bad_alloc);
    EXPECT_EQ(done, 3) << "the others end first";
    threads.join(); // thrown once
}

TEST(Threads, AreWaitedForByTheDestructor)
{
    std::atomic<bool> isDone{false};
    {
        foundation::Threads threads;
        threads.run([&isDone] { isDone = true; });
        threads.run([] { throw std::bad_alloc(); });
    }
    EXPECT_TRUE(isDone);
}

} // namespace

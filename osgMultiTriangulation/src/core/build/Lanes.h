// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace osgMultiTriangulation::core
{

/// Four numbers side by side, and what comparing them gives: all bits or none, by lane. The compiler takes
/// what the processor has; each lane is computed as a number alone would be, so results are the same on all.
constexpr std::size_t kLanes = 4;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
using LaneMask = std::int64_t __attribute__((vector_size(kLanes * sizeof(std::int64_t))));

constexpr LaneMask kWithoutSign{INT64_MAX, INT64_MAX, INT64_MAX, INT64_MAX};

/// Four points, or fewer.
struct PointLanes
{
    Lanes x, y, height;
    LaneMask isThere;

    void set(std::size_t lane, double atX, double atY, double atHeight)
    {
        x[lane] = atX;
        y[lane] = atY;
        height[lane] = atHeight;
        isThere[lane] = -1;
    }
};

/// Code that gains from wide registers is compiled for those with AVX2, too; which is taken is found out when
/// the program starts.
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) &&    \
    !defined(__SANITIZE_THREAD__)
#define OSGTRAINER_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define OSGTRAINER_WIDE
#endif

} // namespace osgMultiTriangulation::core

// SPDX-License-Identifier: Apache-2.0
// Headers of osgTrainer in a project that includes it with add_subdirectory.
#include <cmath>
#include <cstdio>

#include <foundation/Angle.h>

#include <viewlod/ScreenError.h>

int main()
{
    const double radians = foundation::radiansOf(180.0);
    std::printf("%g\n", radians);
    return std::abs(radians - 3.14159265358979) < 1e-12 ? 0 : 1;
}

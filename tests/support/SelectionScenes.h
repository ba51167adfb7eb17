// SPDX-License-Identifier: Apache-2.0
// Views, boxes, tables and walks for tests of selection.
#pragma once

#include <cmath>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <viewlod/ViewState.h>

#include <osgPMObjects/core/selection/BoundingVolumes.h>
#include <osgPMObjects/core/selection/LevelTable.h>

#include "Random.h"

namespace testsupport
{

inline double between(Random& random, double low, double high)
{
    return low + random.unit() * (high - low);
}

inline glm::dvec3 direction(Random& random)
{
    for (;;)
    {
        const glm::dvec3 p{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
        const double length = glm::length(p);
        if (length > 0.1 && length < 1.0) return p / length;
    }
}

inline glm::dmat3 rotation(Random& random)
{
    const glm::dvec3 x = direction(random), y = glm::normalize(glm::cross(x, direction(random)));
    return {x, y, glm::cross(x, y)};
}

/// 1280 × 720 pixels, `highDeg` high, looking from `eye` to `at`.
inline viewlod::ViewState viewTo(const glm::dvec3& eye, const glm::dvec3& at, double highDeg = 40.0)
{
    const glm::dvec3 along = glm::normalize(at - eye);
    const glm::dvec3 up = std::abs(along.z) > 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
    return viewlod::ViewState::fromMatrices(glm::lookAt(eye, at, up),
                                            glm::perspective(glm::radians(highDeg), 1280.0 / 720.0, 0.1, 1e6),
                                            1280, 720);
}

/// Any view, off-axis ones and such with pixels that are not square among them, of what is about `at`.
inline viewlod::ViewState viewAbout(Random& random, const glm::dvec3& at, double farthestM)
{
    const glm::dvec3 eye = at + direction(random) * between(random, 0.5, farthestM);
    const glm::dvec3 aim = at + direction(random) * (0.3 * glm::length(at - eye));
    const double left = -between(random, 0.02, 0.1), right = between(random, 0.02, 0.1);
    const double low = -between(random, 0.02, 0.1), high = between(random, 0.02, 0.1);
    return viewlod::ViewState::fromMatrices(glm::lookAt(eye, aim, direction(random)),
                                            glm::frustum(left, right, low, high, 0.1, 1e5), 1000, 700);
}

inline osgPMObjects::core::OrientedBox box(Random& random)
{
    return {glm::dvec3(between(random, -50, 50), between(random, -50, 50), between(random, -50, 50)),
            rotation(random),
            {between(random, 0.1, 3), between(random, 0.1, 3), between(random, 0.1, 3)}};
}

/// A closed mesh of `positions` positions whose every step takes two faces, with an error that grows with the
/// steps; the area is that of a sphere of radius 1.
inline osgPMObjects::core::LevelTable levelTable(std::uint32_t positions = 1000)
{
    osgPMObjects::core::LevelTable table;
    table.positions = positions;
    table.area = 12.566;
    for (std::uint32_t steps = 0; steps + 4 <= positions; ++steps)
    {
        table.faces.push_back(2 * (positions - steps) - 4);
        const auto off = static_cast<float>(1.0 / (positions - steps) - 1.0 / positions);
        table.errors.push_back({off, off, 0.1f * off, 0.01f * off});
    }
    return table;
}

/// How often `level(x)` changes while x goes up and down by `share` about `middle` for `rounds` rounds; x may
/// be a distance. `level` keeps its own state.
template<class Level>
int switchesWhileTrembling(double middle, double share, int rounds, const Level& level)
{
    int switches = 0;
    auto last = level(middle * (1.0 - share));
    constexpr int kStepsARound = 40;
    for (int i = 0; i < rounds * kStepsARound; ++i)
    {
        const auto now = level(middle * (1.0 - share * std::cos(2.0 * 3.14159265358979 * i / kStepsARound)));
        switches += now != last;
        last = now;
    }
    return switches;
}

/// The same for a random walk within the share.
template<class Level>
int switchesWhileWalking(Random& random, double middle, double share, int steps, const Level& level)
{
    int switches = 0;
    double at = between(random, -share, share);
    auto last = level(middle * (1.0 + at));
    for (int i = 0; i < steps; ++i)
    {
        at = glm::clamp(at + between(random, -0.4, 0.4) * share, -share, share);
        const auto now = level(middle * (1.0 + at));
        switches += now != last;
        last = now;
    }
    return switches;
}

} // namespace testsupport

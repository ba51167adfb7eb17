// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

namespace viewlod
{

/// A view frustum: six half-spaces whose normals point inwards and have unit length.
/// Frame: that of the matrix it was made from (world for ViewState).
/// Source: Gribb & Hartmann, *Fast Extraction of Viewing Frustum Planes from the World-View-Projection
/// Matrix*, 2001. Masks after Assarsson & Möller, *Optimized View Frustum Culling Algorithms for Bounding
/// Boxes*, 2000: when a bounding volume lies inside a plane, its contents need no test against that plane.
class Frustum
{
public:
    static constexpr int kPlanes = 6;
    using Mask = std::uint8_t;
    static constexpr Mask kAllPlanes = (1u << kPlanes) - 1;

    /// The answer of a test: outside, or the planes that cross the volume (0: wholly inside).
    struct Verdict
    {
        bool outside;
        Mask crossing;
    };

    Frustum() = default;

    /// `clipFromFrame`: projection × view, GL clip conventions (-w ≤ x, y, z ≤ w).
    explicit Frustum(const glm::dmat4& clipFromFrame)
    {
        const glm::dmat4 m = glm::transpose(clipFromFrame);
        for (int axis = 0; axis < 3; ++axis)
        {
            _planes[2 * axis] = normalized(m[3] + m[axis]);
            _planes[2 * axis + 1] = normalized(m[3] - m[axis]);
        }
    }

    /// Tests a sphere against the planes in `toTest` only. Child volumes need tests only against the planes
    /// returned.
    Verdict classify(const glm::dvec3& center, double radius, Mask toTest = kAllPlanes) const
    {
        Mask crossing = 0;
        for (int i = 0; i < kPlanes; ++i)
        {
            const Mask bit = static_cast<Mask>(1u << i);
            if (!(toTest & bit)) continue;
            const double distance = signedDistance(i, center);
            if (distance < -radius) return {true, 0};
            if (distance < radius) crossing |= bit;
        }
        return {false, crossing};
    }

    /// Signed distance of a point from plane `i`, metres; positive inside.
    double signedDistance(int i, const glm::dvec3& point) const
    {
        return glm::dot(glm::dvec3(_planes[i]), point) + _planes[i].w;
    }

    const std::array<glm::dvec4, kPlanes>& planes() const { return _planes; }

private:
    /// Scales a plane to a unit normal. A projection without a far plane gives a zero normal: then everything
    /// is inside.
    static glm::dvec4 normalized(const glm::dvec4& plane)
    {
        const double length = glm::length(glm::dvec3(plane));
        return length > 1e-12 ? plane / length : glm::dvec4(0, 0, 0, 1e30);
    }

    std::array<glm::dvec4, kPlanes> _planes{};
};

} // namespace viewlod

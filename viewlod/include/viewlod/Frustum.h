// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

namespace viewlod
{

/// Six half-spaces, normals pointing inwards and of unit length.
/// Frame: that of the matrix it was made from (world for ViewState).
/// Source: Gribb & Hartmann, "Fast extraction of viewing frustum planes" (2001); inherited masks after
/// Assarsson & Möller, "Optimized view frustum culling algorithms" (2000): a plane that has a bounding
/// volume wholly inside needs no test for anything within that volume.
class Frustum
{
public:
    static constexpr int kPlanes = 6;
    using Mask = std::uint8_t;
    static constexpr Mask kAllPlanes = (1u << kPlanes) - 1;

    /// Answer of a test: culled, or the planes that still cross the volume (0: wholly inside).
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

    /// Tests a sphere against the planes in `toTest` only; the planes that come back are those a child
    /// volume has still to be tested against.
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

    /// Metres inside (positive) or outside (negative) of plane `i`.
    double signedDistance(int i, const glm::dvec3& point) const
    {
        return glm::dot(glm::dvec3(_planes[i]), point) + _planes[i].w;
    }

    const std::array<glm::dvec4, kPlanes>& planes() const { return _planes; }

private:
    /// A projection without a far plane leaves a null normal: such a plane has everything inside.
    static glm::dvec4 normalized(const glm::dvec4& plane)
    {
        const double length = glm::length(glm::dvec3(plane));
        return length > 1e-12 ? plane / length : glm::dvec4(0, 0, 0, 1e30);
    }

    std::array<glm::dvec4, kPlanes> _planes{};
};

} // namespace viewlod

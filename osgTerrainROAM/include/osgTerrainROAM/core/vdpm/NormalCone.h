// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// A cone of directions: all within an angle of an axis. An angle of π: all directions.
/// Source: Shirman & Abi-Ezzi, *The cone of normals technique for fast processing of curved patches*, 1993;
/// Hoppe, *View-dependent refinement of progressive meshes*, 1997, section 4.2 (surface orientation).
struct NormalCone
{
    static constexpr float kSlack = 1e-5f; ///< exceeds the rounding of angles

    glm::vec3 axis{0.0f, 0.0f, 1.0f};
    float angle = -1.0f; ///< radians; negative: no direction at all

    static NormalCone all() { return {{0.0f, 0.0f, 1.0f}, std::numbers::pi_v<float>}; }
    static NormalCone of(const glm::dvec3& normal)
    {
        const double length = glm::length(normal);
        return length > 0.0 ? NormalCone{glm::vec3(normal / length), kSlack} : NormalCone{};
    }

    bool isEmpty() const { return angle < 0.0f; }

    bool contains(const NormalCone& other) const
    {
        if (other.isEmpty() || angle >= std::numbers::pi_v<float>) return true;
        return !isEmpty() && between(axis, other.axis) + other.angle <= angle;
    }

    /// Returns a cone that contains both, nearly the least.
    NormalCone joined(const NormalCone& other) const
    {
        if (contains(other)) return *this;
        if (other.contains(*this)) return other;
        const float apart = between(axis, other.axis);
        const float half = 0.5f * (apart + angle + other.angle) + kSlack;
        const glm::vec3 aside = other.axis - axis * glm::dot(axis, other.axis);
        const float length = glm::length(aside);
        if (half >= std::numbers::pi_v<float> || length < 1e-6f) return all();
        const float turn = half - angle; // from this axis towards the other
        const glm::vec3 middle = glm::normalize(axis * std::cos(turn) + aside * (std::sin(turn) / length));
        // Computed anew, with the rounded axis.
        return {middle,
                std::max(between(middle, axis) + angle, between(middle, other.axis) + other.angle) + kSlack};
    }

    static float between(const glm::vec3& a, const glm::vec3& b)
    {
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }
};

/// The sides of faces that are drawn.
enum class VisibleSides
{
    both,
    front, ///< back faces are culled: an object seen from outside
    back,  ///< front faces are culled: a closed object seen from inside
};

/// Whether no face with a normal in the cone, anywhere in a ball, shows a visible side to an eye.
inline bool isTurnedAway(const NormalCone& cone, const glm::dvec3& centre, double radius,
                         const glm::dvec3& eye, VisibleSides sides)
{
    if (sides == VisibleSides::both || cone.isEmpty()) return false;
    const glm::dvec3 toEye = eye - centre;
    const double distance = glm::length(toEye);
    if (distance <= radius) return false;
    const glm::dvec3 axis = (sides == VisibleSides::front ? 1.0 : -1.0) * glm::dvec3(cone.axis);
    const double turned = std::acos(std::clamp(glm::dot(axis, toEye) / distance, -1.0, 1.0));
    return turned - cone.angle - std::asin(radius / distance) > 0.5 * std::numbers::pi + NormalCone::kSlack;
}

} // namespace osgTerrainROAM::core

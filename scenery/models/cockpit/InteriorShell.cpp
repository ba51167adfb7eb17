// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/cockpit/InteriorShell.h"

#include <cmath>

namespace scenery::models
{

glm::dmat4 upright(const glm::dvec3& middle)
{
    return {{0.0, -1.0, 0.0, 0.0}, {0.0, 0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0, 0.0}, {middle, 1.0}};
}

void addPost(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double thickM)
{
    const glm::dvec3 along = glm::normalize(to - from);
    const glm::dvec3 helper = std::abs(along.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 a = glm::normalize(glm::cross(along, helper)) * thickM, b = glm::cross(along, a);
    const std::array<glm::dvec3, 4> profile{a + b, b - a, -a - b, a - b};
    addPrism(builder, profile.size(),
             [&](std::size_t end, std::size_t point, std::size_t) {
                 return Corner{(end == 0 ? from : to) + profile[point], plainUv()};
             });
}

InteriorMirror mirrorTowards(const std::string& name, const glm::dvec3& middle, const glm::dvec2& sizeM,
                             const glm::dvec3& eye, const glm::dvec3& seen)
{
    // The normal halves the angle between the way to the eye and the way to what is seen.
    const glm::dvec3 normal = glm::normalize(glm::normalize(eye - middle) + glm::normalize(seen));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), normal));
    const glm::dvec3 up = glm::cross(normal, right);
    const glm::dvec3 low = middle - 0.5 * sizeM.x * right - 0.5 * sizeM.y * up;
    return {name, low, low + sizeM.x * right, low + sizeM.y * up};
}

void addMirror(InteriorModel& interior, const InteriorMirror& mirror)
{
    constexpr double kRimM = 0.012, kDeepM = 0.03;
    const glm::dvec3 right = mirror.lowRight - mirror.lowLeft, up = mirror.topLeft - mirror.lowLeft;
    const glm::dvec3 r = glm::normalize(right), u = glm::normalize(up), out = glm::cross(r, u);
    const glm::dvec3 low = mirror.lowLeft - kRimM * (r + u) - 0.003 * out;
    const glm::dvec3 across = right + 2.0 * kRimM * r, high = up + 2.0 * kRimM * u;
    const std::array<glm::dvec3, 4> profile{low, low + across, low + across + high, low + high};
    ModelBuilder builder;
    builder.begin("housing", kPlain, kSeam);
    addPrism(builder, profile.size(),
             [&](std::size_t end, std::size_t point, std::size_t) {
                 return Corner{profile[point] - (end == 0 ? kDeepM : 0.0) * out, plainUv()};
             });
    interior.parts.push_back({mirror.name + " housing", builder.finish(30.0)});
    interior.mirrors.push_back(mirror);
}

std::optional<InteriorModel> makeInterior(const EntityShape& shape, const glm::dvec3& eye)
{
    switch (shape.kind)
    {
    case EntityKind::car:
    case EntityKind::van:
    case EntityKind::bus:
    case EntityKind::lorry:
    case EntityKind::tractor:
        return makeCarInterior(shape, eye);
    case EntityKind::lightAircraft:
    case EntityKind::glider:
    case EntityKind::airliner:
    case EntityKind::helicopter:
        return makeAircraftCockpit(shape, eye);
    default:
        return std::nullopt;
    }
}

} // namespace scenery::models

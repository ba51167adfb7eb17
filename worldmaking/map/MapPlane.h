// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec2.hpp>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgRoads/core/query/GeoReference.h>

#include "worldmaking/map/LandMap.h"

namespace worldmaking
{

/// Describes a transverse Mercator about the middle of a map.
osgRoads::core::NetworkHeader planeAbout(const LandMap& map);

/// The plane of a network: degrees east and north to metres of its inertial frame, and back. Threads: one at
/// a time.
class MapPlane
{
public:
    /// Errors: as GeoReference::create().
    static foundation::Result<MapPlane> create(const osgRoads::core::NetworkHeader& header,
                                               const std::string& name)
    {
        auto reference = osgRoads::core::GeoReference::create(header, name);
        if (!reference) return reference.error();
        return MapPlane(std::make_shared<osgRoads::core::GeoReference>(std::move(*reference)));
    }

    std::optional<glm::dvec2> toPlan(const glm::dvec2& degrees) const
    {
        const auto place = _reference->toInertial({degrees.y, degrees.x, 0.0});
        return place ? std::optional(glm::dvec2(*place)) : std::nullopt;
    }

    std::optional<glm::dvec2> toDegrees(const glm::dvec2& plan) const
    {
        const auto place = _reference->toGeodetic({plan, 0.0});
        return place ? std::optional(glm::dvec2(place->longitudeDeg, place->latitudeDeg)) : std::nullopt;
    }

    /// Converts all paths of a shape; nothing where a point has no place in the plane.
    std::optional<std::vector<std::vector<glm::dvec2>>>
    toPlan(const std::vector<std::vector<glm::dvec2>>& paths) const
    {
        return converted(paths, [this](const glm::dvec2& place) { return toPlan(place); });
    }
    std::optional<std::vector<std::vector<glm::dvec2>>>
    toDegrees(const std::vector<std::vector<glm::dvec2>>& paths) const
    {
        return converted(paths, [this](const glm::dvec2& place) { return toDegrees(place); });
    }

private:
    explicit MapPlane(std::shared_ptr<const osgRoads::core::GeoReference> reference)
        : _reference(std::move(reference))
    {
    }

    template<class Convert>
    static std::optional<std::vector<std::vector<glm::dvec2>>>
    converted(const std::vector<std::vector<glm::dvec2>>& paths, const Convert& convert)
    {
        std::vector<std::vector<glm::dvec2>> made;
        for (const auto& path : paths)
        {
            made.emplace_back();
            for (const glm::dvec2& point : path)
            {
                const auto place = convert(point);
                if (!place) return std::nullopt;
                made.back().push_back(*place);
            }
        }
        return made;
    }

    std::shared_ptr<const osgRoads::core::GeoReference> _reference;
};

} // namespace worldmaking

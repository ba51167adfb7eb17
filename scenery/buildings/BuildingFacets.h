// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <glm/glm.hpp>

#include "scenery/buildings/Building.h"

namespace scenery
{

/// Triangles of one texture, ready for a vertex buffer. Frame: that of an origin of the caller's. Colours as
/// display values.
struct Facets
{
    std::vector<glm::vec3> positions, normals, colours;
    std::vector<glm::vec2> uvs;
    std::vector<float> skies; ///< share of the sky that each corner sees
    std::vector<std::uint32_t> indices;

    /// Adds a flat convex polygon, counter-clockwise seen from outside.
    /// `skies`: share of the sky that each corner sees; empty: all of it.
    void addPolygon(const std::vector<glm::vec3>& corners, const std::vector<glm::vec2>& uv,
                    const glm::vec3& colour, const std::vector<float>& skies = {});
};

/// A pane of a window or shop front: its lower corners seen from outside, and what is behind it.
/// Frame: the scene's. Units: metres.
struct WindowPane
{
    glm::dvec3 left{0.0}, right{0.0};
    double heightM = 1.3;
    RoomUse use = RoomUse::dwelling;
    std::uint64_t room = 0; ///< chance that is the same in each run
};

/// The facets of buildings: walls and roofs by texture, and windows and doors, which are only worth drawing
/// near by.
struct BuildingFacets
{
    std::map<models::Painting, Facets> shell;
    Facets openings; ///< of Painting::houseDetails, 4 cm before the walls
    std::vector<WindowPane> panes;
};

/// Adds the shell of a building: walls from its foot up to the roof, the roof with its eaves.
/// `origin`: of the facets' frame, in the scene. Closed: each wall ends on the roof's planes.
void addShell(const StandingBuilding& standing, const glm::dvec3& origin, BuildingFacets& facets);

/// Adds its openings, windows in each storey and a door, and their panes. `origin`: the same.
void addOpenings(const StandingBuilding& standing, const glm::dvec3& origin, BuildingFacets& facets);

} // namespace scenery

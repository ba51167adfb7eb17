// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <osgPMObjects/core/mesh/Mesh.h>

namespace scenery::models
{

struct VehicleLook;

/// The textures that the generators paint. They are the same for all seeds, so thousands of models share few
/// textures.
enum class Painting : std::uint8_t
{
    oakBark,
    birchBark,
    pineBark,
    oakLeaves,
    birchLeaves,
    poplarLeaves,
    bushLeaves,
    spruceNeedles,
    plaster,
    bricks,
    sheetMetal,
    planks,
    roofTiles,
    roofMetal,
    houseDetails,
    wheel,
    plain,       ///< one colour and the signs of roads: roads/SignAtlas.h
    instruments, ///< cockpit/PaintInstruments.h
    vehicle,     ///< the sheet of Surface::look
    count,
};

/// How a surface reflects light.
enum class Coat : std::uint8_t
{
    matt,
    lacquered, ///< car paint and glass
    foliage,   ///< visible from both sides with one normal, cut out by the alpha of the texture
    lit,       ///< has a lamp behind it, as the face of a sign: bright by night
};

/// The texture and the finish of a material. Except for foliage, the alpha of the texture tells how much the
/// vertex colour tints it.
struct Surface
{
    Painting painting = Painting::plaster;
    Coat coat = Coat::matt;
    std::shared_ptr<const VehicleLook> look{}; ///< of Painting::vehicle, null of all others

    bool operator==(const Surface&) const = default;
};

/// A generated object.
/// Frame: x forward (vehicles: the way they drive; houses: along the ridge, the entrance looks towards -y), y
/// left, z up; the ground is z = 0, below the middle. Units: metres; colours as display values.
/// Invariant: isModel() of ModelCheck.h.
struct Model
{
    osgPMObjects::core::Mesh mesh; ///< Material::state is the number of the surface
    std::vector<Surface> surfaces;
    double radiusM = 0.0;     ///< of the circle about the z axis that contains it
    double heightM = 0.0;     ///< of its highest point
    double foundationM = 0.0; ///< how deep it reaches below z = 0, for slopes
};

} // namespace scenery::models

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// A cross-section of a wing or a fin: a symmetric aerofoil that looks along x. Units: metres; thickness over
/// chord.
struct AerofoilStation
{
    glm::dvec3 leadingEdge{0.0};
    double chordM = 1.0;
    double thickness = 0.12;
};

/// Returns the stations mirrored to the other side.
std::vector<AerofoilStation> mirrored(std::vector<AerofoilStation> stations);

/// Returns the point of the chord at a share of it behind the leading edge.
inline glm::dvec3 chordPoint(const AerofoilStation& station, double share)
{
    return station.leadingEdge - glm::dvec3(share * station.chordM, 0.0, 0.0);
}

/// The part of a wing between two shares of its chord, through two stations or more: all of it, or what a
/// hinge divides.
struct WingPanel
{
    std::vector<AerofoilStation> stations;
    double fromShare = 0.0, toShare = 1.0;
};

/// Adds the closed surface of a panel. Precondition: a part with the texture plain has begun.
/// Source: Jacobs, Ward & Pinkerton, NACA Report 460, 1933: the thickness distribution of four-digit
/// aerofoils.
void addWingPanel(ModelBuilder& builder, const WingPanel& panel);

} // namespace scenery::models

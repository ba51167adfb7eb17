// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osg/Program>

namespace scenery
{

/// One unit of a precision approach path indicator. Frame: the scene's.
struct PapiUnit
{
    glm::dvec3 place{0.0};
    glm::dvec2 towards{1.0, 0.0}; ///< unit vector to where aircraft come from
    double angleDeg = 3.0;        ///< white is seen above it, red below
};

/// Returns the four units of a runway's end: at the left edge beside the aiming point, 15 m from the edge and
/// 9 m apart, the innermost the steepest: 2°30', 2°50', 3°10', 3°30'. `landing`: unit vector. Heights are
/// left 0.
/// Source: ICAO, *Annex 14*, volume I, 5.3.5; EASA CS-ADR-DSN.L.540 for the aiming point.
std::vector<PapiUnit> papiUnits(const glm::dvec2& threshold, const glm::dvec2& landing, double lengthM,
                                double widthM);

/// Lights and windsocks of airfields: PAPI whose colours follow from where each eye is, and windsocks that
/// the wind turns and lifts.
/// Frame: the scene's. Needs the uniforms of an Atmosphere above it. Threads: setWind() in the update phase.
class AirfieldNode
{
public:
    /// `socks`: the feet of windsocks.
    AirfieldNode(std::span<const PapiUnit> papis, std::span<const glm::dvec3> socks);

    osg::Group* node() const { return _root.get(); }

    /// `windMps`: to where the air moves, east and north. Calm lets socks hang; 7.7 m/s (15 kt) lifts them
    /// level.
    void setWind(const glm::dvec2& windMps);

private:
    osg::ref_ptr<osg::Group> _root = new osg::Group;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> _socks;
    std::vector<glm::dvec3> _tops;
};

/// The program of PAPI lights.
osg::ref_ptr<osg::Program> makePapiProgram();

} // namespace scenery

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/Program>

#include "scenery/roads/things/RoadThings.h"

namespace scenery
{

/// What a traffic light shows. Pedestrian lights show red for all but go.
enum class LightState
{
    off,
    stop,      ///< red
    attention, ///< red and amber
    go,        ///< green
    caution,   ///< amber
};

/// What shines by itself beside and over roads: lenses of traffic lights, and the lamps of tunnels.
/// Frame: the scene's. Threads: setState() in the update phase. Lenses more than 10 km from the first one are
/// placed within a millimetre or two.
class RoadLamps
{
public:
    /// Makes the lamps; all traffic lights show stop.
    explicit RoadLamps(const roads::RoadThings& things);

    /// Null when nothing shines.
    osg::Node* node() const { return _node.get(); }

    /// Sets what all lights of a signal show. Returns false when there is none of that id.
    bool setState(const std::string& signalId, LightState state);

    /// Sets the lenses of a signal one by one, from the top; lenses beyond the list are dark. Returns as
    /// setState().
    bool setLenses(const std::string& signalId, const std::vector<bool>& lit);

private:
    /// A piece of a lamp that shines with it.
    struct Piece
    {
        std::size_t lens = 0;
        std::size_t first = 0, count = 0; ///< corners
        osg::Vec4f light;
    };
    struct Lights
    {
        std::vector<models::SignFace> faces;
        std::vector<Piece> pieces;
    };
    template<class IsLit>
    bool colour(const std::string& signalId, const IsLit& isLit);
    void addFan(const std::vector<glm::dvec3>& corners, const glm::dvec3& towards);
    void addSignal(const roads::StandingThing& thing, const models::RoadModel& model);
    void addCeilingLamp(const roads::CeilingLamp& lamp);

    glm::dvec3 _origin{0.0};
    osg::ref_ptr<osg::Vec3Array> _corners = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec3Array> _normals = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> _colours = new osg::Vec4Array;
    osg::ref_ptr<osg::Geometry> _geometry;
    osg::ref_ptr<osg::MatrixTransform> _node;
    std::multimap<std::string, Lights> _lights; ///< by the id of the signal
};

/// Makes the program of lamps, which shine by themselves, in the haze of an Atmosphere.
osg::ref_ptr<osg::Program> makeRoadLampProgram();

} // namespace scenery

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <osg/Stencil>
#include <osgViewer/View>

#include "scenery/models/entities/EntityShape.h"
#include "scenery/nodes/InteriorNode.h"
#include "view/Channel.h"

namespace trainer
{

/// Which mirrors are drawn anew in a picture.
enum class MirrorPace
{
    all,
    one, ///< of those in sight, in turn, where pictures take long
};

/// The inside of the vehicle that the eye is in, drawn into the picture of one channel by a camera of its
/// own: its near plane is at the eye, that of the scene is not (decision 37). It is drawn first; the scene
/// fills what it leaves free, by the stencil. Its mirrors show the scene. Threads: the update phase of the
/// viewer.
class InteriorView
{
public:
    /// `shape`: of the vehicle. `eyeInBody`: of the driver or pilot. Null where one does not sit inside of
    /// such an entity.
    static std::unique_ptr<InteriorView> create(const scenery::models::EntityShape& shape,
                                                const glm::dvec3& eyeInBody);

    /// Begins to draw before `picture`, a camera of the view, and to keep it from what is covered. `air`: the
    /// uniforms of an Atmosphere. `scene`: what mirrors show.
    void addTo(osgViewer::View& view, osg::Camera& picture, osg::StateSet& air, osg::Node& scene);

    /// Whether it is drawn; hidden, it costs nothing.
    void show(bool isShown);
    bool isShown() const { return _isShown; }

    /// Leaves the mirrors as they are in the next picture.
    void restMirrors();

    /// Whether all but the pictures of the mirrors is drawn.
    void showInside(bool isShown);

    /// Of the eye's own direction. Units: degrees.
    double lookDownDeg() const { return _isShown ? _interior.model().lookDownDeg : 0.0; }

    /// Where a head looks that reads the instruments.
    const scenery::models::PanelView& panel() const { return _interior.model().panel; }

    /// For a picture of `channel` from `eye`. `isDark`: the instruments are lit.
    void update(const scenery::Pose& vehicle, const scenery::Pose& eye, const Channel& channel,
                const scenery::models::Readings& readings, bool isDark, MirrorPace pace);

private:
    explicit InteriorView(scenery::models::InteriorModel model);
    std::vector<bool> dueMirrors(const scenery::Pose& vehicle, const glm::dmat4& clipFromWorld,
                                 MirrorPace pace);
    void updateMirrors(const scenery::Pose& vehicle, const scenery::Pose& eye,
                       const glm::dmat4& clipFromWorld, MirrorPace pace);

    void addCamera(osgViewer::View& view, osg::Camera& camera, osg::Node& shown, osg::Stencil& stencil,
                   osg::StateSet& air);

    scenery::InteriorNode _interior;
    osg::ref_ptr<osg::Camera> _camera, _disc; ///< before the scene, and after it
    osg::ref_ptr<osg::Camera> _picture;
    std::vector<osg::ref_ptr<osg::Camera>> _mirrors;
    std::size_t _turn = 0; ///< the mirror that was drawn last
    bool _isShown = true;
};

} // namespace trainer

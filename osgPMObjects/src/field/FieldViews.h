// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>

#include <osgPMObjects/core/field/FieldView.h>

#include <osgPMObjects/ProgressiveField>

#include "../progressive/EyeGroups.h"
#include "FieldPart.h"

namespace osgPMObjects
{

/// The instances of a field and its view groups. Threads: any; the settings of a look belong to the caller.
class FieldViews
{
public:
    explicit FieldViews(core::Field field);

    /// Chooses the levels for a camera and sorts the instances by what draws them.
    std::shared_ptr<const CulledField> look(const CullView& view, const ProgressiveFieldSettings& settings);

    const core::Field& field() const { return _field; }
    const osg::BoundingSphere& bound() const { return _bound; }
    std::vector<FieldViewStatistics> statistics() const;
    void releaseGLObjects(osg::State* state);

private:
    struct Group
    {
        std::unique_ptr<core::FieldView> view;
        core::SelectionView chosenBy; ///< of the camera that was culled last
        double timeS = 0.0;
        unsigned int steppedFrame = 0;
        float stepS = 0.0F;
        FieldViewStatistics statistics;
    };
    struct PerCamera
    {
        std::shared_ptr<InstanceBuffer> buffer;
    };
    using Groups = EyeGroups<Group, PerCamera>;

    core::FieldCamera cameraOf(const CullView& view, const ProgressiveFieldSettings& settings) const;
    static void step(Groups::Entry& entry, const CullView& view);
    void note(Groups::Entry& entry, const CulledField& culled, double cullMs) const;

    core::Field _field;
    osg::BoundingSphere _bound;
    mutable std::mutex _mutex;
    Groups _groups;
    std::uint64_t _serial = 0;
};

} // namespace osgPMObjects

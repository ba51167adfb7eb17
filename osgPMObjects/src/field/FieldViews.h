// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>

#include <osgPMObjects/core/field/FieldView.h>

#include <osgPMObjects/ProgressiveField>

#include "../progressive/EyeGroups.h"
#include "FieldPart.h"

namespace osgPMObjects
{

/// A field's instances and its view groups. Threads: any; settings of a look are the caller's.
class FieldViews
{
public:
    /// What the node's settings add to a view.
    struct Settings
    {
        core::SceneBudgetSettings budget;
        core::AttentionRule attention;
        double referencePixelsPerTangent = 0.0;
    };

    explicit FieldViews(core::Field field);

    /// Chooses and sorts for a camera.
    std::shared_ptr<const CulledField> look(const CullView& view, const Settings& settings);

    const core::Field& field() const { return _field; }
    const osg::BoundingSphere& bound() const { return _bound; }
    std::vector<FieldViewStatistics> statistics() const;
    void releaseGLObjects(osg::State* state);

private:
    struct Group
    {
        std::unique_ptr<core::FieldView> view;
        core::SelectionView chosenBy; ///< of the camera that looked last
        double timeS = 0.0;
        unsigned int steppedFrame = 0;
        float stepS = 0.0F;
        FieldViewStatistics statistics;
    };
    struct PerCamera
    {
        std::shared_ptr<InstanceBuffer> buffer; ///< each camera has a picture of its own
    };
    using Groups = EyeGroups<Group, PerCamera>;

    core::FieldCamera cameraOf(const CullView& view, const Settings& settings) const;
    static void step(Groups::Entry& entry, const CullView& view);
    void note(Groups::Entry& entry, const CulledField& culled, double cullMs) const;

    core::Field _field;
    osg::BoundingSphere _bound;
    mutable std::mutex _mutex;
    Groups _groups;
    std::uint64_t _serial = 0;
};

} // namespace osgPMObjects

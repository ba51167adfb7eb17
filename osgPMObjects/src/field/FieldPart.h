// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <osg/Drawable>

#include <osgTraversal/DrawCount>

#include "FieldMesh.h"
#include "InstanceBuffer.h"

namespace osgPMObjects
{

/// What one cull of a field found, and where it is drawn from. Never changes.
struct CulledField
{
    core::FieldDrawList drawList;
    std::uint64_t serial = 0;
    std::shared_ptr<InstanceBuffer> buffer;
};

/// What a field puts into the render graph: one material of one model in one pass, all its rungs.
class FieldPart : public osg::Drawable, public osgTraversal::DrawCount
{
public:
    FieldPart(std::shared_ptr<const CulledField> culled, const core::FieldBatch& batch,
              osg::ref_ptr<const FieldMesh> mesh, std::uint32_t group);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;
    osg::BoundingBox computeBoundingBox() const override;

    /// One for each rung.
    unsigned int draws() const override;

protected:
    ~FieldPart() override = default;

private:
    std::shared_ptr<const CulledField> _culled;
    core::FieldBatch _batch;
    osg::ref_ptr<const FieldMesh> _mesh;
    std::uint32_t _group;
};

} // namespace osgPMObjects

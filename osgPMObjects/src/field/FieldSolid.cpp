// SPDX-License-Identifier: Apache-2.0
#include "FieldSolid.h"

#include <cfloat>

#include <osg/Transform>

namespace osgPMObjects
{

namespace
{

/// One instance: the shape's vertices come to the field's frame by it. No group's child, whose parents would
/// be as many as there are instances.
class InstanceNode : public osg::Transform
{
public:
    InstanceNode(const core::Field& field, std::uint32_t object, const osg::ref_ptr<const FieldMesh>& mesh)
        : _mesh(mesh), _number(field.numberOf(object)), _sphere(roundedUp(field.spheres()[object]))
    {
        const core::FieldObject& placed = field.objects()[object];
        const glm::dquat& q = placed.attitude;
        _matrix = osg::Matrixd::translate(_mesh->shape().origin()) *
                  osg::Matrixd::scale(placed.scale, placed.scale, placed.scale) *
                  osg::Matrixd::rotate(osg::Quat(q.x, q.y, q.z, q.w)) *
                  osg::Matrixd::translate(placed.position.x, placed.position.y, placed.position.z);
        getBound(); // made at first sight, which several threads may have at once
    }

    std::uint32_t number() const { return _number; }

    bool computeLocalToWorldMatrix(osg::Matrix& matrix, osg::NodeVisitor*) const override
    {
        matrix.preMult(_matrix);
        return true;
    }
    bool computeWorldToLocalMatrix(osg::Matrix& matrix, osg::NodeVisitor*) const override
    {
        matrix.postMult(osg::Matrixd::inverse(_matrix));
        return true;
    }
    osg::BoundingSphere computeBound() const override { return _sphere; }
    void traverse(osg::NodeVisitor& visitor) override
    {
        for (const auto& faces : _mesh->finest())
            faces->accept(visitor);
    }

protected:
    ~InstanceNode() override = default;

private:
    osg::ref_ptr<const FieldMesh> _mesh;
    std::uint32_t _number;
    osg::BoundingSphere _sphere;
    osg::Matrixd _matrix;
};

class CellNode : public osg::Node
{
public:
    CellNode(std::shared_ptr<const FieldSolid::Source> source, const core::FieldCell& cell)
        : _source(std::move(source)), _cell(cell)
    {
        getBound();
    }

    osg::BoundingSphere computeBound() const override { return roundedUp(_cell.sphere); }
    void traverse(osg::NodeVisitor& visitor) override
    {
        std::call_once(_made, [this] { makeInstances(); });
        for (const auto& instance : _instances)
            instance->accept(visitor);
    }

protected:
    ~CellNode() override = default;

private:
    void makeInstances()
    {
        const core::Field& field = *_source->field;
        for (std::uint32_t object = _cell.first; object < _cell.end; ++object)
            _instances.push_back(
                new InstanceNode(field, object, _source->meshes[field.objects()[object].model]));
    }

    std::shared_ptr<const FieldSolid::Source> _source;
    core::FieldCell _cell;
    std::once_flag _made;
    std::vector<osg::ref_ptr<InstanceNode>> _instances;
};

} // namespace

osg::BoundingSphere roundedUp(const core::BoundingSphere& sphere)
{
    const glm::dvec3& c = sphere.centre;
    const double rounding = FLT_EPSILON * (glm::length(c) + sphere.radius);
    return {osg::Vec3(osg::Vec3d(c.x, c.y, c.z)), static_cast<float>(sphere.radius + rounding)};
}

void FieldSolid::accept(osg::NodeVisitor& visitor)
{
    std::call_once(_made,
                   [this]
                   {
                       for (const core::FieldCell& cell : _source->field->cells())
                           _cells.push_back(new CellNode(_source, cell));
                   });
    for (const auto& cell : _cells)
        cell->accept(visitor);
}

std::optional<std::uint32_t> FieldSolid::instanceOf(const osg::NodePath& path)
{
    for (const osg::Node* const node : path)
        if (const auto* const instance = dynamic_cast<const InstanceNode*>(node)) return instance->number();
    return std::nullopt;
}

} // namespace osgPMObjects

// SPDX-License-Identifier: Apache-2.0
#include <chrono>

#include <osgUtil/Simplifier>

#include <osgPMObjects/core/mesh/MeshBuilder.h>

#include <osgPMObjects/ExportNode>
#include <osgPMObjects/ImportNode>

#include "compare/objects/SimplifyTool.h"

namespace pmtool
{

namespace
{

using namespace osgPMObjects;
using Clock = std::chrono::steady_clock;

/// Continues until the ratio is reached, as the library does by default, or the time is over.
class UntilDeadline : public osgUtil::Simplifier::ContinueSimplificationCallback
{
public:
    explicit UntilDeadline(Clock::time_point deadline) : _deadline(deadline) {}

    bool continueSimplification(const osgUtil::Simplifier& simplifier, float nextError,
                                unsigned int trianglesBefore, unsigned int trianglesLeft) const override
    {
        _isOver = _isOver || Clock::now() > _deadline;
        return !_isOver &&
               simplifier.continueSimplificationImplementation(nextError, trianglesBefore, trianglesLeft);
    }

    bool isOver() const { return _isOver; }

private:
    Clock::time_point _deadline;
    mutable bool _isOver = false;
};

/// The faces of one material: after the way through a node their materials could not be told apart.
core::Mesh facesOf(const core::Mesh& mesh, std::uint32_t material)
{
    core::Mesh some = mesh;
    std::erase_if(some.faces, [&](const core::Face& face) { return face.material != material; });
    return some;
}

/// Simplifies the faces of one material and puts what is left into the level. Returns the time it took, in
/// milliseconds.
foundation::Result<double> simplifyMaterial(const core::Mesh& some, std::uint32_t material,
                                            osgUtil::Simplifier& simplifier, core::MeshBuilder& level)
{
    if (some.faces.empty()) return 0.0;
    const osg::ref_ptr<osg::Group> node = exportNode(some, {});
    const double ms = millisecondsOf([&] { node->accept(simplifier); });
    const auto left = importNode(*node, "osgUtil::Simplifier");
    if (!left) return left.error();
    const core::Mesh& mesh = left->mesh;
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t w = 0; w < mesh.wedgeCount(); ++w)
    {
        core::Wedge wedge = core::wedgeOf(mesh, w);
        wedge.position = level.position(mesh.positions[wedge.position]);
        numbers.push_back(level.wedge(wedge));
    }
    for (const core::Face& face : mesh.faces)
        level.face(
            {{numbers[face.wedges[0]], numbers[face.wedges[1]], numbers[face.wedges[2]]}, material, 0});
    return ms;
}

foundation::Result<SimplifiedLevel> levelOf(const core::Mesh& mesh, std::size_t target, double seconds)
{
    const auto limit = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    const osg::ref_ptr<UntilDeadline> deadline = new UntilDeadline(Clock::now() + limit);
    osgUtil::Simplifier simplifier(static_cast<double>(target) / static_cast<double>(mesh.faces.size()));
    simplifier.setSmoothing(false);
    simplifier.setDoTriStrip(false);
    simplifier.setContinueSimplificationCallback(deadline);
    core::MeshBuilder builder;
    builder.part("simplified");
    SimplifiedLevel level;
    for (std::uint32_t m = 0; m < mesh.materials.size(); ++m)
    {
        const auto ms = simplifyMaterial(facesOf(mesh, m), m, simplifier, builder);
        if (!ms) return ms.error();
        level.ms += *ms;
    }
    level.mesh = builder.finish();
    level.mesh.materials = mesh.materials;
    level.isInTime = !deadline->isOver();
    return level;
}

} // namespace

foundation::Result<std::vector<SimplifiedLevel>> osgUtilLevels(const SimplifyTask& task)
{
    std::vector<SimplifiedLevel> levels;
    for (const std::size_t target : task.targets)
    {
        auto level = levelOf(task.seams ? task.mesh : task.shape, target, task.seconds);
        if (!level) return level.error();
        levels.push_back(*std::move(level));
    }
    return levels;
}

} // namespace pmtool

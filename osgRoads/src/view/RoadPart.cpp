// SPDX-License-Identifier: Apache-2.0
#include "RoadPart.h"

#include <optional>

#include <osgTraversal/ProgramUniforms>

namespace osgRoads
{

namespace
{

/// Where the grain's coordinates are counted from, metres; every period of the grain divides it.
constexpr double kWrapM = 4096.0;

} // namespace

std::vector<RoadRange> rangesOf(const core::RoadMesh& mesh, const std::vector<core::ChunkChoice>& choices,
                                RoadStrips strips)
{
    std::vector<RoadRange> ranges;
    for (const core::ChunkChoice& choice : choices)
    {
        const core::ChunkLevel& level = mesh.chunks[choice.chunk].levels[choice.level];
        RoadRange range{level.firstIndex, level.indexCount};
        if (strips == RoadStrips::paved) range.count = level.pavedCount;
        if (strips == RoadStrips::ground)
            range = {level.firstIndex + level.pavedCount, level.indexCount - level.pavedCount};
        if (range.count > 0) ranges.push_back(range);
    }
    return ranges;
}

RoadPart::RoadPart(std::shared_ptr<RoadBuffers> buffers, std::vector<RoadRange> ranges,
                   const core::RoadViewSettings& settings, double pixelsPerTangent,
                   const osg::BoundingBox& bounds)
    : CulledPart(bounds),
      _buffers(std::move(buffers)),
      _ranges(std::move(ranges)),
      _settings(settings),
      _pixelsPerTangent(pixelsPerTangent)
{
}

void RoadPart::setUniforms(osg::State& state) const
{
    const osg::Matrixd& eyeFromLocal = state.getModelViewMatrix();
    const osg::Vec3d eye = osgTraversal::eyeInLocal(state);
    const glm::dvec3& origin = _buffers->mesh().outline().origin;
    const auto whole = osgTraversal::WholeSteps::of(eye - osg::Vec3d(origin.x, origin.y, origin.z),
                                                    core::RoadMesh::kMeshStepM);
    const osgTraversal::ProgramUniforms uniforms(state);
    uniforms.set("roadEyeSteps", whole.steps);
    uniforms.set("roadEyeRest", whole.rest);
    const auto wrapped = osgTraversal::WrappedPlace::of(eye, kWrapM);
    uniforms.set("roadEyeWrapped", wrapped.within);
    uniforms.set("roadEyeWraps", wrapped.periods);
    uniforms.set("roadLift",
                 osg::Vec4f(static_cast<float>(_settings.liftPx / _pixelsPerTangent),
                            static_cast<float>(_settings.liftFromM), static_cast<float>(_settings.liftFullM),
                            static_cast<float>(_settings.farthestM)));
    uniforms.setRotation("roadEyeFromLocal", eyeFromLocal);
    uniforms.setRotation("roadWorldFromLocal", eyeFromLocal * state.getInitialInverseViewMatrix());
}

void RoadPart::drawImplementation(osg::RenderInfo& renderInfo) const
{
    osg::State& state = *renderInfo.getState();
    setUniforms(state);
    _buffers->draw(state, _ranges);
}

void RoadPart::accept(osg::PrimitiveFunctor& functor) const
{
    showTriangles(_buffers->mesh(), _ranges, functor);
}

void showTriangles(const core::PagedRoadMesh& mesh, const std::vector<RoadRange>& ranges,
                   osg::PrimitiveFunctor& functor)
{
    // OSG's functors know no positions in double precision.
    std::vector<osg::Vec3f> places;
    std::optional<core::RoadPageContent> content;
    std::size_t number = mesh.pages().size();
    for (const RoadRange& range : ranges)
    {
        if (const std::size_t next = mesh.pageOf(range.first); next != number)
        {
            content = mesh.read(next);
            number = next;
        }
        if (!content) continue;
        const std::uint32_t first = range.first - mesh.pages()[number].firstIndex;
        for (std::uint32_t i = first; i < first + range.count; ++i)
        {
            const glm::dvec3 place = mesh.outline().placeOf(content->vertices[content->indices[i]]);
            places.emplace_back(static_cast<float>(place.x), static_cast<float>(place.y),
                                static_cast<float>(place.z));
        }
    }
    if (places.empty()) return;
    functor.setVertexArray(static_cast<unsigned int>(places.size()), places.data());
    functor.drawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(places.size()));
}

} // namespace osgRoads

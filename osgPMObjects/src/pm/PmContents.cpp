// SPDX-License-Identifier: Apache-2.0
#include "PmContents.h"

#include <algorithm>

#include <osgPMObjects/core/progressive/PmFile.h>

namespace osgPMObjects
{

foundation::Result<PmContents> readPmContents(std::istream& stream, const std::string& place,
                                              CutFiles cutFiles)
{
    core::PmReader reader(stream, place);
    auto more = reader.readMore();
    if (!more) return more.error();
    while (more && *more)
        more = reader.readMore();
    const bool isCutOff = !more && reader.isCutOff() && cutFiles == CutFiles::accepted;
    if (!more && !isCutOff) return more.error();
    auto mesh = reader.mesh();
    if (!mesh) return mesh.error();
    const std::uint32_t missing = reader.totalSteps() - mesh->stepCount;
    return PmContents{*std::move(mesh), reader.attachment(), reader.images(), missing, isCutOff};
}

foundation::Outcome fitStates(std::vector<osg::ref_ptr<osg::StateSet>>& states,
                              const core::ProgressiveMesh& mesh, const std::string& place)
{
    std::size_t named = states.size();
    for (const core::Material& material : mesh.mesh.materials)
        named = std::max<std::size_t>(named, material.state + std::size_t{1});
    if (named > states.size() + mesh.mesh.materials.size())
        return foundation::Error{place, "has materials with states that are not there",
                                 "build the file again"};
    states.resize(named);
    return foundation::success();
}

} // namespace osgPMObjects

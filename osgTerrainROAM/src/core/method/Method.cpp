// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/method/Method.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

namespace
{

foundation::Error cannot(Method method, const std::string& owner, const std::string& what,
                         const std::string& remedy)
{
    return {owner + ".method", std::string(methodName(method)) + " " + what, remedy};
}

} // namespace

std::optional<Method> methodNamed(std::string_view name)
{
    for (const MethodTraits& traits : kMethods)
        if (traits.name == name) return traits.method;
    return std::nullopt;
}

std::map<std::string, Method> methodsByName()
{
    std::map<std::string, Method> methods;
    for (const MethodTraits& traits : kMethods)
        methods.emplace(traits.name, traits.method);
    return methods;
}

std::string methodNames()
{
    std::string names;
    for (const MethodTraits& traits : kMethods)
        names += (names.empty() ? "" : ", ") + std::string(traits.name);
    return names;
}

foundation::Outcome checkMethod(const MethodRequest& request, const std::string& owner)
{
    const MethodTraits& traits = traitsOf(request.method);
    if (request.patchExponent > 0 && !traits.hasPatches)
        return cannot(request.method, owner, "has no patches", "set the patch exponent to 0");
    if (request.morphing && !traits.morphs)
        return cannot(request.method, owner, "does not morph", "turn morphing off");
    if (request.limitsTime && !traits.stopsInTime)
        return cannot(request.method, owner, "keeps no limit of time",
                      "leave out the time for adapting, or choose another method");
    if (request.inSight && !traits.refinesInSight)
        return cannot(request.method, owner, "refines all around", "leave out the margin of the view");
    return foundation::success();
}

foundation::Outcome checkMethod(Method method, const RoamTile& tile, const std::string& owner)
{
    const MethodTraits& traits = traitsOf(method);
    if (tile.tile.samples().hasHoles() && !traits.hasHoles)
        return cannot(method, owner, "draws no holes", "fill the voids (voids = fill), or use roam");
    if (tile.tile.grid().exponent() > 0 && !traits.hasFineSamples)
        return cannot(method, owner, "takes no samples between those of the raster",
                      "leave out roads, dense parts and finest_spacing, or use roam");
    return foundation::success();
}

} // namespace osgTerrainROAM::core

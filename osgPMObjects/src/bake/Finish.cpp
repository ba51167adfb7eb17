// SPDX-License-Identifier: Apache-2.0
#include "Finish.h"

#include <glm/common.hpp>

#include <osg/Material>

namespace osgPMObjects
{

namespace
{

glm::vec4 glmOf(const osg::Vec4& v)
{
    return {v.r(), v.g(), v.b(), v.a()};
}

void divideByBase(Finish& finish, float alpha)
{
    finish.base = glm::vec4(
        glm::max(glm::max(finish.ambient, finish.diffuse), glm::max(finish.emission, finish.specular)),
        alpha);
    for (glm::vec3* part : {&finish.ambient, &finish.diffuse, &finish.emission, &finish.specular})
        *part = ratio(*part, finish.base, 0.0f);
}

} // namespace

Finish finishOf(const osg::StateSet& state, const VertexColours& colours)
{
    const bool hasColours = colours.have;
    using Mode = osg::Material::ColorMode;
    constexpr auto kFront = osg::Material::FRONT;
    static const osg::ref_ptr<const osg::Material> nothingSet = new osg::Material;
    const auto* set = dynamic_cast<const osg::Material*>(state.getAttribute(osg::StateAttribute::MATERIAL));
    const osg::Material& material = set ? *set : *nothingSet;
    // OSG's initial state: faces take their vertex colours, and those without are light grey, darker in
    // ambient light.
    const Mode mode = set          ? set->getColorMode()
                      : hasColours ? osg::Material::AMBIENT_AND_DIFFUSE
                                   : osg::Material::OFF;
    Finish finish;
    const auto lighting = state.getMode(GL_LIGHTING);
    finish.isLit = lighting == osg::StateAttribute::INHERIT || (lighting & osg::StateAttribute::ON) != 0;
    const bool isFollowing = hasColours && (mode == osg::Material::DIFFUSE ||
                                            mode == osg::Material::AMBIENT_AND_DIFFUSE || !finish.isLit);
    finish.timesColours = isFollowing && colours.differ;
    // An osg::Material makes its diffuse colour the current colour, which faces without colours have.
    const glm::vec4 diffuse = finish.timesColours                    ? glm::vec4(1.0f)
                              : isFollowing                          ? colours.first
                              : finish.isLit || (set && !hasColours) ? glmOf(material.getDiffuse(kFront))
                                                                     : glm::vec4(1.0f);
    finish.diffuse = glm::vec3(diffuse);
    if (finish.isLit)
    {
        finish.ambient = mode == osg::Material::AMBIENT_AND_DIFFUSE
                             ? finish.diffuse
                             : glm::vec3(glmOf(material.getAmbient(kFront)));
        finish.emission = glm::vec3(glmOf(material.getEmission(kFront)));
        finish.specular = glm::vec3(glmOf(material.getSpecular(kFront)));
        finish.shininess = material.getShininess(kFront);
    }
    divideByBase(finish, diffuse.a);
    return finish;
}

glm::vec3 ratio(const glm::vec3& a, const glm::vec3& b, float otherwise)
{
    glm::vec3 r;
    for (int c = 0; c < 3; ++c)
        r[c] = b[c] > 0.0f ? a[c] / b[c] : otherwise;
    return r;
}

} // namespace osgPMObjects

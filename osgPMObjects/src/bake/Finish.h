// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <osg/StateSet>

namespace osgPMObjects
{

/// What a state's surface does with light, alike on all of it. A map is to hold `base` times texture and vertex colour;
/// base is the largest of what it is divided into, so that no part is above 1, which is all that OpenGL's material can be.
struct Finish
{
    bool isLit = true;
    bool timesColours = false; ///< vertex colours, which differ, are multiplied with it
    glm::vec4 base{1.0f};      ///< the largest of the following, by channel; alpha: diffuse's
    glm::vec3 ambient{0.0f};   ///< the following: parts of base
    glm::vec3 diffuse{1.0f};
    glm::vec3 emission{0.0f};
    glm::vec3 specular{0.0f};
    float shininess = 0.0f;
};

/// The vertex colours of all faces of one material.
struct VertexColours
{
    bool have = false;   ///< there are some
    bool differ = false; ///< not all are `first`
    glm::vec4 first{1.0f};

    void add(const glm::vec4& colour)
    {
        if (!have) first = colour;
        have = true;
        differ = differ || colour != first;
    }
};

/// What a state makes of light without shaders.
Finish finishOf(const osg::StateSet& state, const VertexColours& colours);

/// a / b by channel; where there is nothing to divide by, `otherwise`.
glm::vec3 ratio(const glm::vec3& a, const glm::vec3& b, float otherwise);

} // namespace osgPMObjects

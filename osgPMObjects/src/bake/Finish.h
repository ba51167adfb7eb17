// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <osg/StateSet>

namespace osgPMObjects
{

/// How the surface of a state reflects light, the same everywhere on it. A map holds `base` times texture and
/// vertex colour; `base` is the largest of the parts it is divided into, so that no part is above 1, the most
/// that an OpenGL material allows.
struct Finish
{
    bool isLit = true;
    bool timesColours = false; ///< whether vertex colours, which differ, are multiplied with it
    glm::vec4 base{1.0f};      ///< the largest of the following, by channel; alpha: that of diffuse
    glm::vec3 ambient{0.0f};   ///< the following are parts of base
    glm::vec3 diffuse{1.0f};
    glm::vec3 emission{0.0f};
    glm::vec3 specular{0.0f};
    float shininess = 0.0f;
};

/// The vertex colours of all faces of one material.
struct VertexColours
{
    bool have = false;   ///< whether there are any
    bool differ = false; ///< whether not all are `first`
    glm::vec4 first{1.0f};

    void add(const glm::vec4& colour)
    {
        if (!have) first = colour;
        have = true;
        differ = differ || colour != first;
    }
};

/// Returns how a state reflects light without shaders.
Finish finishOf(const osg::StateSet& state, const VertexColours& colours);

/// Divides a by b, by channel; gives `otherwise` where b is 0.
glm::vec3 ratio(const glm::vec3& a, const glm::vec3& b, float otherwise);

} // namespace osgPMObjects

// -*- c++ -*-
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgPMObjects
{

inline constexpr const char* kBakedVertexShader = R"(#version 120
varying vec3 bakedPlace; // from the eye
varying vec2 bakedTexel;
void main()
{
    vec4 inView = gl_ModelViewMatrix * gl_Vertex;
    bakedPlace = inView.xyz;
    bakedTexel = gl_MultiTexCoord0.xy;
    gl_ClipVertex = inView;
    gl_Position = ftransform();
}
)";

// OpenGL 2.1, 2.14.1, without local viewer and spots. The mean of normals reflects the mean of their light, down to a length of
// 0.7: shorter ones are of sides apart, at an edge between texels, not of one that bends, and are not to be darker still.
inline constexpr const char* kBakedFragmentShader = R"(#version 120
varying vec3 bakedPlace;
varying vec2 bakedTexel;
uniform sampler2D bakedColours;
uniform sampler2D bakedNormals;
uniform int bakedLights;     // the first of them that are on
uniform bool bakedBothSides; // backs are lit by normals turned round
void main()
{
    vec3 mean = 2.0 * texture2D(bakedNormals, bakedTexel).rgb - 1.0;
    vec3 normal = normalize(gl_NormalMatrix * mean);
    if (bakedBothSides && !gl_FrontFacing) normal = -normal;
    vec3 colour = gl_FrontLightModelProduct.sceneColor.rgb;
    for (int i = 0; i < bakedLights; ++i)
    {
        vec4 position = gl_LightSource[i].position;
        vec3 way = position.w == 0.0 ? position.xyz : position.xyz / position.w - bakedPlace;
        float far = length(way);
        vec3 towards = way / max(far, 1e-20);
        float strength = position.w == 0.0 ? 1.0
            : 1.0 / (gl_LightSource[i].constantAttenuation
                + far * (gl_LightSource[i].linearAttenuation + far * gl_LightSource[i].quadraticAttenuation));
        float facing = max(length(mean), 0.7) * max(dot(normal, towards), 0.0);
        colour += strength * (gl_FrontLightProduct[i].ambient.rgb + facing * gl_FrontLightProduct[i].diffuse.rgb);
        float gloss = max(dot(normal, normalize(towards + vec3(0.0, 0.0, 1.0))), 0.0);
        if (facing > 0.0 && gloss > 0.0)
            colour += strength * pow(gloss, gl_FrontMaterial.shininess) * gl_FrontLightProduct[i].specular.rgb;
    }
    vec4 paint = texture2D(bakedColours, bakedTexel);
    gl_FragColor = vec4(colour, gl_FrontMaterial.diffuse.a) * paint;
}
)";

} // namespace osgPMObjects

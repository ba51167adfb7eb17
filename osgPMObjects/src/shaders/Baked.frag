// SPDX-License-Identifier: Apache-2.0
// Lights a baked model by its normal map, as the fixed functions light vertices. Source: Segal and Akeley, The OpenGL
// Graphics System, version 2.1 (2006), section 2.14.1, without local viewer and spots.
// A texel holds the mean of normals and so reflects the mean of their light, down to a length of 0.7. A shorter mean comes
// from two sides of an edge between texels; it must not be darker still.

#version 120
varying vec3 bakedPlace;
varying vec2 bakedTexel;
uniform sampler2D bakedColours;
uniform sampler2D bakedNormals;
uniform int bakedLights;     // the number of lights: lights 0 ... bakedLights - 1 are on
uniform bool bakedBothSides; // back faces are lit with the reversed normal
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

// SPDX-License-Identifier: Apache-2.0
// Computes light and fog as the fixed functions do, but per pixel. Source: Segal and Akeley, The OpenGL Graphics System,
// version 2.1 (2006), section 2.14.1, without local viewer and separate specular colour.
// A software renderer runs all branches, so the loop has as many turns as there are lights.

vec4 lit(vec3 normal, vec3 place)
{
    vec3 colour = gl_FrontLightModelProduct.sceneColor.rgb;
    int i = 0;
    do
    {
        vec4 position = gl_LightSource[i].position;
        vec3 way = position.w == 0.0 ? position.xyz : position.xyz / position.w - place;
        float far = length(way);
        vec3 towards = way / max(far, 1e-20);
        float strength = (terrainLights & (1 << i)) != 0 ? 1.0 : 0.0;
        if (position.w != 0.0)
        {
            strength /= gl_LightSource[i].constantAttenuation
                + far * (gl_LightSource[i].linearAttenuation + far * gl_LightSource[i].quadraticAttenuation);
            float spot = dot(-towards, normalize(gl_LightSource[i].spotDirection));
            if (gl_LightSource[i].spotCosCutoff > -1.0)
                strength *= spot < gl_LightSource[i].spotCosCutoff ? 0.0 : pow(spot, gl_LightSource[i].spotExponent);
        }
        float facing = max(dot(normal, towards), 0.0);
        vec3 sum = gl_FrontLightProduct[i].ambient.rgb + facing * gl_FrontLightProduct[i].diffuse.rgb;
        float gloss = max(dot(normal, normalize(towards + vec3(0.0, 0.0, 1.0))), 0.0);
        if (facing > 0.0 && gloss > 0.0)
            sum += pow(gloss, gl_FrontMaterial.shininess) * gl_FrontLightProduct[i].specular.rgb;
        colour += strength * sum;
    } while (++i < terrainLightCount);
    vec4 all = clamp(vec4(colour, gl_FrontMaterial.diffuse.a), 0.0, 1.0);
    return terrainLights < 0 ? vec4(1.0) : all;
}

vec3 fogged(vec3 colour, float depth)
{
    float clear = clamp(terrainFog.x + terrainFog.y * depth, 0.0, 1.0)
        * exp2(-depth * (terrainFog.z + terrainFog.w * depth));
    return mix(gl_Fog.color.rgb, colour, clear);
}

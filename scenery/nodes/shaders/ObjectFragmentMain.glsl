// SPDX-License-Identifier: Apache-2.0
// Lights an object by the atmosphere's sun and sky and hazes it as the terrain is hazed. Source: Schlick, An inexpensive
// BRDF model for physically-based rendering (1994), section 4: the Fresnel term.

#pragma import_defines(OBJECT_LACQUER, OBJECT_BARE)

in vec3 fromEye;
in vec3 normalWorld;
in vec4 colour;
in vec2 textureAt;
uniform sampler2D objectTexture;
uniform float objectLacquer;
uniform float objectLeaves;   // 1: foliage; 0.5: blades, which stand alone
uniform float objectTintMask;
uniform float objectLamp;     // of a sheet with a lamp behind it
uniform float objectCutOut;   // alpha below which foliage is not drawn

// Of the sunlight that a crown meets, what its leaves let through and scatter comes out of the inner ones again. Green leaves let some 10 % of
// visible light through and reflect as much (Gates, Keegan, Schleter and Weidner, Spectral Properties of Plants, 1965).
const float kThroughLeaves = 0.2;

#if defined(SURFACE_WEATHER) && !defined(OBJECT_LACQUER) && !defined(OBJECT_BARE)
#define OBJECT_WEATHERED // what stands in the open: wet, and under snow
vec3 weatheredAlbedo(vec3 albedo, float upright)
{
    const float kLost = 0.3; // of what is rough and dark: tiles, bark
    float depthCm = 0.0, roughCm = 1.0;
    if (objectLeaves == 0.0)
    {
        albedo = wetAlbedo(albedo, kLost * smoothstep(-0.1, 0.3, upright));
        depthCm = snowDepth(fromEye, upright);
    }
    else if (objectLeaves > 0.75)
        // On leaves and twigs half of what falls stays, on the upper side of a crown.
        depthCm = 0.5 * snowDepth(fromEye, 1.0) * smoothstep(-0.2, 0.8, upright), roughCm = 1.5;
    else
        depthCm = snowDepth(fromEye, 1.0), roughCm = 3.0; // the blades' height
    // Between the leaves a crown stays dark.
    float most = objectLeaves > 0.75 ? 0.55 : 1.0;
    return mix(albedo, kFreshSnow, most * snowShare(depthCm, roughCm, 0.0));
}
#endif

void main()
{
    float shownAlpha = pmAlpha();
#ifdef SUN_SHADOW_MAP // depth alone; the test of alpha needs a colour
#ifndef PICTURE_LOW
    if (objectLeaves > 0.75 && texture(objectTexture, textureAt).a < objectCutOut) discard;
#endif
    gl_FragColor = vec4(1.0);
#else
    float distanceM = length(fromEye);
    vec3 towards = fromEye / distanceM;
    vec3 normal = normalize(normalWorld);
    if (!gl_FrontFacing && objectLeaves == 0.0) normal = -normal; // open surfaces have two sides
    vec4 texel = texture(objectTexture, textureAt);
    vec4 paint = colour * texel;
    float skyShare = 1.0;
    if (objectTintMask > 0.0)
    {
        paint = vec4(mix(texel.rgb, paint.rgb, texel.a), 1.0);
        skyShare = colour.a;
    }
    vec3 albedo = paint.rgb * paint.rgb;              // the inverse of displayColour's gamma
#ifdef OBJECT_WEATHERED
    albedo = weatheredAlbedo(albedo, normal.z);
#endif

    float sunCosine = dot(normal, sunDirection());
    float sunHeight = max(sunCosine, 0.0);
    if (objectLeaves > 0.0) sunHeight = max((sunCosine + 0.5) / 1.5, 0.12); // light comes round the crown and through it
    float share = mix(sunShare(fromEye, normal, 1.0), 1.0, kThroughLeaves * step(0.75, objectLeaves));
    vec3 lit = albedo * (lightOn(normal, share * sunHeight, skyShare) + headLight(fromEye, normal) + vec3(objectLamp * atmosphereLampShare));
#ifdef OBJECT_WEATHERED
    if (objectLeaves == 0.0) // a film on roofs and slabs
        lit = filmOfWater(lit, towards, normal, 0.5 * surfaceWeather.x * smoothstep(0.5, 0.9, normal.z) * (1.0 - min(0.5 * surfaceWeather.y, 1.0)));
#endif
#ifdef OBJECT_LACQUER
    // Lacquer and glass reflect 4 % at normal incidence. The mirrored scene is sky above and ground below.
    float fresnel = objectLacquer * (0.04 + 0.96 * pow(1.0 - max(-dot(normal, towards), 0.0), 5.0));
    vec3 mirrored = reflect(towards, normal);
    vec3 scene = mix(0.3 * ambientLight(vec3(0.0, 0.0, -1.0)), skyColour(mirrored), smoothstep(-0.08, 0.08, mirrored.z));
    vec3 highlight = sunLight() * (share * objectLacquer * 0.35 * pow(max(dot(mirrored, sunDirection()), 0.0), 120.0));
    lit = mix(lit, scene, fresnel) + highlight;
#endif
    gl_FragColor = vec4(displayColour(applyHaze(lit, towards, distanceM)), paint.a * shownAlpha);
#endif
}

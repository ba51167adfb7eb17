// SPDX-License-Identifier: Apache-2.0
// Lights the road by the atmosphere's sun and sky and hazes it as the terrain is hazed. A road seen along its surface mirrors the sky a little.
// A wet one is darker, since light that its film of water throws back enters it again, and mirrors the sky as water does, where the film lies
// unbroken: in patches, more of them the wetter it is.
// Source: Schlick, An inexpensive BRDF model for physically-based rendering (1994), section 4: the Fresnel term; Lekner and Dorf, Why some
// things are darker when wet (1988), section 4: rough dark surfaces lose some two fifths.

uniform float roadWetness; // 0 dry ... 1 with puddles

float waterFilm()
{
    float patches = texture(roadGrain, roadGround * 0.03125).b + 0.5 * (texture(roadGrain, roadGround * 0.125).g - 0.5);
#ifdef SURFACE_WEATHER
    patches += 0.12 * roadTracks(); // wheels have pressed ruts
    if (surfaceWeather.z > 0.0) return 0.6 * min(2.0 * roadWetness, 1.0); // ice is even
#endif
    return smoothstep(0.95 - roadWetness, 1.30 - roadWetness, patches);
}

vec3 mirroring(vec3 lit, vec3 towards, vec3 normal)
{
    float grazing = 1.0 - max(-dot(normal, towards), 0.0);
    float fresnel = 0.12 * pow(grazing, 6.0);
    if (roadWetness > 0.0) fresnel = mix(fresnel, 0.02 + 0.98 * pow(grazing, 5.0), 0.8 * waterFilm());
    vec3 mirrored = reflect(towards, normal);
    return mix(lit, skyColour(vec3(mirrored.xy, max(mirrored.z, 0.0))), fresnel);
}

#ifdef SURFACE_WEATHER
// The share of snow on the road, and in alpha how bright it is: wheels press it away in their tracks and make it grey beside them.
vec2 snowOnRoad(vec3 normal)
{
    float across = roadAt.y / max(roadAt.z, 0.1);
    float tracks = roadIsLane() ? roadTracksAt(across, 4.0) : 0.0;
    float driven = roadIsLane() ? 0.5 : 0.0;
    float patches = texture(roadGrain, roadGround * 0.125).g - 0.5;
    float depthCm = snowDepth(roadFromEye, normal.z) * (1.0 - surfaceWeather.w) * (1.0 - 0.96 * tracks) * (1.0 - 0.3 * driven);
    return vec2(snowShare(depthCm, 0.4, patches), 1.0 - 0.35 * driven * (1.0 + tracks));
}
#endif

void main()
{
#ifndef SUN_SHADOW_MAP // depth alone
    vec3 albedo = roadAlbedo() * (1.0 - 0.4 * min(roadWetness * 1.25, 1.0));
    float distanceM = length(roadFromEye);
    vec3 towards = roadFromEye / distanceM;
    vec3 normal = normalize(roadNormalWorld);
    float sunlit = max(dot(normal, sunDirection()), 0.0) * sunShare(roadFromEye, normal, 1.0);
#ifdef SURFACE_WEATHER
    vec2 snow = snowOnRoad(normal);
    albedo = mix(albedo, kFreshSnow * snow.y, snow.x);
    // A film throws the light of the own lamps ahead, not back.
    float film = roadKind < 5 ? 0.8 * waterFilm() * (1.0 - snow.x) * min(4.0 * roadWetness, 1.0) : 0.0;
    vec3 lit = albedo * (lightOn(normal, sunlit, 1.0) + headLight(roadFromEye, normal) * (1.0 - 0.7 * film));
    if (roadKind < 5) lit = mix(mirroring(lit, towards, normal), lit, snow.x);
    float glint = max(dot(reflect(towards, normal), sunDirection()), 0.0);
    lit += sunLight() * (0.25 * film * sunShare(roadFromEye, normal, 1.0) * pow(glint, 160.0));
#else
    vec3 lit = albedo * (lightOn(normal, sunlit, 1.0) + headLight(roadFromEye, normal));
    if (roadKind < 5) lit = mirroring(lit, towards, normal);
#endif
    gl_FragColor = vec4(displayColour(applyHaze(lit, towards, distanceM)), roadShown());
#endif
}

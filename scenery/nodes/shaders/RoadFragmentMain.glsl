// SPDX-License-Identifier: Apache-2.0
// Lights the road by the atmosphere's sun and sky and hazes it as the terrain is hazed. A road seen along its surface mirrors the sky a little.
// Source: Schlick, An inexpensive BRDF model for physically-based rendering (1994), section 4: the Fresnel term.

void main()
{
#ifndef SUN_SHADOW_MAP // depth alone
    vec3 albedo = roadAlbedo();
    float distanceM = length(roadFromEye);
    vec3 towards = roadFromEye / distanceM;
    vec3 normal = normalize(roadNormalWorld);
    float sunlit = max(dot(normal, sunDirection()), 0.0) * sunShare(roadFromEye, normal, 1.0);
    vec3 lit = albedo * (sunLight() * sunlit + ambientLight(normal));
    if (roadKind < 5)
    {
        float fresnel = 0.12 * pow(1.0 - max(-dot(normal, towards), 0.0), 6.0);
        vec3 mirrored = reflect(towards, normal);
        lit = mix(lit, skyColour(vec3(mirrored.xy, max(mirrored.z, 0.0))), fresnel);
    }
    gl_FragColor = vec4(displayColour(applyHaze(lit, towards, distanceM)), roadShown());
#endif
}

// SPDX-License-Identifier: Apache-2.0
// Adds what asphalt and gardens reflect of a street lamp: by the law of cosines, E = I cos / d^2, and a little less far aside. GLSL 1.30.

in vec3 fromEye;
in vec3 light;
in vec3 fromLampM;
uniform float lightPools; // how bright: from 0 to 1
const float kBelow = 0.075; // linear light below a lamp of 6 m
void main()
{
    float high = fromLampM.z, away2 = dot(fromLampM.xy, fromLampM.xy), square = high * high + away2;
    float cosine = high / sqrt(square);
    float share = cosine * high * high / square * smoothstep(17.0 * 17.0, 6.0 * 6.0, away2);
    float distanceM = length(fromEye);
    vec3 towards = fromEye / distanceM;
    vec3 lit = light * (kBelow * lightPools * share * 36.0 / (high * high));
    vec3 through = applyHaze(lit, towards, distanceM) - applyHaze(vec3(0.0), towards, distanceM);
    gl_FragColor = vec4(displayColour(through), 1.0);
}

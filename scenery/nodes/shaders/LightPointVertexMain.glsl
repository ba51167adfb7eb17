// SPDX-License-Identifier: Apache-2.0
// A lamp as a point of the picture: one vertex. Its flux in the picture follows the illuminance that it has at the eye, E = I exp(-3 d/V)/d²
// (Allard's law, with the air of the Atmosphere), over the least that an eye sees. It is spread over no less than a pixel, and over more where
// it is brighter than a picture can show. scenery/lights has the same as plain values. Follows Atmosphere::glslFunctions(). GLSL 1.30.
// Normal: cosine and sine of the beam's heading, and its tilt in degrees. Colour: alpha is the intensity in candela. Texture coordinates 0: period,
// start and lit time of its flash, and its group; 1: colour below an angle in degrees; 2: row of its beam.

flat out vec3 exposed; // what a pixel would get with the whole light
flat out float spreadPx;
uniform sampler2D lightBeams; // shares of intensity: aside from -180 to 180 degrees, and in the next row up from -90 to 90
uniform float drawnPixels; // along each side of a pixel of the picture
uniform float lightLeastLx, lightTimeS, lightDayS, lightLevels[12];
const float kSeenFlux = 0.002;        // of a lamp that an eye just sees: one or two levels of 255 where it falls between pixels
const float kMostLight = 1.6;         // of the brightest pixel: nearly white
const float kMostSpreadPx = 4.0;
const float kChangePerDeg = 24.0;     // 1 / 2.5 minutes of arc

float beamShare(int row, float at)
{
    float texel = at * float(textureSize(lightBeams, 0).x - 1);
    int first = int(texel);
    return mix(texelFetch(lightBeams, ivec2(first, row), 0).r, texelFetch(lightBeams, ivec2(first + 1, row), 0).r, texel - float(first));
}

void main()
{
    vec4 inView = gl_ModelViewMatrix * gl_Vertex;
    vec3 eye = -(transpose(mat3(gl_ModelViewMatrix)) * gl_ModelViewMatrix[3].xyz); // in the frame of the lamps, without scale
    vec3 from = eye - gl_Vertex.xyz;
    float level = length(from.xy), distanceM = max(length(from), 0.5);
    float upDeg = degrees(atan(from.z, level));
    vec2 ahead = vec2(dot(from.xy, gl_Normal.xy), dot(from.xy, vec2(-gl_Normal.y, gl_Normal.x)));
    float asideDeg = level > 0.0 ? degrees(atan(ahead.y, ahead.x)) : 0.0;
    int row = int(gl_MultiTexCoord2.x + 0.5);
    float candela = gl_Color.a * beamShare(row, clamp((asideDeg + 180.0) / 360.0, 0.0, 0.99999))
                  * beamShare(row + 1, clamp((upDeg - gl_Normal.z + 90.0) / 180.0, 0.0, 0.99999));
    vec4 flash = gl_MultiTexCoord0;
    bool isWindow = flash.w > 9.5 && flash.w < 10.5;
    float timeS = isWindow ? lightDayS : lightTimeS;
    if (flash.x > 0.0 && fract((timeS - flash.y) / flash.x) * flash.x >= flash.z) candela = 0.0;
    if (isWindow) candela *= smoothstep(300.0, 800.0, distanceM); // nearer, panes are drawn
    if (flash.w > 10.5) candela *= smoothstep(60.0, 200.0, distanceM); // nearer, the glow about lamps of vehicles is
    candela *= lightLevels[int(flash.w + 0.5)];

    vec3 towards = normalize(mat3(osg_ViewMatrixInverse) * inView.xyz);
    vec3 air = applyHaze(vec3(1.0), towards, distanceM) - applyHaze(vec3(0.0), towards, distanceM);
    float times = candela * air.g / (distanceM * distanceM) / max(lightLeastLx, 1e-9); // the least that is seen
    times *= smoothstep(0.95, 1.05, times);
    float white = clamp(0.5 + kChangePerDeg * (upDeg - gl_MultiTexCoord1.w), 0.0, 1.0);
    vec3 colour = mix(gl_MultiTexCoord1.rgb, gl_Color.rgb, white);

    float flux = kSeenFlux * times;
    spreadPx = clamp(sqrt(0.5625 * flux / kMostLight), 1.0, kMostSpreadPx);
    exposed = colour * min(flux / (spreadPx * spreadPx), 2.5 * kMostLight);
    gl_PointSize = drawnPixels * (3.0 * spreadPx + 1.0); // and half a pixel on each side, so that all samples of a touched pixel are within
    // Towards the eye: before the ground or the wall that it stands on, with all of its glare.
    inView.xyz *= 1.0 - min(0.3, 0.4 / distanceM + 0.002 + 0.02 * (spreadPx - 1.0));
    gl_Position = times > 0.0 ? gl_ProjectionMatrix * inView : vec4(0.0, 0.0, 2.0, 1.0);
}

// Programs of the graphics card: one draws triangles with their edges, one adds outlines and soft shadows to the finished picture.

const VERTEX_SHADER = `#version 300 es
precision highp float;
layout(location=0) in vec3 position; layout(location=1) in vec3 normal; layout(location=2) in vec3 middle;
layout(location=3) in vec4 barycentric; layout(location=4) in vec4 ink; layout(location=5) in vec4 kind;
layout(location=6) in float owner;
uniform mat3 turn; uniform vec3 centre; uniform float explode, zoom, perspective, scale; uniform vec2 aspect, pan; uniform float selected;
out vec4 weight; out vec3 light; flat out vec4 colours; flat out float facet; flat out float chosen; flat out float edgesOnly;
void main() {
  vec3 p = turn * (position + explode * (middle - centre) - centre) * scale;
  vec3 n = turn * normal;
  light = vec3(n.z, n.y, n.x);
  weight = barycentric; colours = ink; facet = kind.x; edgesOnly = kind.y; chosen = abs(owner - selected) < 0.5 ? 1.0 : 0.0;
  float depth = 1.0 - perspective * p.z / (1.0 + explode);
  vec2 q = p.xy * zoom / (1.0 + 0.75 * explode) + pan * depth;
  gl_Position = vec4(q * aspect, -p.z * 0.2 / (1.0 + explode), depth);
}`;

const FRAGMENT_SHADER = `#version 300 es
precision highp float;
in vec4 weight; in vec3 light; flat in vec4 colours; flat in float facet; flat in float chosen; flat in float edgesOnly;
uniform vec3 palette[64]; uniform vec3 edge; uniform float width; uniform float flatLight;
out vec4 colour;
void main() {
  int nearest = 0;
  for (int k = 1; k < 4; k++) if (weight[k] > weight[nearest]) nearest = k;
  vec3 base = palette[int(colours[nearest] + 0.5)];
  float front = clamp(0.80 * light.x + 0.42 * light.y - 0.25 * light.z, 0.0, 1.0), sky = 0.5 + 0.5 * light.y;
  float shade = mix(0.42 + 0.46 * front + 0.14 * sky, 1.0, flatLight);
  float shine = (1.0 - flatLight) * 0.10 * pow(clamp(0.86 * light.x + 0.44 * light.y - 0.24 * light.z, 0.0, 1.0), 24.0);
  float distance = 1e6, steepest = 0.0;
  for (int k = 0; k < 4; k++) {
    float slope = length(vec2(dFdx(weight[k]), dFdy(weight[k])));
    if (abs(float(k) - facet) < 0.5) continue;
    distance = min(distance, weight[k] / max(slope, 1e-9));
    steepest = max(steepest, slope);
  }
  float wide = width * (1.0 + 2.0 * chosen);
  float ink = 1.0 - smoothstep(wide - 0.6, wide + 0.6, distance);
  if (edgesOnly > 0.5 && ink < 0.5) discard;
  // Edges of simplices that are a few pixels wide would hide their colours.
  ink *= mix(clamp(1.6 - 6.0 * steepest, 0.25, 1.0), 1.0, max(chosen, edgesOnly));
  vec3 lit = mix(base * shade + shine, vec3(1.0), 0.35 * chosen);
  colour = vec4(mix(lit, mix(edge, vec3(0.85, 0.0, 0.3), chosen), ink), 1.0);
}`;

const WHOLE_VERTEX_SHADER = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0); }`;

// A place between two others at the same distance on both sides lies in their plane or is hollow. Hollows are darker, and where the
// depth jumps there is a line.
const WHOLE_FRAGMENT_SHADER = `#version 300 es
precision highp float;
uniform sampler2D picture, depths; uniform float perspective, near, far, line; uniform vec4 ink;
out vec4 colour;
float height(ivec2 at) {
  ivec2 size = textureSize(depths, 0);
  float z = 2.0 * texelFetch(depths, clamp(at, ivec2(0), size - 1), 0).x - 1.0;
  return z > 0.999 ? -1.6 : z / (z * perspective - 0.2);
}
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 own = texelFetch(picture, at, 0);
  float here = height(at), dark = 0.0, jump = 0.0;
  for (int k = 0; k < 20; k++) {
    float angle = 2.399963 * float(k), reach = mix(near, far, (float(k) + 0.5) / 20.0);
    ivec2 step = ivec2(round(reach * vec2(cos(angle), sin(angle))));
    float rise = 0.5 * (height(at + step) + height(at - step)) - here;
    dark += clamp(rise * 14.0, 0.0, 1.0) * (1.0 - smoothstep(0.25, 0.6, rise));
  }
  int d = int(max(1.0, line));
  for (int k = 0; k < 2; k++) {
    ivec2 step = k == 0 ? ivec2(d, 0) : ivec2(0, d);
    float bend = height(at + step) + height(at - step) - 2.0 * here;
    jump = max(jump, -bend);
  }
  float outline = own.a * smoothstep(0.06, 0.12, jump);
  vec3 shaded = own.rgb * (1.0 - 0.62 * dark / 20.0);
  colour = vec4(mix(shaded, ink.rgb * own.a, outline), own.a);
}`;

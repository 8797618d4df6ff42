// SPDX-License-Identifier: MIT
// A ball of one colour as a point: all that its pixels need of it. Light and depth are linear in q, which a pixel of the
// ball knows: x, y from its middle in pixels, and 1 … 0 from there to its outline.
layout(location = 0) in vec4 ball;  // centre, radius
layout(location = 1) in vec4 ball_color;
layout(location = 2) in float ball_tag;
uniform vec4 right;  // of the picture, in the world; and up
uniform vec4 up;
flat out vec2 middle;    // pixels
flat out vec3 round;     // of x², xy, y²: 1 at the outline
flat out vec2 depth;     // of the middle, and how much nearer the front is
flat out vec3 to_sun;    // times q: n·l
flat out vec3 to_shine;  // n·h
flat out vec3 to_sky;    // n.y
flat out vec3 to_floor;  // n·(the floor's normal)
flat out float under;    // see near_floor()
flat out vec3 dim;       // colours: from below, from the sky on top of it, from the sun
flat out vec3 bright;
flat out vec3 sunny;
flat out vec4 color;
#ifdef TAGGED
flat out float tag;
#endif

float window_depth(vec4 clip) { return 0.5 * clip.z / clip.w + 0.5; }

void main() {
  vec3 centre = ball.xyz;
  gl_Position = frame.world_to_clip * vec4(centre, 1.0);
  vec3 v = normalize(frame.eye.xyz - centre);
  float pixel = frame.viewport.w * gl_Position.w;
  vec3 x = (right.xyz - dot(right.xyz, v) * v) * (pixel / ball.w);
  vec3 y = (up.xyz - dot(up.xyz, v) * v) * (pixel / ball.w);
  middle = (0.5 * gl_Position.xy / gl_Position.w + 0.5) * frame.viewport.xy;
  round = vec3(dot(x, x), 2.0 * dot(x, y), dot(y, y));
  depth.x = window_depth(gl_Position);
  depth.y = depth.x - window_depth(frame.world_to_clip * vec4(centre + ball.w * v, 1.0));
  mat3 normal = mat3(x, y, v);  // times q
  vec3 l = frame.light.xyz;
  to_sun = l * normal;
  to_shine = normalize(l + v) * normal;
  to_sky = vec3(x.y, y.y, v.y);
  to_floor = floor_up() * normal;
#ifdef LIVE
  under = 0.0;
#else
  under = 0.35 * frame.floor_shade.y * exp2(-max(floor_height(centre), 0.0));
#endif
  dim = ball_color.rgb * 0.5 * (frame.bounce.rgb + frame.sky.rgb);
  bright = ball_color.rgb * 0.5 * (frame.sky.rgb - frame.bounce.rgb);
  sunny = ball_color.rgb * frame.sun.rgb;
  color = ball_color;
#ifdef TAGGED
  tag = ball_tag;
#endif
  // The picture of a sphere is an ellipse where the line of sight is not square to the picture.
  gl_PointSize = 2.0 * ball.w / (pixel * abs(dot(v, cross(right.xyz, up.xyz)))) + 2.0;
}

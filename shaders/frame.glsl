// What is the same for everything drawn in one frame (render/frame_uniforms.h).

const int kSmoothNormals = 1;
const int kLit = 2;
const int kWireframe = 4;
const int kColourByDepth = 8;
const int kColourByLevel = 16;
const int kShowIllegal = 32;
const int kFilled = 64;
const int kMaterialShift = 7;  // two bits
const int kColourByDistance = 512;
const int kHasDemands = 1024;    // face bytes are depths asked of drawn faces
const int kLightsDrawn = 2048;   // the set of lit faces is one of drawn faces

const int kStudio = 0;
const int kClay = 1;
const int kDark = 2;
const int kShiny = 3;

layout(std140, binding = 0) uniform Frame {
  mat4 clip_from_local;
  mat4 view_from_local;
  mat4 projection;
  vec4 viewport;       // width, height, pixels per unit of the interface, unused
  vec4 palette[8];     // linear RGB of depths, the first the material's own; or of distances
  vec4 palette_text[8];  // sRGB of digits on them
  vec4 valences[4];    // sRGB of irregular vertices, as are the next ones
  vec4 valence_text[4];  // of digits on them
  vec4 illegal;
  vec4 relabelled;
  vec4 accent;
  vec4 wire;           // alpha: strength
  vec4 cage;           // alpha: strength
  int options;
};

bool has_option(int option) { return (options & option) != 0; }
int material() { return options >> kMaterialShift & 3; }
bool is_perspective() { return projection[3][3] == 0.0; }

vec3 srgb_from_linear(vec3 colour) {
  colour = clamp(colour, 0.0, 1.0);
  return mix(12.92 * colour, 1.055 * pow(colour, vec3(1.0 / 2.4)) - 0.055,
             greaterThan(colour, vec3(0.0031308)));
}
